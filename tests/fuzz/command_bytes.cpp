#include "command_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "scene/command/names.h"
#include "scene/mesh/obj.h"

namespace twinlight {

namespace {

// So that an input takes a millisecond; a teapot alone takes one. Lists that call lists come to 2^64 commands: Twinlight has
// limits for that, which tests/property/hostile_commands_test.cpp tries, and which take seconds to reach.
constexpr std::size_t kMostCommands = 512;
constexpr int kMostShapes = 1;
constexpr int kMostListCalls = 2, kMostListCallsInLists = 1;

// One walk over a command's parameters both reads and writes, so that the two cannot disagree.
class Bytes {
  public:
    explicit Bytes(std::span<const std::uint8_t> input) : input_(input) {}
    Bytes() : writes_(true) {}

    bool writes() const { return writes_; }
    bool at_end() const { return at_ >= input_.size(); }
    const std::string& output() const { return output_; }

    std::uint8_t byte(std::uint8_t value) {
        if (writes_) {
            output_ += static_cast<char>(value);
            return value;
        }
        return at_end() ? std::uint8_t{0} : input_[at_++];
    }
    std::uint16_t index(std::size_t value, std::size_t size) {
        const auto low = byte(static_cast<std::uint8_t>(value)), high = byte(static_cast<std::uint8_t>(value >> 8));
        return static_cast<std::uint16_t>(static_cast<std::size_t>(low | high << 8) % size);
    }
    std::uint32_t bits(std::uint32_t value) {
        std::uint32_t result = 0;
        for (int shift = 0; shift < 32; shift += 8)
            result |= std::uint32_t{byte(static_cast<std::uint8_t>(value >> shift))} << shift;
        return result;
    }
    // Numbers that are small, so that their product is no day's work, and those at which arithmetic goes wrong.
    double whole(double value) {
        constexpr int kSmall = 40, kNegative = 160, kHard = 224;  // from which byte on; what is below is from 0 on
        constexpr std::array kHardValues = {2147483647.0, -2147483648.0, 4294967295.0, 65535.0,
                                            65536.0,      1073741824.0,  255.0,        32767.0};
        const auto hard = std::ranges::find(kHardValues, value);
        int code = static_cast<int>(std::clamp<double>(value, kNegative - kHard, kSmall - 1));
        if (code < 0) code = kNegative - 1 - code;
        if (hard != kHardValues.end()) code = kHard + static_cast<int>(hard - kHardValues.begin());
        code = byte(static_cast<std::uint8_t>(code));
        if (code < kNegative) return code % kSmall;
        if (code < kHard) return kNegative - 1 - code;
        return kHardValues[static_cast<std::size_t>(code - kHard) % kHardValues.size()];
    }

  private:
    std::span<const std::uint8_t> input_;
    std::size_t at_ = 0;
    bool writes_ = false;
    std::string output_;
};

std::size_t index_of(const std::vector<NamedValue>& names, double value) {
    const auto found = std::ranges::find_if(names, [&](const NamedValue& name) { return name.value == value; });
    return found == names.end() ? 0 : static_cast<std::size_t>(found - names.begin());
}

// What a value of `kind` can be, of any number.
template <class Integer>
double wrapped(double value) {
    return static_cast<Integer>(static_cast<std::int64_t>(value));
}

double value_of(Bytes& bytes, Kind kind, double value) {
    const auto named = [&](const std::vector<NamedValue>& names) {
        return static_cast<double>(names[bytes.index(index_of(names, value), names.size())].value);
    };
    switch (kind) {
        case Kind::kEnum: return named(gl_names());
        case Kind::kWord: return named(words());
        case Kind::kBitfield: return bytes.bits(static_cast<std::uint32_t>(static_cast<std::int64_t>(value)));
        case Kind::kBoolean:
        case Kind::kUbyte: return bytes.byte(static_cast<std::uint8_t>(static_cast<std::int64_t>(value)));
        case Kind::kByte: return wrapped<std::int8_t>(bytes.whole(value));
        case Kind::kShort: return wrapped<std::int16_t>(bytes.whole(value));
        case Kind::kUshort: return wrapped<std::uint16_t>(bytes.whole(value));
        case Kind::kInt:
        case Kind::kSizei: return wrapped<std::int32_t>(bytes.whole(value));
        case Kind::kUint: return wrapped<std::uint32_t>(bytes.whole(value));
        case Kind::kSizeiptr:
        case Kind::kQuadric: return bytes.whole(value);
        case Kind::kFloat:
        case Kind::kDouble:
            return static_cast<double>(
                std::bit_cast<float>(bytes.bits(std::bit_cast<std::uint32_t>(static_cast<float>(value)))));
    }
    return 0;
}

class Walk {
  public:
    explicit Walk(Bytes& bytes) : bytes_(bytes) {}

    // Reading: `given` is empty. Writing: the command that is to be said.
    Command command(const Command& given) {
        Command command{
            .id = static_cast<CommandId>(bytes_.index(static_cast<std::size_t>(given.id), signatures().size())),
            .arguments = {},
            .place = {},
            .memory = nullptr};
        const std::vector<Parameter>& parameters = command.sig().parameters;
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const Parameter& parameter = parameters[i];
            if (parameter.extent == Extent::kPointer) {
                pointer(command, given);
            } else if (parameter.extent == Extent::kImage) {
                image(command, given);
            } else if (parameter.extent == Extent::kMesh) {
                mesh(command);
            } else if (parameter.extent == Extent::kText) {
                text(command);
            } else {
                const std::size_t count = count_of(command, i, given);
                for (std::size_t n = 0; n < count; ++n)
                    command.arguments.push_back(value_of(bytes_, parameter.kind, next(given, command)));
            }
        }
        return command;
    }

  private:
    // The value that stands where the next one goes.
    static double next(const Command& given, const Command& command) {
        return command.arguments.size() < given.arguments.size() ? given.arguments[command.arguments.size()] : 0;
    }

    std::size_t count_of(const Command& command, std::size_t i, const Command& given) {
        const Parameter& parameter = command.sig().parameters[i];
        const auto said = [&] {
            constexpr std::size_t kMost = 32;
            const std::size_t left =
                given.arguments.size() - std::min(given.arguments.size(), command.arguments.size());
            return bytes_.byte(static_cast<std::uint8_t>(std::min(left, kMost))) % (kMost + 1);
        };
        switch (parameter.extent) {
            case Extent::kValue:
            case Extent::kResult:
            case Extent::kOutputMemory: return 1;
            case Extent::kArray: return static_cast<std::size_t>(parameter.count);
            case Extent::kRest: return said();
            case Extent::kArrayByPname: {
                const std::optional<int> length =
                    array_length(command.id, command.enumerant(command.arguments.size() - 1));
                return length ? static_cast<std::size_t>(*length) : said();
            }
            case Extent::kArrayByCount:
            case Extent::kNewNames:
            case Extent::kControlPoints: return std::min(command.count(i), kMostValues);
            case Extent::kOutput:
            case Extent::kOutputByPname:
            case Extent::kOutputByCount:
            case Extent::kPointer:
            case Extent::kMesh:
            case Extent::kText:
            case Extent::kImage: return 0;
        }
        return 0;
    }

    // Always the same text.
    static void text(Command& command) {
        static const auto kMemory =
            std::make_shared<const Memory>(Memory{Kind::kByte, {std::byte{'a'}, std::byte{'%'}}});
        command.memory = kMemory;
    }

    // Always the same triangle.
    static void mesh(Command& command) {
        static const auto kMemory = std::make_shared<const Memory>(
            Memory{Kind::kUbyte, {}, "a.obj", read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {})});
        command.arguments = {3, 1};
        command.memory = kMemory;
    }

    // Null or an offset into a buffer object; bytes; or the bytes of the last command that had some.
    void pointer(Command& command, const Command& given) {
        enum : std::uint8_t { kNothing, kSame, kNew };
        const bool is_same = given.memory && given.memory == said_;
        const std::uint8_t what = bytes_.byte(!given.memory ? kNothing : is_same ? kSame : kNew) % 3;
        if (what == kNew) {
            constexpr std::size_t kMost = 255;
            const std::size_t size = bytes_.byte(
                static_cast<std::uint8_t>(given.memory ? std::min(given.memory->bytes.size(), kMost) : std::size_t{0}));
            Memory memory;
            for (std::size_t n = 0; n < size; ++n)
                memory.bytes.push_back(std::byte{bytes_.byte(
                    given.memory ? std::to_integer<std::uint8_t>(given.memory->bytes[n]) : std::uint8_t{0})});
            last_ = std::make_shared<const Memory>(std::move(memory));
            said_ = given.memory;
        }
        if (what != kNothing) command.memory = last_;
        const double offset = bytes_.whole(next(given, command));
        // A place in memory is one of its own, or its end.
        const double size = command.memory ? static_cast<double>(command.memory->bytes.size()) : 0;
        command.arguments.push_back(command.memory ? std::clamp(offset, 0.0, size) : offset);
    }

    void image(Command& command, const Command& given) {
        constexpr std::uint8_t kMost = 16;
        std::size_t size = 4;
        for (int side = 0; side < 2; ++side) {
            const double value = bytes_.byte(static_cast<std::uint8_t>(std::min<double>(next(given, command), kMost)));
            command.arguments.push_back(std::clamp<double>(value, 1, kMost));
            size *= static_cast<std::size_t>(command.arguments.back());
        }
        command.memory = std::make_shared<const Memory>(
            Memory{.kind = Kind::kUbyte, .bytes = std::vector<std::byte>(size), .file = "a picture.png"});
    }

    static constexpr std::size_t kMostValues = 4096;

    Bytes& bytes_;
    std::shared_ptr<const Memory> last_, said_;
};

// Leaves out what would make the commands so far a long work.
class Restraint {
  public:
    bool allows(const Command& command) {
        if (command.id == CommandId::glNewList) in_list_ = true;
        if (command.id == CommandId::glEndList) in_list_ = false;
        if (command.sig().family == Family::kShape) return !is_fine(command) && ++shapes_ <= kMostShapes;
        if (command.id == CommandId::glCallLists && in_list_) return false;
        if (command.id != CommandId::glCallList && command.id != CommandId::glCallLists) return true;
        return in_list_ ? ++calls_in_lists_ <= kMostListCallsInLists : ++calls_ <= kMostListCalls;
    }

  private:
    // Of many slices or stacks, but not of more than are refused.
    static bool is_fine(const Command& command) {
        constexpr double kMany = 100, kRefused = 1e8;
        return std::ranges::any_of(command.arguments, [](double value) {
            return value == std::floor(value) && value > kMany && value < kRefused;
        });
    }

    bool in_list_ = false;
    int shapes_ = 0, calls_ = 0, calls_in_lists_ = 0;
};

}  // namespace

std::vector<Command> commands_from(std::span<const std::uint8_t> input) {
    Bytes bytes(input);
    Walk walk(bytes);
    std::vector<Command> commands;
    Restraint restraint;
    while (!bytes.at_end() && commands.size() < kMostCommands) {
        Command command = walk.command({});
        if (restraint.allows(command)) commands.push_back(std::move(command));
    }
    return commands;
}

std::string bytes_from(std::span<const Command> commands) {
    Bytes bytes;
    Walk walk(bytes);
    for (const Command& command : commands) walk.command(command);
    return bytes.output();
}

}  // namespace twinlight

// Printing a command and reading it back gives the same command, for random arguments of every row of the table.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "judge/fuzz/random.h"
#include "scene/command/object_names.h"
#include "scene/command/text.h"
#include "scene/mesh/obj.h"

namespace twinlight::read_print_test {

namespace {

double random_bits(fuzz::Random& random, Kind kind) {
    const auto bits = static_cast<std::uint32_t>(random.uniform(0, 4294967296.0));
    switch (kind) {
        case Kind::kEnum:
            return gl_names()[static_cast<std::size_t>(random.below(static_cast<int>(gl_names().size())))].value;
        case Kind::kBitfield: return static_cast<double>(bits & 0x4700);
        case Kind::kBoolean:
        case Kind::kUbyte: return bits & 0xFF;
        case Kind::kByte: return static_cast<std::int8_t>(bits);
        case Kind::kShort: return static_cast<std::int16_t>(bits);
        case Kind::kUshort: return bits & 0xFFFF;
        case Kind::kInt:
        case Kind::kSizei: return static_cast<std::int32_t>(bits);
        case Kind::kUint: return bits;
        case Kind::kFloat: {
            const auto value = std::bit_cast<float>(bits);
            return std::isfinite(value) ? static_cast<double>(value) : 0.5;
        }
        case Kind::kDouble: {
            const auto value = std::bit_cast<double>(static_cast<std::uint64_t>(bits) << 32 |
                                                     static_cast<std::uint32_t>(random.uniform(0, 4294967296.0)));
            return std::isfinite(value) ? value : 0.25;
        }
        case Kind::kSizeiptr: return std::floor(random.uniform(-0x1p53, 0x1p53));
        case Kind::kQuadric: return 1;  // made once, by the first row that needs one
        case Kind::kWord: return random.below(static_cast<int>(words().size()));
    }
    return 0;
}

// Any bytes, including NaNs and odd lengths.
std::shared_ptr<const Memory> random_memory(fuzz::Random& random) {
    Memory memory;
    memory.kind = static_cast<Kind>(random.below(static_cast<int>(Kind::kSizeiptr) + 1));
    memory.bytes.resize(static_cast<std::size_t>(random.below(50)));
    for (std::byte& byte : memory.bytes) byte = static_cast<std::byte>(random.below(256));
    return std::make_shared<Memory>(std::move(memory));
}

// The contents of a picture file.
ImageFile image(const std::string& name) {
    return {4, 2, std::vector<std::byte>(4 * 2 * 4, static_cast<std::byte>(name.size()))};
}

std::shared_ptr<const Mesh> mesh(const std::string&) { return read_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {}); }

// A target, strides, orders and points; wrong half of the time, then without points.
void random_map(fuzz::Random& random, Command& command) {
    const std::vector<Parameter>& parameters = command.sig().parameters;
    if (random.chance(0.5))
        command.arguments[0] = (parameters.size() == 6 ? kGL_MAP1_COLOR_4 : kGL_MAP2_COLOR_4) + random.below(9);
    for (std::size_t i = 3; i + 1 < parameters.size(); i += 4) {
        command.arguments[i] = random.below(9);
        command.arguments[i + 1] = random.below(5);
    }
    const std::size_t count = command.count(parameters.size() - 1);
    for (std::size_t i = 0; i < count; ++i) command.arguments.push_back(random_bits(random, parameters.back().kind));
}

Command random_command(fuzz::Random& random, CommandId id) {
    Command command{id, {}, {}};
    bool is_counted = false;
    for (const Parameter& parameter : signature(id).parameters) {
        int count = 1;
        if (parameter.extent == Extent::kPointer) {
            if (random.chance(0.8)) command.memory = random_memory(random);
            const auto size = command.memory ? command.memory->bytes.size() : 1000;
            command.arguments.push_back(random.below(static_cast<int>(size) + 1));
            continue;
        }
        if (parameter.extent == Extent::kArrayByCount || parameter.extent == Extent::kNewNames) {
            // The first counted array decides how long the others are.
            if (!is_counted) command.arguments.back() = random.below(5) - 1;
            is_counted = true;
            count =
                static_cast<int>(command.count(static_cast<std::size_t>(&parameter - signature(id).parameters.data())));
        }
        // When a command is read, its results are unknown, except names and that a framebuffer is complete.
        if (parameter.extent == Extent::kResult && parameter.kind != Kind::kQuadric && !named_objects(parameter)) {
            command.arguments.push_back(id == CommandId::glCheckFramebufferStatus ? kGL_FRAMEBUFFER_COMPLETE : 0);
            continue;
        }
        if (parameter.extent == Extent::kOutputByCount) {
            if (id == CommandId::glSelectBuffer || id == CommandId::glFeedbackBuffer)
                command.arguments[0] = random.below(5) - 1;
            continue;
        }
        if (parameter.extent == Extent::kOutputMemory) {
            command.arguments.push_back(random.below(50));
            continue;
        }
        if (parameter.extent == Extent::kControlPoints) {
            random_map(random, command);
            continue;
        }
        const bool names = parameter.extent == Extent::kNewNames || parameter.extent == Extent::kResult;
        if (names && parameter.kind != Kind::kQuadric) {
            for (int i = 0; i < count; ++i) command.arguments.push_back(1 + random.below(1000));
            continue;
        }
        if (parameter.extent == Extent::kImage) {
            command.arguments = {4, 2};
            command.memory =
                std::make_shared<const Memory>(Memory{Kind::kUbyte, image("a picture.png").rgba, "a picture.png"});
            continue;
        }
        if (parameter.extent == Extent::kMesh) {
            command.arguments = {3, 1};
            command.memory = std::make_shared<const Memory>(Memory{Kind::kUbyte, {}, "a.obj", mesh("a.obj")});
            continue;
        }
        if (parameter.extent == Extent::kText) {
            const std::string text = fmt::format("n = 5 %, {}", random.below(100));
            const auto bytes = std::as_bytes(std::span(text));
            command.memory = std::make_shared<const Memory>(Memory{Kind::kByte, {bytes.begin(), bytes.end()}});
            continue;
        }
        if (parameter.is_output()) continue;
        if (parameter.extent == Extent::kRest) count = random.below(5);
        if (parameter.extent == Extent::kArray) count = parameter.count;
        if (parameter.extent == Extent::kArrayByPname) {
            // Half of the time a pname that exists, so that the array has its true length.
            std::vector<Enum> pnames;
            for (const ParameterInfo& info : parameter_infos()) {
                if (info.owner == owner_of(id)) pnames.push_back(info.pname);
            }
            if (random.chance(0.5)) {
                command.arguments.back() =
                    pnames[static_cast<std::size_t>(random.below(static_cast<int>(pnames.size())))];
            }
            count = array_length(id, command.enumerant(command.arguments.size() - 1)).value_or(random.below(5));
        }
        for (int i = 0; i < count; ++i) command.arguments.push_back(random_bits(random, parameter.kind));
    }
    return command;
}

TEST(ReadPrint, GivesTheSameCommandForEveryRowOfTheTable) {
    constexpr std::uint64_t kSeed = 20240502;
    constexpr int kRounds = 100;
    fuzz::Random random(kSeed);
    for (int round = 0; round < kRounds; ++round) {
        CommandList scene{"random", {}};
        for (std::size_t i = 0; i < signatures().size(); ++i) {
            scene.commands.push_back(random_command(random, static_cast<CommandId>(i)));
        }
        const std::string text = print_scene(scene);
        const CommandList back = read_scene(text, "printed", "random", image, {.load_mesh = mesh});
        ASSERT_EQ(back.commands.size(), scene.commands.size()) << "seed " << kSeed;
        for (std::size_t i = 0; i < scene.commands.size(); ++i) {
            ASSERT_EQ(back.commands[i], scene.commands[i])
                << "seed " << kSeed << ", round " << round << ": " << print_command(scene.commands[i]) << " became "
                << print_command(back.commands[i]);
        }
        ASSERT_EQ(print_scene(back), text);
    }
}

}  // namespace

}  // namespace twinlight::read_print_test

// Command: an entry point, its arguments and the place it came from. CommandList: a recording.
//
// What a command looks like (its Signature) stands in commands.def, once; CommandId enumerates the rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/command/names.h"

namespace twinlight {

enum class CommandId : std::uint16_t {
#define GL_COMMAND(name, ...) name,
#define PRAGMA_COMMAND(name, ...) pragma_##name,
#include "scene/command/commands.def"
};

// The types of arguments: GL's (2.2), GLU's quadric, and kWord, a word of a pragma.
enum class Kind : std::uint8_t {
    kEnum,
    kBitfield,
    kBoolean,
    kByte,
    kShort,
    kInt,
    kSizei,
    kUbyte,
    kUshort,
    kUint,
    kFloat,
    kDouble,
    kSizeiptr,  // of sizes and offsets in buffer objects (2.9)
    kQuadric,   // GLUquadric*: its number
    kWord,
};

// What a parameter is. Outputs are arrays that the command writes: none of their values are arguments.
enum class Extent : std::uint8_t {
    kValue,          // one value
    kArray,          // an array of `count` values
    kArrayByPname,   // an array whose length the argument pname decides
    kArrayByCount,   // an array whose length the last GLsizei argument before it gives
    kControlPoints,  // of glMap: as many values as its order and its stride say
    kOutput,         // `count` values
    kOutputByPname,  // as many as the argument pname decides
    kOutputByCount,  // as many as the last GLsizei argument before it says
    kOutputMemory,   // memory that the command writes: one value, how many bytes there are
    kNewNames,       // an array by count that the command writes: the names of new objects, which are recorded
    kPointer,  // a pointer to memory, or an offset into a buffer object: one value, the offset; see Command::memory
    kImage,    // the name of an image's file: its width and its height are the values; see Command::memory
    kRest,     // any number of values
    kResult,   // what the command returned, one value, which is recorded; no argument in C
};

struct Parameter {
    std::string_view name;
    Kind kind = Kind::kInt;
    Extent extent = Extent::kValue;
    int count = 1;  // of values: of a kArray, a kOutput or a kImage

    bool is_output() const {
        return extent == Extent::kOutput || extent == Extent::kOutputByPname || extent == Extent::kOutputByCount;
    }
    bool is_by_pname() const { return extent == Extent::kArrayByPname || extent == Extent::kOutputByPname; }
    bool is_array() const;  // of any length, read or written; memory and pointers are none
};

enum class Family : std::uint8_t { kGl, kShape, kQuadric, kPragma };

struct Signature {
    std::string_view name;  // "glLightfv"; of a pragma its bare name
    Family family = Family::kGl;
    std::vector<Parameter> parameters;

    // Where the first array stands among the parameters; how many there are where there is none. Only arrays of a
    // fixed or a counted length may have others after them.
    std::size_t first_array() const;
    // How many arguments a C program gives: all parameters but the result.
    std::size_t c_arguments() const;
    // "glLightfv(light, pname, params)": for messages.
    std::string usage() const;
};

// The row of the table; `id` indexes it.
const Signature& signature(CommandId id);
std::span<const Signature> signatures();

std::optional<CommandId> find_command(std::string_view name);  // of GL, GLU and GLUT
// The same; for a name with the suffix of an extension, glActiveTextureARB, the core command of the same meaning, where it
// has the same parameters.
std::optional<CommandId> find_command_or_extension(std::string_view name);
std::optional<CommandId> find_pragma(std::string_view name);

// Where a command stands in its text; lines and columns count from 1, 0 means unknown. A command of a recorded program
// has its number there instead of a line, and kCallNumber for a column.
struct Place {
    static constexpr int kCallNumber = -1;

    std::shared_ptr<const std::string> file;
    int line = 0;
    int column = 0;

    std::string str() const;  // "scene.gl:14:22", "program.trace: call 1234"

    friend bool operator==(const Place&, const Place&) = default;
};

// What a pointer argument points into: the bytes of an array, from its start. `kind` is the C type that they were declared
// with (kUbyte where that is not known), for printing; what a command does depends on the bytes alone. Commands that
// name the same array share one.
struct Memory {
    Kind kind = Kind::kUbyte;
    std::vector<std::byte> bytes;
    std::string file{};  // of an image that was read from one: its name
};

// The arguments one after the other, an array as its elements, the result (if any) last. Each is held as a double that has
// exactly the value the C type of its parameter would have (every GL type fits into a double).
struct Command {
    CommandId id{};
    std::vector<double> arguments;
    Place place;
    // Of a command with a pointer argument: null for a null pointer or an offset into a buffer object. The argument
    // itself is the offset in bytes, into the memory or into the buffer object that is bound. Of a command with an image:
    // its pixels, four bytes each, the lowest row first.
    std::shared_ptr<const Memory> memory = nullptr;

    const Signature& sig() const { return signature(id); }
    std::string_view name() const { return sig().name; }
    double number(std::size_t i) const { return arguments[i]; }
    Enum enumerant(std::size_t i) const { return static_cast<Enum>(arguments[i]); }
    Word word(std::size_t i) const { return static_cast<Word>(enumerant(i)); }
    // Where the values of a parameter start, and how many there are.
    std::size_t first(std::size_t parameter) const;
    std::size_t count(std::size_t parameter) const;
    std::span<const double> values(std::size_t parameter) const;
    // What the last GLsizei argument before a parameter says, and 0 where that is less.
    std::size_t counted(std::size_t parameter) const;
    // The elements of the first array argument (empty if the command has none).
    std::span<const double> array() const;

    // Equal commands do the same; where they stand does not matter.
    friend bool operator==(const Command& a, const Command& b);
};

// One step of a recording.
struct Step {
    enum class Kind : std::uint8_t {
        kCommand,
        kFrameEnd,  // the program showed its picture (SwapBuffers); what the buffers hold next is undefined
        kOutside,   // a call of a function that commands.def does not have: `text` names it
        kCutOff,    // the recording breaks off here: `text` says how
    };
    Kind kind = Kind::kCommand;
    const Command& command;  // of all but kCommand only its place
    std::string_view text{};
};

struct CommandList;

// Commands that can be gone through again and again, one at a time: a list, or a recorded program that is too long to be
// held.
struct Recording {
    std::string name;  // of the scene: "report", "scene.gl"

    Recording() = default;
    explicit Recording(std::string given_name) : name(std::move(given_name)) {}
    virtual ~Recording() = default;

    // Hands every step to `visit`, until that answers false. Throws SceneError where the recording cannot be read.
    virtual void for_each(const std::function<bool(const Step&)>& visit) const = 0;
    // The scene in C text that it is; null for a recorded program.
    virtual const CommandList* command_list() const { return nullptr; }

  protected:  // copied as what they are, or not at all
    Recording(const Recording&) = default;
    Recording& operator=(const Recording&) = default;
    Recording(Recording&&) = default;
    Recording& operator=(Recording&&) = default;
};

struct CommandList final : Recording {
    std::vector<Command> commands;

    CommandList() = default;
    CommandList(std::string given_name, std::vector<Command> given_commands)
        : Recording(std::move(given_name)), commands(std::move(given_commands)) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override;
    const CommandList* command_list() const override { return this; }
};

// ---- The parameters of lights, materials, the light model, fog, textures and pixel storage (parameters.def) ----

enum class Owner : std::uint8_t {
    kLight,
    kMaterial,
    kLightModel,
    kFog,
    kTexEnv,
    kTexFilterControl,
    kTexture,
    kPixelStore,
    kPoint
};
enum class Meaning : std::uint8_t { kColor, kPosition, kDirection, kScalar, kEnum };

struct ParameterInfo {
    Owner owner{};
    Enum pname = 0;
    int count = 0;
    Meaning meaning{};
    double smallest = 0, largest = 0;
};

std::span<const ParameterInfo> parameter_infos();
const ParameterInfo* find_parameter(Owner owner,
                                    Enum pname);  // null for a pname that the owner does not have

// Whose parameters the argument pname of this command names (glLight*, glGetLight*: kLight, ...).
std::optional<Owner> owner_of(CommandId id);

// The parameter that the argument pname of this command names; null where it has none, or names none of its owner's.
const ParameterInfo* parameter_info(const Command& command);

// How many values glGet* gives for a name; nothing where that is one, or not known here.
std::optional<int> query_length(Enum pname);

// How many elements the command's array argument has; the pname decides where the table says so. For an unknown pname
// the answer is nothing (the driver would raise GL_INVALID_ENUM and read none).
std::optional<int> array_length(CommandId id, std::optional<Enum> pname);

}  // namespace twinlight

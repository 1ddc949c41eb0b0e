// Command: a GL call with its arguments and its place in the text. CommandList: the commands of a scene.
//
// commands.def is the table of all commands. CommandId enumerates its rows; Signature describes a row.
#pragma once

#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/command/names.h"
#include "scene/command/place.h"

namespace twinlight {

enum class CommandId : std::uint16_t {
#define GL_COMMAND(name, ...) name,
#define PRAGMA_COMMAND(name, ...) pragma_##name,
#include "scene/command/commands.def"
};

// The types of arguments: GL's types (2.2), GLU's quadrics, and kWord for the words of pragmas (words.def).
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
    kSizeiptr,  // sizes and offsets in buffer objects (2.9)
    kQuadric,   // a GLUquadric*, by its number
    kWord,
};

// How many values a parameter has, and whether the command reads or writes them. An output is an array that the command
// writes; it adds no values to Command::arguments.
enum class Extent : std::uint8_t {
    kValue,          // one value
    kArray,          // an array of `count` values
    kArrayByPname,   // an array whose length follows from the argument pname
    kArrayByCount,   // an array whose length is the last GLsizei argument before it
    kControlPoints,  // control points of glMap: their number follows from order and stride
    kOutput,         // an output of `count` values
    kOutputByPname,  // an output whose length follows from the argument pname
    kOutputByCount,  // an output whose length is the last GLsizei argument before it
    kOutputMemory,   // memory that the command writes: one value, its size in bytes
    kNewNames,  // an array of new objects' names, by count; the command writes them, and they are recorded as values
    kPointer,   // a pointer to memory, or an offset into a buffer object: one value, the offset; see Command::memory
    kImage,     // the file name of an image: two values, width and height; see Command::memory
    kMesh,      // the file name of a mesh: two values, its vertices and its triangles; see Command::memory
    kText,      // a text in quotes: no value; see Command::text()
    kRest,      // any number of values
    kResult,    // the value that the command returned, which is recorded; not an argument in C
};

struct Parameter {
    std::string_view name;
    Kind kind = Kind::kInt;
    Extent extent = Extent::kValue;
    int count = 1;  // number of values of a kArray, kOutput, kImage or kMesh

    bool is_output() const {
        return extent == Extent::kOutput || extent == Extent::kOutputByPname || extent == Extent::kOutputByCount;
    }
    bool is_by_pname() const { return extent == Extent::kArrayByPname || extent == Extent::kOutputByPname; }
    bool is_array() const;  // an array that the command reads or writes; not memory, pointers or images
};

enum class Family : std::uint8_t { kGl, kShape, kQuadric, kPragma };

struct Signature {
    std::string_view name;  // "glLightfv"; a pragma's name without "#pragma twinlight"
    Family family = Family::kGl;
    std::vector<Parameter> parameters;

    // The index of the first array parameter, or the number of parameters if there is none. Other parameters may follow
    // it only if its length is fixed or counted.
    std::size_t first_array() const;
    // The number of arguments in C: all parameters except the result.
    std::size_t c_arguments() const;
    // "glLightfv(light, pname, params)", for messages.
    std::string usage() const;
};

// The row `id` of the table.
const Signature& signature(CommandId id);
std::span<const Signature> signatures();

std::optional<CommandId> find_command(std::string_view name);  // a function of GL, GLU or GLUT
// The same, and for the name of an extension such as glActiveTextureARB the core command with the same meaning and
// parameters.
std::optional<CommandId> find_command_or_extension(std::string_view name);
std::optional<CommandId> find_pragma(std::string_view name);

struct Mesh;  // mesh.h

// The bytes of the array that a pointer argument points into. `kind` is the declared C type (kUbyte if unknown) and
// only affects printing. Commands that use the same array share one Memory.
struct Memory {
    Kind kind = Kind::kUbyte;
    std::vector<std::byte> bytes;
    std::string file{};                          // for an image or a mesh: the name of its file
    std::shared_ptr<const Mesh> mesh = nullptr;  // of a mesh, which has no bytes
};

// `arguments` lists all values in order: an array as its elements, the result (if any) last. Each is a double with
// exactly the value that the parameter's C type would have (every GL type fits into a double).
struct Command {
    CommandId id{};
    std::vector<double> arguments;
    Place place;
    // For a pointer argument: the memory that it points into; null for a null pointer or an offset into a buffer
    // object. The argument's value is the offset in bytes into this memory or into the bound buffer object. For an
    // image: its pixels, four bytes each, the bottom row first.
    std::shared_ptr<const Memory> memory = nullptr;

    const Signature& sig() const { return signature(id); }
    std::string_view name() const { return sig().name; }
    double number(std::size_t i) const { return arguments[i]; }
    // The number as GL's enumerants have it, modulo 2^32; 0 for NaN and numbers of more than 63 bits.
    Enum enumerant(std::size_t i) const {
        return std::abs(arguments[i]) < 0x1p63 ? static_cast<Enum>(static_cast<std::int64_t>(arguments[i])) : 0;
    }
    Word word(std::size_t i) const { return static_cast<Word>(enumerant(i)); }
    // The index of a parameter's first value in `arguments`, and the number of its values.
    std::size_t first(std::size_t parameter) const;
    std::size_t count(std::size_t parameter) const;
    std::span<const double> values(std::size_t parameter) const;
    // The last GLsizei argument before a parameter; 0 if it is negative.
    std::size_t counted(std::size_t parameter) const;
    // The elements of the first array argument; empty if there is none.
    std::span<const double> array() const;
    // The bytes of its memory: of a kText argument, UTF-8.
    std::string_view text() const;

    // Equal commands have the same effect. Their places are not compared.
    friend bool operator==(const Command& a, const Command& b);
};

// An object that GL contexts may share.
struct SharedObject {
    enum class Kind : std::uint8_t { kTexture, kBuffer, kList };
    Kind kind = Kind::kTexture;
    std::uint32_t name = 0;

    friend auto operator<=>(const SharedObject&, const SharedObject&) = default;  // NOLINT
};

// One step of a recording.
struct Step {
    enum class Kind : std::uint8_t {
        kCommand,
        kFrameEnd,   // the program showed its picture (SwapBuffers); what the buffers hold next is undefined
        kOutside,    // a call of a function that is not in commands.def: `text` is its name
        kElsewhere,  // another context makes or changes `object`: `text` is "glTexImage2D in context 2"
        kCutOff,     // the recording ends abruptly: `text` describes how
    };
    Kind kind = Kind::kCommand;
    const Command& command;  // only its place is valid for kinds other than kCommand
    std::string_view text{};
    SharedObject object{};
};

struct CommandList;

// Commands that can be visited any number of times, one after the other: a list, or a recorded program that may be too
// long for memory.
struct Recording {
    std::string name;  // the scene's name: "report", "scene.gl"

    Recording() = default;
    explicit Recording(std::string given_name) : name(std::move(given_name)) {}
    virtual ~Recording() = default;

    // Calls `visit` for each step until it returns false. Throws SceneError if the recording cannot be read.
    virtual void for_each(const std::function<bool(const Step&)>& visit) const = 0;
    // For people: "report", or "terms, step 2: Diffuse only".
    virtual std::string title() const { return name; }
    // This recording as a CommandList; null for a recorded program.
    virtual const CommandList* command_list() const { return nullptr; }
    // What to know about all its pictures, a sentence each: for example that other windows are not drawn.
    virtual std::vector<std::string> notes() const { return {}; }
    // The text that a place lies in; null if there is none.
    virtual std::shared_ptr<const std::string> text_of(const Place&) const { return nullptr; }

  protected:  // only derived types may be copied
    Recording(const Recording&) = default;
    Recording& operator=(const Recording&) = default;
    Recording(Recording&&) = default;
    Recording& operator=(Recording&&) = default;
};

struct WindowSize {
    int width = 640, height = 480;

    friend bool operator==(const WindowSize&, const WindowSize&) = default;
};

// What a whole program does when GLUT calls its functions again: its idle, timer or keyboard function, then its display function.
struct LaterPicture {
    std::string when;               // "from the second picture on", "after 1 s", "after the key 'l'"
    std::vector<Command> commands;  // since the picture before
    Place start;                    // of the first statement of the display function
    bool is_after_key = false;
};

// A note about a program whose window has several samples per pixel (section 3.2.1).
inline constexpr std::string_view kOneSampleNote =
    "the program asks for a window with several samples per pixel; Twinlight draws one, so edges are less smooth "
    "than in that window";

struct CommandList final : Recording {
    std::vector<Command> commands;
    std::optional<WindowSize> window{};  // what the scene or program gives its picture
    // The second picture, one after a second and one after a key; null where there is no program, or the reader cannot follow it.
    std::shared_ptr<const std::vector<LaterPicture>> later{};
    std::shared_ptr<const std::string> text = nullptr;  // the C text, for messages; null if there is none
    bool is_program = false;                            // a whole program, whose GL errors do not end it
    // The texts of the files that a program includes, by the names in their places.
    std::map<std::string, std::shared_ptr<const std::string>> included{};
    std::vector<std::string> steps{};      // the titles of the scene's steps (#pragma twinlight step)
    std::size_t step = 0;                  // the number of the one that `commands` has; 0 without steps
    std::vector<std::string> own_notes{};  // notes()

    CommandList() = default;
    CommandList(std::string given_name, std::vector<Command> given_commands)
        : Recording(std::move(given_name)), commands(std::move(given_commands)) {}

    void for_each(const std::function<bool(const Step&)>& visit) const override;
    const CommandList* command_list() const override { return this; }
    std::vector<std::string> notes() const override { return own_notes; }
    std::shared_ptr<const std::string> text_of(const Place& place) const override {
        const auto found = place.file ? included.find(*place.file) : included.end();
        return found == included.end() ? text : found->second;
    }
    std::string title() const override;
};

// ---- The parameters of lights, materials, the light model, fog, textures and pixel storage (parameters.def) ----

enum class Owner : std::uint8_t {
    kLight,
    kMaterial,
    kLightModel,
    kFog,
    kTexEnv,
    kTexGen,
    kTexFilterControl,
    kPointSprite,
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
// Null if the owner has no such parameter.
const ParameterInfo* find_parameter(Owner owner, Enum pname);

// The owner of the parameters that this command sets or returns: kLight for glLight* and glGetLight*, ...
std::optional<Owner> owner_of(CommandId id);

// The parameter that the argument pname names; null if the command has no pname or its owner no such parameter.
const ParameterInfo* parameter_info(const Command& command);

// How many values glGet* returns for a name; nullopt if that is one or not in the table.
std::optional<int> query_length(Enum pname);

// The length of the command's array argument, which may depend on pname. Returns nullopt for an unknown pname (the
// driver would raise GL_INVALID_ENUM and read nothing).
std::optional<int> array_length(CommandId id, std::optional<Enum> pname);

}  // namespace twinlight

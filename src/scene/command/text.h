// Reads scenes from C text, and prints them as C that compiles (docs/scene-language.md). Reading printed text gives the
// same commands again.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

// One error in a scene's text: its place, what is wrong and how to fix it.
struct TextError {
    Place place;
    std::string message;
};
// The number of errors that one SceneError reports.
inline constexpr std::size_t kMaxErrorsShown = 10;

// Bad input. what() is one line, about the first error: "file:line:column: what is wrong; how to fix it".
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
    // `errors_in_text` must not be empty. Sorts the errors by their places and keeps the first kMaxErrorsShown.
    explicit SceneError(std::vector<TextError> errors_in_text, std::shared_ptr<const std::string> scene_text = nullptr);

    std::vector<TextError> errors{};  // empty if the input is not a scene's text
    std::shared_ptr<const std::string> text = nullptr;
    std::shared_ptr<const CommandList> readable = nullptr;  // the commands without errors
    std::string note{};                                     // what may help, after the errors; may be empty
};

// All errors as compilers print them: "file:line:column: error: message", the line of the text, and a caret below the
// column. An error without a text is one line. Control characters of the text are shown as '?'.
std::string as_compilers_print(const SceneError& error);

// Escapes control characters, so that a message with any file name stays on one line.
std::string one_line(std::string_view text);
// The line of the text at this place and a line with a caret below the column; "" if there is no such line.
std::string line_with_caret(std::string_view text, const Place& place);

// Limits on untrusted text.
inline constexpr std::size_t kMaxSceneBytes = 64u << 20;
inline constexpr std::size_t kMaxNesting = 64;  // parentheses in an expression
inline constexpr std::size_t kMaxArrayLength = 1 << 24;
inline constexpr std::size_t kMaxMemoryBytes = 256u << 20;  // all arrays together
inline constexpr std::size_t kMaxSceneSteps = 32;           // step pragmas with different titles
inline constexpr std::size_t kMaxStepTitleBytes = 80;
inline constexpr int kMaxWindow = 8192;  // each side, in pixels
// Limits on whole programs. A step is a word or a sign of the text that is read while the program runs.
inline constexpr std::size_t kMaxProgramSteps = 50'000'000;
inline constexpr std::size_t kMaxProgramTokens = 4'000'000;  // words and signs after macros are replaced
inline constexpr std::size_t kMaxProgramCommands = 2'000'000;
inline constexpr std::size_t kMaxProgramDepth = 800;    // statements, expressions and calls inside each other
inline constexpr std::size_t kMaxProgramLocals = 1000;  // variables of one running function

// Red, green, blue and alpha of each pixel, one byte each; row by row, the bottom row first, as in GL.
struct ImageFile {
    int width = 0, height = 0;
    std::vector<std::byte> rgba;
};
// Reads the image that #pragma twinlight texture(...) names. Throws std::runtime_error with the reason and a remedy.
using ImageLoader = std::function<ImageFile(const std::string& name)>;
// For scenes without a folder, such as those from standard input: refuses every name.
ImageFile no_images(const std::string& name);

// Reads the OBJ file that #pragma twinlight mesh(...) names. Throws std::runtime_error with the reason and a remedy.
using MeshLoader = std::function<std::shared_ptr<const Mesh>(const std::string& name)>;
// For scenes without a folder: refuses every name.
std::shared_ptr<const Mesh> no_meshes(const std::string& name);

// The text of a file in the program's folder, which #include "..." names; nullopt if there is none.
using TextLoader = std::function<std::optional<std::string>(const std::string& name)>;

struct ReadOptions {
    // Of a scene with steps (#pragma twinlight step): the number or the title of the step to read. Empty: the first.
    std::string step{};
    MeshLoader load_mesh = no_meshes;
    TextLoader load_text{};  // of whole programs; empty: none
    // How a whole GLUT program is run (docs/scene-language.md). Other scenes ignore these.
    std::optional<WindowSize> window{};  // instead of the size in glutInitWindowSize
    std::size_t most_steps = kMaxProgramSteps;
    // Whether a picture with so many vertices of one glBegin fits into the memory that is allowed. A loop that would send more is refused
    // before it runs. Empty: not asked.
    std::function<bool(Enum mode, std::size_t vertices)> fits{};
};

// Reads the C dialect, or a whole GLUT program. `file` appears in error messages, `name` in reports. Throws SceneError, also
// for errors in the steps that are not chosen.
CommandList read_scene(std::string_view text, const std::string& file, const std::string& name,
                       const ImageLoader& load_image = no_images, const ReadOptions& options = {});

std::string print_command(const Command& command);                              // "glEnable(GL_LIGHT0);", no newline
std::string print_scene(const CommandList& scene);                              // one line per command
std::string print_c_function(const CommandList& scene, std::string_view name);  // "static void NAME(void) { ... }"
std::string print_c_program(const CommandList& scene);  // a freeglut program that draws the scene
inline constexpr std::string_view kPrintedProgram = ": a scene of Twinlight as a C program.";  // its first line

}  // namespace twinlight

// Scenes as text: reading C statements, and printing them as C that compiles (DESIGN section 1 names the grammar;
// docs/scene-language.md describes it for people). Reading what was printed gives the same commands.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "command/command.h"

namespace twinlight {

// Bad input. what() is one line: "file:line:column: what is wrong; how to mend it".
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Limits on untrusted text.
inline constexpr std::size_t kMaxSceneBytes = 64u << 20;
inline constexpr std::size_t kMaxNesting = 64;  // parentheses in an expression
inline constexpr std::size_t kMaxArrayLength = 1 << 24;
inline constexpr std::size_t kMaxMemoryBytes = 256u << 20;  // of all arrays together

// Reads the C dialect. `file` is used in places; `name` in reports. Throws SceneError.
CommandList read_scene(std::string_view text, const std::string& file, const std::string& name);

std::string print_command(const Command& command);      // "glEnable(GL_LIGHT0);", no newline
std::string print_scene(const CommandList& scene);      // a line a command
std::string print_c_program(const CommandList& scene);  // a freeglut program that draws the scene

}  // namespace twinlight

// The parts of a printed command, for a window in which its arguments can be edited.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

// "glLightf(", "GL_LIGHT0", ", ", ...
struct PrintedPart {
    std::string text;
    std::optional<std::size_t> argument{};  // index into Command::arguments; empty for what is between them
};

// Together they are the text of print_command(). Memory is printed by its size only, and so is an array of more than
// `longest_array` values: "(GLubyte[128]){...}".
std::vector<PrintedPart> print_parts(const Command& command, std::size_t longest_array = 16);

// enum_name(), and the names of 0 to 9 in this command: GL_TRIANGLES in glBegin, GL_ONE in glBlendFunc.
std::string value_name(CommandId command, Enum value);

}  // namespace twinlight

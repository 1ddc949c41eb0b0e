// Arguments: how the window edits one argument of a command.
//
// An argument is an element of Command::arguments; an array is several.
#pragma once

#include <cstddef>

#include "scene/command/command.h"

namespace twinlight::session {

// The same command with another value, rounded to the argument's type. A pname with another number of values, or of
// another meaning, gets GL's initial values.
Command changed_argument(const Command& command, std::size_t argument, double value);

}  // namespace twinlight::session

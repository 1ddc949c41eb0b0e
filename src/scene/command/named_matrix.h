// Matrices that GLU makes: a recording has their numbers only.
#pragma once

#include <span>
#include <string>

#include "scene/command/command.h"

namespace twinlight {

// "gluPerspective(45, 4.0 / 3, 1, 100)" or "gluLookAt(0, 2, 6, 0, 0, 0, 0, 1, 0)" if the first commands of `rest` multiply with the
// matrix that this call makes, to a float's last digits, and its arguments are short numbers; otherwise "".
std::string named_matrix(std::span<const Command> rest);

}  // namespace twinlight

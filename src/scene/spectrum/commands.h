// The commands of GL that the spectra's pragmas stand for: what GL can do of them.
#pragma once

#include <optional>

#include "scene/command/command.h"

namespace twinlight {

// `reflectance(face, pname, name)` is glMaterialfv with the colour under D65, `illuminant(light, pname, name, scale)` glLightfv
// with the colour on white: linear sRGB. Nothing for other commands, and where State refuses the
// arguments.
std::optional<Command> gl_command_of_spectrum(const Command& pragma);

}  // namespace twinlight

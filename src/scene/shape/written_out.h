// Pragmas written out as commands of GL and GLU: for a driver, and for a C compiler.
#pragma once

#include <optional>

#include "scene/command/command.h"

namespace twinlight {

// `texture(file)` is gluBuild2DMipmaps with the picture's pixels, `reflectance(face, pname, name)` glMaterialfv with the colour
// under D65, `illuminant(light, pname, name, scale)` glLightfv with the colour on white: linear sRGB. Nothing for other
// commands, and where State refuses the arguments.
std::optional<Command> gl_command_of(const Command& pragma);

// The same scene with those, and each `#pragma twinlight shape(...)` replaced by the primitives that it stands for.
CommandList with_pragmas_written_out(const CommandList& scene);

}  // namespace twinlight

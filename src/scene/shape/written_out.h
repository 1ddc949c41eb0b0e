// Converts pragmas to commands of GL and GLU, for a driver and for a C compiler.
#pragma once

#include <optional>

#include "scene/command/command.h"

namespace twinlight {

// `texture(file)` becomes gluBuild2DMipmaps with the picture's pixels; `reflectance(face, pname, name)` becomes
// glMaterialfv with the colour under D65; `illuminant(light, pname, name, scale)` becomes glLightfv with the colour on
// white. Colours are linear sRGB. Returns nullopt for other commands, and for arguments that State refuses.
std::optional<Command> gl_command_of(const Command& pragma);

// The GL commands that draw the mesh of #pragma twinlight mesh(...). They leave no state behind, except the image of the
// bound texture where a material has one.
std::vector<Command> mesh_commands(const Command& pragma);

// The primitives of a shape of GLUT or of #pragma twinlight shape(...), by glBegin, with normals; the last normal stays the current one.
std::vector<Command> shape_commands(const Command& shape);

// The scene with these pragmas converted, and with each `#pragma twinlight shape(...)` replaced by its primitives.
CommandList with_pragmas_written_out(const CommandList& scene);

}  // namespace twinlight

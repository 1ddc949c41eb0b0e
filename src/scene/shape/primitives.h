// Pragmas written out as commands of GL and GLU, for who has no such pragmas: a C compiler.
#pragma once

#include "scene/command/command.h"

namespace twinlight {

// The same scene with each `#pragma twinlight shape(...)` replaced by the primitives that it stands for, and each
// `texture(...)` by gluBuild2DMipmaps with the picture's pixels.
CommandList with_pragmas_written_out(const CommandList& scene);

}  // namespace twinlight

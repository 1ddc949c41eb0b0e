// The pragma `shape(...)` written out as glBegin, glNormal, glVertex and glEnd, for who has no such pragma: a C compiler.
#pragma once

#include "command/command.h"

namespace twinlight {

// The same scene with each `#pragma twinlight shape(...)` replaced by the primitives that it stands for.
CommandList with_shapes_as_primitives(const CommandList& scene);

}  // namespace twinlight

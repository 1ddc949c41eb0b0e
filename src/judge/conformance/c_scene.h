// What programs and reports share: a case's scene in C.
#pragma once

#include <string>

#include "scene/command/command.h"

namespace twinlight::conformance {

// The scene by GL's functions alone, as far as the built-in cases go: pragmas, GLUT's shapes and gluPerspective are written out. At its end
// glPixelTransfer has its initial values.
CommandList c_scene(const CommandList& scene);
bool needs_glu(const CommandList& scene);

std::string c_literal(const std::string& text);  // with quotes

}  // namespace twinlight::conformance

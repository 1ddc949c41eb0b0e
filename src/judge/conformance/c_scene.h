// What programs and reports share: a case's scene and places in C.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "judge/compare/vertex_colors.h"
#include "scene/command/command.h"

namespace twinlight::conformance {

// The scene by GL's functions alone, as far as the built-in cases go: pragmas, GLUT's shapes and gluPerspective are written out. At its end
// glPixelTransfer has its initial values.
CommandList c_scene(const CommandList& scene);
bool needs_glu(const CommandList& scene);

// The place of a vertex of the last Draw in a window of 1 x 1; the origin is the lower left corner.
glm::dvec2 place_of_vertex(const compare::VertexScene& scene, int vertex);

std::string c_literal(const std::string& text);  // with quotes

}  // namespace twinlight::conformance

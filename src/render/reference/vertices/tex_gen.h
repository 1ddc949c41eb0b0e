// Generated texture coordinates (2.11.4), before the texture matrix.
//
// In: a vertex, with its position and normal in eye coordinates. Out: (s, t, r, q).
#pragma once

#include "scene/frame/frame.h"

namespace twinlight::reference {

struct StageVertex;

// The vertex's texture coordinates for `unit`, `tex_coord`, with those that the unit generates in their place.
// `normal_eye`: after GL_NORMALIZE or GL_RESCALE_NORMAL.
glm::dvec4 generated_tex_coord(const TextureUnit& unit, const Vertex& vertex, const glm::dvec4& tex_coord,
                               const glm::dvec4& position_eye, const glm::dvec3& normal_eye);

// The largest error of a generated coordinate in float arithmetic, after the texture matrix; 0 if none is generated.
double generated_error(const Draw& draw, const TextureUnit& unit, const Vertex& vertex, const StageVertex& staged);

}  // namespace twinlight::reference

// The vertex stage (2.11, 2.14): object -> eye -> clip, the normal, the texture coordinates.
//
// In: a Draw's vertices, in object coordinates. Out: one StageVertex each, with what the later stages need.
#pragma once

#include <vector>

#include "lighting/rulings.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

struct StageVertex {
    glm::dvec4 position_eye{0};
    glm::dvec4 position_clip{0};
    glm::dvec3 normal_eye{0};  // as NORMALIZE and RESCALE_NORMAL leave it
    glm::dvec4 color{0};       // the current colour that came with the vertex
    glm::dvec4 tex_coord{0};   // (s, t, r, q), as the texture matrix leaves it (2.11.2)
    std::uint32_t material = 0;
};

std::vector<StageVertex> vertex_stage(const Draw& draw);

// Which rulings decided a vertex, or a point of a surface. `normalize`: its normal is made a unit vector.
struct VertexRulings {
    lighting::RulingSet position, normal;
};
VertexRulings vertex_rulings(const Draw& draw, const Vertex& vertex, bool normalize);

// What takes an object-space normal to eye space, as a column vector: the transpose of the inverse of the
// upper 3x3 (2.11.3). RULING: a singular matrix takes every normal to 0, which no light reaches.
glm::dmat3 normal_matrix(const glm::dmat4& eye_from_object);

}  // namespace twinlight::reference

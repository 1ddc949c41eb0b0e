// The vertex stage (2.11, 2.14): transforms positions (object to eye to clip), normals and texture coordinates.
//
// In: a Draw's vertices, in object coordinates. Out: one StageVertex each, with the inputs of later stages.
#pragma once

#include <span>
#include <vector>

#include "lighting/rulings.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

struct StageVertex {
    glm::dvec4 position_eye{0};
    glm::dvec4 position_clip{0};
    glm::dvec3 normal_eye{0};  // after GL_NORMALIZE or GL_RESCALE_NORMAL
    glm::dvec4 color{0};       // the vertex's current colour
    glm::dvec4 tex_coord{0};   // (s, t, r, q), generated (2.11.4) or not, after the texture matrix (2.11.2)
    std::uint32_t material = 0;
};

// The Draw, which must outlive it, for one vertex after the other.
class VertexStage {
  public:
    explicit VertexStage(const Draw& draw);
    StageVertex operator()(const Vertex& vertex) const;

  private:
    const Draw& draw_;
    glm::dmat3 normal_eye_from_object_{1};
    double rescale_ = 1;
};
std::vector<StageVertex> vertex_stage(const Draw& draw);
// The same for vertices that the Draw need not have.
std::vector<StageVertex> vertex_stage(const Draw& draw, std::span<const Vertex> vertices);

// What clipping and rasterisation need of a StageVertex.
struct VertexPosition {
    glm::dvec4 position_eye{0}, position_clip{0};
};
std::vector<VertexPosition> vertex_positions(const Draw& draw);

// The rulings that a vertex or a surface's point depends on. `normalize`: whether its normal is scaled to length 1.
struct VertexRulings {
    lighting::RulingSet position, normal;
};
VertexRulings vertex_rulings(const Draw& draw, const Vertex& vertex, bool normalize);

// The factor of GL_RESCALE_NORMAL (2.11.3), from the normal matrix.
double rescale_factor(const glm::dmat3& normal_eye_from_object);

}  // namespace twinlight::reference

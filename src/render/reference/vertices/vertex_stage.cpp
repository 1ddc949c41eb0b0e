#include "render/reference/vertices/vertex_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/math/normal_matrix.h"
#include "render/reference/vertices/draw_lighting.h"
#include "render/reference/vertices/tex_gen.h"
#include "scene/frame/far_from_origin.h"

namespace twinlight::reference {

namespace {

glm::dvec3 unit(const glm::dvec3& v) { return vec3_cast<glm::dvec3>(lighting::unit(vec3_cast<Vec>(v))); }

VertexPosition position_of(const Draw& draw, const Vertex& vertex) {
    const glm::dvec4 position_eye = draw.eye_from_object * vertex.position_object;
    return {position_eye, draw.clip_from_eye * position_eye};
}

}  // namespace

// 2.11.3: 1 / sqrt(m31^2 + m32^2 + m33^2), where m is the inverse of the modelview matrix. Its third row is the third
// column of the normal matrix.
double rescale_factor(const glm::dmat3& normal_eye_from_object) {
    const double row = lighting::unit_and_length(vec3_cast<Vec>(normal_eye_from_object[2])).length;
    return row > 0 ? 1 / row : 0;
}

std::vector<StageVertex> vertex_stage(const Draw& draw) { return vertex_stage(draw, draw.vertices); }

std::vector<StageVertex> vertex_stage(const Draw& draw, std::span<const Vertex> vertices) {
    const VertexStage stage(draw);
    std::vector<StageVertex> result;
    result.reserve(vertices.size());
    for (const Vertex& vertex : vertices) result.push_back(stage(vertex));
    return result;
}

VertexStage::VertexStage(const Draw& draw)
    : draw_(draw), normal_eye_from_object_(normal_matrix(glm::dmat3(draw.eye_from_object))) {
    if (draw.lighting.rescale_normal) rescale_ = rescale_factor(normal_eye_from_object_);
}

StageVertex VertexStage::operator()(const Vertex& vertex) const {
    const VertexPosition position = position_of(draw_, vertex);
    StageVertex v;
    v.position_eye = position.position_eye;
    v.position_clip = position.position_clip;
    v.normal_eye = normal_eye_from_object_ * vertex.normal_object;
    v.normal_eye = draw_.lighting.normalize ? unit(v.normal_eye) : v.normal_eye * rescale_;
    v.color = vertex.color;
    v.tex_coord = draw_.texture.texture_matrix *
                  generated_tex_coord(draw_.texture, vertex, vertex.tex_coord, v.position_eye, v.normal_eye);
    v.material = vertex.material;
    return v;
}

std::vector<VertexPosition> vertex_positions(const Draw& draw) {
    std::vector<VertexPosition> result;
    result.reserve(draw.vertices.size());
    for (const Vertex& vertex : draw.vertices) result.push_back(position_of(draw, vertex));
    return result;
}

VertexRulings vertex_rulings(const Draw& draw, const Vertex& vertex, bool normalize) {
    using lighting::Ruling;
    VertexRulings rulings;
    if (is_far_from_origin(draw, vertex.position_object)) rulings.position |= {Ruling::kFarFromOrigin};
    const LightingState& state = draw.lighting;
    const glm::dmat3 normal_eye_from_object = normal_matrix(glm::dmat3(draw.eye_from_object));
    const Vec normal_eye = vec3_cast<Vec>(normal_eye_from_object * vertex.normal_object);
    if (normal_eye_from_object == glm::dmat3(0))
        rulings.normal |= {Ruling::kSingularModelview};
    else if (normal_eye == Vec{} && normalize)
        rulings.normal |= {Ruling::kZeroNormal};
    if (normalize)
        rulings.normal |= rulings_of(lighting::unit(vec3_cast<Vec3<lighting::Marked>>(normal_eye)));
    else if (state.rescale_normal && normal_eye != Vec{}) {
        // The ruling matters if the other allowed answer (2.11.3), a unit vector, differs.
        constexpr double kRounding = 1e-6;  // the rounding error of normals that a program means to be unit
        const double rescaled = lighting::unit_and_length(normal_eye).length * rescale_factor(normal_eye_from_object);
        if (std::abs(rescaled - 1) > kRounding) rulings.normal |= {Ruling::kRescaled};
    }
    return rulings;
}

}  // namespace twinlight::reference

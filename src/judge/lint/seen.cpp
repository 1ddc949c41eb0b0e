#include "judge/lint/seen.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

namespace twinlight::lint {

bool culls(const Draw& draw, const reference::Primitive& primitive,
           const std::vector<reference::StageVertex>& vertices) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4& clip = vertices[primitive.vertices[i]].position_clip;
        if (clip.w <= 0) return false;
        p[i] = glm::dvec2(clip) / clip.w;
    }
    const glm::dvec2 a = p[1] - p[0], b = p[2] - p[0];
    const double area = (a.x * b.y - a.y * b.x) * (draw.raster.front_face == kGL_CCW ? 1 : -1);
    const Enum cull = draw.raster.cull_face;
    return cull == kGL_FRONT_AND_BACK || (cull == kGL_FRONT ? area > 0 : area <= 0);
}

SeenPoints::SeenPoints(const Frame& frame) : draws_(frame.draws()) {
    for (std::size_t d = 0; d < draws_.size(); ++d) {
        first_face_.push_back(faces_.size());
        const Draw& draw = *draws_[d];
        if (!draws_polygons(draw.mode) || draw.draws_borders()) continue;
        const std::vector<reference::StageVertex> vertices = reference::vertex_stage(draw);
        std::size_t number = 0;
        for (const reference::Primitive& primitive : reference::assemble(draw, reference::QuadCut::kFirstToThird)) {
            if (primitive.shape != reference::Shape::kTriangle) continue;
            Face face{
                .number = {d, number++}, .corners_clip{}, .low = glm::dvec2(INFINITY), .high = glm::dvec2(-INFINITY)};
            if (draw.raster.cull_enabled && culls(draw, primitive, vertices)) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec4& p = face.corners_clip[i] = vertices[primitive.vertices[i]].position_clip;
                const glm::dvec2 at = glm::dvec2(p) / p.w;
                face.low = p.w > 0 ? glm::min(face.low, at) : glm::dvec2(-INFINITY);
                face.high = p.w > 0 ? glm::max(face.high, at) : glm::dvec2(INFINITY);
            }
            faces_.push_back(face);
        }
    }
}

bool SeenPoints::hides(const Face& face, const TriangleNumber& triangle, const glm::dvec3& point_ndc) const {
    if (point_ndc.x < face.low.x || point_ndc.x > face.high.x || point_ndc.y < face.low.y || point_ndc.y > face.high.y)
        return false;
    const Draw &drawn = *draws_[face.number.draw], &own = *draws_[triangle.draw];
    if (!(drawn.raster.viewport == own.raster.viewport)) return false;
    // The point of the face there is the sum of its corners with weights that are not negative.
    const auto row = [&](int axis) {
        const auto& p = face.corners_clip;
        return glm::dvec3(p[0][axis], p[1][axis], p[2][axis]);
    };
    const glm::dmat3 m = glm::transpose(glm::dmat3(row(0), row(1), row(3)));
    if (glm::determinant(m) == 0) return false;  // seen from its edge
    const glm::dvec3 weights = glm::inverse(m) * glm::dvec3(point_ndc.x, point_ndc.y, 1);
    if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0)) return false;
    constexpr double kRounding = 1e-6;
    const bool is_nearer = glm::dot(weights, row(2)) < point_ndc.z - kRounding;
    if (face.number > triangle) return is_nearer || !drawn.raster.depth_test || !own.raster.depth_test;
    return is_nearer && own.raster.depth_test && drawn.raster.depth_test;
}

bool SeenPoints::shows(const TriangleNumber& triangle, const glm::dvec4& point_clip) const {
    if (!(point_clip.w > 0)) return false;
    const glm::dvec3 ndc = glm::dvec3(point_clip) / point_clip.w;
    if (!(std::max({std::abs(ndc.x), std::abs(ndc.y), std::abs(ndc.z)}) <= 1)) return false;
    const auto own = std::ranges::find(faces_.begin() + static_cast<std::ptrdiff_t>(first_face_[triangle.draw]),
                                       faces_.end(), triangle, &Face::number);
    if (own == faces_.end()) return false;  // culled
    return std::ranges::none_of(
        faces_, [&](const Face& face) { return face.number != triangle && hides(face, triangle, ndc); });
}

}  // namespace twinlight::lint

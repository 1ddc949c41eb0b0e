#include "judge/lint/seen.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

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
            const auto id = static_cast<std::uint32_t>(faces_.size());
            faces_.push_back(face);
            const int left = cell_at(face.low.x), right = cell_at(face.high.x), low = cell_at(face.low.y),
                      high = cell_at(face.high.y);
            constexpr int kLarge = 256;  // cells
            if ((right - left + 1) * (high - low + 1) > kLarge) {
                large_.push_back(id);
                continue;
            }
            for (int y = low; y <= high; ++y)
                for (int x = left; x <= right; ++x) cells_[static_cast<std::size_t>(y * kCells + x)].push_back(id);
        }
    }
}

int SeenPoints::cell_at(double ndc) { return static_cast<int>(std::clamp((ndc + 1) / 2 * kCells, 0.0, kCells - 1.0)); }

namespace {

constexpr double kBorderRounding = 1e-6;

glm::dvec3 row(const std::array<glm::dvec4, 3>& corners, int axis) {
    return {corners[0][axis], corners[1][axis], corners[2][axis]};
}

// The point of a triangle's plane at this place of the picture is the sum of its corners with these weights. None is negative inside
// the triangle, if it is before the eye. nullopt for one that is seen from its edge.
std::optional<glm::dvec3> weights_at(const std::array<glm::dvec4, 3>& corners_clip, const glm::dvec2& place_ndc) {
    const glm::dmat3 m = glm::transpose(glm::dmat3(row(corners_clip, 0), row(corners_clip, 1), row(corners_clip, 3)));
    if (glm::determinant(m) == 0) return std::nullopt;
    return glm::inverse(m) * glm::dvec3(place_ndc, 1);
}

// Whether they are those of a place inside the triangle. `border`: how wide its border is, which is outside; negative: inside.
bool is_inside(const glm::dvec3& weights, double border) {
    const double sum = std::abs(weights.x) + std::abs(weights.y) + std::abs(weights.z);
    return std::min({weights.x, weights.y, weights.z}) >= border * sum;
}

}  // namespace

bool SeenPoints::hides(const Face& face, const Face& own, const glm::dvec3& point_ndc, bool at_border) const {
    if (point_ndc.x < face.low.x || point_ndc.x > face.high.x || point_ndc.y < face.low.y || point_ndc.y > face.high.y)
        return false;
    const RasterState &raster = draws_[face.number.draw]->raster, &own_raster = draws_[own.number.draw]->raster;
    if (!(raster.viewport == own_raster.viewport)) return false;
    const std::optional<glm::dvec3> weights = weights_at(face.corners_clip, glm::dvec2(point_ndc));
    if (!weights || !is_inside(*weights, -kBorderRounding)) return false;
    const double behind = point_ndc.z - glm::dot(*weights, row(face.corners_clip, 2));
    // Of two faces at one depth, glDepthFunc and rounding choose one, so neither is certain. Neighbours share their border.
    const bool hides_by_depth = behind > (at_border ? kBorderRounding : -kBorderRounding);
    const bool tests = raster.depth_test && own_raster.depth_test;
    return face.number > own.number ? hides_by_depth || !tests : hides_by_depth && tests;
}

bool SeenPoints::shows(const TriangleNumber& triangle, const glm::dvec4& point_clip) const {
    if (!(point_clip.w > 0)) return false;
    const glm::dvec3 ndc = glm::dvec3(point_clip) / point_clip.w;
    if (!(std::max({std::abs(ndc.x), std::abs(ndc.y), std::abs(ndc.z)}) <= 1)) return false;
    const auto own =
        std::lower_bound(faces_.begin(), faces_.end(), triangle,
                         [](const Face& face, const TriangleNumber& number) { return face.number < number; });
    if (own == faces_.end() || own->number != triangle) return false;  // culled
    const std::optional<glm::dvec3> weights = weights_at(own->corners_clip, glm::dvec2(ndc));
    const bool at_border = !weights || !is_inside(*weights, kBorderRounding);
    const auto hides_it = [&](std::uint32_t id) {
        return faces_[id].number != triangle && hides(faces_[id], *own, ndc, at_border);
    };
    const auto& cell = cells_[static_cast<std::size_t>(cell_at(ndc.y) * kCells + cell_at(ndc.x))];
    return std::ranges::none_of(large_, hides_it) && std::ranges::none_of(cell, hides_it);
}

}  // namespace twinlight::lint

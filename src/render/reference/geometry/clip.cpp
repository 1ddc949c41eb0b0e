#include "render/reference/geometry/clip.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace twinlight::reference {

namespace {

// The point where the edge meets the plane, always computed from the inner to the outer vertex, so that two triangles
// with a common edge get the same point.
ClipVertex crossing(const ClipVertex& inner, double inner_distance, const ClipVertex& outer, double outer_distance) {
    const double t = inner_distance / (inner_distance - outer_distance);
    return {.position_clip = inner.position_clip + t * (outer.position_clip - inner.position_clip),
            .position_eye = inner.position_eye + t * (outer.position_eye - inner.position_eye),
            .weights = inner.weights + t * (outer.weights - inner.weights)};
}

}  // namespace

ClipVolume::ClipVolume(const RasterState& raster) {
    for (const auto& plane_eye : raster.clip_planes_eye)
        if (plane_eye) planes_.push_back({glm::dvec4(0), *plane_eye, EdgeOrigin::kClipPlane});
    for (int axis : {2, 0, 1})
        for (double sign : {1, -1}) {  // -w <= x is x + w >= 0; x <= w is -x + w >= 0
            glm::dvec4 normal_clip(0, 0, 0, 1);
            normal_clip[axis] = sign;
            planes_.push_back({normal_clip, glm::dvec4(0), axis == 2 ? EdgeOrigin::kNearFar : EdgeOrigin::kSide});
        }
}

double ClipVolume::Plane::signed_distance(const ClipVertex& v) const {
    return origin == EdgeOrigin::kClipPlane ? glm::dot(normal_eye, v.position_eye)
                                            : glm::dot(normal_clip, v.position_clip);
}

std::optional<ClipVolume> ClipVolume::without_planes_of(std::span<const ClipVertex> primitive) const {
    // The eye positions that a driver computes are sums of products of floats; 16 roundings are more than two matrices
    // and the dot product need.
    constexpr double kRounding = 16 * 0x1p-24;
    const auto lies_in = [&](const Plane& plane) {
        return std::ranges::all_of(primitive, [&](const ClipVertex& v) {
            const double distance = std::abs(plane.signed_distance(v));
            if (plane.origin == EdgeOrigin::kClipPlane)
                return distance <= kRounding * glm::length(plane.normal_eye) * glm::length(v.position_eye);
            // What is exactly in the view volume's planes is drawn on purpose, mostly without a matrix.
            return distance > 0 &&
                   distance <= kRounding * glm::dot(glm::abs(plane.normal_clip), glm::abs(v.position_clip));
        });
    };
    if (std::ranges::none_of(planes_, lies_in)) return std::nullopt;
    ClipVolume others = *this;
    std::erase_if(others.planes_, lies_in);
    return others;
}

bool ClipVolume::contains(const ClipVertex& v) const {
    for (const Plane& plane : planes_)
        if (!(plane.signed_distance(v) >= 0)) return false;
    return v.position_clip.w > 0;
}

// Sutherland and Hodgman, "Reentrant polygon clipping", 1974: one plane after the other.
std::vector<ClipVertex> ClipVolume::polygon(std::span<const ClipVertex> polygon) const {
    std::vector<ClipVertex> result(polygon.begin(), polygon.end());
    for (const Plane& plane : planes_) {
        bool all_inside = true;
        for (const ClipVertex& v : result) all_inside = all_inside && plane.signed_distance(v) >= 0;
        if (all_inside) continue;
        std::vector<ClipVertex> kept;
        for (std::size_t i = 0; i < result.size(); ++i) {
            const ClipVertex &current = result[i], &next = result[(i + 1) % result.size()];
            const double d = plane.signed_distance(current), d_next = plane.signed_distance(next);
            if (d >= 0) kept.push_back(current);
            if (d >= 0 && d_next < 0) {  // leaving: the next edge runs along the plane
                if (d > 0) kept.push_back(crossing(current, d, next, d_next));
                kept.back().edge_to_next = plane.origin;
            } else if (d < 0 && d_next > 0) {  // coming back on the same edge
                kept.push_back(crossing(next, d_next, current, d));
                kept.back().edge_to_next = current.edge_to_next;
            }
        }
        result = std::move(kept);
    }
    // RULING: points with w = 0 have no window position and are left out.
    for (const ClipVertex& v : result)
        if (!(v.position_clip.w > 0)) return {};
    return result;
}

std::vector<ClipVertex> ClipVolume::line(const ClipVertex& from, const ClipVertex& to) const {
    ClipVertex a = from, b = to;
    for (const Plane& plane : planes_) {
        const double da = plane.signed_distance(a), db = plane.signed_distance(b);
        if (!(da >= 0) && !(db >= 0)) return {};
        if (da < 0) a = crossing(b, db, a, da);
        if (db < 0) b = crossing(a, da, b, db);
    }
    if (!(a.position_clip.w > 0) || !(b.position_clip.w > 0)) return {};
    return {a, b};
}

}  // namespace twinlight::reference

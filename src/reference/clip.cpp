#include "reference/clip.h"

#include <glm/geometric.hpp>

namespace twinlight::reference {

namespace {

struct Plane {
    glm::dvec4 normal_clip;  // inside where the dot product with a position is not negative
    EdgeOrigin origin;
};

const std::array<Plane, 6> kPlanes = {{
    {{0, 0, 1, 1}, EdgeOrigin::kNearFar},  // -w <= z
    {{0, 0, -1, 1}, EdgeOrigin::kNearFar},
    {{1, 0, 0, 1}, EdgeOrigin::kSide},
    {{-1, 0, 0, 1}, EdgeOrigin::kSide},
    {{0, 1, 0, 1}, EdgeOrigin::kSide},
    {{0, -1, 0, 1}, EdgeOrigin::kSide},
}};

double signed_distance(const Plane& plane, const ClipVertex& v) { return glm::dot(plane.normal_clip, v.position_clip); }

// The point where the edge meets the plane. Always computed from the inner to the outer vertex, so that two
// triangles with a common edge get the same point.
ClipVertex crossing(const ClipVertex& inner, double inner_distance, const ClipVertex& outer, double outer_distance) {
    const double t = inner_distance / (inner_distance - outer_distance);
    return {.position_clip = inner.position_clip + t * (outer.position_clip - inner.position_clip),
            .weights = inner.weights + t * (outer.weights - inner.weights)};
}

}  // namespace

bool inside_view_volume(const glm::dvec4& position_clip) {
    for (const Plane& plane : kPlanes)
        if (!(glm::dot(plane.normal_clip, position_clip) >= 0)) return false;
    return position_clip.w > 0;
}

// Sutherland and Hodgman, "Reentrant polygon clipping", 1974: one plane after the other.
std::vector<ClipVertex> clip_polygon(std::span<const ClipVertex> polygon) {
    std::vector<ClipVertex> result(polygon.begin(), polygon.end());
    for (const Plane& plane : kPlanes) {
        bool all_inside = true;
        for (const ClipVertex& v : result) all_inside = all_inside && signed_distance(plane, v) >= 0;
        if (all_inside) continue;
        std::vector<ClipVertex> kept;
        for (std::size_t i = 0; i < result.size(); ++i) {
            const ClipVertex &current = result[i], &next = result[(i + 1) % result.size()];
            const double d = signed_distance(plane, current), d_next = signed_distance(plane, next);
            if (d >= 0) kept.push_back(current);
            if (d >= 0 && d_next < 0) {  // leaves: the next edge runs along the plane
                kept.push_back(crossing(current, d, next, d_next));
                kept.back().edge_to_next = plane.origin;
            } else if (d < 0 && d_next >= 0) {  // comes back on the same edge
                kept.push_back(crossing(next, d_next, current, d));
                kept.back().edge_to_next = current.edge_to_next;
            }
        }
        result = std::move(kept);
    }
    // RULING: what touches w = 0 has no window position and is left out.
    for (const ClipVertex& v : result)
        if (!(v.position_clip.w > 0)) return {};
    return result;
}

std::vector<ClipVertex> clip_line(const ClipVertex& from, const ClipVertex& to) {
    ClipVertex a = from, b = to;
    for (const Plane& plane : kPlanes) {
        const double da = signed_distance(plane, a), db = signed_distance(plane, b);
        if (!(da >= 0) && !(db >= 0)) return {};
        if (da < 0) a = crossing(b, db, a, da);
        if (db < 0) b = crossing(a, da, b, db);
    }
    if (!(a.position_clip.w > 0) || !(b.position_clip.w > 0)) return {};
    return {a, b};
}

}  // namespace twinlight::reference

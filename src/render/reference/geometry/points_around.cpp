#include "render/reference/geometry/points_around.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <utility>

namespace twinlight::reference {

namespace {

constexpr double kBeside = 1e-3;  // of a pixel

using Points = std::vector<RayPoint>;

bool meet_the_same_faces(const Points& a, const Points& b) {
    return std::ranges::equal(a, b, [](const RayPoint& p, const RayPoint& q) { return p.face == q.face; });
}

// The points on both sides of the place between two rays where the first one's faces end.
std::array<Points, 2> at_border(const SurfaceRays& rays, glm::dvec2 here, glm::dvec2 there) {
    constexpr int kHalvings = 20;
    std::array<Points, 2> sides{rays.points(here), rays.points(there)};
    for (int i = 0; i < kHalvings; ++i) {
        const glm::dvec2 middle = (here + there) / 2.0;
        Points points = rays.points(middle);
        const bool is_here = meet_the_same_faces(points, sides[0]);
        (is_here ? here : there) = middle;
        sides[is_here ? 0 : 1] = std::move(points);
    }
    return sides;
}

}  // namespace

PointsAround::PointsAround(const SurfaceRays& rays, const glm::dvec2& centre_window) {
    const Points at_centre = rays.points(centre_window);
    add(at_centre);
    const auto add_others = [&](Points points) {
        is_certain_ = is_certain_ && meet_the_same_faces(points, at_centre);
        add(std::move(points));
    };
    // In floats, a point in a clipping plane may be on either side of it.
    constexpr double kRounding = 8 * 0x1p-24;
    for (const double slack : {-kRounding, kRounding}) add_others(rays.points(centre_window, slack));
    static constexpr std::array<glm::dvec2, 4> kCorners{glm::dvec2(-1, -1), {-1, 1}, {1, -1}, {1, 1}};
    for (const glm::dvec2& way : kCorners) add_others(rays.points(centre_window + kBeside * way));
    if (is_certain_) return;
    // Colours change fastest at a silhouette.
    static constexpr std::array<glm::dvec2, 8> kWays{glm::dvec2(-1, -1), {-1, 0}, {-1, 1}, {0, -1},
                                                     glm::dvec2(0, 1),   {1, -1}, {1, 0},  {1, 1}};
    for (const glm::dvec2& way : kWays)
        for (Points& side : at_border(rays, centre_window, centre_window + kBeside * way)) add(std::move(side));
}

void PointsAround::add(Points points) {
    by_number_.resize(std::max(by_number_.size(), points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) by_number_[i].push_back(std::move(points[i]));
}

// The highlight of exponent 128 changes by at most seven times the angle: by less than half of 1/255.
std::span<const RayPoint> PointsAround::lit(int number) const {
    constexpr double kAngle = 1.0 / 4000;
    const std::span<const RayPoint> all = points(number);
    const glm::dvec3& normal = all.front().vertex.normal_eye;
    const bool turns = std::ranges::any_of(all, [&](const RayPoint& point) {
        return glm::distance(point.vertex.normal_eye, normal) > kAngle || point.face != all.front().face;
    });
    return is_certain_ && !turns ? all.first(1) : all;
}

}  // namespace twinlight::reference

#include "render/programmable/numbers/wide_range.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <vector>

#include "base/math/directions.h"

namespace twinlight::programmable {
namespace {

// Lengths whose squares, and the squares of lengths a hundred thousand times as small, are floats.
constexpr double kShort = 1e-9, kLong = 1e9;
// Nearer than this share of the coordinates' size, a difference of floats is off by more than 2^-24 / kNearShare = 1.5e-5.
constexpr double kNearShare = 0x1p-8;

// Whether a vertex may be nearer to the place than `distance`. The sphere and the box around all vertices answer for most Draws.
// A box helps where the sphere reaches far from the vertices, as that of a floor does to the lamps above it.
bool may_be_near(std::span<const Draw* const> draws, const glm::dmat4& m, const VertexFacts& facts,
                 const glm::dvec3& place, double distance) {
    if (facts.has_sphere) {
        double squares = 0;  // at least the square of the matrix's largest stretch
        for (int column = 0; column < 3; ++column) squares += glm::dot(glm::dvec3(m[column]), glm::dvec3(m[column]));
        const glm::dvec3 center = glm::dmat3(m) * facts.center_object + glm::dvec3(m[3]);
        if (glm::length(place - center) - std::sqrt(squares) * facts.radius_object > distance) return false;
        if (glm::determinant(glm::dmat3(m)) != 0) {
            const glm::dmat3 object_from_eye = glm::inverse(glm::dmat3(m));
            const glm::dvec3 place_object = object_from_eye * (place - glm::dvec3(m[3]));
            const glm::dvec3 way_object = place_object - glm::clamp(place_object, facts.low_object, facts.high_object);
            double inverse_squares = 0;  // at least the square of the inverse's largest stretch
            for (int column = 0; column < 3; ++column)
                inverse_squares += glm::dot(object_from_eye[column], object_from_eye[column]);
            // Twice, for rounding; false if a number is infinite.
            if (glm::length(way_object) > 2 * distance * std::sqrt(inverse_squares)) return false;
        }
    }
    const auto is_near = [&](const Vertex& vertex) {
        const glm::dvec4 at = m * vertex.position_object;
        const glm::dvec3 way = place - glm::dvec3(at) / (at.w == 0 ? 1 : at.w);
        return !(glm::dot(way, way) > distance * distance);
    };
    return std::ranges::any_of(draws, [&](const Draw* draw) { return std::ranges::any_of(draw->vertices, is_near); });
}

// A bound on one component.
double reach_of_row(int row, const glm::dmat4& matrix, const glm::dvec4& reach) {
    double sum = 0;
    for (int column = 0; column < 4; ++column) sum += std::abs(matrix[column][row]) * reach[column];
    return sum;
}

}  // namespace

double reach_xyz(const glm::dmat4& matrix, const glm::dvec4& reach) {
    return std::max({reach_of_row(0, matrix, reach), reach_of_row(1, matrix, reach), reach_of_row(2, matrix, reach)});
}
double reach_w(const glm::dmat4& matrix, const glm::dvec4& reach) { return reach_of_row(3, matrix, reach); }

double power_of_two(double x) { return x > 0 && std::isfinite(x) ? std::ldexp(1, std::ilogb(x)) : 1; }

double homogeneous_scale(double longest, double w) {
    constexpr double kLargest = 0x1p40;
    return std::clamp(power_of_two(std::max(longest / kLargest, w)), 0x1p-100, 0x1p120);
}

double clip_scale(const glm::dmat4& clip_from_object, const glm::dvec4& reach_object) {
    constexpr double kHuge = 0x1p80;
    const double scale =
        homogeneous_scale(reach_xyz(clip_from_object, reach_object), reach_w(clip_from_object, reach_object));
    return scale > 1 / kHuge && scale < kHuge ? 1 : scale;
}

std::vector<glm::dvec3> places_eye(const Plan& plan) {
    std::vector<glm::dvec3> places;
    if (plan.effects.local_viewer) places.emplace_back(0);
    for (const PlannedLight& planned : plan.lights) {
        const glm::dvec4& p = plan.lighting.lights[static_cast<std::size_t>(planned.number)].position_eye;
        if (p.w != 0) places.push_back(glm::dvec3(p) / p.w);
    }
    return places;
}

glm::dmat4 keeping_w(const glm::dmat4& eye_from_object) {
    const double w = eye_from_object[3][3];
    const bool only_scales_w = eye_from_object[0][3] == 0 && eye_from_object[1][3] == 0 && eye_from_object[2][3] == 0;
    return only_scales_w && w > 0 && w != 1 && std::isfinite(w) ? eye_from_object / w : eye_from_object;
}

bool has_wide_range(std::span<const Draw* const> draws, const Plan& plan) {
    if (!plan.effects.lighting || !plan.effects.needs_position_eye()) return false;
    const VertexFacts& facts = plan.vertices;
    const glm::dmat4 eye_from_object = keeping_w(draws.front()->eye_from_object);
    if (!keeps_w(eye_from_object)) return false;
    if (!facts.w_is_1) return true;
    const double size = reach_xyz(eye_from_object, facts.position_reach);
    if (size > 0 && !(size > kShort && size < kLong)) return true;
    return std::ranges::any_of(places_eye(plan), [&](const glm::dvec3& place) {
        return !(largest_component(place) < kLong) ||
               may_be_near(draws, eye_from_object, facts, place, std::max(kNearShare * size, kShort));
    });
}

NearestVertex nearest_vertex(const Draw& draw, const glm::dvec3& place_eye) {
    const glm::dmat4 m = keeping_w(draw.eye_from_object);
    NearestVertex nearest{.way_eye = place_eye - glm::dvec3(m[3])};
    bool found = false;
    for (const Vertex& vertex : draw.vertices) {
        const glm::dvec4& p = vertex.position_object;
        if (p.w == 0 || !(largest_component(glm::dvec3(p) / p.w) < kMostDistant)) continue;
        const glm::dvec4 at = draw.eye_from_object * p;  // as the light's, so that nothing is left where they agree
        const glm::dvec3 way = place_eye - glm::dvec3(at) / at.w;
        if (found && !(largest_component(way) < largest_component(nearest.way_eye))) continue;
        nearest = {p, way};
        found = true;
    }
    return nearest;
}

}  // namespace twinlight::programmable

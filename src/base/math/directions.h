// Unit vectors and angles, in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace twinlight {

inline double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// v / |v|. Returns 0 for the zero vector and for a vector with an infinite or NaN component. If squares would overflow
// or underflow, v is first scaled by a power of two, which is exact.
inline glm::dvec3 unit(const glm::dvec3& v) {
    const double biggest = largest_component(v);
    const glm::dvec3 dir = glm::normalize(v * (biggest > 1e150 ? 0x1p-600 : biggest < 1e-150 ? 0x1p600 : 1));
    return glm::dot(dir, dir) <= 2 ? dir : glm::dvec3(0);
}

// The cosine of an angle in degrees. Exactly 0 at 90 degrees, where the rounded pi would give 6e-17.
inline double cos_deg(double angle_deg) { return angle_deg == 90 ? 0 : std::cos(angle_deg * std::numbers::pi / 180); }

}  // namespace twinlight

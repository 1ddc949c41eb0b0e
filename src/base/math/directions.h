// Vectors of length 1, and angles, in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace twinlight {

inline double largest_component(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// v / |v|. The zero vector, and one with a component that is infinite or NaN, has no direction: they give 0. Vectors whose
// squares would overflow or underflow are scaled by a power of two first, which is exact.
inline glm::dvec3 unit(const glm::dvec3& v) {
    const double biggest = largest_component(v);
    const glm::dvec3 dir = glm::normalize(v * (biggest > 1e150 ? 0x1p-600 : biggest < 1e-150 ? 0x1p600 : 1));
    return glm::dot(dir, dir) <= 2 ? dir : glm::dvec3(0);
}

// The cosine of an angle in degrees; exactly 0 at 90, which pi does not give.
inline double cos_deg(double angle_deg) { return angle_deg == 90 ? 0 : std::cos(angle_deg * std::numbers::pi / 180); }

}  // namespace twinlight

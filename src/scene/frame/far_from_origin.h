// Detects objects far from the origin with the eye near them. Their eye coordinates are small differences of large
// numbers, and floats lose their digits.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/frame/frame.h"

namespace twinlight {

// Whether this holds at a point of the Draw (object coordinates), or within the distance `reach_eye` (eye coordinates)
// of it.
inline bool is_far_from_origin(const Draw& draw, const glm::dvec4& place_object, double reach_eye = 0) {
    // Then a float loses 8 of its 24 bits. The remaining error is 1e-5 of the distance from the eye, the limit of
    // section 2.1.1.
    constexpr double kCancels = 256;
    const glm::dvec3 turned = glm::dmat3(draw.eye_from_object) * glm::dvec3(place_object);
    const glm::dvec3 moved = glm::dvec3(draw.eye_from_object[3]) * place_object.w;
    const double distance = std::max(glm::length(turned + moved) - reach_eye, 0.0);
    return place_object.w != 0 && glm::length(turned) + glm::length(moved) > kCancels * distance;
}

}  // namespace twinlight

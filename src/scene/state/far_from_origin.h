// Objects far from the origin of their coordinates, with the eye beside them: eye coordinates are then what is left of numbers
// that cancel, and floats have lost it.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/state/frame.h"

namespace twinlight {

// Whether that is so at this place of the Draw, or as near to the eye as `reach_eye` around it.
inline bool is_far_from_origin(const Draw& draw, const glm::dvec4& place_object, double reach_eye = 0) {
    // Of 24 bits, eight are lost: what is left is 1e-5 of the distance from the eye, 2.1.1's measure.
    constexpr double kCancels = 256;
    const glm::dvec3 turned = glm::dmat3(draw.eye_from_object) * glm::dvec3(place_object);
    const glm::dvec3 moved = glm::dvec3(draw.eye_from_object[3]) * place_object.w;
    const double distance = std::max(glm::length(turned + moved) - reach_eye, 0.0);
    return place_object.w != 0 && glm::length(turned) + glm::length(moved) > kCancels * distance;
}

}  // namespace twinlight

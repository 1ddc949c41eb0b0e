#include "render/programmable/origin.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/state/far_from_origin.h"

namespace twinlight::programmable {

std::optional<glm::dvec3> upload_origin(const Draw& draw, const VertexFacts& facts) {
    // Coordinates are as large as the object then, and no longer as its distance from the origin: at least two bits are gained.
    constexpr double kGain = 4;
    if (!facts.has_sphere || !(glm::length(facts.center_object) > kGain * facts.radius_object)) return {};
    double stretch = 0;  // squared, at least: the sum of the squares of the matrix's elements
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 axis(draw.eye_from_object[column]);
        stretch += glm::dot(axis, axis);
    }
    const double radius_eye = std::sqrt(stretch) * facts.radius_object;
    if (!is_far_from_origin(draw, glm::dvec4(facts.center_object, 1), radius_eye)) return {};
    return facts.center_object;
}

}  // namespace twinlight::programmable

#include "programmable/origin.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace twinlight::programmable {

bool is_far_from_origin(const Draw& draw) {
    if (draw.vertices.empty()) return false;
    // Of 24 bits, eight are lost: what is left is 1e-5 of the distance from the eye, 2.1.1's measure.
    constexpr double kCancels = 256;
    const glm::dvec4& place = draw.vertices.front().position_object;
    const glm::dvec3 turned = glm::dmat3(draw.eye_from_object) * glm::dvec3(place);
    const glm::dvec3 moved = glm::dvec3(draw.eye_from_object[3]) * place.w;
    return place.w != 0 && glm::length(turned) + glm::length(moved) > kCancels * glm::length(turned + moved);
}

std::optional<Draw> moved_to_origin(const Draw& draw) {
    if (!is_far_from_origin(draw)) return std::nullopt;
    const glm::dvec4 first = draw.vertices.front().position_object;
    const glm::dvec3 origin = glm::dvec3(first) / first.w;
    Draw moved = draw;
    for (Vertex& vertex : moved.vertices) vertex.position_object -= glm::dvec4(origin * vertex.position_object.w, 0);
    moved.eye_from_object = glm::translate(draw.eye_from_object, origin);
    return moved;
}

}  // namespace twinlight::programmable

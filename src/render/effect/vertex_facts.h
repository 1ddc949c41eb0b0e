// What the planner asks of a Draw's vertices, in object coordinates: nothing here changes while they stay as they are,
// wherever the modelview matrix takes them.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight {

// What rounding may take from bounds found in double precision, relative to the sum of the magnitudes that are added: ten
// thousand times its unit.
inline constexpr double kBoundsRounding = 1e-12;
// Beyond these, squares overflow or underflow.
inline constexpr double kLargestLength = 1e100, kSmallestLength = 1e-100;

struct VertexFacts {
    bool w_is_1 = true;
    bool q_is_1 = true;            // of the texture coordinates
    glm::dvec4 position_reach{0};  // the largest absolute value of each component

    // A sphere around the positions, divided by their w, and so around all that lies between them. Nothing is known of
    // it (has_sphere is false) where there is no vertex, or not every w has the same sign.
    bool has_sphere = false;
    glm::dvec3 center_object{0};
    double radius_object = 0;

    bool normals_equal = true;     // to the last bit
    bool has_zero_normal = false;  // such normals do not count in what follows
    double shortest_normal = 0, longest_normal = 0;
    // A cone around them; its half angle is pi where it is of no use.
    glm::dvec3 normal_axis_dir_object{0, 0, 1};
    double normal_half_angle = 0;  // in radians

    bool colors_equal = true;
    glm::dvec4 color_low{1}, color_high{1};  // channel by channel

    std::vector<std::uint32_t>
        materials;  // which of Draw::materials, each once, from the lowest; empty where there are none
};

VertexFacts vertex_facts(const Draw& draw);

// Whether positions, or texture coordinates, keep their w under the matrix: its last row is 0, 0, 0, 1.
inline bool keeps_w(const glm::dmat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

}  // namespace twinlight

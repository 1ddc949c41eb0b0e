// What the planner needs to know about a Draw's vertices, in object coordinates. It stays valid while the vertices do
// not change, whatever the modelview matrix is.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight {

// Bounds the rounding error of a sum of products in double, relative to the sum of their magnitudes; the real error is
// ten thousand times smaller.
inline constexpr double kBoundsRounding = 1e-12;
// Beyond these, squares overflow or underflow, and there are no bounds.
inline constexpr double kLargestLength = 1e100, kSmallestLength = 1e-100;

struct VertexFacts {
    bool w_is_1 = true;
    bool has_w_0 = false;          // a position has w = 0
    bool q_is_1 = true;            // of the texture coordinates
    glm::dvec4 position_reach{0};  // the largest absolute value of each component

    // A sphere around the positions divided by w, and so around everything between them. There is none (has_sphere is
    // false) if there are no vertices or the signs of w differ.
    bool has_sphere = false;
    glm::dvec3 center_object{0};
    double radius_object = 0;
    glm::dvec3 low_object{0}, high_object{0};  // their bounding box, if there is a sphere

    bool normals_equal = true;     // to the last bit
    bool has_zero_normal = false;  // zero normals are ignored below
    double shortest_normal = 0, longest_normal = 0;
    // A cone around the normals. A half angle of pi means no useful bound.
    glm::dvec3 normal_axis_dir_object{0, 0, 1};
    double normal_half_angle = 0;  // in radians

    bool colors_equal = true;
    glm::dvec4 color_low{1}, color_high{1};  // channel by channel

    std::vector<std::uint32_t>
        materials;  // the used indices into Draw::materials, ascending, each once; empty if there are no materials
};

VertexFacts vertex_facts(const Draw& draw);

// Whether a plan by state (PlanOptions::for_any_pose) is the same with either, where matrices keep w.
bool have_one_plan_by_state(const VertexFacts& a, const VertexFacts& b);

// Whether the matrix keeps the w of positions or texture coordinates: its last row is 0, 0, 0, 1.
inline bool keeps_w(const glm::dmat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

}  // namespace twinlight

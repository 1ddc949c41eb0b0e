#include "render/effect/vertex_facts.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace twinlight {
namespace {

bool is_far(const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    return !(size.x <= kLargestLength && size.y <= kLargestLength && size.z <= kLargestLength);
}

// Centred on the middle of the positions' bounding box.
void find_sphere(const Draw& draw, VertexFacts& facts) {
    const bool negative = draw.vertices.front().position_object.w < 0;
    glm::dvec3 low(kLargestLength), high(-kLargestLength);
    for (const Vertex& v : draw.vertices) {
        const glm::dvec4& p = v.position_object;
        const glm::dvec3 divided = p.w == 1 ? glm::dvec3(p) : glm::dvec3(p) / p.w;
        if (p.w == 0 || (p.w < 0) != negative || is_far(divided)) return;
        low = glm::min(low, divided);
        high = glm::max(high, divided);
    }
    facts.has_sphere = true;
    facts.low_object = low;
    facts.high_object = high;
    facts.center_object = 0.5 * low + 0.5 * high;
    if (facts.w_is_1) facts.position_reach = glm::dvec4(glm::max(glm::abs(low), glm::abs(high)), 1);
    double square = 0;
    for (const Vertex& v : draw.vertices) {
        const glm::dvec4& p = v.position_object;
        const glm::dvec3 from_center = (p.w == 1 ? glm::dvec3(p) : glm::dvec3(p) / p.w) - facts.center_object;
        square = std::max(square, glm::dot(from_center, from_center));
    }
    facts.radius_object =
        std::sqrt(square) + kBoundsRounding * (std::sqrt(square) + glm::length(facts.center_object)) + kSmallestLength;
}

// The axis is the direction of the sum of the unit normals.
void find_normal_cone(const Draw& draw, VertexFacts& facts) {
    double shortest = kLargestLength, longest = 0;
    glm::dvec3 sum(0);
    bool ordinary = true;
    for (const Vertex& v : draw.vertices) {
        const glm::dvec3& n = v.normal_object;
        facts.normals_equal = facts.normals_equal && n == draw.vertices.front().normal_object;
        if (n == glm::dvec3(0)) {
            facts.has_zero_normal = true;
            continue;
        }
        const double length = glm::length(n);
        ordinary = ordinary && length > kSmallestLength && length < kLargestLength;
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        sum += n / length;
    }
    if (longest == 0 && ordinary) return;  // no normal is other than 0
    facts.normal_half_angle = std::numbers::pi;
    facts.shortest_normal = shortest;
    facts.longest_normal = ordinary ? longest : std::numeric_limits<double>::infinity();
    const double size = glm::length(sum);
    if (!ordinary || !(size > 1e-6)) return;
    facts.normal_axis_dir_object = sum / size;
    double cosine = 1;
    for (const Vertex& v : draw.vertices) {
        const glm::dvec3& n = v.normal_object;
        if (n != glm::dvec3(0)) cosine = std::min(cosine, glm::dot(n, facts.normal_axis_dir_object) / glm::length(n));
    }
    // acos near 1 loses half of the digits.
    facts.normal_half_angle = std::acos(std::max(cosine - kBoundsRounding, -1.0));
}

void find_colors(const Draw& draw, VertexFacts& facts) {
    glm::dvec4 low = draw.vertices.front().color, high = low;
    for (const Vertex& v : draw.vertices) {
        low = glm::min(low, v.color);
        high = glm::max(high, v.color);
    }
    facts.color_low = low;
    facts.color_high = high;
    facts.colors_equal = facts.color_low == facts.color_high;
}

void find_materials(const Draw& draw, VertexFacts& facts) {
    if (draw.materials.empty()) return;
    std::vector<bool> used(draw.materials.size());
    for (const Vertex& v : draw.vertices) used.at(v.material) = true;
    for (std::uint32_t i = 0; i < used.size(); ++i)
        if (used[i]) facts.materials.push_back(i);
}

}  // namespace

VertexFacts vertex_facts(const Draw& draw) {
    VertexFacts facts;
    if (draw.vertices.empty()) return facts;
    bool w_is_1 = true, q_is_1 = true;
    for (const Vertex& v : draw.vertices) {
        w_is_1 &= v.position_object.w == 1;
        q_is_1 &= v.tex_coord.q == 1;
    }
    facts.w_is_1 = w_is_1;
    facts.q_is_1 = q_is_1;
    if (!facts.w_is_1)
        for (const Vertex& v : draw.vertices) facts.has_w_0 = facts.has_w_0 || v.position_object.w == 0;
    find_sphere(draw, facts);
    if (!facts.has_sphere || !facts.w_is_1)
        for (const Vertex& v : draw.vertices)
            facts.position_reach = glm::max(facts.position_reach, glm::abs(v.position_object));
    find_normal_cone(draw, facts);
    find_colors(draw, facts);
    find_materials(draw, facts);
    return facts;
}

bool have_one_plan_by_state(const VertexFacts& a, const VertexFacts& b) {
    return a.w_is_1 == b.w_is_1 && a.has_w_0 == b.has_w_0 && a.q_is_1 == b.q_is_1 &&
           a.normals_equal == b.normals_equal && a.colors_equal == b.colors_equal && a.color_low == b.color_low &&
           a.color_high == b.color_high && a.materials == b.materials;
}

}  // namespace twinlight

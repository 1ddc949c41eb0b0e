#include "render/programmable/joined_draws.h"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <span>

#include "base/math/normal_matrix.h"
#include "render/effect/vertex_facts.h"

namespace twinlight::programmable {
namespace {

// 2.14.3: a material without the colours that the vertices' colours replace.
Material without_tracked(Material material, const ColorMaterial& tracking, Enum other_face) {
    if (!tracking.enabled || tracking.face == other_face) return material;
    const Material initial;
    const bool both = tracking.mode == kGL_AMBIENT_AND_DIFFUSE;
    if (tracking.mode == kGL_EMISSION) material.emission = initial.emission;
    if (tracking.mode == kGL_AMBIENT || both) material.ambient = initial.ambient;
    if (tracking.mode == kGL_DIFFUSE || both) material.diffuse = initial.diffuse;
    if (tracking.mode == kGL_SPECULAR) material.specular = initial.specular;
    return material;
}

// Except for the materials.
bool have_one_lighting(const LightingState& a, const LightingState& b) {
    if (a.enabled != b.enabled || a.shade_model != b.shade_model) return false;
    return !a.enabled ||
           (a.color_material == b.color_material && a.normalize == b.normalize &&
            a.rescale_normal == b.rescale_normal && a.light_model == b.light_model && a.lights == b.lights);
}

// Of Draws whose vertices have no materials of their own. a and b have one colour material.
bool have_one_material(const LightingState& a, const LightingState& b) {
    const auto is_same = [&](Material LightingState::*face, Enum other_face) {
        return a.*face == b.*face ||
               (a.color_material.enabled && without_tracked(a.*face, a.color_material, other_face) ==
                                                without_tracked(b.*face, b.color_material, other_face));
    };
    return !a.enabled || (is_same(&LightingState::front, kGL_BACK) && is_same(&LightingState::back, kGL_FRONT));
}

// Points, lines and polygons differ in which effects they need.
int kind_of(Enum mode) { return draws_polygons(mode) ? 2 : mode == kGL_POINTS ? 0 : 1; }

bool is_known_to_be_one_state(const Draw& a, const Draw& b) {
    return a.state_number != 0 && a.state_number == b.state_number;
}

// Whether all values of its vertices are in Draw::vertices.
bool has_only_vertices(const Draw& draw) { return draw.further_units.empty() && draw.columns.empty() && !draw.pixels; }

}  // namespace

std::size_t count_vertices(DrawRun draws) {
    std::size_t count = 0;
    for (const Draw* draw : draws) count += draw->vertices.size();
    return count;
}

bool have_one_state(const Draw& a, const Draw& b) {
    const bool is_known = is_known_to_be_one_state(a, b);
    // First what mostly differs.
    return (is_known || a.eye_from_object == b.eye_from_object) && have_one_state_anywhere(a, b);
}

bool have_one_state_anywhere(const Draw& a, const Draw& b) {
    return have_one_state_when_placed(a, b) && a.materials == b.materials &&
           (is_known_to_be_one_state(a, b) || have_one_material(a.lighting, b.lighting));
}

bool have_one_state_when_placed(const Draw& a, const Draw& b) {
    return kind_of(a.mode) == kind_of(b.mode) && a.indices.empty() == b.indices.empty() && !needs_edge_flags(a) &&
           !needs_edge_flags(b) && has_only_vertices(a) && has_only_vertices(b) &&
           (is_known_to_be_one_state(a, b) ||
            (a.raster == b.raster && have_one_lighting(a.lighting, b.lighting) && a.clip_from_eye == b.clip_from_eye &&
             a.texture == b.texture && a.fog == b.fog && a.fragment == b.fragment));
}

namespace {

void append(const Draw& draw, JoinedDraws& all) {
    all.parts.push_back(part_of(draw));
    const auto first = static_cast<std::uint32_t>(all.draw.vertices.size());
    std::vector<Vertex>& vertices = all.draw.vertices.edit();
    vertices.insert(vertices.end(), draw.vertices.begin(), draw.vertices.end());
    if (draw.indices.empty()) return;
    std::vector<std::uint32_t>& indices = all.draw.indices.edit();
    for (const std::uint32_t index : draw.indices) indices.push_back(first + index);
}

// For normals in eye coordinates. There GL_RESCALE_NORMAL's factor (2.11.3) is 1, so it is included.
glm::dmat3 placed_normal_matrix(const Draw& draw) {
    const glm::dmat3 normals = normal_matrix(glm::dmat3(draw.eye_from_object));
    const double third = glm::length(normals[2]);
    return draw.lighting.rescale_normal && third > 0 ? normals / third : normals;
}

// Adds the Draw's materials, unless they are there already. Returns the place of the first.
std::uint32_t add_material(const Draw& draw, std::vector<Materials>& materials) {
    const auto add = [&](const Materials& one) {
        const ColorMaterial& tracking = draw.lighting.color_material;
        materials.push_back(
            {without_tracked(one.front, tracking, kGL_BACK), without_tracked(one.back, tracking, kGL_FRONT)});
    };
    const auto next = static_cast<std::uint32_t>(materials.size());
    for (const Materials& one : draw.materials) add(one);
    if (!draw.materials.empty()) return next;
    add({draw.lighting.front, draw.lighting.back});
    // Most neighbours have one of a few materials.
    constexpr std::uint32_t kFew = 8;
    std::uint32_t known = next - std::min(next, kFew);
    while (materials[known] != materials[next]) ++known;
    if (known != next) materials.pop_back();
    return known;
}

}  // namespace

JoinedDraws joined(DrawRun run) {
    JoinedDraws all{.draw = *run.front(), .parts = {}};
    all.draw.vertices = {};
    all.draw.indices = {};
    for (const Draw* draw : run) append(*draw, all);
    return all;
}

bool may_be_placed(DrawRun run) {
    const Draw& draw = *run.front();
    return count_vertices(run) <= kMostPlacedVertices && keeps_w(draw.eye_from_object) &&
           draw.texture.generated.empty() && !needs_edge_flags(draw) && has_only_vertices(draw);
}

namespace {

bool tests_for_equal_depth(const Draw& draw) {
    const Enum func = draw.raster.depth_func;
    return draw.raster.depth_test &&
           (func == kGL_EQUAL || func == kGL_LEQUAL || func == kGL_GEQUAL || func == kGL_NOTEQUAL);
}

// A hash of its place and of its first vertex: equal if it is drawn again, even as another primitive.
std::size_t place_key(const Draw& draw) {
    const glm::dvec4 place = draw.eye_from_object * draw.vertices[0].position_object;
    std::size_t key = 0;
    for (int i = 0; i < 4; ++i) key = (key ^ std::hash<double>()(place[i])) * 0x9E3779B97F4A7C15U;
    return key;
}

}  // namespace

DepthRepeats::DepthRepeats(const Frame& frame) {
    const std::vector<const Draw*> draws = frame.draws();
    if (std::ranges::none_of(draws, [](const Draw* draw) { return tests_for_equal_depth(*draw); })) return;
    std::unordered_set<std::size_t> seen;
    for (const Draw* draw : draws)
        if (!draw->vertices.empty() && draw->vertices.size() <= kMostPlacedVertices) {
            const std::size_t key = place_key(*draw);
            if (!seen.insert(key).second) repeated_.insert(key);
        }
}

bool DepthRepeats::contains_any_of(DrawRun run) const {
    return !repeated_.empty() &&
           std::ranges::any_of(run, [&](const Draw* draw) { return repeated_.contains(place_key(*draw)); });
}

JoinedDraws placed_together(DrawRun draws) {
    JoinedDraws all{.draw = *draws.front(), .parts = {}};
    all.draw.vertices = {};
    all.draw.indices = {};
    all.draw.materials.clear();
    all.draw.eye_from_object = glm::dmat4(1);
    const LightingState& lighting = all.draw.lighting;
    glm::dmat3 eye_from_object_normal(1);
    const Draw* last = nullptr;
    for (const Draw* draw : draws) {
        append(*draw, all);
        if (!last || glm::dmat3(last->eye_from_object) != glm::dmat3(draw->eye_from_object))
            eye_from_object_normal = placed_normal_matrix(*draw);
        last = draw;
        const std::uint32_t material = lighting.enabled ? add_material(*draw, all.draw.materials) : 0;
        for (Vertex& vertex : std::span(all.draw.vertices.edit()).last(draw->vertices.size())) {
            vertex.position_object = draw->eye_from_object * vertex.position_object;
            vertex.normal_object = eye_from_object_normal * vertex.normal_object;
            vertex.material += material;
        }
    }
    if (!lighting.enabled) return all;
    all.draw.lighting.front = all.draw.materials.front().front;
    all.draw.lighting.back = all.draw.materials.front().back;
    return all;
}

}  // namespace twinlight::programmable

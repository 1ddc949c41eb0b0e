#include "render/programmable/joined_draws.h"

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

bool have_one_lighting(const LightingState& a, const LightingState& b) {
    if (a.enabled != b.enabled || a.shade_model != b.shade_model) return false;
    if (!a.enabled) return true;
    const auto have_one_material = [&](Material LightingState::*face, Enum other_face) {
        return a.*face == b.*face ||
               (a.color_material.enabled && without_tracked(a.*face, a.color_material, other_face) ==
                                                without_tracked(b.*face, b.color_material, other_face));
    };
    return a.color_material == b.color_material && have_one_material(&LightingState::front, kGL_BACK) &&
           have_one_material(&LightingState::back, kGL_FRONT) && a.normalize == b.normalize &&
           a.rescale_normal == b.rescale_normal && a.light_model == b.light_model && a.lights == b.lights;
}

// Points, lines and polygons differ in which effects they need.
int kind_of(Enum mode) { return draws_polygons(mode) ? 2 : mode == kGL_POINTS ? 0 : 1; }

// Whether all values of its vertices are in Draw::vertices.
bool has_only_vertices(const Draw& draw) {
    return draw.further_units.empty() && draw.secondary_colors.empty() && draw.fog_coords.empty() && !draw.pixels;
}

}  // namespace

bool have_one_state(const Draw& a, const Draw& b) {
    return a.eye_from_object == b.eye_from_object && kind_of(a.mode) == kind_of(b.mode) &&
           a.indices.empty() == b.indices.empty() && !a.draws_borders() && a.raster == b.raster &&
           have_one_lighting(a.lighting, b.lighting) && a.clip_from_eye == b.clip_from_eye && a.texture == b.texture &&
           has_only_vertices(a) && has_only_vertices(b) && a.fog == b.fog && a.fragment == b.fragment &&
           a.materials == b.materials;
}

JoinedDraws joined(DrawRun run) {
    JoinedDraws all{.draw = *run.front(), .parts = {}};
    all.parts.push_back(part_of(*run.front()));
    std::vector<Vertex>& vertices = all.draw.vertices.edit();
    std::vector<std::uint32_t>& indices = all.draw.indices.edit();
    for (const Draw* draw : run.subspan(1)) {
        all.parts.push_back(part_of(*draw));
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), draw->vertices.begin(), draw->vertices.end());
        for (const std::uint32_t index : draw->indices) indices.push_back(first + index);
    }
    return all;
}

}  // namespace twinlight::programmable

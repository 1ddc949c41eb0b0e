#include "judge/study/lighting_change.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace twinlight::study {

namespace {

template <class Change>
void for_materials(Draw& draw, const Change& change) {
    for (Material* material : {&draw.lighting.front, &draw.lighting.back}) change(*material);
    for (Materials& materials : draw.materials)
        for (Material* material : {&materials.front, &materials.back}) change(*material);
}

template <class Change>
void for_lights(Draw& draw, const Change& change) {
    for (LightSource& light : draw.lighting.lights)
        if (light.enabled) change(light);
}

template <class Is>
bool any_light(const Draw& draw, const Is& is) {
    return std::ranges::any_of(draw.lighting.lights,
                               [&](const LightSource& light) { return light.enabled && is(light); });
}

bool shines(const Draw& draw) {
    const auto is_seen = [](const Material& material) { return glm::dvec3(material.specular) != glm::dvec3(0); };
    return is_seen(draw.lighting.front) || is_seen(draw.lighting.back) ||
           std::ranges::any_of(draw.materials, [&](const Materials& materials) {
               return is_seen(materials.front) || is_seen(materials.back);
           });
}

bool is_place(const LightSource& light) { return !light.is_directional(); }

// The middle of a round shape is the origin of its object space, for all of its parts.
glm::dvec3 middle_eye(const Draw& draw) {
    glm::dvec4 sum(0);
    for (const Vertex& vertex : draw.vertices) sum += vertex.position_object;
    const glm::dvec4 middle = draw.eye_from_object * (draw.surfaces ? glm::dvec4(0, 0, 0, 1) : sum);
    return middle.w == 0 ? glm::dvec3(0) : glm::dvec3(middle) / middle.w;
}

void make_directional(Draw& draw) {
    for_lights(draw, [&](LightSource& light) {
        if (!is_place(light)) return;
        const glm::dvec3 way = glm::dvec3(light.position_eye) / light.position_eye.w - middle_eye(draw);
        light.position_eye = glm::dvec4(glm::dot(way, way) == 0 ? glm::dvec3(0, 0, 1) : way, 0);
    });
}

void set_specular(Draw& draw, Word specular, double of_exponent) {
    draw.lighting.light_model.specular = specular;
    for_materials(draw, [&](Material& material) { material.shininess *= of_exponent; });
}

// Whether rescaled normals have length 1 (2.11.3): the matrix scales equally in all directions, and the normals have
// length 1.
bool rescaling_normalizes(const Draw& draw) {
    constexpr double kRounding = 1e-5;  // matrices and normals may come from floats
    const glm::dmat3 m(draw.eye_from_object);
    const glm::dmat3 square = glm::transpose(m) * m;
    const double scale = square[0][0];
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(square[column][row] - (column == row ? scale : 0)) > kRounding * scale) return false;
    return std::ranges::all_of(draw.vertices, [](const Vertex& vertex) {
        return std::abs(glm::length(vertex.normal_object) - 1) <= kRounding;
    });
}

constexpr LightingChangeRow kChanges[] = {
    {LightingChange::kWhole, "whole", "as in the scene", [](const Draw&) { return true; }, [](Draw&) {}},
    {LightingChange::kNoSpecular, "no-specular", "no highlights", shines,
     [](Draw& draw) { for_materials(draw, [](Material& material) { material.specular = glm::dvec4(0, 0, 0, 1); }); }},
    {LightingChange::kReflection, "reflection", "highlights by reflection vector",
     [](const Draw& draw) { return shines(draw) && draw.lighting.light_model.specular == Word::half_vector; },
     [](Draw& draw) { set_specular(draw, Word::reflection, kReflectionExponent); }},
    {LightingChange::kHalfVector, "half-vector", "highlights by half vector",
     [](const Draw& draw) { return shines(draw) && draw.lighting.light_model.specular == Word::reflection; },
     [](Draw& draw) { set_specular(draw, Word::half_vector, 1 / kReflectionExponent); }},
    {LightingChange::kDistantViewer, "distant-viewer", "distant viewer",
     [](const Draw& draw) { return draw.lighting.light_model.local_viewer && shines(draw); },
     [](Draw& draw) { draw.lighting.light_model.local_viewer = false; }},
    {LightingChange::kDirectional, "directional", "directional lights",
     [](const Draw& draw) { return any_light(draw, is_place); }, make_directional},
    {LightingChange::kNoAttenuation, "no-attenuation", "no attenuation",
     [](const Draw& draw) { return any_light(draw, [](const LightSource& light) { return light.is_attenuated(); }); },
     [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.clear_attenuation(); }); }},
    {LightingChange::kNoSpots, "no-spots", "no spotlight cones",
     [](const Draw& draw) { return any_light(draw, [](const LightSource& light) { return light.is_spot(); }); },
     [](Draw& draw) {
         for_lights(draw, [](LightSource& light) {
             light.spot_cutoff_deg = 180;
             light.smooth_cone.reset();
         });
     }},
    {LightingChange::kRescale, "rescale", "rescaled normals", [](const Draw& draw) { return draw.lighting.normalize; },
     [](Draw& draw) {
         draw.lighting.rescale_normal |= draw.lighting.normalize;
         draw.lighting.normalize = false;
     }},
    {LightingChange::kNoNormalize, "no-normalize", "unnormalised normals",
     [](const Draw& draw) { return draw.lighting.normalize || draw.lighting.rescale_normal; },
     [](Draw& draw) { draw.lighting.normalize = draw.lighting.rescale_normal = false; }},
};

const LightingChangeRow& row_of(LightingChange change) {
    return *std::ranges::find(kChanges, change, &LightingChangeRow::value);
}

}  // namespace

std::span<const LightingChangeRow> lighting_changes() { return kChanges; }

bool matters(const Frame& frame, LightingChange change) {
    bool any = false;
    for (const Draw* draw : frame.draws()) {
        if (!draw->lighting.enabled) continue;
        const bool here = row_of(change).matters(*draw);
        if (here && change == LightingChange::kRescale && !rescaling_normalizes(*draw)) return false;
        any |= here;
    }
    return any;
}

Frame with_lighting_change(const Frame& frame, LightingChange change) {
    Frame result = frame;
    for (Draw* draw : result.editable_draws())
        if (draw->lighting.enabled) row_of(change).apply(*draw);
    return result;
}

}  // namespace twinlight::study

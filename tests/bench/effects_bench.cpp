// What each effect costs where it is called for: the vertex stage and a picture with all of them, and with one that is not
// called for. docs/effects.md has the table.
#include <fmt/format.h>

#include <glm/common.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lit_spheres.h"
#include "ratios.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "ways.h"

namespace twinlight::bench::effects_bench {
namespace {

constexpr int kLights = 4;
constexpr int kSide = 512;  // of the pictures

glm::dvec4 gray(double value) { return {value, value, value, 1}; }

// Everything that a vertex can call for, but for what kAdditions adds.
Draw all_effects() {
    Draw draw = sphere(512, 256);
    LightingState& lighting = draw.lighting;
    lighting.enabled = lighting.normalize = true;
    lighting.light_model.local_viewer = lighting.light_model.two_side = true;
    lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    for (Material* material : {&lighting.front, &lighting.back}) {
        material->specular = gray(0.5);
        material->shininess = 32.5;
    }
    for (int i = 0; i < kLights; ++i) {
        LightSource& light = lighting.lights[static_cast<std::size_t>(i)];
        light = LightSource{};
        light.enabled = true;
        light.ambient = gray(0.1);
        light.diffuse = light.specular = gray(0.5);
        light.position_eye = {2 - i, 3, -2 + 0.5 * i, 1};
        light.spot_direction_eye = glm::dvec3(0, 0, -5) - glm::dvec3(light.position_eye);
        light.spot_cutoff_deg = 40;
        light.spot_exponent = 2.5;
        light.linear_attenuation = light.quadratic_attenuation = 0.1;
    }
    for (Vertex& vertex : draw.vertices.edit()) vertex.normal_object *= 2;
    return draw;
}

// What fragments can call for, lit one by one.
Draw all_effects_of_fragments() {
    const std::vector<LitScene> scenes = seven_scenes(sphere(3, 2));
    Draw draw = on_dome(scenes[1].draw, kSide);  // three kinds of lights
    draw.lighting.light_model.two_side = true;
    draw.lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    draw.lighting.front.emission = draw.lighting.back.emission = gray(0.5);
    auto texture = std::make_shared<Texture>(*scenes.back().draw.texture.texture);
    texture->wrap_s = texture->wrap_t = kGL_CLAMP;
    texture->min_filter = kGL_LINEAR;
    texture->mag_filter = kGL_NEAREST;
    draw.texture.texture = std::move(texture);
    draw.texture.texture_matrix[0][0] = 1.5;
    for (Vertex& vertex : draw.vertices.edit()) vertex.tex_coord.w = 1.5 + 0.5 * vertex.position_object.x;
    draw.fog = {.enabled = true, .mode = kGL_EXP2, .density = 0.2};
    draw.raster.clip_planes_eye[0] = glm::dvec4(0, 0, -1, 0);  // cuts nothing off
    return draw;
}

using Change = void (*)(Draw& draw);

struct Effect {
    const char* name;
    Change change;                           // leaves it out, or adds it
    Change prepare = [](Draw& /*draw*/) {};  // both what has it and what does not
};

void for_lights(Draw& draw, void (*change)(LightSource& light)) {
    for (LightSource& light : draw.lighting.lights) change(light);
}

void for_materials(Draw& draw, void (*change)(Material& material)) {
    for (Material* material : {&draw.lighting.front, &draw.lighting.back}) change(*material);
}

constexpr Effect kOfVertices[] = {
    {"lighting", [](Draw& draw) { draw.lighting.enabled = false; }},
    {"a light of four", [](Draw& draw) { draw.lighting.lights[3].enabled = false; }},
    {"attenuation",
     [](Draw& draw) {
         for_lights(draw, [](LightSource& light) { light.linear_attenuation = light.quadratic_attenuation = 0; });
     }},
    {"the cone", [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.spot_cutoff_deg = 180; }); }},
    {"the cone's fall-off", [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.spot_exponent = 0; }); }},
    {"a fraction in the cone's exponent",
     [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.spot_exponent = 2; }); }},
    {"a place (the lights directional)",
     [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.position_eye.w = 0; }); }},
    {"ambient terms", [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.ambient = gray(0); }); }},
    {"diffuse terms", [](Draw& draw) { for_lights(draw, [](LightSource& light) { light.diffuse = gray(0); }); }},
    {"specular terms",
     [](Draw& draw) { for_materials(draw, [](Material& material) { material.specular = gray(0); }); }},
    {"the highlight's power",
     [](Draw& draw) { for_materials(draw, [](Material& material) { material.shininess = 0; }); }},
    {"a fraction in the shininess",
     [](Draw& draw) { for_materials(draw, [](Material& material) { material.shininess = 32; }); }},
    {"the local viewer", [](Draw& draw) { draw.lighting.light_model.local_viewer = false; }},
    {"separate specular colour", [](Draw& draw) { draw.lighting.light_model.color_control = kGL_SINGLE_COLOR; }},
    {"two sides", [](Draw& draw) { draw.lighting.light_model.two_side = false; }},
    {"GL_NORMALIZE",
     [](Draw& draw) {
         for (Vertex& vertex : draw.vertices.edit()) vertex.normal_object /= 2;
     }},
};

constexpr Effect kAdditions[] = {
    {"a division by w", [](Draw& draw) { draw.eye_from_object[3][3] = 1.1; }},
    {"colour material",
     [](Draw& draw) {
         draw.lighting.color_material.enabled = true;
         for (Vertex& vertex : draw.vertices.edit()) vertex.color = gray(0.5 + 0.4 * vertex.position_object.x);
     }},
    {"materials of vertices",
     [](Draw& draw) {
         Materials other{draw.lighting.front, draw.lighting.back};
         other.front.diffuse = other.back.diffuse = gray(0.3);
         draw.materials = {{draw.lighting.front, draw.lighting.back}, other};
         for (Vertex& vertex : draw.vertices.edit()) vertex.material = vertex.position_object.y > 0 ? 1 : 0;
     }},
};

void make_directional(Draw& draw) {
    for_lights(draw, [](LightSource& light) {
        light.position_eye = {1, 1, 1, 0};
        light.spot_cutoff_deg = 180;
    });
    draw.lighting.light_model.local_viewer = false;
}

constexpr Effect kOfFragments[] = {
    {"lighting of fragments: equal normals",
     [](Draw& draw) {
         for (Vertex& vertex : draw.vertices.edit()) vertex.normal_object = {0, 0, 1};
     },
     make_directional},
    {"two sides", [](Draw& draw) { draw.lighting.light_model.two_side = false; }},
    {"separate specular colour", [](Draw& draw) { draw.lighting.light_model.color_control = kGL_SINGLE_COLOR; }},
    {"the clamp",
     [](Draw& draw) {
         for_materials(draw, [](Material& material) {
             material.emission = gray(0);
             material.diffuse = material.specular = gray(0.2);
         });
     }},
    {"the texture", [](Draw& draw) { draw.texture.texture = nullptr; }},
    {"the texture matrix", [](Draw& draw) { draw.texture.texture_matrix = glm::dmat4(1); }},
    {"a division by q",
     [](Draw& draw) {
         for (Vertex& vertex : draw.vertices.edit()) vertex.tex_coord.w = 1;
     }},
    {"GL_CLAMP",
     [](Draw& draw) {
         auto texture = std::make_shared<Texture>(*draw.texture.texture);
         texture->wrap_s = texture->wrap_t = kGL_CLAMP_TO_EDGE;
         draw.texture.texture = std::move(texture);
     }},
    {"fog", [](Draw& draw) { draw.fog.enabled = false; }},
    {"a clip plane", [](Draw& draw) { draw.raster.clip_planes_eye[0].reset(); }},
};

// Times are with and without: the ratio is how many times as long it takes with the effect.
void compare_effect(Results& results, const Effect& effect, const Frame& with, const Frame& without,
                    const std::optional<Shading>& shading) {
    std::vector<Way> ways = {shader_way("shaders, with", with, programmable::Tier::kUniform, true, shading),
                             shader_way("shaders, without", without, programmable::Tier::kUniform, true, shading)};
    if (!shading) {
        ways.push_back(fixed_way("fixed, with", with, fixed::Scrub::kState, true));
        ways.push_back(fixed_way("fixed, without, as told", without, fixed::Scrub::kNothing, true));
        ways.push_back(fixed_way("fixed, without, scrubbed", without, fixed::Scrub::kState, true));
    }
    const std::vector<Timed> times = results.compare(effect.name, ways);
    std::string sums = fmt::format("    shaders {:.2f} x", times_faster(times[1], times[0]));
    if (!shading) sums += fmt::format(", fixed {:.2f} x", times_faster(times[4], times[2]));
    results.remark(sums);
}

void compare_effects(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    glEnable(GL_RASTERIZER_DISCARD);
    for (const Effect& effect : kOfVertices) {
        Draw draw = all_effects();
        effect.prepare(draw);
        const Frame with = frame_of(draw);
        effect.change(draw);
        compare_effect(results, effect, with, frame_of(draw), {});
    }
    for (const Effect& effect : kAdditions) {
        Draw draw = all_effects();
        const Frame without = frame_of(draw);
        effect.change(draw);
        compare_effect(results, effect, frame_of(draw), without, {});
    }
    glDisable(GL_RASTERIZER_DISCARD);
    for (const Effect& effect : kOfFragments) {
        Draw draw = all_effects_of_fragments();
        effect.prepare(draw);
        const Frame with = frame_of(draw, kSide);
        effect.change(draw);
        compare_effect(results, effect, with, frame_of(draw, kSide), Shading::kPhong);
    }
}

const bool added = add_part("effects", compare_effects);

}  // namespace
}  // namespace twinlight::bench::effects_bench

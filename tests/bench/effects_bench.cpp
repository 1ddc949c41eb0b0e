// What each effect costs where it is called for: the vertex stage with all of them, and with one that is not called for.
// docs/effects.md has the table.
#include <glm/common.hpp>
#include <memory>
#include <vector>

#include "context/context.h"
#include "context/gl.h"
#include "lit_spheres.h"
#include "ratios.h"
#include "ways.h"

namespace twinlight::bench {
namespace {

constexpr int kSide = 64;
constexpr int kLights = 4;

glm::dvec4 gray(double value) { return {value, value, value, 1}; }

// Everything that a vertex can call for, but for colour material, which is an addition.
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
    for (Vertex& vertex : draw.vertices) vertex.normal_object *= 2;
    return draw;
}

struct Effect {
    const char* name;
    void (*leave_out)(Draw& draw);
};

void for_lights(Draw& draw, void (*change)(LightSource& light)) {
    for (LightSource& light : draw.lighting.lights) change(light);
}

void for_materials(Draw& draw, void (*change)(Material& material)) {
    for (Material* material : {&draw.lighting.front, &draw.lighting.back}) change(*material);
}

constexpr Effect kEffects[] = {
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
         for (Vertex& vertex : draw.vertices) vertex.normal_object /= 2;
     }},
};

// Times are with and without: the ratio is how many times as long it takes with the effect.
void compare_effects(Results& results) {
    const auto context = make_offscreen_context(kSide, kSide);
    glEnable(GL_RASTERIZER_DISCARD);
    const Frame with = frame_of(all_effects());
    for (const Effect& effect : kEffects) {
        Draw draw = all_effects();
        effect.leave_out(draw);
        const Frame without = frame_of(draw);
        const std::vector<Timed> times =
            results.compare(effect.name, {fixed_way("fixed, with", with, fixed::Scrub::kNothing, true),
                                          fixed_way("fixed, without, as told", without, fixed::Scrub::kNothing, true),
                                          fixed_way("fixed, without, scrubbed", without, fixed::Scrub::kState, true),
                                          shader_way("shaders, with", with, Tier::kUniform, true),
                                          shader_way("shaders, without", without, Tier::kUniform, true)});
        results.remark("    fixed " + std::to_string(times_faster(times[2], times[0])) + " x, shaders " +
                       std::to_string(times_faster(times[4], times[3])) + " x");
    }
}

const bool added = add_part("effects", compare_effects);

}  // namespace
}  // namespace twinlight::bench

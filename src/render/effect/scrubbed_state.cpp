#include "render/effect/scrubbed_state.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>

namespace twinlight {
namespace {

glm::dvec4 with_rgb(const glm::dvec3& rgb, const glm::dvec4& color) { return {rgb, color.a}; }

// The light with its constant attenuation and spot factors multiplied into its colours.
LightSource scrubbed_light(const Plan& plan, std::size_t i) {
    LightSource light = plan.lighting.lights[static_cast<std::size_t>(plan.lights[i].number)];
    const LightEffects& effects = plan.effects.lights[i];
    light.ambient = with_rgb(effects.ambient ? glm::dvec3(light.ambient) : glm::dvec3(0), light.ambient);
    if (!effects.attenuated) {
        const double reach = plan.lights[i].constant_reach;
        for (glm::dvec4* color : {&light.ambient, &light.diffuse, &light.specular})
            *color = with_rgb(reach * glm::dvec3(*color), *color);
        for (LightSource::Illuminant* illuminant : {&light.diffuse_illuminant, &light.specular_illuminant})
            illuminant->scale *= reach;
        light.clear_attenuation();
    }
    if (effects.cone != SpotCone::kGl) light.spot_cutoff_deg = 180;
    light.enabled = true;
    return light;
}

}  // namespace

ScrubbedState scrubbed_state(const Plan& plan, std::size_t most_lights) {
    ScrubbedState state{.lighting = plan.lighting, .lights_beyond = {}};
    LightingState& lighting = state.lighting;
    const EffectSet& effects = plan.effects;
    lighting.enabled = effects.lighting;
    lighting.lights.clear();
    if (!effects.lighting) return state;

    // Keeps the lights that may add most, in their own order, because GL sums in that order.
    const auto bound = [&](std::size_t i) {
        return plan.light_bounds.at(static_cast<std::size_t>(plan.lights[i].number)).largest();
    };
    std::vector<std::size_t> order(plan.lights.size());
    std::iota(order.begin(), order.end(), 0);
    if (order.size() > most_lights) {
        std::ranges::stable_sort(order, std::greater<>(), bound);
        glm::dvec3 sum(0);
        for (const std::size_t i : std::span(order).subspan(most_lights)) {
            state.lights_beyond.push_back(plan.lights[i].number);
            sum += plan.light_bounds[static_cast<std::size_t>(plan.lights[i].number)].bound;
        }
        state.bound_beyond = std::max({sum.r, sum.g, sum.b});
        order.resize(most_lights);
        std::ranges::sort(order);
    }
    for (const std::size_t i : order) lighting.lights.push_back(scrubbed_light(plan, i));
    LightModel& model = lighting.light_model;
    model.ambient = with_rgb(plan.constant_ambient, model.ambient);
    model.two_side = effects.two_side;
    model.local_viewer = effects.local_viewer;
    if (!effects.separate_specular) model.color_control = kGL_SINGLE_COLOR;
    if (!effects.any_light(&LightEffects::specular)) lighting.front.shininess = lighting.back.shininess = 0;
    lighting.color_material.enabled = effects.front.tracks() || effects.back.tracks();
    lighting.normalize = effects.normalize;
    if (!effects.needs_normal()) lighting.rescale_normal = false;
    return state;
}

Frame scrubbed_frame(const Frame& frame, const PlanOptions& options) {
    Frame result = frame;
    for (Draw* draw : result.editable_draws()) {
        if (!draw->lighting.enabled) continue;
        const Plan plan = plan_effects(*draw, options);
        const ColorMaterial tracking = draw->lighting.color_material;
        draw->lighting = scrubbed_state(plan, plan.lights.size()).lighting;
        if (draw->materials.empty()) continue;
        if (plan.effects.front.varies() || plan.effects.back.varies())
            draw->lighting.color_material =
                tracking;  // a colour that all vertices share is only in the plan's material
        else
            draw->materials.clear();
    }
    return result;
}

}  // namespace twinlight

// Detects the lectures' variants of lighting. GL lacks them: shaders and the reference draw them, the fixed function
// cannot.
#pragma once

#include <algorithm>

#include "scene/frame/frame.h"

namespace twinlight {

inline bool has_variants(const Draw& draw) {
    const LightingState& state = draw.lighting;
    const LightModel& model = state.light_model;
    return model.specular != LightModel{}.specular || model.light_ambient != LightModel{}.light_ambient ||
           model.spectrum || draw.fragment.srgb_coded || state.lights.size() > kMaxLights ||
           std::ranges::any_of(state.lights, [](const LightSource& light) { return light.smooth_cone.has_value(); });
}

inline bool has_variants(const Frame& frame) {
    return std::ranges::any_of(frame.items, [](const auto& item) {
        const Draw* draw = std::get_if<Draw>(&item);
        return draw && has_variants(*draw);
    });
}

}  // namespace twinlight

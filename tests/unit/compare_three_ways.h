// A scene, drawn by all three renderers in a context of its own size, and compared.
#pragma once

#include "judge/compare/comparison.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"

namespace twinlight {

inline compare::Comparison compare_three_ways(const Scene& scene, Shading per_pixel = Shading::kPhong) {
    const auto context = make_offscreen_context(scene.frame.width, scene.frame.height);
    programmable::Renderer shaders;
    const compare::Renderers renderers = {
        .fixed = fixed::render,
        .programmable = [&](const Frame& frame,
                            const programmable::Options& options) { return shaders.render(frame, options); },
        .reference = reference::render,
        .allowed_difference = reference::allowed_difference,
    };
    return compare::compare_scene(scene, {.driver = driver_name(), .per_pixel = per_pixel}, renderers);
}

}  // namespace twinlight

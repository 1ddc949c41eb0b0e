// Draws built by hand, and what the planner says of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/effect/plan.h"

namespace twinlight {

inline const PlanOptions kPhong{{.shading = Shading::kPhong}};
inline const PlanOptions kGlAlone{{.shading = std::nullopt, .lecture_variants = false}};

// A triangle lit by GL_LIGHT0, white and directional, in GL's initial state: diffuse alone is called for.
inline Draw lit_triangle() {
    Draw draw;
    draw.vertices.edit().resize(3);
    draw.vertices.edit()[1].position_object = {1, 0, 0, 1};
    draw.vertices.edit()[2].position_object = {0, 1, 0, 1};
    draw.lighting.enabled = true;
    draw.lighting.lights[0].enabled = true;
    return draw;
}

inline Draw with_positional_light(Draw draw = lit_triangle()) {
    draw.lighting.lights[0].position_eye = {0, 0, 5, 1};
    return draw;
}

inline Draw with_specular_material(Draw draw = lit_triangle()) {
    draw.lighting.front.specular = {1, 1, 1, 1};
    draw.lighting.front.shininess = 32;
    return draw;
}

inline Draw with_vertex_colors(Draw draw = lit_triangle()) {
    draw.vertices.edit()[1].color = {1, 0, 0, 1};
    draw.lighting.color_material.enabled = true;
    return draw;
}

inline EffectSet facts(const Draw& draw, const PlanOptions& options = {}) {
    return plan_effects(draw, options).effects;
}

// Why `what` is left out; empty if it is not.
inline std::string reason(const Draw& draw, const std::string& what, const PlanOptions& options = {}) {
    const Plan plan = plan_effects(draw, options);
    for (const std::vector<LeftOut>& list : {plan.left_out, lights_left_out(plan)})
        for (const LeftOut& left_out : list)
            if (left_out.what == what) return left_out.why;
    return "";
}

}  // namespace twinlight

// The planner: which effects a Draw calls for, and why the others are left out.
//
// Here only that is left out which is exactly zero or identical; bounds come from a later planner.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "effect/effect_set.h"

namespace twinlight {

struct LeftOut {
    std::string what;  // "GL_LIGHT3", "GL_LIGHT0's attenuation", "two-sided lighting"
    std::string why;   // "its constant, linear and quadratic factors are 1, 0, 0"
};

struct PlannedLight {
    int number = 0;  // of GL_LIGHTi
    // The part of att_i spot_i that is the same at every vertex: a constant attenuation, a directional light's spot.
    double constant_reach = 1;
};

struct Plan {
    EffectSet effects;
    std::vector<LeftOut> left_out;

    std::vector<PlannedLight> lights;  // one for each of effects.lights
    // The ambient light that is the same at every vertex: a_cs and, of the lights whose ambient term nothing
    // weakens on its way, a_cli. Their ambient terms are called for nowhere else.
    glm::dvec3 constant_ambient{0};
    // The state in force: the Draw's, with the lecture's variants off if the options say so, and with a
    // colour that all vertices share put into the material which tracks it.
    LightingState lighting;
};

Plan plan_effects(const Draw& draw, const RenderOptions& options);

}  // namespace twinlight

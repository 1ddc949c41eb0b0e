// The parts of a plan that have a file each: the lights (plan_lights.cpp) and the fragments (plan_fragments.cpp).
#pragma once

#include <array>

#include "render/effect/bounds.h"
#include "render/effect/plan.h"

namespace twinlight {

struct LightsToPlan {
    DrawBounds bounds;
    std::array<FaceRange, 2> faces;  // in force; the back's counts with effects.two_side
    bool primary = true;             // whether the texture leaves something of the primary colour's red, green and blue
};

// Fills plan.lights, effects.lights, constant_ambient, light_bounds and error_bound, by plan.lighting and plan.budget.
// Gives what the lights that are in may add to a channel of both colours together.
ColorRange plan_lights(const LightsToPlan& what, Plan& plan);

// Adds the effects of texture, fog and clip planes to plan.effects, and to plan.left_out why the others are not there.
void plan_fragments(const Draw& draw, const VertexFacts& vertices, Plan& plan);

}  // namespace twinlight

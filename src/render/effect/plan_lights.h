// The lights of a Draw, planned: which are out because they are nothing, which because they are faint, what is called for of
// the others.
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

}  // namespace twinlight

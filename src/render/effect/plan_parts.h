// The parts of the planner: lights (plan_lights.cpp) and fragments (plan_fragments.cpp).
#pragma once

#include <array>

#include "render/effect/bounds.h"
#include "render/effect/plan.h"

namespace twinlight {

struct LightsToPlan {
    DrawBounds bounds;               // unused for any pose
    std::array<FaceRange, 2> faces;  // effective materials; the back's counts only with effects.two_side
    bool primary = true;             // false if the texture replaces the primary colour's red, green and blue
    bool for_any_pose = false;       // PlanOptions::for_any_pose
    bool has_directions = false;     // a vertex has w = 0 in eye coordinates
};

// Fills plan.lights, effects.lights, constant_ambient, light_bounds and error_bound, from plan.lighting and
// plan.budget. Returns what the kept lights may add to a channel of both colours together.
ColorRange plan_lights(const LightsToPlan& lights, Plan& plan);

// Adds texture, fog and clip planes to plan.effects, or to plan.left_out with the reason why they are not needed.
void plan_fragments(const Draw& draw, const VertexFacts& vertices, Plan& plan);

}  // namespace twinlight

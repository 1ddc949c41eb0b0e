// What happens to a Draw's fragments, planned: its texture and fog; and the user's clip planes.
#pragma once

#include "render/effect/plan.h"

namespace twinlight {

// Adds these facts to plan.effects, and to plan.left_out why the others are not there.
void plan_fragments(const Draw& draw, const VertexFacts& vertices, Plan& plan);

}  // namespace twinlight

// Scrubbed state: what of GL's state a Draw is lit with, without what cannot change its colours.
//
//   what goes                                what Mesa 22.3 does with it otherwise (ffvertex_prog.c)
//   lights that the plan leaves out          lights them, with products of 0
//   shininess, if nothing is specular        a half vector, a normalisation and a power a light and vertex
//   the local viewer, separate specular      the same
//   a constant attenuation                   a division a light and vertex
//   a directional light's cone               a power a light and vertex
//   the back of two sides                    lights it too
//   colour material, if all colours are one  multiplies the products at each vertex
//   GL_NORMALIZE                             a square root a vertex
#pragma once

#include "render/effect/plan.h"
#include "scene/state/frame.h"

namespace twinlight {

struct ScrubbedState {
    LightingState lighting;  // its lights are those that are lit, in their order: as many as were asked for at most
    // The lights that were left for those to remain, by number, and how much of a channel they may add to at most.
    std::vector<int> lights_beyond;
    double bound_beyond = 0;
};

// Of more than `most_lights` that are called for, those remain whose bounds are largest.
ScrubbedState scrubbed_state(const Plan& plan, std::size_t most_lights);

// Every Draw with the scrubbed state of its plan, and all lights that are called for. The reference draws it to show what a plan
// saves whoever simulates; the reference that others are held against has no plan.
Frame scrubbed_frame(const Frame& frame, const PlanOptions& options);

}  // namespace twinlight

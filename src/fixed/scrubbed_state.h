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

#include "effect/plan.h"
#include "state/frame.h"

namespace twinlight::fixed {

struct ScrubbedState {
    LightingState lighting;  // its lights are those that are lit, in their order: eight at most
    // The lights that were left for eight to remain, by number, and how much of a channel they may add to at most.
    std::vector<int> lights_beyond;
    double bound_beyond = 0;
};

// The plan is one with the lecture's variants off, which the fixed function does not have.
ScrubbedState scrubbed_state(const Plan& plan);

}  // namespace twinlight::fixed

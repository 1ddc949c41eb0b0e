// Scrubbed state: the GL state of a Draw without everything that cannot change its colours.
//
//   what is removed                          what Mesa 22.3 would do with it (ffvertex_prog.c)
//   lights that the plan leaves out          light them, with products of 0
//   shininess, if nothing is specular        a half vector, a normalisation and a power per light and vertex
//   the local viewer, separate specular      the same
//   a constant attenuation                   a division per light and vertex
//   a directional light's cone               a power per light and vertex
//   the back of two sides                    light it too
//   colour material, if all colours are one  multiply the products at each vertex
//   GL_NORMALIZE                             a square root per vertex
#pragma once

#include "render/effect/plan.h"
#include "scene/frame/frame.h"

namespace twinlight {

struct ScrubbedState {
    LightingState lighting;  // with only the kept lights, in their order, at most most_lights
    // The lights dropped because of the limit, by number, and the most that they may add to a channel.
    std::vector<int> lights_beyond;
    double bound_beyond = 0;
};

// If the plan needs more than `most_lights`, keeps those with the largest bounds.
ScrubbedState scrubbed_state(const Plan& plan, std::size_t most_lights);

// Every Draw with the scrubbed state of its plan, and all lights that it needs. The reference draws this to show what a
// plan saves; the reference picture for comparisons is drawn without a plan.
Frame scrubbed_frame(const Frame& frame, const PlanOptions& options);

}  // namespace twinlight

// The state of a Draw, set in the driver: what FixedStages does not set.
#pragma once

#include "scene/state/frame.h"

namespace twinlight::fixed {

void set_enabled(Enum capability, bool enabled);
void load_matrix(Enum mode, const glm::dmat4& matrix);

// With the identity as modelview matrix: positions and directions are in eye coordinates. Values of what is off are set
// where `also_off` asks for it; without it they change no picture.
void set_lighting(const LightingState& lighting, bool also_off);
void set_fog(const Fog& fog);  // its parameters

}  // namespace twinlight::fixed

// Sets the state of a Draw in the driver, except what FixedStages sets.
#pragma once

#include "scene/frame/frame.h"

namespace twinlight::fixed {

void set_enabled(Enum capability, bool enabled);
void load_matrix(Enum mode, const glm::dmat4& matrix);

// The modelview matrix must be the identity: positions and directions are in eye coordinates. Values of disabled
// features change no picture and are set only if `also_off` is true.
void set_lighting(const LightingState& lighting, bool also_off);
void set_fog(const Fog& fog);  // the parameters, not GL_FOG itself

void set_combine(const Combine& combine);  // of the active texture unit

}  // namespace twinlight::fixed

// The spot factor of a light that is the same at every vertex.
#pragma once

#include "scene/state/frame.h"

namespace twinlight {

// spot_i of a directional light (2.14.1), or the lecture's cone in its place.
double directional_spot(const LightSource& light);

}  // namespace twinlight

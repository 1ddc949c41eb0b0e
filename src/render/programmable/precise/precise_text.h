// The lighting of --precise as GLSL: the equation in the order of operations of Mesa's fixed function (precise.h, precise.glsl).
#pragma once

#include "render/programmable/lighting_text.h"

namespace twinlight::programmable {

LightingText precise_lighting_text(const EffectSet& effects, const Form& form);

}  // namespace twinlight::programmable

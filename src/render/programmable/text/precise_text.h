// The lighting of --precise (numbers/precise.h) in GLSL.
#pragma once

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/text/lighting_text.h"

namespace twinlight::programmable {

// In the order of operations of Mesa's fixed function (shaders/precise.glsl).
LightingText precise_lighting_text(const EffectSet& effects, const Form& form);

}  // namespace twinlight::programmable

// The numbers of programs for any pose (programmable/export/kept_code.h): GL's state under the names of their uniforms.
#pragma once

#include <vector>

#include "base/text/json.h"
#include "render/effect/plan.h"
#include "render/programmable/numbers/form.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

// The nearest float, as the shortest number that a reader takes for it: 0.1, not 0.10000000149011612.
double short_number(double x);

// Objects from uniforms to numbers: matrices, materials, each light, and so on, because Draws often share them. Places and planes are
// in the eye coordinates of the scene's own camera. What viewer.js computes is not there: ModelViewProjectionMatrix, NormalMatrix,
// NormalScale and the lights' halfVector. It needs ProjectionMatrix instead, which no program has.
std::vector<Json> kept_values(const Draw& draw, const Plan& plan, const programmable::Code& code);

}  // namespace twinlight::webgl

// Precise: the programs of --precise. Lighting is neither planned nor folded: every enabled light is computed, with the
// floats and in the order of operations of Mesa's fixed function (mesa_floats.h, precise_text.cpp, precise.glsl). So on
// llvmpipe the vertex colours equal the fixed function's to the last bit, wherever it follows the specification.
// Elsewhere --precise follows the specification.
#pragma once

#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/shader_options.h"

namespace twinlight::programmable {

// The options with nothing left out and GL's own model. Throws std::invalid_argument for phong or exact shading and for
// constants (Tier::kBaked, kAuto), which --precise does not support.
Options precise_options(Options options);

// Whether Mesa's floats give the specified result for a Draw. They do not with a singular matrix, nor if the squares of
// a light's position, its spot direction or the modelview matrix overflow or underflow, nor far from the origin. Such
// Draws use the ordinary programs.
bool floats_suffice(const Draw& draw, const Plan& plan);

// Used instead of code_for() and uniforms(). Throw std::runtime_error for a Draw with more than GL's eight lights.
Code precise_code(const Draw& draw, const Plan& plan);
Uniforms precise_uniforms(const Draw& draw, const Plan& plan, const Code& code);

}  // namespace twinlight::programmable

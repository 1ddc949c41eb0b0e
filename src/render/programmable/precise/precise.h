// Precise: what --precise draws with. A Draw's lighting is neither planned nor folded: every enabled light is there, with
// the floats and in the order of operations of Mesa's fixed function (mesa_floats.h, precise_text.cpp, precise.glsl), so that on
// llvmpipe the colours of vertices are the fixed function's to the last bit, wherever that keeps to the text. Where it does
// not, the text is followed.
#pragma once

#include "render/programmable/draw_values.h"
#include "render/programmable/form.h"
#include "render/programmable/lighting_text.h"
#include "render/programmable/shader_options.h"

namespace twinlight::programmable {

// With nothing left out and GL's own model. Throws std::invalid_argument for phong shading and for constants, which
// --precise does not go with.
Options precise_options(Options options);

// Whether the GLSL of the current context has `precise`; the second throws std::runtime_error where it has not.
bool has_precise();
void check_has_precise();

// Whether Mesa's floats keep to the text for a Draw: they do not under a matrix without an inverse, nor where the squares of a
// light's place, of its spot direction or of the modelview matrix leave them, nor far from the origin. Such Draws have the
// ordinary programs.
bool floats_suffice(const Draw& draw, const Plan& plan);

// In the place of code_for() and uniforms(). Throws std::runtime_error for a Draw with lights that GL does not have.
Code precise_code(const Draw& draw, const Plan& plan);
Uniforms precise_uniforms(const Draw& draw, const Plan& plan, const Code& code);

// The lighting as GLSL: the equation in the order of operations of Mesa's fixed function (precise.glsl).
LightingText precise_lighting_text(const EffectSet& effects, const Form& form);

}  // namespace twinlight::programmable

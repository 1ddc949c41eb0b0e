// Precise: what --precise draws with. A Draw's lighting is neither planned nor folded: every enabled light is there, with
// the floats and in the order of operations of Mesa's fixed function (mesa_floats.h, shaders/precise*.glsl), so that on
// llvmpipe the colours of vertices are the fixed function's to the last bit, wherever that keeps to the text. Where it does
// not, the text is followed. The lecture's variants of the lighting model are off, as in the fixed function.
#pragma once

#include "programmable/draw_values.h"
#include "programmable/form.h"

namespace twinlight::programmable {

// Throws std::runtime_error that says what --precise does not go with, phong shading and constants, or that the driver's GLSL
// has no `precise`. The context is current.
void check_precise(const RenderOptions& options);

// In the place of code_for() and uniforms().
Code precise_code(const Draw& draw, const Plan& plan);
Uniforms precise_uniforms(const Draw& draw, const Plan& plan, const Code& code);

}  // namespace twinlight::programmable

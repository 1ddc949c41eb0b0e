// Baking: replaces uniforms that do not change by constants in the shader text, so that the driver's compiler can use
// their values: it folds products, drops terms multiplied by 0, and turns powers with integer exponents into squarings.
#pragma once

#include <set>
#include <string>

#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/text/shader_assembly.h"

namespace twinlight::programmable {

// The source with each uniform named in `values` replaced by a constant; the others stay uniforms.
ShaderSource with_constants(const ShaderSource& source, const Uniforms& values);

// The names of the source's uniforms.
std::set<std::string, std::less<>> uniform_names(const ShaderSource& source);

}  // namespace twinlight::programmable

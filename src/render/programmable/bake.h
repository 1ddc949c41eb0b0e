// Baking: the numbers that stand still become constants of the text, so that the driver's compiler works out in advance
// what they decide: products fold, what is multiplied by 0 goes, whole exponents become squarings.
#pragma once

#include <set>
#include <string>

#include "render/programmable/draw_values.h"
#include "render/programmable/shader_assembly.h"

namespace twinlight::programmable {

// The source with a constant in the place of each uniform that `values` names; the others stay uniforms.
ShaderSource with_constants(const ShaderSource& source, const Uniforms& values);

// The names of its uniforms.
std::set<std::string, std::less<>> uniform_names(const ShaderSource& source);

}  // namespace twinlight::programmable

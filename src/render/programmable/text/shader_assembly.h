// Assembly: makes the GLSL of an EffectSet. C++ writes the lighting (lighting_text.h) and the values passed between the
// stages; the rest comes from the files in shaders/.
//
// Libraries are files of functions, and the list of uniforms (program_uniforms.h): a program has those that its text uses, directly or
// through others. A uniform that is not listed throws std::logic_error, because no Draw gives it a value.
// Files with a main() have directives at the start of a line:
//
//   #if EFFECT_A && !EFFECT_B || EFFECT_C  ... #elif ... #else ... #endif     lines for some effects only
//   #include "file.glsl"    inserts the file
//   #insert name            inserts the text that C++ wrote under this name
//
// and words in capitals, such as TEX_COORD_S, that C++ replaces by an expression.
#pragma once

#include <string>
#include <vector>

#include "base/image/embedded.h"
#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kShaderFiles;  // shaders/*.glsl, export/*.glsl

namespace programmable {

struct ShaderSource {
    std::string vertex;
    std::string fragment;
};

ShaderSource assemble(const EffectSet& effects, const Form& form = {});

}  // namespace programmable
}  // namespace twinlight

// Assembly: the GLSL of an EffectSet. C++ writes what lights (lighting_text.h) and what one stage hands to the next; the rest comes
// from the files under shaders/.
//
// A file of functions or uniforms is a library: a program has those that its text names, directly or through others. The files
// of main() have directives at the start of a line:
//
//   #if EFFECT_A && !EFFECT_B || EFFECT_C  ... #elif ... #else ... #endif     lines for some effects alone
//   #include "file.glsl"    the file
//   #insert name            what C++ wrote under this name
//
// and words in capitals, such as TEX_COORD_S, for which C++ has an expression.
#pragma once

#include <string>
#include <vector>

#include "base/image/file.h"
#include "render/effect/effect_set.h"
#include "render/programmable/form.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kShaderFiles;  // shaders/*.glsl, precise/*.glsl

namespace programmable {

struct ShaderSource {
    std::string vertex;
    std::string fragment;
};

ShaderSource assemble(const EffectSet& effects, const Form& form = {});

}  // namespace programmable
}  // namespace twinlight

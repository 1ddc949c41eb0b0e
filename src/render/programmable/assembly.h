// Assembly: the GLSL of an EffectSet, put together from the pieces under shaders/.
//
// A piece is GLSL with directives at the start of a line, which assembly carries out:
//
//   #if EFFECT_A && !EFFECT_B || EFFECT_C  ... #elif ... #else ... #endif     lines for some effects alone
//   #include "piece.glsl"         the piece
//   #for_each_light "piece.glsl"  the piece once a light, with LIGHTi replaced by light0, light1, ...; where a light stands
//                                 for many, their numbers become arrays and what is done with them a loop
//   #for_each_face "piece.glsl"   the piece once a face that shows, with FACE replaced by front, back
//   #for_each_lit_face "piece.glsl"  the same; where one text serves both faces, once, with FACE replaced by shown, and what
//                                    is a face's number chosen by gl_FrontFacing
//   #for_each_property LINE       the line once a property of a material that each vertex brings, with PROPERTY replaced
//                                 by front_ambient, ..., PROPERTY_TYPE by float, vec3 or vec4
//   #for_each_clip_plane LINE     the line once a clip plane, with CLIP_PLANE_NUMBER replaced by 0, 1, ...
//
// So what an effect does not call for is nowhere in the program's text.
#pragma once

#include <string>

#include "render/effect/effect_set.h"
#include "render/programmable/form.h"

namespace twinlight::programmable {

struct ShaderSource {
    std::string vertex;
    std::string fragment;
};

ShaderSource assemble(const EffectSet& effects, const Form& form = {});

}  // namespace twinlight::programmable

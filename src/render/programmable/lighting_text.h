// LightingText: the GLSL that lights a vertex or a fragment, written for an EffectSet. What an effect does not call for is nowhere in it.
#pragma once

#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/form.h"

namespace twinlight::programmable {

struct LightingText {
    const char* version = "130";
    // The files whose functions it calls; of two with one name the first counts.
    std::vector<const char*> libraries = {"equation.glsl"};
    // The vertex shader's statement that sets gl_Position.
    std::string clip_position;
    // What the vertex shader makes of the vertex's position and normal: expressions.
    std::string vertex_position, vertex_normal;
    // Where the Draw is lit: uniforms, struct Surface and Lit, light_front() and its like.
    std::string uniforms, functions;
};

// Functions have the names of src/lighting/equation.h; shaders/equation.glsl has those that every light shares.
LightingText lighting_text(const EffectSet& effects, const Form& form);

}  // namespace twinlight::programmable

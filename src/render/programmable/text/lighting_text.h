// LightingText: the GLSL that lights a vertex or a fragment, written for an EffectSet. It has only what the effects
// need.
#pragma once

#include <string>
#include <vector>

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"

namespace twinlight::programmable {

struct LightingText {
    const char* version = "130";
    // The files whose functions it calls; if two have the same name, the first counts.
    std::vector<const char*> libraries = {"equation.glsl"};
    // The statement of the vertex shader that sets gl_Position.
    std::string clip_position;
    // Expressions for the vertex's position and normal, transformed as lighting needs them.
    std::string vertex_position, vertex_normal;
    // For the stage that lights: uniforms, the structs Surface and Lit, light_front() and so on.
    std::string uniforms, functions;
};

// Functions have the names of src/lighting/equation.h; those that lights share are in shaders/equation.glsl.
LightingText lighting_text(const EffectSet& effects, const Form& form);

}  // namespace twinlight::programmable

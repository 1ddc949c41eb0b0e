// The parts of the text that differ in shaders to keep: names, the version's spelling, what core GL and OpenGL ES lack.
#pragma once

#include <string>

#include "render/programmable/form.h"
#include "render/programmable/shader_pieces.h"

namespace twinlight::programmable {

// From the names of attributes and uniforms in the shader files to GL's, without the prefix gl_.
const Words& kept_names();

// What follows "#version ": the version, and for OpenGL ES the precisions that it demands. `sampler`: the texture's type.
std::string kept_version(Glsl version, const std::string& sampler);

// The statement that discards what the alpha test (section 4.1.4) rejects; empty for GL_ALWAYS.
std::string kept_alpha_test(Enum alpha_func);

}  // namespace twinlight::programmable

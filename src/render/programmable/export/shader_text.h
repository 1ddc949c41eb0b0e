// The shaders of a frame, as text to read.
#pragma once

#include <string>

#include "render/programmable/numbers/shader_options.h"
#include "scene/frame/frame.h"

namespace twinlight::programmable {

// The GLSL that draws the frame, as text to read: each program with its effects, what is left out and why, and the
// values of the uniforms in comments. Needs no context.
std::string shader_source(const Frame& frame, const Options& options);

}  // namespace twinlight::programmable

// The GLSL pieces under programmable/shaders.
#pragma once

#include <vector>

#include "math/embedded_file.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kShaderFiles;

}  // namespace twinlight

// The GLSL pieces under render/programmable/shaders.
#pragma once

#include <vector>

#include "base/image/file.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kShaderFiles;

}  // namespace twinlight

// The built-in scenes.
#pragma once

#include <vector>

#include "base/math/embedded_file.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kSceneFiles;

}  // namespace twinlight

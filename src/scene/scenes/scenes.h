// The built-in scenes.
#pragma once

#include <vector>

#include "base/image/file.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kSceneFiles;

}  // namespace twinlight

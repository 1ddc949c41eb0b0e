// What reports are made of: the page, its style and its script.
#pragma once

#include <vector>

#include "base/image/file.h"

namespace twinlight {

extern const std::vector<EmbeddedFile> kPageFiles;

}  // namespace twinlight

// How much a picture shows.
#pragma once

#include "base/image/image.h"

namespace twinlight {

// The largest difference of a colour channel between two pixels: 0 for a picture of one colour.
float color_contrast(const Image& image);

}  // namespace twinlight

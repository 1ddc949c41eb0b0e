// Pixel rectangles without a point for each pixel.
#pragma once

#include "scene/frame/frame.h"

namespace twinlight::programmable {

// A Draw that shows only an image, as one quadrilateral with this texture. It has the same fragments as the points, which take many
// times as long.
Draw as_textured_rectangle(const Draw& draw);

}  // namespace twinlight::programmable

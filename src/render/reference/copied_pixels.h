// Frames whose textures copy pixels of the picture (3.8.2), with the reference's own pixels in them.
#pragma once

#include "render/reference/vertices/reference_options.h"
#include "scene/frame/copied_texels.h"

namespace twinlight::reference {

// For the picture. The frame must outlive the result.
DrawableFrame drawable(const Frame& frame, const Options& options);

// For the allowed difference: with the ranges of what correct renderers may have copied. That is any colour from an edge
// pixel, and otherwise the 8-bit colours within the allowed difference of the reference's; the depths that are open at the pixel's
// centre; and any stencil value where one is open.
DrawableFrame drawable_with_ranges(const Frame& frame, const Options& options, CopyRanges& ranges);

}  // namespace twinlight::reference

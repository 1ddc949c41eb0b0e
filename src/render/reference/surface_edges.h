// The edge pixels of exact surfaces, whose silhouettes are not their meshes'.
#pragma once

#include "base/image/difference.h"
#include "render/reference/options.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

// Adds the pixels where so little beside the centre something else is seen: a thousandth of a pixel, by which colours otherwise
// change by less than half a code.
void add_surface_edges(const Frame& frame, const Options& options, PixelMask& edge);

}  // namespace twinlight::reference

// How much correct pictures of a frame may differ at each pixel: allowed_difference() of reference.h for a part of the
// picture.
#pragma once

#include <cstdint>

#include "render/reference/geometry/coverage.h"
#include "render/reference/pictures.h"

namespace twinlight::reference {

enum class Joining : std::uint8_t {
    kReplaces,  // what was found before
    kAdds,      // pictures may differ in either way
};

// Finds the differences of the pixels `within`, y up, with one cut of quadrilaterals.
void find_differences(StagedFrame stages, const Options& options, const PixelRect& within, OpenDifference& difference,
                      Joining joining);

// What correct renderers may leave in the depth buffer, or in the stencil buffer in 1/255, as red, green and blue, with one cut of
// quadrilaterals. A stencil value is certain, or may be any.
struct BufferBounds {
    Image low, high;
};
BufferBounds depth_bounds(StagedFrame stages, const Options& options, int width, int height);
BufferBounds stencil_bounds(StagedFrame stages, const Options& options, int width, int height);

}  // namespace twinlight::reference

// Where a driver's two cuts of a quadrilateral into triangles give two pictures.
#pragma once

#include <cmath>
#include <optional>

#include "render/context/driver_name.h"
#include "render/reference/reference.h"

namespace twinlight {

// How far the pictures of both cuts lie apart, where a driver may choose one for each program, as 2.6.1 allows: llvmpipe of Mesa
// 25 does. At edge pixels where they differ, anything is allowed. Zero on Mesa 22.3, which cuts alike. Needs a current context.
inline Image between_cuts(const Frame& frame, std::optional<Shading> shading) {
    Image between(frame.width, frame.height);
    if (current_driver().has_version("Mesa 22.3") || !reference::has_quadrilaterals(frame)) return between;
    const Image first = reference::render(frame, {{.shading = shading}});
    const Image second = reference::render(frame, {{.shading = shading}, reference::QuadCut::kSecondToFourth});
    const PixelMask edge = reference::allowed_difference(frame, {{.shading = shading}}).edge;
    for (std::size_t i = 0; i < between.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) between.pixels[i][c] = std::abs(first.pixels[i][c] - second.pixels[i][c]);
        if (edge[i] && first.pixels[i] != second.pixels[i]) between.pixels[i] = {1, 1, 1, 1};
    }
    return between;
}

}  // namespace twinlight

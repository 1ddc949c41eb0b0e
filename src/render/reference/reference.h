// The reference renderer: GL's vertex stage, clipping, rasterisation and lighting in double precision, from the
// specification, without a driver. It uses only the Frame.
#pragma once

#include "base/image/difference.h"
#include "base/image/image.h"
#include "render/reference/vertices/reference_options.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// Draws the frame on a black picture with depth 1.
Image render(const Frame& frame, const Options& options);

// The number of the shape visible at each pixel, row by row from the top. Shapes are counted from 0 in the order of
// their commands, each as one however many Draws it has. -1 if there is no shape or colours were blended.
std::vector<int> seen_shapes(const Frame& frame, const Options& options);
// The same with the numbers of the Draws (Frame::draws()).
std::vector<int> seen_draws(const Frame& frame, const Options& options);

// How much correct pictures of the frame may differ (docs/edges.md), with either cut of quadrilaterals. For
// exact surfaces: the allowed difference of their meshes, lit per pixel, plus edges where the colour changes within a
// thousandth of a pixel.
AllowedDifference allowed_difference(const Frame& frame, const Options& options = {});

}  // namespace twinlight::reference

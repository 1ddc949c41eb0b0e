// The double-precision reference: GL's vertex stage, clipping, rasterisation and lighting from the
// specification, without a driver. Sees only the Frame.
#pragma once

#include "base/image/difference.h"
#include "base/image/image.h"
#include "render/reference/reference_options.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

// Starts from black and depth 1.
Image render(const Frame& frame, const Options& options);

// Which shape is seen at each pixel, row by row from the top: shapes are numbered from 0 in the order of the commands that send
// them, whatever number of Draws each is; -1 where none is, or where colours were blended.
std::vector<int> seen_shapes(const Frame& frame, const Options& options);

// How far apart right pictures of the frame may be (docs/lighting.md, "Edges").
// Of either cut of quadrilaterals. Of exact surfaces: that of their meshes, lit per pixel, and edges where a thousandth of a pixel
// beside the centre something else is seen.
AllowedDifference allowed_difference(const Frame& frame, Options options = {});

// A vertex as the lighting equation leaves it: what GL's feedback returns.
struct LitVertex {
    glm::dvec4 position_clip{0};
    glm::dvec4 front_primary{0}, front_secondary{0};
    glm::dvec4 back_primary{0}, back_secondary{0};
    // The sums of the magnitudes of the terms of the primary colours, channel by channel: what an error is held against.
    glm::dvec4 front_magnitude{0}, back_magnitude{0};
};

// The vertex stage of every vertex of the Draw (not of every index). `clamped`: 2.14.6, colours to [0,1]. Magnitudes are double
// whatever the options' arithmetic.
std::vector<LitVertex> light_vertices(const Draw& draw, const Options& options, bool clamped);

}  // namespace twinlight::reference

// What a comparison of two pictures tolerates.
#pragma once

#include "base/image/difference.h"
#include "render/context/drawing_precision.h"

namespace twinlight::compare {

// The tolerance of a pair, for pixels away from edges and for the part of each difference that exceeds the allowed difference
// (allowances.h): no channel is off by more than max, and the share of differing pixels is below differing_share.
struct Tolerance {
    double max = 1 / 255.0;          // a correct value may be rounded up or down
    double differing_share = 0.001;  // float and double rarely round to different sides
};
bool is_within(const ImageDifference& difference, const Tolerance& tolerance);

// Adds the colour of the reference's picture to those that an edge pixel may have; of both pictures if quadrilaterals can be cut in
// two ways. `other_cut` may be null.
void allow_reference(AllowedDifference& allowed, const Image& reference, const Image* other_cut);

// 2.1.1: a colour must be accurate to 1 part in 10^5. If the right value is that close to halfway between two 8-bit values, such as
// a background of 0.3 (76.5/255), both are allowed.
inline constexpr double kArithmetic = 1e-5;
// Whether an error of `error` can change the channel's 8-bit value.
bool may_cross(float channel, double error);
// Adds kArithmetic where it matters.
void allow_ties(AllowedDifference& allowed, const Image& reference);

// The same for a driver: adds what its precision may change, where that matters. other_cut: Render::other_cut, or null.
void allow_drawing(AllowedDifference& allowed, const Image& reference, const Image* other_cut,
                   const DrawingPrecision& precision);

// 3.5.1 leaves open how exact a rasteriser's positions are. One that rounds them to 2^-bits of a pixel moves each vertex by half of
// that at the most, across and up. What it interpolates at a pixel is then the right value of a place that is as near: places
// between vertices move by a mean of the vertices' ways. So the allowed difference grows by the change of the colour on that way,
// for which the change to the neighbouring pixels counts, if possible to those of the same surface. llvmpipe has 8 bits, some
// browsers have 4.
void allow_rounded_positions(AllowedDifference& allowed, const Image& reference, int bits);

}  // namespace twinlight::compare

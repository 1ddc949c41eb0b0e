// How different two colours look: Delta E 2000. About 1 is a difference that can just be seen beside each other.
//
// G. Sharma, W. Wu, E. N. Dalal: The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data,
// and Mathematical Observations. Color Research and Application 30 (1), 2005. CIELAB as in CIE 15:2004.
//
// Which reading of a picture: GL's lighting knows no transfer curve; what it writes is what the display gets, and a
// display takes it for sRGB codes. So the channels of an Image are codes here, not linear light. White is D65.
#pragma once

#include <cstddef>

#include "base/image/image.h"
#include "base/math/vec3.h"

namespace twinlight {

struct Lab {
    double lightness = 0;  // L*, 0 to 100
    double a = 0, b = 0;   // a*, b*
};

Lab lab_from_xyz(Vec3<double> xyz);             // relative to sRGB's white, D65, whose Y is 1
Lab lab_from_linear_srgb(Vec3<double> linear);  // linear light; what is outside of [0,1] is kept
Lab lab_from_srgb_codes(Vec3<double> codes);    // what a picture's channels are; the same

// CIEDE2000 with k_L = k_C = k_H = 1. Symmetric.
double delta_e_2000(Lab one, Lab other);

// Over the pixels of two pictures.
struct PerceivedDifference {
    std::size_t pixels = 0;  // that were counted; all others below are 0 where there are none
    double mean = 0;
    double percentile_95 = 0;  // the smallest that at least 95 % of the pixels do not exceed
    double max = 0;
    int worst_x = 0, worst_y = 0;  // the first pixel, row by row from the top left, that has `max`

    friend bool operator==(const PerceivedDifference&, const PerceivedDifference&) = default;
};

// Channels are clamped to [0,1], NaN is 0, alpha is passed over. Not rounded to codes: round them first (channel_code()) for what
// 8 bits show. Throws std::invalid_argument unless the sizes are equal.
PerceivedDifference perceived_difference(const Image& one, const Image& other);
// Over the pixels that are set in the mask.
PerceivedDifference perceived_difference(const Image& one, const Image& other, const PixelMask& counted);

}  // namespace twinlight

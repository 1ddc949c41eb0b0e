// Delta E 2000: how different two colours look. A value of about 1 is just visible when the colours are side by side.
//
// G. Sharma, W. Wu, E. N. Dalal: The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data,
// and Mathematical Observations. Color Research and Application 30 (1), 2005. CIELAB as in CIE 15:2004.
//
// GL's lighting applies no transfer curve. The display receives the numbers that GL writes and reads them as sRGB
// codes. So the channels of an Image are taken as sRGB codes here, not as linear light. White is D65.
#pragma once

#include <cstddef>

#include "base/image/image.h"
#include "base/math/vec3.h"

namespace twinlight {

struct Lab {
    double lightness = 0;  // L*, 0 to 100
    double a = 0, b = 0;   // a*, b*
};

Lab lab_from_xyz(Vec3<double> xyz);             // relative to sRGB's white (D65), which has Y = 1
Lab lab_from_linear_srgb(Vec3<double> linear);  // linear light; not clamped to [0,1]
Lab lab_from_srgb_codes(Vec3<double> codes);    // sRGB codes on [0,1], as in a picture; not clamped

// CIEDE2000 with k_L = k_C = k_H = 1. Symmetric.
double delta_e_2000(Lab one, Lab other);

// Delta E over the pixels of two pictures.
struct PerceivedDifference {
    std::size_t pixels = 0;  // how many were counted; if 0, the members below are 0
    double mean = 0;
    double percentile_95 = 0;  // at least 95 % of the pixels are not above this
    double max = 0;
    int worst_x = 0, worst_y = 0;  // the first pixel, row by row from the top left, that has `max`

    friend bool operator==(const PerceivedDifference&, const PerceivedDifference&) = default;
};

// Clamps channels to [0,1], treats NaN as 0 and ignores alpha. Does not round to 8 bits; for the difference of two
// 8-bit pictures, round them first (channel_code()). Throws std::invalid_argument if the sizes differ.
PerceivedDifference perceived_difference(const Image& one, const Image& other);
// The same for the pixels that are set in `counted`.
PerceivedDifference perceived_difference(const Image& one, const Image& other, const PixelMask& counted);

}  // namespace twinlight

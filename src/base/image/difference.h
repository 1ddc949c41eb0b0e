// How two pictures differ: in numbers, and as a picture.
#pragma once

#include <cstddef>

#include "base/image/image.h"

namespace twinlight {

// Over one part of two pictures, as an 8-bit framebuffer holds them; all four channels, each on [0,1].
struct RegionDifference {
    std::size_t pixels = 0;
    std::size_t differing = 0;  // pixels of which any channel's code differs
    double max = 0;             // the largest difference of a channel: a whole number / 255
    double rms = 0;             // over all channels of all pixels
    // The first pixel, row by row from the top left, that has `max`: the region's first where nothing
    // differs, (0,0) where the region is empty.
    int worst_x = 0, worst_y = 0;

    double differing_share() const {
        return pixels == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(pixels);
    }
};

// How far apart two right pictures of one scene may be, pixel by pixel.
struct AllowedDifference {
    // Where they may choose differently: the border of what is drawn passes through the pixel, two surfaces cut each
    // other there, or which texel, level or filter is the right one hangs on the last bits (docs/lighting.md, "Edges").
    PixelMask edge;
    // Elsewhere: how far apart a channel may be, beyond the rounding of the picture itself, for the precision of filters
    // and of blending. 0 where nothing is textured or blended.
    Image channels;
};

struct ImageDifference {
    RegionDifference interior;
    RegionDifference edge;
    // Of the interior: what is left of each channel's difference beyond the allowed one, in whole codes. Where one is allowed,
    // two right answers may also be rounded apart: one code of the difference is theirs.
    RegionDifference beyond_allowed;
};

// The pixels of the mask are the edge, all others the interior. Throws std::invalid_argument unless all have one size.
ImageDifference difference(const Image& a, const Image& b, const AllowedDifference& allowed);
// The same where only edges are allowed.
ImageDifference difference(const Image& a, const Image& b, const PixelMask& edge);

// At each pixel whichever of two right answers is nearer to `image`: the one with the smaller largest difference of a
// channel, `first` where they are equally near. All of one size.
Image nearer_of(const Image& image, const Image& first, const Image& second);
// The same of what is left beyond the allowed difference: of a right answer with a great difference that is its own to make, and one
// with a small difference that is not, the first is the nearer.
Image nearer_of(const Image& image, const Image& first, const Image& second, const Image& allowed);

// A difference too small to see must be amplified, by a factor that is told: the largest power of two, at
// most 64, that does not take `max` beyond 1.
int amplification_for(double max);

// Equal pixels are kZeroGrey; towards white, channel by channel, goes the absolute difference times the
// factor. A difference of alpha, which has no channel to be seen in, shows in all three.
inline constexpr float kZeroGrey = 0.25F;
Image difference_picture(const Image& a, const Image& b, int factor);

}  // namespace twinlight

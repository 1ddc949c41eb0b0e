// The difference of two pictures, as numbers and as a picture.
//
// A code is the whole number from 0 to 255 that an 8-bit framebuffer stores for a channel (channel_code()). Edge pixels
// are those where two correct pictures may choose differently; all others are the interior.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "base/image/image.h"

namespace twinlight {

// The difference of two pictures in a region, after rounding to 8 bits. Covers all four channels, each on [0,1].
struct RegionDifference {
    std::size_t pixels = 0;
    std::size_t differing = 0;  // pixels with a channel whose codes differ
    double max = 0;             // the largest difference of a channel: a whole number / 255
    double rms = 0;             // over all channels of all pixels
    // The first pixel, row by row from the top left, with the difference `max`. If nothing differs, the region's first
    // pixel; (0,0) for an empty region.
    int worst_x = 0, worst_y = 0;
    bool only_alpha = false;  // pixels differ, but none in red, green or blue

    double differing_share() const {
        return pixels == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(pixels);
    }
};

// The colours from `low` to `high`, channel by channel.
struct AllowedRange {
    Rgba low{}, high{};
    friend bool operator==(const AllowedRange&, const AllowedRange&) = default;
};

// How much two correct pictures of one scene may differ, pixel by pixel.
struct AllowedDifference {
    // Edge pixels: a primitive's border passes through the pixel, two surfaces intersect there, or the last bits decide
    // which texel, level or filter is used (docs/edges.md).
    PixelMask edge;
    // Interior pixels: how much a channel may differ because of the precision of filters and blending, in addition to
    // the rounding to 8 bits. 0 where nothing is textured or blended.
    Image channels;
    // Of edge pixels, by their index: the colours of which they may have one. Those that are not listed may have any colour, so they
    // cannot be judged.
    std::map<std::size_t, std::vector<AllowedRange>> ranges{};
    // The pixels that a fragment covers, or may cover; may be empty.
    PixelMask drawn{};

    bool is_judged(std::size_t i) const { return !edge[i] || ranges.contains(i); }
};

struct ImageDifference {
    RegionDifference interior;
    RegionDifference edge;
    // All judged pixels, after the allowed difference is subtracted from each channel's difference, in whole codes.
    // Where it is above 0, one more code is subtracted: rounding may move two correct values apart. At an edge what is left is how far
    // the picture that is farther from all of the pixel's colours is from the nearest.
    RegionDifference beyond_allowed;
};

// Throws std::invalid_argument unless all sizes are equal.
ImageDifference difference(const Image& a, const Image& b, const AllowedDifference& allowed);
// The same with no allowed difference in the interior.
ImageDifference difference(const Image& a, const Image& b, const PixelMask& edge);
// The pixels that beyond_allowed counts as differing.
PixelMask pixels_beyond_allowed(const Image& a, const Image& b, const AllowedDifference& allowed);

// Chooses at each pixel the one of two correct pictures that is nearer to `image`: the one whose largest difference of
// a channel is smaller; `first` if both are equally near. Throws std::invalid_argument unless all sizes are equal.
Image nearer_of(const Image& image, const Image& first, const Image& second);
// The same, but compares the differences beyond `allowed` first. A large difference that is allowed then counts as
// nearer than a small one that is not.
Image nearer_of(const Image& image, const Image& first, const Image& second, const Image& allowed);

// The factor that makes a small difference visible: the largest power of two, at most 64, that keeps `max` times the
// factor within 1.
int amplification_for(double max);

// Equal pixels are kZeroGrey; brighter means a larger difference, channel by channel, multiplied by `factor`. A
// difference of alpha brightens all three channels.
inline constexpr float kZeroGrey = 0.25F;
Image difference_picture(const Image& a, const Image& b, int factor);

}  // namespace twinlight

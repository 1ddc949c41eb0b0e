// The difference of two pictures, as numbers and as a picture.
//
// A code is the whole number from 0 to 255 that an 8-bit framebuffer stores for a channel (channel_code()). Edge pixels
// are those where two correct pictures may choose differently; all others are the interior.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
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

// Why two correct pictures may differ at a pixel. docs/edges.md has the sections of the specification.
enum class Why : std::uint8_t {
    // At edges: why a choice is open.
    kBorder,   // a border passes beside the centre, or the primitive lies in a clipping plane
    kDepth,    // the depth test
    kStencil,  // the stencil test
    kAlpha,    // the alpha test
    kTexel,    // which texel, level or filter is used
    kOrder,    // lines and points of one border are blended in any order
    kMissing,  // one of the renderers does not draw a command
    // Elsewhere: what a channel may be off by.
    kTextures,    // the precision of filters and blending
    kCopies,      // pixels that were copied from pictures that may differ
    kFog,         // linear fog of a primitive that reaches behind the eye
    kCone,        // the border of a spot's cone, lit per pixel
    kCurve,       // an exact surface turns much within a thousandth of a pixel
    kTie,         // the right value is halfway between two 8-bit values
    kPositions,   // the driver interpolates between rounded positions
    kConversion,  // the driver rounds to 8 bits less exactly
    kPlan,        // lights that the shaders skip
    kCut,         // two drivers may cut a quadrilateral differently
    kDrivers,     // each of two drivers may be off in its own direction
};
inline constexpr int kWhys = static_cast<int>(Why::kDrivers) + 1;  // how many there are
// A few words for people: "a border passes beside its centre".
std::string_view words_of(Why why);
// Bit 1 << Why.
using Whys = std::uint32_t;
constexpr Whys bit_of(Why why) { return Whys{1} << static_cast<int>(why); }

// What one cause adds to the allowed difference of each channel.
struct AllowedPart {
    Why why = Why::kTie;
    Image channels;
};

// How much two correct pictures of one scene may differ, pixel by pixel.
struct AllowedDifference {
    AllowedDifference() = default;
    AllowedDifference(int image_width, int image_height)
        : width(image_width),
          height(image_height),
          edge(static_cast<std::size_t>(image_width) * static_cast<std::size_t>(image_height)) {}

    int width = 0, height = 0;
    // Edge pixels: a choice is open.
    PixelMask edge{};
    // How much a channel may be off, in addition to the rounding to 8 bits: the sum of the parts, of which each has another cause.
    std::vector<AllowedPart> parts{};
    // Of edge pixels, by their index: the colours of which they may have one. Those that are not listed may have any colour, so they
    // cannot be judged.
    std::map<std::size_t, std::vector<AllowedRange>> ranges{};
    // Why a pixel is an edge pixel; may be empty.
    std::vector<Whys> open{};
    // The pixels that a fragment covers, or may cover; may be empty.
    PixelMask drawn{};
    // The pixels whose colour the specification leaves undefined, so that a difference there is no error; may be empty.
    PixelMask undefined{};

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    bool is_judged(std::size_t i) const { return !edge[i] || ranges.contains(i); }
    bool is_undefined(std::size_t i) const { return !undefined.empty() && undefined[i]; }
    // The sum of the parts.
    Rgba channels(std::size_t i) const;
    Image channels() const;
    // Whether any channel of the pixel may be off because of this.
    bool allows(Why why, std::size_t i) const;
    // The part with this cause: a new one that allows nothing, if there was none.
    Image& part(Why why);
};

struct ImageDifference {
    RegionDifference interior;
    RegionDifference edge;
    // All judged pixels, after the allowed difference is subtracted from each channel's difference, in whole codes.
    // Where it is above 0, one more code is subtracted: rounding may move two correct values apart. At an edge what is left is how far
    // the picture that is farther from all of the pixel's colours is from the nearest.
    RegionDifference beyond_allowed;
    // Pixels that differ by more than this, but whose colour is undefined. They are not in beyond_allowed.
    std::size_t undefined = 0;
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

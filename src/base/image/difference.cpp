// Subtracts the 8-bit codes (0 to 255) as whole numbers, so results are exact and the same on every machine.
#include "base/image/difference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <utility>

namespace twinlight {

namespace {

constexpr std::size_t kChannels = 4;

using Codes = std::array<int, kChannels>;

Codes absolute_difference(const Rgba& a, const Rgba& b) {
    Codes codes{};
    if (a == b) return codes;  // fast path for most pixels
    for (std::size_t c = 0; c < kChannels; ++c) codes[c] = std::abs(channel_code(a[c]) - channel_code(b[c]));
    return codes;
}

Codes excess(const Codes& codes, const Rgba& allowed) {
    Codes result = codes;
    for (std::size_t c = 0; c < kChannels; ++c) {
        if (codes[c] == 0 || !(allowed[c] > 0)) continue;
        const double left = std::ceil(codes[c] - (1 + 255.0 * static_cast<double>(allowed[c])));
        result[c] = static_cast<int>(std::max(left, 0.0));
    }
    return result;
}

void check_sizes(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) {
        throw std::invalid_argument("pictures of different sizes cannot be compared");
    }
}

// How far the colour is from the nearest of the ranges, which may be wider by `allowed`.
Codes distance(const Rgba& color, const std::vector<AllowedRange>& ranges, const Rgba& allowed) {
    Codes nearest{};
    int least = -1;
    for (const AllowedRange& range : ranges) {
        Codes codes{};
        for (std::size_t c = 0; c < kChannels; ++c) {
            const int code = channel_code(color[c]);
            codes[c] = std::max(
                {channel_code(range.low[c] - allowed[c]) - code, code - channel_code(range.high[c] + allowed[c]), 0});
        }
        const int largest = std::ranges::max(codes);
        if (least >= 0 && largest >= least) continue;
        least = largest;
        nearest = codes;
    }
    return nearest;
}

Codes farther(const Codes& a, const Codes& b) { return std::ranges::max(a) < std::ranges::max(b) ? b : a; }
Codes nearer(const Codes& a, const Codes& b) { return std::ranges::max(b) < std::ranges::max(a) ? b : a; }

// What is left at a pixel that is judged (ImageDifference::beyond_allowed).
Codes beyond_allowed(const Image& a, const Image& b, const AllowedDifference& allowed, std::size_t i) {
    const Codes codes = absolute_difference(a.pixels[i], b.pixels[i]);
    if (codes == Codes{}) return codes;
    const Rgba channels = allowed.channels(i);
    const Codes left = excess(codes, channels);
    if (!allowed.edge[i] || std::ranges::max(left) == 0) return left;
    const std::vector<AllowedRange>& ranges = allowed.ranges.at(i);
    return nearer(left, farther(distance(a.pixels[i], ranges, channels), distance(b.pixels[i], ranges, channels)));
}

struct Region {
    std::size_t pixels = 0, differing = 0;
    int max = -1;
    std::uint64_t sum_of_squares = 0;
    int worst_x = 0, worst_y = 0;
    bool has_colors = false;

    void add(const Codes& codes, int x, int y) {
        if (codes == Codes{} && max >= 0) {  // fast path for most pixels
            ++pixels;
            return;
        }
        const int largest = *std::ranges::max_element(codes);
        ++pixels;
        differing += largest > 0 ? 1 : 0;
        has_colors = has_colors || std::ranges::any_of(std::span(codes).first<3>(), [](int code) { return code > 0; });
        for (const int code : codes) sum_of_squares += static_cast<std::uint64_t>(code * code);
        if (largest > max) {
            max = largest;
            worst_x = x;
            worst_y = y;
        }
    }

    RegionDifference result() const {
        const double samples = static_cast<double>(std::max<std::size_t>(pixels, 1) * kChannels);
        return {.pixels = pixels,
                .differing = differing,
                .max = std::max(max, 0) / 255.0,
                .rms = std::sqrt(static_cast<double>(sum_of_squares) / samples) / 255,
                .worst_x = worst_x,
                .worst_y = worst_y,
                .only_alpha = differing > 0 && !has_colors};
    }
};

}  // namespace

std::string_view words_of(Why why) {
    switch (why) {
        case Why::kBorder: return "a border passes beside its centre";
        case Why::kDepth: return "two surfaces are equally near";
        case Why::kStencil: return "the stencil test is open";
        case Why::kAlpha: return "its alpha is at the limit of the alpha test";
        case Why::kTexel: return "it is between two texels, levels or filters";
        case Why::kOrder: return "lines or points of one border are blended in any order";
        case Why::kMissing: return "not every renderer draws a command that changes it";
        case Why::kTextures: return "filters and blending";
        case Why::kCopies: return "copied pixels";
        case Why::kFog: return "fog behind the eye";
        case Why::kCone: return "the border of a spot's cone";
        case Why::kCurve: return "a surface that turns much within the pixel";
        case Why::kTie: return "a value halfway between two 8-bit values";
        case Why::kPositions: return "positions that the driver rounds";
        case Why::kConversion: return "how the driver rounds to 8 bits";
        case Why::kPlan: return "lights that the shaders skip";
        case Why::kCut: return "the cut of quadrilaterals";
        case Why::kDrivers: return "two drivers";
    }
    return "";
}

Rgba AllowedDifference::channels(std::size_t i) const {
    Rgba sum{};
    for (const AllowedPart& part : parts)
        for (std::size_t c = 0; c < kChannels; ++c) sum[c] += part.channels.pixels[i][c];
    return sum;
}

Image AllowedDifference::channels() const {
    Image sum(width, height);
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] = channels(i);
    return sum;
}

bool AllowedDifference::allows(Why why, std::size_t i) const {
    const auto found = std::ranges::find(parts, why, &AllowedPart::why);
    return found != parts.end() &&
           std::ranges::any_of(found->channels.pixels[i], [](float channel) { return channel > 0; });
}

Image& AllowedDifference::part(Why why) {
    const auto found = std::ranges::find(parts, why, &AllowedPart::why);
    if (found != parts.end()) return found->channels;
    return parts.emplace_back(AllowedPart{why, Image(width, height)}).channels;
}

ImageDifference difference(const Image& a, const Image& b, const AllowedDifference& allowed) {
    check_sizes(a, b);
    if (allowed.width != a.width || allowed.height != a.height || allowed.edge.size() != a.pixels.size())
        throw std::invalid_argument("the allowed difference and the pictures have different sizes");
    std::size_t undefined = 0;
    Region interior, edge, beyond;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = a.index(x, y);
            (allowed.edge[i] ? edge : interior).add(absolute_difference(a.pixels[i], b.pixels[i]), x, y);
            if (!allowed.is_judged(i)) continue;
            const Codes left = beyond_allowed(a, b, allowed, i);
            if (allowed.is_undefined(i) && std::ranges::max(left) > 0)
                ++undefined;
            else
                beyond.add(left, x, y);
        }
    }
    return {.interior = interior.result(),
            .edge = edge.result(),
            .beyond_allowed = beyond.result(),
            .undefined = undefined};
}

PixelMask pixels_beyond_allowed(const Image& a, const Image& b, const AllowedDifference& allowed) {
    PixelMask mask(a.pixels.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] =
            allowed.is_judged(i) && !allowed.is_undefined(i) && std::ranges::max(beyond_allowed(a, b, allowed, i)) > 0;
    return mask;
}

ImageDifference difference(const Image& a, const Image& b, const PixelMask& edge) {
    AllowedDifference allowed(a.width, a.height);
    allowed.edge = edge;
    return difference(a, b, allowed);
}

Image nearer_of(const Image& image, const Image& first, const Image& second) {
    return nearer_of(image, first, second, Image(image.width, image.height));
}

Image nearer_of(const Image& image, const Image& first, const Image& second, const Image& allowed) {
    check_sizes(image, first);
    check_sizes(image, second);
    check_sizes(image, allowed);
    Image result = first;
    // First compares the differences beyond the allowed one, then the whole differences.
    const auto distance = [&](const Image& other, std::size_t i) {
        const Codes codes = absolute_difference(image.pixels[i], other.pixels[i]);
        return std::pair(std::ranges::max(excess(codes, allowed.pixels[i])), std::ranges::max(codes));
    };
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        if (first.pixels[i] == second.pixels[i]) continue;
        if (distance(second, i) < distance(first, i)) result.pixels[i] = second.pixels[i];
    }
    return result;
}

int amplification_for(double max) {
    constexpr int kLargest = 64;  // then a difference of 1/255 shows as a quarter of the range
    int factor = kLargest;
    while (factor > 1 && factor * max > 1) factor /= 2;
    return factor;
}

Image difference_picture(const Image& a, const Image& b, int factor) {
    check_sizes(a, b);
    Image picture(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Codes codes = absolute_difference(a.pixels[i], b.pixels[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            const int code = std::max(codes[c], codes[3]);
            const float amplified = std::min(static_cast<float>(code * factor) / 255.0F, 1.0F);
            picture.pixels[i][c] = kZeroGrey + (1 - kZeroGrey) * amplified;
        }
        picture.pixels[i][3] = 1;
    }
    return picture;
}

}  // namespace twinlight

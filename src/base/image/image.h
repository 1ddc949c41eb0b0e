// Image: a picture of floats, RGBA, row 0 at the top. What every renderer returns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twinlight {

using Rgba = std::array<float, 4>;

struct Image {
    int width = 0;
    int height = 0;
    std::vector<Rgba> pixels;  // width * height, row by row from the top

    Image() = default;
    Image(int w, int h, Rgba fill = {0, 0, 0, 0})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    Rgba& at(int x, int y) { return pixels[index(x, y)]; }
    const Rgba& at(int x, int y) const { return pixels[index(x, y)]; }
};

// One flag a pixel; same order as Image::pixels.
using PixelMask = std::vector<bool>;

// A channel clamped to [0,1] and rounded to the nearest of 256 codes, as an 8-bit framebuffer does (2.14.9).
// A NaN, for which GL has no answer, is 0.
std::uint8_t channel_code(float channel);

}  // namespace twinlight

// Image: a picture of RGBA floats, row 0 at the top. Every renderer returns one.
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

// One flag per pixel, in the order of Image::pixels.
using PixelMask = std::vector<bool>;

// The code of a channel: clamped to [0,1] and rounded to the nearest of 0/255 to 255/255, as an 8-bit framebuffer does
// (GL 2.1, section 2.14.9). NaN, which GL leaves undefined, gives 0.
std::uint8_t channel_code(float channel);

}  // namespace twinlight

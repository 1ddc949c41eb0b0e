// Images as PNG: 8 bits a channel, red, green and blue.
//
// Alpha is left out: a renderer's alpha is data (the diffuse alpha, GL 2.1 section 2.14.1), not transparency,
// and a viewer would take it for that.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/image.h"

namespace twinlight {

std::string encode_png(const Image& image);

// What a PNG holds: red, green, blue and alpha, a byte each, the highest row first.
struct PngPixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

// Any PNG, rounded to 8 bits; alpha is 255 where the file has none. A side longer than `longest_side`, or pixel data that
// unpacks to more than such an image has, is refused before it takes memory. Throws std::runtime_error.
PngPixels decode_png_pixels(std::string_view bytes, int longest_side);

void write_png(const std::string& path, const Image& image);  // atomically: see file.h

}  // namespace twinlight

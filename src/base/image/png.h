// Writes images as PNG with red, green and blue, 8 bits each, and reads PNG files.
//
// Alpha is not written. A renderer's alpha is the material's diffuse alpha (GL 2.1, section 2.14.1), but a viewer would
// show it as transparency.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/image.h"

namespace twinlight {

// Throws std::runtime_error if the encoder fails.
std::string encode_png(const Image& image);

// Decoded pixels: red, green, blue and alpha, one byte each, the top row first.
struct PngPixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    bool operator==(const PngPixels&) const = default;
};

// Reads any PNG and rounds it to 8 bits; alpha is 255 if the file has none. Throws std::runtime_error if the file is
// damaged, if a side is longer than `longest_side`, or if the pixel data unpacks to more bytes than the size in the
// file allows.
PngPixels decode_png_pixels(std::string_view bytes, int longest_side);

void write_png(const std::string& path, const Image& image);  // atomically, see file.h; throws FileError

}  // namespace twinlight

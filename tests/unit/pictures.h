// Pictures as tests read them back from PNGs, and as 8 bits hold them.
#pragma once

#include <string>
#include <string_view>

#include "base/image/file.h"
#include "base/image/image.h"
#include "base/image/png.h"

namespace twinlight {

inline Image decode_png(std::string_view bytes) {
    constexpr int kLongestSide = 1 << 14;
    const PngPixels pixels = decode_png_pixels(bytes, kLongestSide);
    Image image(pixels.width, pixels.height);
    for (std::size_t i = 0; i < pixels.rgba.size(); ++i)
        image.pixels[i / 4][i % 4] = static_cast<float>(pixels.rgba[i]) / 255.0F;
    return image;
}

inline Image read_png(const std::string& path) { return decode_png(read_file(path)); }

// Every channel replaced by its code / 255.
inline Image quantised(Image image) {
    for (Rgba& pixel : image.pixels)
        for (float& channel : pixel) channel = static_cast<float>(channel_code(channel)) / 255.0F;
    return image;
}

}  // namespace twinlight

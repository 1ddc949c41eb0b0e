// Pictures for textures: any bytes are a picture of the size that they say, or one clear line.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "base/image/png.h"

using namespace twinlight;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr int kLongestSide = 64;  // a scene's may be longer: then an input takes the time to fill memory
    try {
        const PngPixels image = decode_png_pixels({reinterpret_cast<const char*>(data), size}, kLongestSide);
        const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        if (image.width < 1 || image.height < 1 || image.width > kLongestSide || image.height > kLongestSide ||
            image.rgba.size() != 4 * pixels)
            std::abort();
    } catch (const std::runtime_error& error) {
        if (std::strchr(error.what(), '\n')) std::abort();
    }
    return 0;
}

// PNG through Debian's stb library.
#include "image/png.h"

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <climits>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "image/file.h"

namespace twinlight {

std::string encode_png(const Image& image) {
    constexpr int kChannels = 3;
    std::vector<std::uint8_t> codes;
    codes.reserve(image.pixels.size() * kChannels);
    for (const Rgba& pixel : image.pixels) {
        for (std::size_t channel = 0; channel < kChannels; ++channel) codes.push_back(channel_code(pixel[channel]));
    }
    std::string png;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    const int written = stbi_write_png_to_func(append, &png, image.width, image.height, kChannels, codes.data(),
                                               image.width * kChannels);
    if (written == 0) throw std::runtime_error("the picture could not be encoded as PNG");
    return png;
}

Image decode_png(std::string_view bytes) {
    constexpr int kChannels = 4;
    if (bytes.size() > INT_MAX) throw std::runtime_error("the PNG is larger than 2 GiB");
    int width = 0, height = 0, channels_in_file = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> codes(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()), &width,
                              &height, &channels_in_file, kChannels),
        stbi_image_free);
    if (!codes) throw std::runtime_error(std::string("the PNG cannot be read: ") + stbi_failure_reason());

    Image image(width, height);
    const stbi_uc* code = codes.get();
    for (Rgba& pixel : image.pixels) {
        for (float& channel : pixel) channel = static_cast<float>(*code++) / 255.0F;
    }
    return image;
}

void write_png(const std::string& path, const Image& image) { write_file_atomically(path, encode_png(image)); }

Image read_png(const std::string& path) { return decode_png(read_file(path)); }

}  // namespace twinlight

// Reads and writes PNG with the stb library; libdeflate compresses, in a third of stb's time and to three quarters of its size.
#include "base/image/png.h"

#include <fmt/format.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/image/file.h"
#include "base/text/translation.h"

#ifndef __EMSCRIPTEN__  // which has no libdeflate
#include <libdeflate.h>

namespace {

// Returns memory that stb_image_write frees; null if the system has no more. `quality` is meant for stb's own compressor.
unsigned char* deflated(const unsigned char* data, int size, int* deflated_size, int /*quality*/) {
    constexpr int kLevel = 3;  // of 1 to 12: 12 ms for a picture of 640 x 480; level 6 takes 18 ms, and is 5 % smaller
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor);
    if (!compressor) return nullptr;
    const auto bytes = static_cast<std::size_t>(size);
    const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), bytes);
    auto* const result = static_cast<unsigned char*>(std::malloc(most));
    if (result)
        *deflated_size = static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, bytes, result, most));
    return result;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflated
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#endif
#include <stb/stb_image_write.h>

namespace twinlight {

std::string encode_png(const Image& image) {
    constexpr int kPngChannels = 3;
    std::vector<std::uint8_t> codes;
    codes.reserve(image.pixels.size() * kPngChannels);
    for (const Rgba& pixel : image.pixels) {
        for (std::size_t channel = 0; channel < kPngChannels; ++channel) codes.push_back(channel_code(pixel[channel]));
    }
    // No exception may pass through stb, which has all bytes ready and gives them at once.
    struct Written {
        std::string png;
        bool lacked_memory = false;
    } result;
    const auto append = [](void* context, void* data, int size) {
        Written& written = *static_cast<Written*>(context);
        try {
            written.png.append(static_cast<const char*>(data), static_cast<std::size_t>(size));
        } catch (const std::bad_alloc&) {
            written.lacked_memory = true;
        }
    };
    const int written = stbi_write_png_to_func(append, &result, image.width, image.height, kPngChannels, codes.data(),
                                               image.width * kPngChannels);
    if (written == 0 || result.lacked_memory) throw std::bad_alloc();  // stb has no other reason
    return std::move(result.png);
}

namespace {

constexpr int kRgba = 4;

// The decoder's message. It may quote bytes of the file, so other characters become '?'.
std::string cannot_be_read() {
    std::string reason = stbi_failure_reason();
    if (reason == "outofmem") throw std::bad_alloc();
    std::ranges::replace_if(
        reason, [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, '?');
    return tr("the PNG cannot be read: {}; save it again", reason);
}

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

// PNG's integers (section 7.1): 4 bytes, the highest first.
std::uint32_t integer(std::string_view bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

// The compressed pixels: the data of all IDAT chunks (PNG, section 5.3: length, type, data, check sum).
std::string packed_pixels(std::string_view bytes) {
    constexpr std::size_t kAroundData = 12;
    if (!bytes.starts_with(kSignature)) throw std::runtime_error(tr("this is not a PNG; convert it to one"));
    std::string packed;
    for (std::string_view rest = bytes.substr(kSignature.size()); rest.size() >= kAroundData;) {
        const std::size_t length = integer(rest);
        if (length > rest.size() - kAroundData) break;
        const std::string_view type = rest.substr(4, 4);
        if (type == "IEND") return packed;
        if (type == "IDAT") packed += rest.substr(8, length);
        rest.remove_prefix(length + kAroundData);
    }
    throw std::runtime_error(tr("the PNG is cut off; save it again"));
}

// The size from the header, which is the first chunk (section 11.2.2). stbi_info() also reads later chunks, and where one is
// wrong it does not report why.
struct Size {
    std::uint32_t width, height;
};
Size size_of(std::string_view bytes) {
    constexpr std::string_view kHeader("\0\0\0\xDIHDR", 8);  // its length, 13, and its name
    std::string_view rest = bytes.substr(kSignature.size());
    if (!rest.starts_with(kHeader) || rest.size() < kHeader.size() + 13)
        throw std::runtime_error(tr("the PNG cannot be read: its header is missing; save it again"));
    rest.remove_prefix(kHeader.size());
    return {integer(rest), integer(rest.substr(4))};
}

}  // namespace

PngPixels decode_png_pixels(std::string_view bytes, int longest_side) {
    const std::string packed = packed_pixels(bytes);
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), INT_MAX));
    const auto [width, height] = size_of(bytes);
    const auto limit = static_cast<std::uint32_t>(longest_side);
    if (width > limit || height > limit) {
        throw std::runtime_error(
            tr("the picture has {} x {} pixels; the limit is {} x {}; make it smaller", width, height, limit, limit));
    }
    // The most bytes that the pixels can unpack to: 16 bits per channel, one more byte per row, and the padding of the
    // passes of an interlaced image. The decoder itself has no limit, so a small file could fill the memory.
    constexpr std::size_t kLargestPixel = 8, kRowBytes = 1, kPasses = 8;
    std::string unpacked(std::size_t{height} * width * kLargestPixel + (height + kPasses) * kRowBytes * kPasses, '\0');
    if (stbi_zlib_decode_buffer(unpacked.data(), static_cast<int>(unpacked.size()), packed.data(),
                                static_cast<int>(packed.size())) < 0) {
        throw std::runtime_error(
            tr("the PNG's pixels cannot be unpacked, or there are more than its size allows; save it again"));
    }
    PngPixels image;
    int channels_in_file = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> codes(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels_in_file, kRgba), stbi_image_free);
    if (!codes) throw std::runtime_error(cannot_be_read());
    image.rgba.assign(codes.get(), codes.get() + std::size_t{height} * width * kRgba);
    return image;
}

void write_png(const std::string& path, const Image& image) { write_file_atomically(path, encode_png(image)); }

}  // namespace twinlight

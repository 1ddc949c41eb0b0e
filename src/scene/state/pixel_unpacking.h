// Converts pixels in client memory to texels: unpacking (3.6.1 to 3.6.4).
#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/frame/texture_formats.h"
#include "scene/state/attributes.h"

namespace twinlight {

// The number of values of a pixel of `format`; nullopt for formats that have neither colours nor depths.
std::optional<int> components_of(Enum format);
// The bytes of one pixel; nullopt for an unknown type, or one that cannot be used with the format (3.6.4).
std::optional<int> pixel_bytes(Enum format, Enum type);

struct PixelSource {
    int width = 0, height = 1, depth = 1;
    Enum format = kGL_RGBA;
    Enum type = kGL_UNSIGNED_BYTE;
    bool is_volume = false;  // of glTexImage3D or glTexSubImage3D: images lie behind each other (3.8.1)
};

// The size in bytes of a bitmap, which has one bit per pixel (3.6.4); 0 if it has no pixels.
std::size_t bitmap_bytes(int width, int height, const PixelStore& store);
// The bits of a bitmap in memory of at least bitmap_bytes(), row by row from the bottom.
std::vector<bool> bitmap_bits(int width, int height, std::span<const std::byte> bytes, const PixelStore& store);
// The stencil values of an image in memory, row by row from the bottom: whole numbers, before any pixel transfer (3.6.4).
std::vector<std::int64_t> stencil_values(const PixelSource& source, const PixelStore& store,
                                         std::span<const std::byte> bytes);

// The number of bytes that are read from the pointer on; 0 for an image without pixels; the largest std::size_t if it
// is more than any memory has.
std::size_t bytes_read(const PixelSource& source, const PixelStore& store);

// An image in memory. unpack() converts one row to RGBA in [0,1]: missing components are 0, alpha 1; luminance L
// becomes R = G = B = L, of which table 3.15 keeps red; so does a depth.
struct PixelRows {
    PixelSource source;
    PixelStore store;
    std::span<const std::byte> bytes;  // at least bytes_read() bytes; null: every value is 0
    PixelTransfer transfer{};
    const PixelMaps* maps = nullptr;

    // Writes source.width pixels to `row`; `z` is the number of the image.
    void unpack(int y, std::vector<glm::dvec4>& row, int z = 0) const;
};

// 3.6.5, "Arithmetic on components" and "RGBA to RGBA lookup". NaN becomes 0.
glm::dvec4 transferred(glm::dvec4 color, const PixelTransfer& transfer, const PixelMaps* maps);

}  // namespace twinlight

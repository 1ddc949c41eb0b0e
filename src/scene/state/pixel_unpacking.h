// Pixels in client memory as texels: unpacking (3.6.1 to 3.6.4), internal formats (3.8.1), mipmaps.
#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/state/attributes.h"

namespace twinlight {

// A texture's largest side; more is GL_INVALID_VALUE. Mesa's llvmpipe has the same.
inline constexpr int kMaxTextureSize = 16384;
inline constexpr int kMaxTextureLevels = 15;
// What all images of a scene may hold together; more is GL_OUT_OF_MEMORY.
inline constexpr std::size_t kMaxTexels = std::size_t{1} << 26;

struct InternalFormat {
    Enum base_format = kGL_RGBA;
    int red = 8, green = 8, blue = 8, alpha = 8;  // bits; of luminance and intensity `red`
};

// The components and bits of an internalformat argument: 1 to 4, a base format or a sized one (table 3.16). Nothing for
// names that are none, or that Twinlight does not hold (depth, compressed, sRGB).
//
// RULING (3.8.1: the resolution is the implementation's choice): 8 bits a component where the name gives no size, else
// what the name says, but 8 for one component alone and 16 for 12: what llvmpipe has.
std::optional<InternalFormat> internal_format(double name);

// How many values a pixel of `format` has; nothing for formats that carry no colour.
std::optional<int> components_of(Enum format);
// Bytes of one pixel; nothing for a type that GL does not know, or that does not go with the format (3.6.4).
std::optional<int> pixel_bytes(Enum format, Enum type);

struct PixelSource {
    int width = 0, height = 1;
    Enum format = kGL_RGBA;
    Enum type = kGL_UNSIGNED_BYTE;
};

// 3.6.4: the bytes of a bitmap, whose pixels are bits; 0 for one without pixels.
std::size_t bitmap_bytes(int width, int height, const PixelStore& store);
// How many bytes a pixel has of those formats and types that State does not follow: indices, depths, stencil values.
std::optional<int> driver_only_pixel_bytes(Enum format, Enum type);

// How many bytes from the pointer on are read; 0 for an image without pixels, the largest number for more than any memory
// has.
std::size_t bytes_read(const PixelSource& source, const PixelStore& store);

// An image in memory, whose rows become RGBA in [0,1] one at a time (missing components 0, alpha 1; table 3.15's luminance
// is R = G = B = L in red).
struct PixelRows {
    PixelSource source;
    PixelStore store;
    std::span<const std::byte> bytes;  // bytes_read() of them at least; null: every value is 0

    void unpack(int y, std::vector<glm::dvec4>& row) const;  // row: source.width of them
};

// The components that the format keeps, rounded to its bits.
glm::vec4 stored(const glm::dvec4& rgba, const InternalFormat& format);

// The next smaller level by a box filter (3.8.8 recommends it), rounded to the format's bits. Odd sizes: the last
// column or row is left out.
TextureImage half(const TextureImage& image, const InternalFormat& format);

}  // namespace twinlight

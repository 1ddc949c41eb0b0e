// The internal formats of textures (3.8.1), and what they store; the limits on the sizes of textures.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <optional>

#include "scene/frame/frame.h"

namespace twinlight {

// The largest side of a texture; more is GL_INVALID_VALUE. Mesa's llvmpipe has the same limit.
inline constexpr int kMaxTextureSize = 16384;
inline constexpr int kMaxTextureLevels = 15;
// The same for textures of three dimensions: llvmpipe's limit; GL requires at least 16 (table 6.29).
inline constexpr int kMax3dTextureSize = 2048;
inline constexpr int kMax3dTextureLevels = 12;
// The limit on the texels of all images of a scene together; more is GL_OUT_OF_MEMORY.
inline constexpr std::size_t kMaxTexels = std::size_t{1} << 26;

struct InternalFormat {
    Enum base_format = kGL_RGBA;
    int red = 8, green = 8, blue = 8, alpha = 8;  // bits; luminance, intensity and depths use `red`
};

// The components and bits for an internalformat argument: 1 to 4, a base format or a sized format (table 3.16). Returns
// nullopt for other values, and for formats that Twinlight does not support (compressed, sRGB).
//
// RULING (3.8.1 leaves the resolution to the implementation): 8 bits per component and 24 for depths if the name gives no size;
// otherwise the size in the name, but 8 bits for a single component, and 16 instead of 12. This is what llvmpipe does.
std::optional<InternalFormat> internal_format(double name);

// RULING (3.8.1): a generic compressed format, such as GL_COMPRESSED_RGB, is replaced by its base format. The section allows that;
// drivers may compress the image instead, each in its own way. Other names are returned as they are.
double without_compression(double name);

// The components that the internal format stores, rounded to its bits.
glm::vec4 stored(const glm::dvec4& rgba, const InternalFormat& format);

// The next smaller level, by a box filter (recommended by 3.8.8) and rounded to the format's bits. If a side is odd,
// the last column, row or layer is ignored.
TextureImage half(const TextureImage& image, const InternalFormat& format);

}  // namespace twinlight

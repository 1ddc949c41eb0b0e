#include "scene/frame/texture_formats.h"

#include <algorithm>
#include <cmath>

namespace twinlight {

std::optional<InternalFormat> internal_format(double name) {
    if (!(name >= 1 && name <= 0xFFFF) || name != std::trunc(name)) return std::nullopt;
    const auto same = [](Enum base, int bits) { return InternalFormat{base, bits, bits, bits, bits}; };
    switch (static_cast<Enum>(name)) {
        case 1:
        case kGL_LUMINANCE:
        case kGL_LUMINANCE4:
        case kGL_LUMINANCE8: return same(kGL_LUMINANCE, 8);
        case 2:
        case kGL_LUMINANCE_ALPHA:
        case kGL_LUMINANCE6_ALPHA2:
        case kGL_LUMINANCE8_ALPHA8: return same(kGL_LUMINANCE_ALPHA, 8);
        case 3:
        case kGL_RGB:
        case kGL_RGB8: return same(kGL_RGB, 8);
        case 4:
        case kGL_RGBA:
        case kGL_RGBA8: return same(kGL_RGBA, 8);
        case kGL_ALPHA:
        case kGL_ALPHA4:
        case kGL_ALPHA8: return same(kGL_ALPHA, 8);
        case kGL_INTENSITY:
        case kGL_INTENSITY4:
        case kGL_INTENSITY8: return same(kGL_INTENSITY, 8);
        case kGL_ALPHA12:
        case kGL_ALPHA16: return same(kGL_ALPHA, 16);
        case kGL_LUMINANCE12:
        case kGL_LUMINANCE16: return same(kGL_LUMINANCE, 16);
        case kGL_LUMINANCE12_ALPHA4:
        case kGL_LUMINANCE12_ALPHA12:
        case kGL_LUMINANCE16_ALPHA16: return same(kGL_LUMINANCE_ALPHA, 16);
        case kGL_INTENSITY12:
        case kGL_INTENSITY16: return same(kGL_INTENSITY, 16);
        case kGL_LUMINANCE4_ALPHA4: return same(kGL_LUMINANCE_ALPHA, 4);
        case kGL_R3_G3_B2: return InternalFormat{kGL_RGB, 3, 3, 2, 8};
        case kGL_RGB4: return same(kGL_RGB, 4);
        case kGL_RGB5: return same(kGL_RGB, 5);
        case kGL_RGB10: return same(kGL_RGB, 10);
        case kGL_RGB12:
        case kGL_RGB16: return same(kGL_RGB, 16);
        case kGL_RGBA2:
        case kGL_RGBA4: return same(kGL_RGBA, 4);
        case kGL_RGB5_A1: return InternalFormat{kGL_RGBA, 5, 5, 5, 1};
        case kGL_RGB10_A2: return InternalFormat{kGL_RGBA, 10, 10, 10, 2};
        case kGL_RGBA12:
        case kGL_RGBA16: return same(kGL_RGBA, 16);
        case kGL_DEPTH_COMPONENT16: return same(kGL_DEPTH_COMPONENT, 16);
        case kGL_DEPTH_COMPONENT:
        case kGL_DEPTH_COMPONENT24: return same(kGL_DEPTH_COMPONENT, 24);
        case kGL_DEPTH_COMPONENT32: return same(kGL_DEPTH_COMPONENT, 32);
        default: return std::nullopt;
    }
}

double without_compression(double name) {
    constexpr std::array<std::pair<Enum, Enum>, 6> kBaseFormats = {
        {{kGL_COMPRESSED_ALPHA, kGL_ALPHA},
         {kGL_COMPRESSED_LUMINANCE, kGL_LUMINANCE},
         {kGL_COMPRESSED_LUMINANCE_ALPHA, kGL_LUMINANCE_ALPHA},
         {kGL_COMPRESSED_INTENSITY, kGL_INTENSITY},
         {kGL_COMPRESSED_RGB, kGL_RGB},
         {kGL_COMPRESSED_RGBA, kGL_RGBA}}};
    for (const auto& [compressed, base] : kBaseFormats)
        if (name == compressed) return base;
    return name;
}

glm::vec4 stored(const glm::dvec4& rgba, const InternalFormat& format) {
    const auto rounded = [](double v, int bits) {
        const auto largest = static_cast<double>((std::uint64_t{1} << bits) - 1);
        const double inside = v > 0 ? std::min(v, 1.0) : 0;  // NaN is 0
        return static_cast<float>(static_cast<double>(static_cast<std::uint64_t>(inside * largest + 0.5)) / largest);
    };
    const float r = rounded(rgba.r, format.red), a = rounded(rgba.a, format.alpha);
    switch (format.base_format) {  // table 3.15
        case kGL_ALPHA: return {0, 0, 0, a};
        case kGL_LUMINANCE:
        case kGL_DEPTH_COMPONENT: return {r, r, r, 1};
        case kGL_LUMINANCE_ALPHA: return {r, r, r, a};
        case kGL_INTENSITY: return {r, r, r, r};
        case kGL_RGB: return {r, rounded(rgba.g, format.green), rounded(rgba.b, format.blue), 1};
        default: return {r, rounded(rgba.g, format.green), rounded(rgba.b, format.blue), a};
    }
}

TextureImage half(const TextureImage& image, const InternalFormat& format) {
    TextureImage result = image.half_size();
    const int dx = image.width > 1 ? 1 : 0, dy = image.height > 1 ? 1 : 0, dz = image.depth > 1 ? 1 : 0;
    for (int z = 0; z < result.depth; ++z) {
        for (int y = 0; y < result.height; ++y) {
            for (int x = 0; x < result.width; ++x) {
                const int x0 = x * (1 + dx), y0 = y * (1 + dy), z0 = z * (1 + dz);
                const auto sum = [&](int layer) {
                    return glm::dvec4(image.texel(x0, y0, layer)) + glm::dvec4(image.texel(x0 + dx, y0, layer)) +
                           glm::dvec4(image.texel(x0, y0 + dy, layer)) +
                           glm::dvec4(image.texel(x0 + dx, y0 + dy, layer));
                };
                const glm::dvec4 mean = dz == 0 ? sum(z0) / 4.0 : (sum(z0) + sum(z0 + 1)) / 8.0;
                result.texels.push_back(stored(mean, format));
            }
        }
    }
    return result;
}

}  // namespace twinlight

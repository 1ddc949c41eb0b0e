#include "render/webgl/webgl_textures.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace twinlight::webgl {

namespace {

bool uses_mipmaps(const Texture& texture) {
    return texture.min_filter != kGL_NEAREST && texture.min_filter != kGL_LINEAR;
}

// Whether each of s, t and r shows the border's colour (3.8.7).
std::array<bool, 3> shown_borders(const Texture& texture) {
    const auto shows = [&](Enum mode) {
        return mode == kGL_CLAMP_TO_BORDER || (mode == kGL_CLAMP && texture.filters_linearly());
    };
    return {shows(texture.wrap_s), !texture.is_flat() && shows(texture.wrap_t),
            texture.is_volume() && shows(texture.wrap_r)};
}
bool shows_border(const Texture& texture) { return std::ranges::count(shown_borders(texture), true) > 0; }

}  // namespace

bool has_rim(const Texture& texture) { return shows_border(texture) && !uses_mipmaps(texture) && !texture.is_cube(); }

bool lacks_border(const Texture& texture) { return shows_border(texture) && !has_rim(texture); }

glm::dvec3 part_inside(const Texture& texture) {
    glm::dvec3 inside(1);
    if (!has_rim(texture)) return inside;
    const TextureImage& image = texture.levels.front();
    const std::array<int, 3> sizes = {image.width, image.height, image.depth};
    for (std::size_t i = 0; i < 3; ++i)
        if (shown_borders(texture)[i]) inside[static_cast<int>(i)] = sizes[i] / (sizes[i] + 2.0);
    return inside;
}

Texture with_rim(const Texture& texture) {
    const TextureImage& image = texture.levels.front();
    const auto [s, t, r] = shown_borders(texture);
    const int x0 = s ? 1 : 0, y0 = t ? 1 : 0, z0 = r ? 1 : 0;
    Texture result = texture;
    result.levels.resize(1);
    TextureImage& wide = result.levels.front();
    wide.width += 2 * x0;
    wide.height += 2 * y0;
    wide.depth += 2 * z0;
    wide.texels.assign(static_cast<std::size_t>(wide.width) * static_cast<std::size_t>(wide.height) *
                           static_cast<std::size_t>(wide.depth),
                       glm::vec4(texture.border_texel()));
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                wide.texels[wide.index(x + x0, y + y0, z + z0)] = image.texel(x, y, z);
    return result;
}

}  // namespace twinlight::webgl

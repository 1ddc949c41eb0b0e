#include "render/webgl/webgl_textures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "render/programmable/export/core_elements.h"

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

// The base level with the rim.
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

// Whether WebGL's textures of 8 bits hold these texels exactly.
bool are_bytes(const Texture& texture) {
    for (std::size_t face = 0; face < texture.face_count(); ++face)
        for (const TextureImage& image : texture.face(face))
            for (const glm::vec4& texel : image.texels)
                for (int i = 0; i < 4; ++i)
                    if (std::abs(texel[i] * 255 - std::round(texel[i] * 255)) > 1e-3F) return false;
    return true;
}

enum class Format { kDepth, kBytes, kFloats };
Format format_of(const Texture& texture) {
    if (texture.compares()) return Format::kDepth;
    return are_bytes(texture) ? Format::kBytes : Format::kFloats;
}

void append(const glm::vec4& texel, Format format, std::vector<std::uint32_t>& words) {
    switch (format) {
        case Format::kDepth: words.push_back(static_cast<std::uint32_t>(std::llround(texel.r * 4294967295.0))); break;
        case Format::kBytes: words.push_back(programmable::texel_word(texel)); break;
        case Format::kFloats:
            for (int i = 0; i < 4; ++i) words.push_back(std::bit_cast<std::uint32_t>(texel[i]));
            break;
    }
}

Json parameters_of(const Texture& texture) {
    const auto wrap = [](Enum mode) -> Enum {
        return mode == kGL_CLAMP || mode == kGL_CLAMP_TO_BORDER ? Enum{kGL_CLAMP_TO_EDGE} : mode;
    };
    Json parameters = {{kGL_TEXTURE_MIN_FILTER, texture.min_filter},
                       {kGL_TEXTURE_MAG_FILTER, texture.mag_filter},
                       {kGL_TEXTURE_WRAP_S, wrap(texture.wrap_s)},
                       {kGL_TEXTURE_WRAP_T, texture.is_flat() ? Enum{kGL_CLAMP_TO_EDGE} : wrap(texture.wrap_t)},
                       {kGL_TEXTURE_WRAP_R, wrap(texture.wrap_r)},
                       {kGL_TEXTURE_MAX_LEVEL, texture.levels.size() - 1},
                       {kGL_TEXTURE_MIN_LOD, texture.min_lod},
                       {kGL_TEXTURE_MAX_LOD, texture.max_lod}};
    if (texture.compares()) {
        parameters.push_back({kGL_TEXTURE_COMPARE_MODE, texture.compare_mode});
        parameters.push_back({kGL_TEXTURE_COMPARE_FUNC, texture.compare_func});
    }
    return parameters;
}

}  // namespace

bool has_rim(const Texture& texture) { return shows_border(texture) && !uses_mipmaps(texture) && !texture.is_cube(); }

bool lacks_border(const Texture& texture) { return shows_border(texture) && !has_rim(texture); }

namespace {

bool clamps_to_edge(const Texture& texture) {
    return texture.wrap_s == kGL_CLAMP_TO_EDGE && texture.wrap_t == kGL_CLAMP_TO_EDGE;
}

}  // namespace

bool stays_on_faces(const Texture& texture) {
    return texture.is_cube() && texture.filters_linearly() && clamps_to_edge(texture) && !uses_mipmaps(texture);
}

bool lacks_faces(const Texture& texture) {
    return texture.is_cube() && texture.filters_linearly() && !stays_on_faces(texture);
}

glm::dvec3 part_inside(const Texture& texture) {
    glm::dvec3 inside(1);
    if (stays_on_faces(texture)) return inside * (1 - 1.0 / texture.levels.front().width);
    if (!has_rim(texture)) return inside;
    const TextureImage& image = texture.levels.front();
    const std::array<int, 3> sizes = {image.width, image.height, image.depth};
    for (std::size_t i = 0; i < 3; ++i)
        if (shown_borders(texture)[i]) inside[static_cast<int>(i)] = sizes[i] / (sizes[i] + 2.0);
    return inside;
}

Json texture_json(const Texture& given, programmable::ExportWords& words) {
    const Texture texture = has_rim(given) ? with_rim(given) : given;
    const Format format = format_of(texture);
    Json images = Json::array();
    for (std::size_t face = 0; face < texture.face_count(); ++face)
        for (std::size_t level = 0; level < texture.face(face).size(); ++level) {
            const TextureImage& image = texture.face(face)[level];
            if (image.texels.empty()) continue;
            std::vector<std::uint32_t> texels;
            for (const glm::vec4& texel : image.texels) append(texel, format, texels);
            images.push_back({face, level, image.width, image.height, image.depth, words.place_of(texels).first});
        }
    return {{"target", texture.is_flat() ? Enum{kGL_TEXTURE_2D} : texture.target},
            {"format", format == Format::kDepth   ? "depth"
                       : format == Format::kBytes ? "rgba8"
                                                  : "rgba32f"},
            {"images", images},
            {"levels", texture.levels.size()},
            {"anisotropy", texture.max_anisotropy},
            {"parameters", parameters_of(texture)}};
}

}  // namespace twinlight::webgl

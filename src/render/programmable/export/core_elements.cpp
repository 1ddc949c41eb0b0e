#include "render/programmable/export/core_elements.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace twinlight::programmable {

std::pair<Enum, std::vector<std::uint32_t>> core_elements(const Draw& draw, bool flat) {
    const std::size_t count = draw.count();
    std::vector<std::uint32_t> indices;
    const auto add = [&](std::initializer_list<std::size_t> corners) {
        for (const std::size_t corner : corners) indices.push_back(draw.index(corner));
    };
    if (draw.mode == kGL_QUADS) {
        for (std::size_t i = 0; i + 3 < count; i += 4) {
            if (flat)
                add({i, i + 1, i + 3, i + 1, i + 2, i + 3});
            else
                add({i, i + 1, i + 2, i, i + 2, i + 3});
        }
    } else if (draw.mode == kGL_QUAD_STRIP) {
        for (std::size_t i = 0; i + 3 < count; i += 2) add({i, i + 1, i + 3, i + 2, i, i + 3});
    } else if (draw.mode == kGL_POLYGON) {
        for (std::size_t i = 1; i + 1 < count; ++i) add({i, i + 1, 0});
    } else {
        for (std::size_t i = 0; i < count; ++i) indices.push_back(draw.index(i));
        return {draw.mode, indices};
    }
    return {kGL_TRIANGLES, indices};
}

double point_size(const Draw& draw) { return draw.raster.point_parameters.derived_size(draw.raster.point_size, 0); }

std::uint32_t texel_word(const glm::vec4& texel) {
    std::uint32_t word = 0;
    for (int c = 0; c < 4; ++c)
        word |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(texel[c], 0.0F, 1.0F))) << (8 * c);
    return word;
}

}  // namespace twinlight::programmable

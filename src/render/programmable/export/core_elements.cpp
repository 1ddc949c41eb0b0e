#include "render/programmable/export/core_elements.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace twinlight::programmable {

CoreElements core_elements(const Draw& draw, bool flat) {
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

CoreElements separate_elements(CoreElements elements) {
    const Enum mode = elements.first;
    std::vector<std::uint32_t>& indices = elements.second;
    std::vector<std::uint32_t> separate;
    const std::size_t count = indices.size();
    const auto add = [&](std::initializer_list<std::size_t> corners) {
        for (const std::size_t corner : corners) separate.push_back(indices[corner]);
    };
    if (mode == kGL_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < count; ++i)
            if (i % 2 == 0)
                add({i, i + 1, i + 2});
            else
                add({i + 1, i, i + 2});
    } else if (mode == kGL_TRIANGLE_FAN) {
        for (std::size_t i = 1; i + 1 < count; ++i) add({0, i, i + 1});
    } else if (mode == kGL_LINE_STRIP || mode == kGL_LINE_LOOP) {
        for (std::size_t i = 0; i + 1 < count; ++i) add({i, i + 1});
        if (mode == kGL_LINE_LOOP && count > 1) add({count - 1, 0});
    } else {
        // An incomplete primitive at the end draws nothing.
        indices.resize(count - count % (mode == kGL_TRIANGLES ? 3 : mode == kGL_LINES ? 2 : 1));
        return elements;
    }
    const bool has_triangles = mode == kGL_TRIANGLE_STRIP || mode == kGL_TRIANGLE_FAN;
    return {has_triangles ? kGL_TRIANGLES : kGL_LINES, separate};
}

double point_size(const Draw& draw) { return draw.raster.point_parameters.derived_size(draw.raster.point_size, 0); }

std::uint32_t texel_word(const glm::vec4& texel) {
    std::uint32_t word = 0;
    for (int c = 0; c < 4; ++c)
        word |= static_cast<std::uint32_t>(std::lround(255 * std::clamp(texel[c], 0.0F, 1.0F))) << (8 * c);
    return word;
}

}  // namespace twinlight::programmable

#include "render/programmable/kept/core_elements.h"

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

}  // namespace twinlight::programmable

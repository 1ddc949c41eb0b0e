#include "render/reference/surface_edges.h"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec2.hpp>

#include "render/reference/reference.h"

namespace twinlight::reference {

namespace {

// All that is drawn, moved in the window by that part of a pixel.
Frame moved(Frame frame, const glm::dvec2& pixels) {
    for (auto& item : frame.items) {
        Draw* draw = std::get_if<Draw>(&item);
        if (!draw || draw->raster.viewport.width <= 0 || draw->raster.viewport.height <= 0) continue;
        const glm::dvec2 ndc = 2.0 * pixels / glm::dvec2(draw->raster.viewport.width, draw->raster.viewport.height);
        draw->clip_from_eye = glm::translate(glm::dmat4(1), glm::dvec3(ndc, 0)) * draw->clip_from_eye;
    }
    return frame;
}

}  // namespace

void add_surface_edges(const Frame& frame, const Options& options, PixelMask& edge) {
    constexpr double kBeside = 1e-3;  // of a pixel
    constexpr float kHalfCode = 0.5F / 255;
    const Image here = render(frame, options);
    for (const glm::dvec2& beside : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
        const Image there = render(moved(frame, kBeside * beside), options);
        for (std::size_t i = 0; i < edge.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                edge[i] = edge[i] || std::abs(here.pixels[i][c] - there.pixels[i][c]) > kHalfCode;
    }
}

}  // namespace twinlight::reference

// The current raster position: glRasterPos and glWindowPos (2.13).
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/state/state.h"

namespace twinlight {

namespace {

// A driver computes the position in floats. This is far more than they lose with a window of thousands of pixels.
constexpr double kRasterDoubt = 0.01;  // of a pixel
constexpr double kClipDoubt = 1e-5;    // of the larger of two numbers that are compared

}  // namespace

std::shared_ptr<RasterVertex> State::raster_vertex() const {
    auto raster = std::make_shared<RasterVertex>();
    raster->vertex = a_.current;
    raster->vertex.position_object = {0, 0, 0, 1};
    raster->vertex.material = 0;
    raster->secondary_color = a_.secondary_color;
    raster->fog_coord = a_.fog_coord;
    raster->fog_by_coordinates = a_.fog.by_coordinates;
    for (std::size_t i = 0; i < raster->units.size(); ++i) raster->units[i].tex_coord = a_.tex_coord(i);
    return raster;
}

// The position is transformed and lit as a vertex is. If the clip volume does not contain it, it is not valid.
void State::raster_pos(const Command& c) {
    const std::shared_ptr<RasterVertex> raster = raster_vertex();
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        raster->vertex.position_object[static_cast<int>(i)] = c.number(i);
    sanitize(raster->vertex);
    raster->lighting = a_.lighting;
    raster->eye_from_object = modelview();
    raster->clip_from_eye = projection();
    for (std::size_t i = 0; i < raster->units.size(); ++i) {
        raster->units[i].texture_matrix = texture_[i].back().matrix;
        raster->units[i].generated = generated_coordinates(a_.units[i]);
    }
    const glm::dvec4 eye = modelview() * raster->vertex.position_object, clip = projection() * eye;
    RasterPosition& position = a_.raster_position;
    position.is_valid = clip.w > 0;  // RULING: a position with w = 0 has no place in the window
    position.is_doubtful = false;
    const auto must_be_inside = [&](double distance, double size) {
        position.is_valid = position.is_valid && distance >= 0;
        position.is_doubtful |= std::abs(distance) <= kClipDoubt * size;
    };
    for (int i = 0; i < 3; ++i) must_be_inside(clip.w - std::abs(clip[i]), std::abs(clip.w));
    for (const ClipPlane& plane : a_.clip_planes) {
        const glm::dvec4 terms = plane.equation_eye * eye;
        if (plane.enabled)
            must_be_inside(terms.x + terms.y + terms.z + terms.w,
                           std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w));
    }
    position.is_doubtful = position.is_doubtful && clip.w > 0;
    position.vertex = raster;
    if (!position.is_valid && !position.is_doubtful) return;
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    const Viewport& viewport = a_.raster.viewport;
    const double near = a_.raster.depth_near, far = a_.raster.depth_far;
    position.position_window = {(ndc.x + 1) / 2 * viewport.width + viewport.x,
                                (ndc.y + 1) / 2 * viewport.height + viewport.y, (ndc.z + 1) / 2 * (far - near) + near,
                                clip.w};
    position.doubt = kRasterDoubt;
}

// Without matrices, lighting and clipping; the distance for fog is 0.
void State::window_pos(const Command& c) {
    glm::dvec4 window{0, 0, 0, 1};
    for (std::size_t i = 0; i < c.arguments.size(); ++i) window[static_cast<int>(i)] = c.number(i);
    const double near = a_.raster.depth_near, far = a_.raster.depth_far;
    window.z = near + std::clamp(window.z, 0.0, 1.0) * (far - near);
    a_.raster_position = {.position_window = window, .vertex = raster_vertex()};
}

}  // namespace twinlight

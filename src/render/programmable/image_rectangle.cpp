#include "render/programmable/image_rectangle.h"

#include <utility>
#include <vector>

namespace twinlight::programmable {

Draw as_textured_rectangle(const Draw& draw) {
    const WindowPixels& pixels = *draw.pixels;
    const TextureImage& image = pixels.image->levels.front();
    const glm::ivec2 corner = pixels.places.front();
    Draw rectangle = draw;
    rectangle.mode = kGL_QUADS;
    rectangle.pixels = nullptr;
    rectangle.eye_from_object = rectangle.clip_from_eye = glm::dmat4(1);
    rectangle.texture = {.texture = pixels.image, .env_mode = kGL_REPLACE};
    // What holds for polygons, but not for pixels.
    RasterState& raster = rectangle.raster;
    raster.viewport = {corner.x, corner.y, image.width, image.height};
    raster.front_face = kGL_CCW;  // 4.1.5: the stencil test of the front
    raster.cull_enabled = false;
    raster.polygon_mode_front = raster.polygon_mode_back = kGL_FILL;
    raster.polygon_offset = {};
    std::vector<Vertex> corners(4, draw.vertices[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double s = i == 1 || i == 2 ? 1 : 0, t = i >= 2 ? 1 : 0;
        corners[i].position_object = {2 * s - 1, 2 * t - 1, 2 * pixels.depths.front() - 1, 1};
        corners[i].tex_coord = {s, t, 0, 1};
    }
    rectangle.vertices = std::move(corners);
    return rectangle;
}

}  // namespace twinlight::programmable

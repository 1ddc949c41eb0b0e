// Reads the picture from any context.
#include <algorithm>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight {

namespace {

Image flipped(const Image& bottom_up) {
    const auto& [width, height, pixels] = bottom_up;
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(bottom_up.index(0, height - 1 - y));
        std::copy(row, row + width, image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, y)));
    }
    return image;
}

}  // namespace

Image read_pixels(int width, int height) {
    Image bottom_up(width, height);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, bottom_up.pixels.data());
    return flipped(bottom_up);
}

Image read_depths(int width, int height) {
    Image bottom_up(width, height);
    std::vector<GLfloat> depths(bottom_up.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    for (std::size_t i = 0; i < depths.size(); ++i) bottom_up.pixels[i] = {depths[i], depths[i], depths[i], 1};
    return flipped(bottom_up);
}

Image read_stencils(int width, int height) {
    Image bottom_up(width, height);
    std::vector<GLubyte> values(bottom_up.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float value = static_cast<float>(values[i]) / 255.0F;
        bottom_up.pixels[i] = {value, value, value, 1};
    }
    return flipped(bottom_up);
}

}  // namespace twinlight

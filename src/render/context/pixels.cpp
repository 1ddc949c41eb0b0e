// Reads the picture from any context.
#include <algorithm>
#include <vector>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight {

namespace {

void flip(Image& image) {
    const auto row = [&](int y) { return image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, y)); };
    for (int y = 0; y < image.height / 2; ++y)
        std::swap_ranges(row(y), row(y) + image.width, row(image.height - 1 - y));
}

}  // namespace

Image read_pixels(int width, int height, int x, int y) {
    Image image(width, height);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(x, y, width, height, GL_RGBA, GL_FLOAT, image.pixels.data());
    flip(image);
    return image;
}

Image read_depths(int width, int height, int x, int y) {
    Image image(width, height);
    std::vector<GLfloat> depths(image.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(x, y, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    for (std::size_t i = 0; i < depths.size(); ++i) image.pixels[i] = {depths[i], depths[i], depths[i], 1};
    flip(image);
    return image;
}

Image read_stencils(int width, int height, int x, int y) {
    Image image(width, height);
    std::vector<GLubyte> values(image.pixels.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float value = static_cast<float>(values[i]) / 255.0F;
        image.pixels[i] = {value, value, value, 1};
    }
    flip(image);
    return image;
}

}  // namespace twinlight

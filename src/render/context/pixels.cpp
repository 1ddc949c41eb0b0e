// Reads the picture from any context.
#include <algorithm>

#include "render/context/context.h"
#include "render/context/gl.h"

namespace twinlight {

Image read_pixels(int width, int height) {
    Image bottom_up(width, height);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, bottom_up.pixels.data());
    Image image(width, height);
    for (int y = 0; y < height; ++y) {
        const auto row = bottom_up.pixels.begin() + static_cast<std::ptrdiff_t>(bottom_up.index(0, height - 1 - y));
        std::copy(row, row + width, image.pixels.begin() + static_cast<std::ptrdiff_t>(image.index(0, y)));
    }
    return image;
}

}  // namespace twinlight

// A picture to draw into that is not the context's own: of codes or of floats, with one sample or several for a pixel.
#pragma once

#include <vector>

#include "render/context/context.h"

namespace twinlight {

// Owns objects of the context that is current; dies before that does.
class RenderTarget {
  public:
    // `samples`: a side of the square of samples that a pixel has, a power of two. What is drawn is samples * width by
    // samples * height pixels. Throws std::runtime_error where the driver has none such.
    RenderTarget(int width, int height, ColorBuffer color_buffer, int samples = 1);
    ~RenderTarget();
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;

    void bind() const;  // drawing goes there
    // Makes the means of each pixel's samples, by halves; drawing goes to the context's own buffer again.
    void resolve() const;
    // Of the last resolve(), row 0 at the top.
    Image read() const;

  private:
    struct Level {
        int width = 0, height = 0;
        unsigned framebuffer = 0, color = 0;
    };

    std::vector<Level> levels_;  // the first is drawn into, the last is the picture
    unsigned depth_ = 0;
    unsigned own_ = 0;  // the context's own framebuffer
};

}  // namespace twinlight

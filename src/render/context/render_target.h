// An offscreen buffer to draw into, of bytes or floats, with one or several samples per pixel.
#pragma once

#include <vector>

#include "render/context/context.h"

namespace twinlight {

// Owns objects of the current context, so it must be destroyed before the context.
class RenderTarget {
  public:
    // Each pixel has samples * samples samples; `samples` is a power of two. The drawing has samples * width by samples
    // * height pixels. Throws std::runtime_error if the driver cannot create it.
    RenderTarget(int width, int height, ColorBuffer color_buffer, int samples = 1);
    ~RenderTarget();
    RenderTarget(const RenderTarget&) = delete;
    RenderTarget& operator=(const RenderTarget&) = delete;

    void bind() const;  // draws go here from now on
    // Averages each pixel's samples, by halving; then draws go to the context's own buffer again.
    void resolve() const;
    // The picture of the last resolve(), row 0 at the top.
    Image read() const;
    void release() const;  // draws go to the context's own buffer again, without a resolve()

  private:
    struct Level {
        int width = 0, height = 0;
        unsigned framebuffer = 0, color = 0;
    };

    std::vector<Level> levels_;  // draws go to the first; the last is the picture
    unsigned depth_ = 0;         // and stencil
    unsigned own_ = 0;           // the context's own framebuffer
};

}  // namespace twinlight

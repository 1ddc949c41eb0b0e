// A place to draw beside the window: a GLX pbuffer on a connection of its own, so that a thread can use it.
#include <X11/Xlib.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "render/context/context.h"
#include "render/context/gl.h"

// GLX comes after render/context/gl.h, which declares GL.
#include <GL/glx.h>

namespace twinlight {
namespace {

class GlxContext final : public OffscreenContext {
  public:
    GlxContext(int width, int height, ColorBuffer color_buffer) : display_(XOpenDisplay(nullptr)) {
        if (!display_) throw std::runtime_error("GLX: cannot connect to the display");
        const int bits = color_buffer == ColorBuffer::kFloat ? 32 : 8;
        const int type = color_buffer == ColorBuffer::kFloat ? GLX_RGBA_FLOAT_BIT_ARB : GLX_RGBA_BIT;
        // With one buffer only, llvmpipe would copy each picture to the X server, which refuses it for a pbuffer.
        // clang-format off
        const int wanted[] = {
            GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RENDER_TYPE, type, GLX_DOUBLEBUFFER, True, GLX_DEPTH_SIZE, 24,
            GLX_STENCIL_SIZE, 8, GLX_RED_SIZE, bits, GLX_GREEN_SIZE, bits, GLX_BLUE_SIZE, bits, GLX_ALPHA_SIZE, bits, None};
        // clang-format on
        int count = 0;
        GLXFBConfig* configs = glXChooseFBConfig(display_, DefaultScreen(display_), wanted, &count);
        if (configs && count > 0) {
            const int size[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, None};
            pbuffer_ = glXCreatePbuffer(display_, configs[0], size);
            const int render_type = color_buffer == ColorBuffer::kFloat ? GLX_RGBA_FLOAT_TYPE_ARB : GLX_RGBA_TYPE;
            context_ = glXCreateNewContext(display_, configs[0], render_type, nullptr, True);
        }
        if (configs) XFree(configs);
        if (!pbuffer_ || !context_ || !glXMakeContextCurrent(display_, pbuffer_, pbuffer_, context_)) {
            close();
            throw std::runtime_error("GLX: this driver cannot draw beside the window");
        }
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~GlxContext() override {
        glFinish();
        close();
    }
    GlxContext(const GlxContext&) = delete;
    GlxContext& operator=(const GlxContext&) = delete;

    void make_current() override {
        if (!glXMakeContextCurrent(display_, pbuffer_, pbuffer_, context_))
            throw std::runtime_error("GLX cannot make its context current again");
    }

  private:
    void close() {
        glXMakeContextCurrent(display_, None, None, nullptr);
        if (context_) glXDestroyContext(display_, context_);
        if (pbuffer_) glXDestroyPbuffer(display_, pbuffer_);
        XCloseDisplay(display_);
    }

    Display* display_;
    GLXPbuffer pbuffer_ = 0;
    GLXContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height, ColorBuffer color_buffer) {
    return std::make_unique<GlxContext>(width, height, color_buffer);
}

}  // namespace twinlight

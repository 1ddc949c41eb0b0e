#include "app/demo/x_drawing_context.h"

#include <algorithm>
#include <stdexcept>

#include "base/text/translation.h"
#include "render/context/gl.h"

// X's headers come after render/context/gl.h, which declares GL.
#include <GL/glx.h>
#include <X11/Xlib.h>

namespace twinlight::demo {

struct DrawingContext::X {
    Display* display = nullptr;
    GLXFBConfig config{};
    GLXContext context = nullptr;
    GLXPbuffer buffer = 0;
    int width = 0, height = 0;

    ~X() {
        if (!display) return;
        glXMakeContextCurrent(display, 0, 0, nullptr);
        if (buffer != 0) glXDestroyPbuffer(display, buffer);
        if (context) glXDestroyContext(display, context);
        XCloseDisplay(display);
    }
};

DrawingContext::DrawingContext() : x_(std::make_unique<X>()) {
    x_->display = XOpenDisplay(nullptr);
    if (!x_->display) throw std::runtime_error(tr("X gives no second connection"));
    constexpr int kAttributes[] = {GLX_DRAWABLE_TYPE,
                                   GLX_PBUFFER_BIT,
                                   GLX_RENDER_TYPE,
                                   GLX_RGBA_BIT,
                                   GLX_RED_SIZE,
                                   8,
                                   GLX_GREEN_SIZE,
                                   8,
                                   GLX_BLUE_SIZE,
                                   8,
                                   GLX_ALPHA_SIZE,
                                   8,
                                   GLX_DEPTH_SIZE,
                                   24,
                                   GLX_STENCIL_SIZE,
                                   8,
                                   GLX_SAMPLES,
                                   0,
                                   GLX_DOUBLEBUFFER,
                                   True,
                                   None};
    int count = 0;
    GLXFBConfig* const configs = glXChooseFBConfig(x_->display, DefaultScreen(x_->display), kAttributes, &count);
    if (configs && count > 0) x_->config = configs[0];
    if (configs) XFree(configs);
    if (x_->config) x_->context = glXCreateNewContext(x_->display, x_->config, GLX_RGBA_TYPE, nullptr, True);
    if (!x_->context) throw std::runtime_error(tr("X gives no context without a window"));
}

DrawingContext::~DrawingContext() = default;

void DrawingContext::allow_threads() { XInitThreads(); }

// A driver that interpolates downwards from the top rounds by the buffer's height, so a larger buffer would not do.
void DrawingContext::make_current(int width, int height) {
    if (width == x_->width && height == x_->height) return;
    const int attributes[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, GLX_PRESERVED_CONTENTS, True, None};
    const GLXPbuffer buffer = glXCreatePbuffer(x_->display, x_->config, attributes);
    if (buffer == 0 || !glXMakeContextCurrent(x_->display, buffer, buffer, x_->context))
        throw std::runtime_error(tr("X gives no buffer without a window"));
    if (x_->buffer != 0) glXDestroyPbuffer(x_->display, x_->buffer);
    x_->buffer = buffer;
    x_->width = width;
    x_->height = height;
}

}  // namespace twinlight::demo

// GLX: a libGL that draws into a pbuffer of an X server, on a connection of its own, so that a thread can use it.
#include <X11/Xlib.h>

#include <mutex>
#include <optional>
#include <stdexcept>

#include "base/text/translation.h"
#include "render/context/context_buffer.h"
#include "render/context/gl.h"
#include "render/context/provider.h"

// GLX comes after render/context/gl.h, which declares GL.
#include <GL/glx.h>

namespace twinlight {

namespace {

struct GlxFunctions {
    explicit GlxFunctions(const Library& library) {
        const Library x("libX11.so.6");
        x.find("XOpenDisplay", open_display);
        x.find("XCloseDisplay", close_display);
        x.find("XFree", free);
        x.find("XSync", sync);
        x.find("XSetErrorHandler", set_error_handler);
        library.find("glXChooseFBConfig", choose_config);
        library.find("glXCreatePbuffer", create_pbuffer);
        library.find("glXDestroyPbuffer", destroy_pbuffer);
        library.find("glXCreateNewContext", create_context);
        library.find("glXDestroyContext", destroy_context);
        library.find("glXMakeContextCurrent", make_current);
        library.find("glXGetProcAddressARB", address);
    }

    decltype(&::XOpenDisplay) open_display = nullptr;
    decltype(&::XCloseDisplay) close_display = nullptr;
    decltype(&::XFree) free = nullptr;
    decltype(&::XSync) sync = nullptr;
    decltype(&::XSetErrorHandler) set_error_handler = nullptr;
    decltype(&::glXChooseFBConfig) choose_config = nullptr;
    decltype(&::glXCreatePbuffer) create_pbuffer = nullptr;
    decltype(&::glXDestroyPbuffer) destroy_pbuffer = nullptr;
    decltype(&::glXCreateNewContext) create_context = nullptr;
    decltype(&::glXDestroyContext) destroy_context = nullptr;
    decltype(&::glXMakeContextCurrent) make_current = nullptr;
    decltype(&::glXGetProcAddressARB) address = nullptr;
};

// While it lives, an error of X on this connection does not end the program. Only one lives at a time.
class ErrorsOfX {
  public:
    ErrorsOfX(const GlxFunctions& glx, Display* display) : lock_(mutex_), glx_(glx) {
        display_ = display;
        has_error_ = false;
        others_ = glx_.set_error_handler([](Display* where, XErrorEvent* error) {
            if (where != display_) return others_ ? others_(where, error) : 0;
            has_error_ = true;
            return 0;
        });
    }
    ~ErrorsOfX() { glx_.set_error_handler(others_); }
    ErrorsOfX(const ErrorsOfX&) = delete;
    ErrorsOfX& operator=(const ErrorsOfX&) = delete;

    bool occurred() const {
        glx_.sync(display_, False);
        return has_error_;
    }

  private:
    static inline std::mutex mutex_;
    std::lock_guard<std::mutex> lock_;
    const GlxFunctions& glx_;
    // (X calls a function that knows nothing else.)
    static inline Display* display_ = nullptr;
    static inline bool has_error_ = false;
    static inline XErrorHandler others_ = nullptr;
};

class GlxContext final : public OffscreenContext {
  public:
    GlxContext(const GlxFunctions& glx, int width, int height, ColorBuffer color_buffer)
        : glx_(glx), display_(glx.open_display(nullptr)) {
        if (!display_) throw std::runtime_error(tr("GLX: cannot connect to an X server (DISPLAY)"));
        const ErrorsOfX errors(glx_, display_);
        if (!create(width, height) || errors.occurred() || !bind() || errors.occurred()) {
            close();
            throw std::runtime_error(
                tr("GLX: this driver cannot draw into a pbuffer of {} x {} pixels", width, height));
        }
        GLint lights = 0;
        glGetIntegerv(GL_MAX_LIGHTS, &lights);
        if (lights == 0) {
            close();
            throw std::runtime_error(tr("GLX: this driver has no compatibility profile"));
        }
        try {
            if (color_buffer == ColorBuffer::kFloat) buffer_.emplace(width, height, color_buffer);
        } catch (const std::runtime_error&) {
            close();
            throw;
        }
        prepare_context(width, height);
    }
    ~GlxContext() override {
        const ErrorsOfX errors(glx_, display_);
        if (bind()) {
            glFinish();
            buffer_.reset();
        }
        close();
    }
    GlxContext(const GlxContext&) = delete;
    GlxContext& operator=(const GlxContext&) = delete;

    void make_current() override {
        if (!bind()) throw std::runtime_error(tr("GLX cannot make its context current again"));
    }

  private:
    bool create(int width, int height) {
        // With one buffer only, llvmpipe would copy each picture to the X server, which refuses it for a pbuffer.
        // clang-format off
        const int wanted[] = {
            GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT, GLX_RENDER_TYPE, GLX_RGBA_BIT, GLX_DOUBLEBUFFER, True, GLX_DEPTH_SIZE, 24,
            GLX_STENCIL_SIZE, 8, GLX_RED_SIZE, 8, GLX_GREEN_SIZE, 8, GLX_BLUE_SIZE, 8, GLX_ALPHA_SIZE, 8, None};
        // clang-format on
        int count = 0;
        GLXFBConfig* configs = glx_.choose_config(display_, DefaultScreen(display_), wanted, &count);
        if (configs && count > 0) {
            const int size[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, None};
            pbuffer_ = glx_.create_pbuffer(display_, configs[0], size);
            context_ = glx_.create_context(display_, configs[0], GLX_RGBA_TYPE, nullptr, True);
        }
        if (configs) glx_.free(configs);
        return pbuffer_ && context_;
    }
    bool bind() { return glx_.make_current(display_, pbuffer_, pbuffer_, context_) == True; }
    void close() {
        glx_.make_current(display_, None, None, nullptr);
        if (context_) glx_.destroy_context(display_, context_);
        if (pbuffer_) glx_.destroy_pbuffer(display_, pbuffer_);
        glx_.sync(display_, False);
        glx_.close_display(display_);
    }

    GlxFunctions glx_;
    Display* display_;
    GLXPbuffer pbuffer_ = 0;
    GLXContext context_ = nullptr;
    std::optional<ContextBuffer> buffer_;  // of floats
};

}  // namespace

bool is_glx(const Library& library) { return library.has("glXGetProcAddressARB"); }

Provider glx_provider(const Library& library) {
    const GlxFunctions glx(library);
    const auto make_context = [glx](int width, int height, ColorBuffer color_buffer) {
        return std::make_unique<GlxContext>(glx, width, height, color_buffer);
    };
    const auto address = [glx](const char* name) {
        return reinterpret_cast<void*>(glx.address(reinterpret_cast<const GLubyte*>(name)));
    };
    return {"GLX", make_context, address};
}

}  // namespace twinlight

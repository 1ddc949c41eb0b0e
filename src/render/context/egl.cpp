// EGL: a GPU's driver or Mesa's software drivers, without a window system. Draws bytes into a surface, if there is one, and floats into
// a framebuffer object, because few drivers offer surfaces with float colours.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/text/input_text.h"
#include "render/context/clamped_colors.h"
#include "render/context/context.h"
#include "render/context/driver_choice.h"
#include "render/context/driver_name.h"
#include "render/context/egl_devices.h"
#include "render/context/gl.h"
#include "render/context/softpipe.h"

namespace twinlight {

namespace {

bool has_word(const char* words, std::string_view word) {
    InputText stream(words ? words : "");
    for (std::string each; stream >> each;)
        if (each == word) return true;
    return false;
}

// A possible source of a display.
struct Source {
    std::string name;
    EGLenum platform;
    void* native;
};

// GPUs first, if they are taken; then Mesa's default, then all other devices.
std::vector<Source> sources() {
    constexpr int kKeep = 0;  // keeps the user's setting
    if (!kTakesGpus) ::setenv("LIBGL_ALWAYS_SOFTWARE", "true", kKeep);
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Source> gpus, others;
    if (has_word(extensions, "EGL_MESA_platform_surfaceless"))
        others.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto query_string =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    if (query_devices && query_string && has_word(extensions, "EGL_EXT_platform_device")) {
        std::array<EGLDeviceEXT, 32> devices{};
        EGLint count = 0;
        query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            void* device = devices[static_cast<std::size_t>(i)];
            const bool is_software = has_word(query_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
            (is_software ? others : gpus).push_back({fmt::format("device {}", i), EGL_PLATFORM_DEVICE_EXT, device});
        }
    }
    if (!kTakesGpus) return others;
    gpus.insert(gpus.end(), others.begin(), others.end());
    return gpus;
}

// A display with a context on it, made current without a surface.
struct Connection {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;
    EGLContext context = EGL_NO_CONTEXT;
};

// The display's first configuration for the surfaces that are wanted, or else any; nullptr if OpenGL has none.
EGLConfig configuration(EGLDisplay display) {
    const std::array<EGLint, 17> with_surface = {EGL_SURFACE_TYPE,
                                                 EGL_PBUFFER_BIT,
                                                 EGL_RENDERABLE_TYPE,
                                                 EGL_OPENGL_BIT,
                                                 EGL_RED_SIZE,
                                                 8,
                                                 EGL_GREEN_SIZE,
                                                 8,
                                                 EGL_BLUE_SIZE,
                                                 8,
                                                 EGL_ALPHA_SIZE,
                                                 8,
                                                 EGL_DEPTH_SIZE,
                                                 24,
                                                 EGL_STENCIL_SIZE,
                                                 8,
                                                 EGL_NONE};
    const std::array<EGLint, 5> any = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, with_surface.data(), &config, 1, &count) && count > 0) return config;
    if (eglChooseConfig(display, any.data(), &config, 1, &count) && count > 0) return config;
    return nullptr;
}

// Connects, and returns nullptr or the reason why it failed. An initialised display stays so: a process has only one of
// each.
const char* refusal(const Source& source, Connection& connection) {
    connection.display = eglGetPlatformDisplay(source.platform, source.native, nullptr);
    if (connection.display == EGL_NO_DISPLAY || !eglInitialize(connection.display, nullptr, nullptr))
        return "it does not start";
    if (!has_word(eglQueryString(connection.display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return "it cannot draw without a surface";
    connection.config = eglBindAPI(EGL_OPENGL_API) ? configuration(connection.display) : nullptr;
    if (!connection.config) return "it does not support OpenGL";
    // Without a requested version, the driver gives the newest one that keeps the commands of GL 1.0.
    connection.context = eglCreateContext(connection.display, connection.config, EGL_NO_CONTEXT, nullptr);
    if (connection.context == EGL_NO_CONTEXT) return "it cannot create an OpenGL context";
    GLint lights = 0;
    const bool is_current = eglMakeCurrent(connection.display, EGL_NO_SURFACE, EGL_NO_SURFACE, connection.context);
    if (is_current) glGetIntegerv(GL_MAX_LIGHTS, &lights);
    if (lights > 0) return nullptr;
    eglMakeCurrent(connection.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(connection.display, connection.context);
    return is_current ? "it has no compatibility profile" : "its context cannot be made current";
}

// Throws if nothing connects, with one line for all attempts; Mesa's own line for each attempt is turned off.
Connection connect() {
    constexpr int kKeep = 0;  // keeps the user's setting
    ::setenv("EGL_LOG_LEVEL", "fatal", kKeep);
    std::string tried;
    for (const Source& source : sources()) {
        Connection connection;
        const char* why = refusal(source, connection);
        if (!why) return connection;
        tried += fmt::format("{}{}: {}", tried.empty() ? "" : "; ", source.name, why);
    }
    const std::string wrong = wrong_driver_choice();
    throw std::runtime_error(
        fmt::format("EGL provides no OpenGL with a compatibility profile ({}); {}",
                    tried.empty() ? "it offers neither a device nor a surfaceless display" : tried,
                    wrong.empty() ? "install the GPU's driver or Mesa's (libegl-mesa0, libgl1-mesa-dri)" : wrong));
}

class EglContext final : public OffscreenContext {
  public:
    EglContext(int width, int height, ColorBuffer color_buffer) : connection_(connect()) {
        if (color_buffer != ColorBuffer::kUnorm8 || !make_surface(width, height)) {
            make_framebuffer(color_buffer == ColorBuffer::kFloat ? GL_RGBA32F : GL_RGBA8, width, height);
        }
        clamp_colors();
        glViewport(0, 0, width, height);
        glScissor(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~EglContext() override {
        bind();
        glFinish();
        release();
    }

    void make_current() override {
        if (!bind()) throw std::runtime_error("EGL cannot make its context current again");
    }

  private:
    // A surface is a window's framebuffer, whose name is 0. Without one, a scene that binds no framebuffer object would still have one.
    bool make_surface(int width, int height) {
        const std::array<EGLint, 5> size = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
        surface_ = eglCreatePbufferSurface(connection_.display, connection_.config, size.data());
        if (surface_ == EGL_NO_SURFACE) return false;
        std::array<GLint, 3> bits{};
        if (bind()) {
            glGetIntegerv(GL_DEPTH_BITS, &bits[0]);
            glGetIntegerv(GL_STENCIL_BITS, &bits[1]);
            glGetIntegerv(GL_ALPHA_BITS, &bits[2]);
        }
        // NVIDIA's driver (580.159.04) gives black pictures of a surface if its context was current without one.
        if (bits == std::array<GLint, 3>{24, 8, 8} && current_driver().maker() == "Mesa") return true;
        eglMakeCurrent(connection_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, connection_.context);
        eglDestroySurface(connection_.display, std::exchange(surface_, EGL_NO_SURFACE));
        return false;
    }
    void make_framebuffer(GLenum color, int width, int height) {
        glGenRenderbuffers(2, buffers_.data());
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        attach(GL_COLOR_ATTACHMENT0, color, buffers_[0], width, height);
        attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, buffers_[1], width, height);
        flip_rows_like_a_window();
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
        const std::string driver = driver_name();
        release();
        throw std::runtime_error(
            fmt::format("{} cannot draw into a buffer of {} x {} pixels; try a smaller one", driver, width, height));
    }
    static void attach(GLenum attachment, GLenum format, GLuint buffer, int width, int height) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    }
    // In Mesa a window's first row in memory is the top one, a framebuffer object's is the bottom one. Upside down,
    // borders and positions would round to the other side. Other drivers have no such switch.
    static void flip_rows_like_a_window() {
        if (has_word(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), "GL_MESA_framebuffer_flip_y"))
            glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, GL_TRUE);
    }
    bool bind() { return eglMakeCurrent(connection_.display, surface_, surface_, connection_.context) == EGL_TRUE; }
    void release() {
        if (framebuffer_ != 0) {
            glDeleteFramebuffers(1, &framebuffer_);
            glDeleteRenderbuffers(2, buffers_.data());
        }
        eglMakeCurrent(connection_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(connection_.display, surface_);
        eglDestroyContext(connection_.display, connection_.context);
    }

    Connection connection_;
    EGLSurface surface_ = EGL_NO_SURFACE;
    std::array<GLuint, 2> buffers_{};  // colour; depth and stencil: without a surface
    GLuint framebuffer_ = 0;
};

}  // namespace

std::string_view context_provider() { return "EGL"; }

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height, ColorBuffer color_buffer) {
    keep_llvm_out_of_softpipe();
    return std::make_unique<EglContext>(width, height, color_buffer);
}

}  // namespace twinlight

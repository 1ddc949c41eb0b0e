// EGL: a GPU's driver or Mesa's software drivers, without a window system. Draws bytes into a surface, if there is one, and floats into
// a framebuffer object, because few drivers offer surfaces with float colours.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "render/context/context_buffer.h"
#include "render/context/driver_choice.h"
#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/context/provider.h"
#include "render/context/softpipe.h"

namespace twinlight {

namespace {

struct EglFunctions {
    explicit EglFunctions(const Library& library) {
        library.find("eglGetProcAddress", address);
        library.find("eglQueryString", query_string);
        library.find("eglGetPlatformDisplay", get_platform_display);
        library.find("eglInitialize", initialize);
        library.find("eglBindAPI", bind_api);
        library.find("eglChooseConfig", choose_config);
        library.find("eglCreateContext", create_context);
        library.find("eglDestroyContext", destroy_context);
        library.find("eglCreatePbufferSurface", create_surface);
        library.find("eglDestroySurface", destroy_surface);
        library.find("eglMakeCurrent", make_current);
    }

    decltype(&::eglGetProcAddress) address = nullptr;
    decltype(&::eglQueryString) query_string = nullptr;
    decltype(&::eglGetPlatformDisplay) get_platform_display = nullptr;
    decltype(&::eglInitialize) initialize = nullptr;
    decltype(&::eglBindAPI) bind_api = nullptr;
    decltype(&::eglChooseConfig) choose_config = nullptr;
    decltype(&::eglCreateContext) create_context = nullptr;
    decltype(&::eglDestroyContext) destroy_context = nullptr;
    decltype(&::eglCreatePbufferSurface) create_surface = nullptr;
    decltype(&::eglDestroySurface) destroy_surface = nullptr;
    decltype(&::eglMakeCurrent) make_current = nullptr;
};

// A possible source of a display.
struct Source {
    std::string name;
    EGLenum platform;
    void* native;
};

// GPUs first, if they are taken; then Mesa's default, then all other devices.
std::vector<Source> sources(const EglFunctions& egl, EglDevices taken) {
    constexpr int kKeep = 0;  // keeps the user's setting
    if (taken == EglDevices::kSoftware) ::setenv("LIBGL_ALWAYS_SOFTWARE", "true", kKeep);
    const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Source> gpus, others;
    if (has_word(extensions, "EGL_MESA_platform_surfaceless"))
        others.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.address("eglQueryDevicesEXT"));
    const auto query_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.address("eglQueryDeviceStringEXT"));
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
    if (taken == EglDevices::kSoftware) return others;
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
EGLConfig configuration(const EglFunctions& egl, EGLDisplay display) {
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
    if (egl.choose_config(display, with_surface.data(), &config, 1, &count) && count > 0) return config;
    if (egl.choose_config(display, any.data(), &config, 1, &count) && count > 0) return config;
    return nullptr;
}

// Connects, and returns nullptr or the reason why it failed. An initialised display stays so: a process has only one of
// each.
const char* refusal(const EglFunctions& egl, const Source& source, Connection& connection) {
    connection.display = egl.get_platform_display(source.platform, source.native, nullptr);
    if (connection.display == EGL_NO_DISPLAY || !egl.initialize(connection.display, nullptr, nullptr))
        return "it does not start";
    if (!has_word(egl.query_string(connection.display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return "it cannot draw without a surface";
    connection.config = egl.bind_api(EGL_OPENGL_API) ? configuration(egl, connection.display) : nullptr;
    if (!connection.config) return "it does not support OpenGL";
    // Without a requested version, the driver gives the newest one that keeps the commands of GL 1.0.
    connection.context = egl.create_context(connection.display, connection.config, EGL_NO_CONTEXT, nullptr);
    if (connection.context == EGL_NO_CONTEXT) return "it cannot create an OpenGL context";
    GLint lights = 0;
    const bool is_current = egl.make_current(connection.display, EGL_NO_SURFACE, EGL_NO_SURFACE, connection.context);
    if (is_current) glGetIntegerv(GL_MAX_LIGHTS, &lights);
    if (lights > 0) return nullptr;
    egl.make_current(connection.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl.destroy_context(connection.display, connection.context);
    return is_current ? "it has no compatibility profile" : "its context cannot be made current";
}

// Throws if nothing connects, with one line for all attempts; Mesa's own line for each attempt is turned off.
Connection connect(const EglFunctions& egl, EglDevices taken) {
    constexpr int kKeep = 0;  // keeps the user's setting
    ::setenv("EGL_LOG_LEVEL", "fatal", kKeep);
    std::string tried;
    for (const Source& source : sources(egl, taken)) {
        Connection connection;
        const char* why = refusal(egl, source, connection);
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
    EglContext(const EglFunctions& egl, EglDevices devices, int width, int height, ColorBuffer color_buffer)
        : egl_(egl), connection_(connect(egl, devices)) {
        if (color_buffer != ColorBuffer::kUnorm8 || !make_surface(width, height)) {
            try {
                buffer_.emplace(width, height, color_buffer);
            } catch (const std::runtime_error&) {
                release();
                throw;
            }
        }
        prepare_context(width, height);
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
        surface_ = egl_.create_surface(connection_.display, connection_.config, size.data());
        if (surface_ == EGL_NO_SURFACE) return false;
        std::array<GLint, 3> bits{};
        if (bind()) {
            glGetIntegerv(GL_DEPTH_BITS, &bits[0]);
            glGetIntegerv(GL_STENCIL_BITS, &bits[1]);
            glGetIntegerv(GL_ALPHA_BITS, &bits[2]);
        }
        // NVIDIA's driver (580.159.04) gives black pictures of a surface if its context was current without one.
        if (bits == std::array<GLint, 3>{24, 8, 8} && current_driver().maker() == "Mesa") return true;
        egl_.make_current(connection_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, connection_.context);
        egl_.destroy_surface(connection_.display, std::exchange(surface_, EGL_NO_SURFACE));
        return false;
    }
    bool bind() { return egl_.make_current(connection_.display, surface_, surface_, connection_.context) == EGL_TRUE; }
    void release() {
        buffer_.reset();
        egl_.make_current(connection_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (surface_ != EGL_NO_SURFACE) egl_.destroy_surface(connection_.display, surface_);
        egl_.destroy_context(connection_.display, connection_.context);
    }

    EglFunctions egl_;
    Connection connection_;
    EGLSurface surface_ = EGL_NO_SURFACE;
    std::optional<ContextBuffer> buffer_;  // without a surface
};

}  // namespace

bool is_egl(const Library& library) { return library.has("eglGetProcAddress"); }

Provider egl_provider(const Library& library, EglDevices devices) {
    const EglFunctions egl(library);
    const auto make_context = [egl, devices](int width, int height, ColorBuffer color_buffer) {
        keep_llvm_out_of_softpipe();
        return std::make_unique<EglContext>(egl, devices, width, height, color_buffer);
    };
    const auto address = [egl](const char* name) { return reinterpret_cast<void*>(egl.address(name)); };
    return {"EGL", make_context, address};
}

}  // namespace twinlight

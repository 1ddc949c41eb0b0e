// OSMesa: Mesa's software rendering into our own memory, without a window system.
#include <GL/osmesa.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "render/context/clamped_colors.h"
#include "render/context/context.h"
#include "render/context/driver_choice.h"
#include "render/context/gl.h"
#include "render/context/softpipe.h"

namespace twinlight {

namespace {

class OsmesaContext final : public OffscreenContext {
  public:
    OsmesaContext(int width, int height, ColorBuffer color_buffer)
        : width_(width), height_(height), type_(color_buffer == ColorBuffer::kFloat ? GL_FLOAT : GL_UNSIGNED_BYTE) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_STENCIL_BITS,
                                  8,
                                  OSMESA_ACCUM_BITS,
                                  16,
                                  OSMESA_PROFILE,
                                  OSMESA_COMPAT_PROFILE,
                                  0};
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        if (!context_) throw std::runtime_error("OSMesa cannot create a compatibility-profile context");
        const std::size_t bytes_per_pixel = color_buffer == ColorBuffer::kFloat ? 16 : 4;
        buffer_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * bytes_per_pixel);
        if (!bind()) {
            OSMesaDestroyContext(context_);
            throw std::runtime_error("OSMesa cannot draw into a buffer of this size");
        }
        clamp_colors();
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    ~OsmesaContext() override {
        bind();
        glFinish();
        OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        OSMesaDestroyContext(context_);
    }

    void make_current() override {
        if (!bind()) throw std::runtime_error("OSMesa cannot make its context current again");
    }

  private:
    bool bind() { return OSMesaMakeCurrent(context_, buffer_.data(), type_, width_, height_) == GL_TRUE; }

    OSMesaContext context_ = nullptr;
    int width_, height_;
    GLenum type_;
    std::vector<unsigned char> buffer_;
};

}  // namespace

std::string_view context_provider() { return "OSMesa"; }

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height, ColorBuffer color_buffer) {
    // OSMesa has only Mesa's two software drivers, and crashes with another name.
    if (const std::string wrong = wrong_gallium_driver(); !wrong.empty())
        throw std::runtime_error("OSMesa has no such driver: " + wrong);
    keep_llvm_out_of_softpipe();
    return std::make_unique<OsmesaContext>(width, height, color_buffer);
}

}  // namespace twinlight

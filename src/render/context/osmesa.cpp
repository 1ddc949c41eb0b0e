// OSMesa: Mesa's software rendering into our own memory, without a window system.
#include <stdexcept>
#include <string>
#include <vector>

#include "render/context/context_buffer.h"
#include "render/context/driver_choice.h"
#include "render/context/gl.h"
#include "render/context/provider.h"
#include "render/context/softpipe.h"

namespace twinlight {

namespace {

// Of <GL/osmesa.h>, which systems without OSMesa lack.
struct OsmesaFunctions {
    explicit OsmesaFunctions(const Library& library) {
        library.find("OSMesaCreateContextAttribs", create);
        library.find("OSMesaDestroyContext", destroy);
        library.find("OSMesaMakeCurrent", make_current);
        library.find("OSMesaGetProcAddress", address);
    }

    void*(APIENTRY* create)(const int* attributes, void* shared) = nullptr;
    void(APIENTRY* destroy)(void* context) = nullptr;
    GLboolean(APIENTRY* make_current)(void* context, void* buffer, GLenum type, GLsizei width,
                                      GLsizei height) = nullptr;
    void*(APIENTRY* address)(const char* name) = nullptr;
};
enum OsmesaAttribute {
    kFormat = 0x22,  // OSMESA_FORMAT; its value OSMESA_RGBA is GL_RGBA
    kDepthBits = 0x30,
    kStencilBits = 0x31,
    kAccumBits = 0x32,
    kProfile = 0x33,
    kCompatProfile = 0x35,
};

class OsmesaContext final : public OffscreenContext {
  public:
    OsmesaContext(const OsmesaFunctions& osmesa, int width, int height, ColorBuffer color_buffer)
        : osmesa_(osmesa),
          width_(width),
          height_(height),
          type_(color_buffer == ColorBuffer::kFloat ? GL_FLOAT : GL_UNSIGNED_BYTE) {
        const int attributes[] = {kFormat, GL_RGBA,  kDepthBits,     24, kStencilBits, 8, kAccumBits,
                                  16,      kProfile, kCompatProfile, 0};
        context_ = osmesa_.create(attributes, nullptr);
        if (!context_) throw std::runtime_error("OSMesa cannot create a compatibility-profile context");
        const std::size_t bytes_per_pixel = color_buffer == ColorBuffer::kFloat ? 16 : 4;
        buffer_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * bytes_per_pixel);
        if (!bind()) {
            osmesa_.destroy(context_);
            throw std::runtime_error("OSMesa cannot draw into a buffer of this size");
        }
        prepare_context(width, height);
    }
    ~OsmesaContext() override {
        bind();
        glFinish();
        osmesa_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa_.destroy(context_);
    }

    void make_current() override {
        if (!bind()) throw std::runtime_error("OSMesa cannot make its context current again");
    }

  private:
    bool bind() { return osmesa_.make_current(context_, buffer_.data(), type_, width_, height_) == GL_TRUE; }

    OsmesaFunctions osmesa_;
    void* context_ = nullptr;
    int width_, height_;
    GLenum type_;
    std::vector<unsigned char> buffer_;
};

}  // namespace

bool is_osmesa(const Library& library) { return library.has("OSMesaCreateContextAttribs"); }

Provider osmesa_provider(const Library& library) {
    const OsmesaFunctions osmesa(library);
    const auto make_context = [osmesa](int width, int height, ColorBuffer color_buffer) {
        // OSMesa has only Mesa's two software drivers, and crashes with another name.
        if (const std::string wrong = wrong_gallium_driver(); !wrong.empty())
            throw std::runtime_error("OSMesa has no such driver: " + wrong);
        keep_llvm_out_of_softpipe();
        return std::make_unique<OsmesaContext>(osmesa, width, height, color_buffer);
    };
    return {"OSMesa", make_context, osmesa.address};
}

}  // namespace twinlight

// A place to draw beside the window: a pbuffer of the libGL that GLUT uses.
#include <memory>
#include <string>

#include "render/context/context.h"
#include "render/context/provider.h"

namespace twinlight {

namespace {

const Library& library() {
    static const Library gl("libGL.so.1");
    return gl;
}

}  // namespace

std::string_view context_provider() { return "GLUT"; }

const std::string& gl_library() { return library().path(); }

std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height, ColorBuffer color_buffer) {
    static const Provider glx = glx_provider(library());
    return glx.make_context(width, height, color_buffer);
}

}  // namespace twinlight

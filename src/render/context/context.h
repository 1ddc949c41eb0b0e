// A place to draw without a window: of a GL that is loaded while the program runs (offscreen.cpp), or beside a window.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/image/image.h"

namespace twinlight {

class OffscreenContext {
  public:
    virtual ~OffscreenContext() = default;
    // Needed only if there are several contexts.
    virtual void make_current() = 0;
};

enum class ColorBuffer { kUnorm8, kFloat };

// Returns a current compatibility-profile context with a colour buffer of this size, a 24-bit depth buffer and an 8-bit
// stencil buffer, all cleared. It may lack an accumulation buffer (accumulation_buffer.h). Throws std::runtime_error with the driver's reason. The context stays current until it is destroyed.
std::unique_ptr<OffscreenContext> make_offscreen_context(int width, int height,
                                                         ColorBuffer color_buffer = ColorBuffer::kUnorm8);

// Drivers allocate and free megabytes for each frame, which the C library gives back to the system each time: a small frame
// then takes three times as long (docs/performance.md). After this call it keeps up to 256 MB for the next frame.
void keep_freed_memory();

// Which GL draws: "osmesa", "egl", or the file of a libOSMesa, libEGL or libGL. Without it, the environment variable TWINLIGHT_GL says
// so, or else it is OSMesa, or EGL's software driver where there is no OSMesa. To be called before what is below and before the first
// context.
void choose_gl(const std::string& name);

// Both load the GL, and throw std::runtime_error if that fails.
std::string_view context_provider();  // what makes contexts: "OSMesa", "EGL", "GLX"; "GLUT" in a window's program
const std::string& gl_library();      // the file that it was loaded from

// A rectangle of the colour buffer of the current context (the back buffer of a window), row 0 at the top. x, y: its lower left
// corner, in GL's window coordinates.
Image read_pixels(int width, int height, int x = 0, int y = 0);
// The depth buffer in the same way, as red, green and blue.
Image read_depths(int width, int height, int x = 0, int y = 0);
// The stencil buffer in the same way, in 1/255.
Image read_stencils(int width, int height, int x = 0, int y = 0);

}  // namespace twinlight

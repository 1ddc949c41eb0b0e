// Sends one command to the driver.
#pragma once

#include <cstdint>

#include "render/fixed/quadrics.h"
#include "scene/command/command.h"

namespace twinlight::fixed {

// The current draw buffer: GL_BACK in a window with two buffers; it has another name offscreen.
Enum draw_buffer();
// The framebuffer that is bound for drawing, and the one for reading: a window's often is 0.
std::uint32_t draw_framebuffer();
std::uint32_t read_framebuffer();

// Calls the function with the command's name and arguments, and keeps GLU's objects. Names of GL objects must be the
// driver's, and memory that the command reads must exist: Driver ensures both.
class Executor {
  public:
    Executor();
    // Ignores pragmas without a GL command, except shape(...), which draws.
    void execute(const Command& command);

  private:
    void draw_shape(const Command& command);
    void pragma(const Command& command);

    std::uint32_t window_;  // the window's framebuffer
    Enum color_buffer_;     // the window's, used for GL_BACK and similar names
    Quadrics quadrics_;
};

}  // namespace twinlight::fixed

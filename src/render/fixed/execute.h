// One command to the driver.
#pragma once

#include "render/fixed/quadrics.h"
#include "scene/command/command.h"

namespace twinlight::fixed {

// The one that is drawn to now: GL_BACK in a window with two, another name offscreen.
Enum draw_buffer();

// Calls the function of the command's name with the command's arguments, as they are, and keeps GLU's objects. The names
// of GL's objects are the driver's own here, and what the command reads must be there: Driver sees to both.
class Executor {
  public:
    Executor();
    // Pragmas that GL has no command for do nothing, but shape(...) draws.
    void execute(const Command& command);

  private:
    void draw_shape(const Command& command);
    void pragma(const Command& command);

    Enum color_buffer_;  // the context's, where GL_BACK and its like are drawn
    Quadrics quadrics_;
};

}  // namespace twinlight::fixed

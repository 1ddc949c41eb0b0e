// The control group: the driver's own fixed function executes the commands, literally, in the current context.
#pragma once

#include "command/command.h"
#include "image/image.h"
#include "state/frame.h"

namespace twinlight::fixed {

// One command to the driver. Pragmas that GL has no command for do nothing, but shape(...) draws.
void execute(const Command& command);

// Keeps what commands change to itself: sets GL's initial state, for a window of this size, when it begins and when it
// ends. Objects stay.
class InitialState {
  public:
    InitialState(int width, int height);
    ~InitialState();
    InitialState(const InitialState&) = delete;
    InitialState& operator=(const InitialState&) = delete;

  private:
    int width_, height_;
};

// Clears to black and depth 1, executes the frame's commands, reads the picture. Throws std::invalid_argument for
// Shading::kPhong, which the fixed function cannot do.
Image render(const Frame& frame, const RenderOptions& options);
// The same without reading back: leaves the picture in the current colour buffer.
void draw(const Frame& frame, const RenderOptions& options);

}  // namespace twinlight::fixed

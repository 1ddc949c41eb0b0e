// The accumulation buffer (4.2.4) in our own memory, for framebuffers that have none: framebuffer objects, and the window's.
#pragma once

#include <vector>

#include "scene/frame/frame.h"

namespace twinlight {

// Reads colours from the current context's buffer and writes them to it, as glAccum does. Holds floats, so it is at least
// as precise as a driver's 16 bits. Needs no memory until it is used.
class AccumulationBuffer {
  public:
    // The size of the picture.
    AccumulationBuffer(int width, int height) : width_(width), height_(height) {}

    void clear(const Clear& clear);
    // Leaves the context's state as it was. Needs a free level of both attribute stacks.
    void apply(const Accumulate& accumulate);

  private:
    Rectangle scissored(const Scissor& scissor) const;
    // Calls visit(four floats) for each pixel of the box, row by row from the bottom.
    template <class Visit>
    void for_each(const Rectangle& box, const Visit& visit);
    void need_memory();

    int width_, height_;
    std::vector<float> channels_;  // R, G, B, A of each pixel, row by row from the bottom
};

}  // namespace twinlight

// PreparedFrame: the fixed function draws a Frame Draw by Draw, from buffers that the driver has, and not command by command.
#pragma once

#include <cstdint>
#include <memory>

#include "scene/state/frame.h"

namespace twinlight::fixed {

// How much of a Draw's state is set.
enum class Scrub : std::uint8_t {
    kNothing,  // all that the Draw has, called for or not: what a program does that sets what it was told
    kState,    // what its plan calls for (render/effect/scrubbed_state.h)
};

// Owns buffers and textures of the context that is current; dies before that does. What the Frame lacks (Frame::unsupported)
// it does not draw. Of more than eight lights each Draw has those that may add most to it (note_lights_beyond()).
class PreparedFrame {
  public:
    // The frame must outlive it. Throws as check_shading() does.
    PreparedFrame(const Frame& frame, const RenderOptions& options, Scrub scrub);
    ~PreparedFrame();
    PreparedFrame(const PreparedFrame&) = delete;
    PreparedFrame& operator=(const PreparedFrame&) = delete;

    // Clears to black and depth 1 and draws into the current colour buffer. GL has its initial state afterwards.
    void draw();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace twinlight::fixed

// Replay: the fixed function draws a Frame's Draws, from buffers or by other ways of sending, and not command by command. The study
// and the bench time it; what others are compared with is fixed::render(), which executes the commands.
#pragma once

#include <cstdint>
#include <memory>

#include "base/image/image.h"
#include "render/effect/plan.h"
#include "scene/state/scene.h"

namespace twinlight::fixed {

// How much of a Draw's state is set.
enum class Scrub : std::uint8_t {
    kNothing,  // all that the Draw has, needed or not
    kState,    // what its plan calls for (render/effect/scrubbed_state.h)
};

// How vertices get to the driver, frame after frame (2.6 to 2.9, 5.4).
enum class Sending : std::uint8_t {
    kBuffers,       // arrays in buffer objects
    kClientArrays,  // arrays in the program's own memory
    kImmediate,     // vertex by vertex, between glBegin and glEnd
    kDisplayList,   // the same, compiled once
};

struct ReplayOptions {
    std::optional<Shading> shading{};  // kFlat or kGouraud; nothing: as each Draw's glShadeModel says
    Scrub scrub = Scrub::kNothing;
    double budget = PlanOptions{}.budget;  // of Scrub::kState
    Sending sending = Sending::kBuffers;
    bool patches = true;  // from buffers, large meshes in patches (render/stages/elements.h)
};

// Owns buffers and textures of the context that is current; dies before that does. What the Frame lacks (Frame::unsupported)
// it does not draw. Of more than eight lights each Draw has the first eight, or under Scrub::kState the eight whose bounds are
// largest.
class Replay {
  public:
    // The frame must outlive it. Throws as check_shading() does.
    Replay(const Frame& frame, const ReplayOptions& options);
    ~Replay();
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    // Clears to black and depth 1 and draws into the current colour buffer. GL has its initial state afterwards.
    void draw();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// The scene's Draws with no more state than their plans call for, to within the budget. A scene whose Frame lacks some of its
// commands is drawn from the commands, as by render().
Image render_scrubbed(const Scene& scene, const std::optional<Shading>& shading, double budget);

}  // namespace twinlight::fixed

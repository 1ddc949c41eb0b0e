// Replay: the fixed function draws a Frame's Draws, from buffers or sent in other ways, instead of executing commands.
// The study and the benchmarks time it; for comparisons fixed::render() executes the commands.
#pragma once

#include <cstdint>
#include <memory>

#include "base/image/image.h"
#include "render/effect/plan.h"
#include "scene/frame/scene.h"

namespace twinlight::fixed {

// How much of a Draw's state is set.
enum class Scrub : std::uint8_t {
    kNothing,  // the whole state, needed or not
    kState,    // only the state that the plan needs (render/effect/scrubbed_state.h)
};

// How vertices are sent to the driver in each frame (2.6 to 2.9, 5.4).
enum class Sending : std::uint8_t {
    kBuffers,       // arrays in buffer objects
    kClientArrays,  // arrays in the program's own memory
    kImmediate,     // vertex by vertex, between glBegin and glEnd
    kDisplayList,   // the same commands, compiled once
};

struct ReplayOptions {
    std::optional<Shading> shading{};  // kFlat or kGouraud; empty: by each Draw's glShadeModel
    Scrub scrub = Scrub::kNothing;
    double budget = PlanOptions{}.budget;  // for Scrub::kState
    Sending sending = Sending::kBuffers;
    bool patches = true;  // draws large meshes from buffers in patches (render/stages/elements.h)
};

// Owns buffers and textures of the current context, so it must be destroyed before the context. Does not draw what the
// Frame lacks (Frame::unsupported). If a Draw has more than eight lights, uses the first eight, or with Scrub::kState
// the eight with the largest bounds.
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

// Draws the scene with only the state that its plans need, within the budget. If the Frame lacks some of the scene's
// commands, executes the commands like render().
Image render_scrubbed(const Scene& scene, const std::optional<Shading>& shading, double budget);

}  // namespace twinlight::fixed

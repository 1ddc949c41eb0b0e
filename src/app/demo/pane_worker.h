// PaneWorker: draws the driver's pictures in a thread and a context of its own: of the fixed function and of the shaders, with overlays, and
// from outside. A driver compiles when it first draws, which takes up to seconds, and the window shows the last picture meanwhile. Without a
// thread or a second context the window's own context draws.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/session/overlays.h"
#include "render/look.h"
#include "render/path.h"
#include "render/programmable/programmable.h"
#include "scene/command/command.h"

namespace twinlight::demo {

// The worker's renderers, in its context. The world has its own, so that the panes' constants stay (kept_programs.h).
struct Renderers {
    programmable::Renderer panes, world;

    void allow_baking(bool is_allowed) {
        panes.allow_baking(is_allowed);
        world.allow_baking(is_allowed);
    }
    bool want_to_bake() const { return panes.wants_to_bake() || world.wants_to_bake(); }
};

// A picture that a function draws into the current context's back buffer, which has its size.
struct PaneJob {
    std::size_t pane = 0;  // its number; jobs of one number replace each other
    WindowSize size;
    std::function<void(Renderers&)> draw;
    bool is_first = false;    // it is drawn twice and the second is timed
    bool is_small = false;    // nothing waits for it
    bool only_bakes = false;  // its picture is there already; shaders with constants are compiled for the next ones
    std::shared_ptr<const session::OverlayPicture> overlays{};  // that it shows
    // Only for a pane's own picture, without overlays.
    Path renderer = Path::kFixed;
    Look look{};
    int revision = -1;  // of the session
};

struct PanePicture {
    PaneJob job;
    std::vector<std::uint8_t> rgba{};  // of each pixel, the bottom row first
    double ms = 0;
    std::string error{};  // of the renderer
};

class PaneWorker {
  public:
    PaneWorker();
    ~PaneWorker();  // waits for the picture that is being drawn
    PaneWorker(const PaneWorker&) = delete;
    PaneWorker& operator=(const PaneWorker&) = delete;

    // Replaces a job of the same pane that has not begun.
    void request(PaneJob job);
    // Whether anything is still to be drawn, not counting small pictures.
    bool is_drawing() const;
    // Waits until that is drawn, or until then.
    void wait(std::optional<std::chrono::steady_clock::time_point> end = {}) const;
    // Waits until nothing at all is to be done.
    void wait_until_idle() const;
    // What was drawn since the last call, the oldest first. Without a thread it is drawn now, into the back buffer's lower left corner.
    std::vector<PanePicture> take();

  private:
    void run();
    void draw_jobs(Renderers& renderers, const std::function<void(int width, int height)>& prepare);
    std::vector<PaneJob>::iterator next_job();
    bool is_drawing_now() const;

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::vector<PaneJob> jobs_;
    std::vector<PanePicture> pictures_;
    bool is_working_ = false, is_drawing_ = false, is_ending_ = false;
    bool draws_by_itself_ = false;          // in a thread with a context
    std::unique_ptr<Renderers> of_window_;  // draw in the window's context without such a thread
    std::thread thread_;                    // the last member: it uses the others
};

}  // namespace twinlight::demo

// PaneWorker: draws the pictures of the fixed function and of the shaders in a thread and a context of its own. A driver compiles when it
// first draws, which takes up to seconds, and the window shows the last picture meanwhile. Without a thread or a second context the
// window's own context draws.
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

#include "render/look.h"
#include "render/path.h"
#include "render/programmable/programmable.h"
#include "scene/frame/scene.h"

namespace twinlight::demo {

// A picture of the size of the scene's frame.
struct PaneJob {
    std::size_t pane = 0;  // its number
    std::shared_ptr<const Scene> scene;
    Path renderer = Path::kFixed;  // not the reference
    Look look{};
    int revision = -1;      // of the session
    bool is_first = false;  // by this renderer with this look: it is drawn twice and the second is timed
    // A picture for which nothing waits. Its scene is made when it is drawn.
    std::function<std::shared_ptr<const Scene>()> make_scene{};

    bool is_small() const { return make_scene != nullptr; }
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
    // Waits until that is drawn, or at most so long.
    void wait(std::optional<std::chrono::milliseconds> most = {}) const;
    // What was drawn since the last call, the oldest first. Without a thread it is drawn now, into the back buffer's lower left corner.
    std::vector<PanePicture> take();

  private:
    void run();
    void draw_jobs(programmable::Renderer& renderer, const std::function<void(int width, int height)>& prepare);
    std::vector<PaneJob>::iterator next_job();
    bool is_drawing_now() const;

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::vector<PaneJob> jobs_;
    std::vector<PanePicture> pictures_;
    bool is_drawing_ = false, is_ending_ = false;
    bool draws_by_itself_ = false;                       // in a thread with a context
    std::unique_ptr<programmable::Renderer> of_window_;  // draws in the window's context without such a thread
    std::thread thread_;                                 // the last member: it uses the others
};

}  // namespace twinlight::demo

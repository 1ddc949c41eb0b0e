// ReferenceWorker: draws the reference's pictures in a thread of its own, so that the window does not wait for them. If the system gives
// no thread, the window waits.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/image/difference.h"
#include "base/image/image.h"
#include "render/look.h"
#include "scene/command/command.h"

namespace twinlight::session {

// What is wanted: the pictures of one scene, one for each look, and how much right pictures of one look may differ.
struct ReferenceJob {
    int revision = -1;  // of the session
    std::shared_ptr<const CommandList> commands;
    WindowSize size;
    std::vector<Look> looks;
    std::optional<Look> allowed_of{};

    bool is_same_work(const ReferenceJob& other) const;
};

struct ReferencePicture {
    Look look;
    int revision = -1;  // of the job that it belongs to
    int divisor = 1;    // the picture is coarse: 1/divisor of the job's size
    Image image;
    std::optional<Image> other_cut{};  // with quadrilaterals cut the other way (reference::QuadCut)
    double ms = 0;
};

struct ReferenceAllowed {
    Look look;
    int revision = -1;
    AllowedDifference difference;
};

class ReferenceWorker {
  public:
    ReferenceWorker();
    ~ReferenceWorker();  // waits for the step that is being drawn
    ReferenceWorker(const ReferenceWorker&) = delete;
    ReferenceWorker& operator=(const ReferenceWorker&) = delete;

    // Replaces the job. The step that is being drawn is finished first; the rest of the old job is dropped.
    void request(ReferenceJob job);
    // Whether anything is still to be drawn, or drawn and not taken.
    bool is_busy() const;
    // What was finished since the last call. Pictures of older jobs come, too: they are shown until a new one is there.
    std::vector<std::shared_ptr<const ReferencePicture>> take_pictures();
    std::shared_ptr<const ReferenceAllowed> take_allowed();
    // Why a job was not drawn: one sentence, once; empty if nothing failed since the last call.
    std::string take_failure();
    // Waits until nothing is left to draw.
    void wait() const;

  private:
    void run();
    void draw_next();
    void draw(const ReferenceJob& job);

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::optional<ReferenceJob> next_;
    ReferenceJob last_;  // the job asked for last
    bool is_drawing_ = false, is_ending_ = false;
    std::vector<std::shared_ptr<const ReferencePicture>> pictures_;
    std::shared_ptr<const ReferenceAllowed> allowed_;
    std::exception_ptr failure_;  // of the last job that was not drawn
    std::thread thread_;          // the last member: it uses the others
};

}  // namespace twinlight::session

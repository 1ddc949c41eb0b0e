#include "app/demo/pane_worker.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

#include "app/demo/x_drawing_context.h"
#include "base/text/reason.h"
#include "base/threads/threads.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"

namespace twinlight::demo {
namespace {

PanePicture drawn_picture(const PaneJob& job, Renderers& renderers) {
    using Clock = std::chrono::steady_clock;
    PanePicture picture{job};
    // The first picture of a renderer includes compiling.
    for (int times = job.is_first ? 2 : 1; times > 0 && picture.error.empty(); --times) {
        glFinish();
        const Clock::time_point start = Clock::now();
        try {
            job.draw(renderers);
        } catch (const std::exception& error) {
            picture.error = reason_of(error);
        }
        glFinish();
        picture.ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
    const auto [width, height] = job.size;
    const fixed::InitialState initial(width, height);
    picture.rgba.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    return picture;
}

}  // namespace

PaneWorker::PaneWorker() : draws_by_itself_(true), thread_(try_start_thread([this] { run(); })) {
    if (thread_.joinable()) return;
    const std::lock_guard lock(mutex_);
    draws_by_itself_ = false;
}

PaneWorker::~PaneWorker() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
        jobs_.clear();
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void PaneWorker::request(PaneJob job) {
    {
        const std::lock_guard lock(mutex_);
        const auto waiting = std::ranges::find(jobs_, job.pane, &PaneJob::pane);
        if (waiting == jobs_.end()) {
            jobs_.push_back(std::move(job));
        } else {
            job.is_first |= waiting->is_first;
            *waiting = std::move(job);
        }
    }
    changed_.notify_all();
}

bool PaneWorker::is_drawing() const {
    const std::lock_guard lock(mutex_);
    return is_drawing_now();
}

bool PaneWorker::is_drawing_now() const {
    return draws_by_itself_ && (is_drawing_ || !std::ranges::all_of(jobs_, &PaneJob::is_small));
}

// Small pictures come last.
std::vector<PaneJob>::iterator PaneWorker::next_job() {
    const auto found = std::ranges::find(jobs_, false, &PaneJob::is_small);
    return found == jobs_.end() ? jobs_.begin() : found;
}

void PaneWorker::wait(std::optional<std::chrono::steady_clock::time_point> end) const {
    std::unique_lock lock(mutex_);
    const auto is_done = [this] { return !is_drawing_now(); };
    if (end)
        changed_.wait_until(lock, *end, is_done);
    else
        changed_.wait(lock, is_done);
}

void PaneWorker::wait_until_idle() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !draws_by_itself_ || (!is_working_ && jobs_.empty()); });
}

std::vector<PanePicture> PaneWorker::take() {
    bool by_itself = true;
    {
        const std::lock_guard lock(mutex_);
        by_itself = draws_by_itself_;
    }
    if (!by_itself) {
        if (!of_window_) of_window_ = std::make_unique<Renderers>();
        draw_jobs(*of_window_, [](int, int) {});
    }
    const std::lock_guard lock(mutex_);
    return std::exchange(pictures_, {});
}

void PaneWorker::run() {
    try {
        DrawingContext context;
        context.make_current(1, 1);
        Renderers renderers;
        const auto prepare = [&](int width, int height) { context.make_current(width, height); };
        for (;;) {
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] { return is_ending_ || !jobs_.empty(); });
                if (is_ending_) return;
            }
            draw_jobs(renderers, prepare);
        }
    } catch (const std::exception&) {
        // There is no context, or no buffer of this size.
        const std::lock_guard lock(mutex_);
        draws_by_itself_ = is_working_ = is_drawing_ = false;
    }
    changed_.notify_all();
}

void PaneWorker::draw_jobs(Renderers& renderers, const std::function<void(int, int)>& prepare) {
    for (;;) {
        PaneJob job;
        {
            const std::lock_guard lock(mutex_);
            if (jobs_.empty()) return;
            const auto next = next_job();
            job = std::move(*next);
            jobs_.erase(next);
            is_working_ = true;
            is_drawing_ = !job.is_small;
        }
        try {
            prepare(job.size.width, job.size.height);
        } catch (const std::exception&) {
            const std::lock_guard lock(mutex_);
            jobs_.insert(jobs_.begin(), std::move(job));
            throw;
        }
        // Baking waits until there is nothing else to do, and another picture of the pane takes its place.
        renderers.allow_baking(job.only_bakes);
        PanePicture picture = drawn_picture(job, renderers);
        {
            const std::lock_guard lock(mutex_);
            is_working_ = is_drawing_ = false;
            if (renderers.want_to_bake() && std::ranges::find(jobs_, job.pane, &PaneJob::pane) == jobs_.end() &&
                !is_ending_) {
                PaneJob& baking = jobs_.emplace_back(job);
                baking.is_small = baking.only_bakes = true;
                baking.is_first = false;
            }
            if (!job.only_bakes) pictures_.push_back(std::move(picture));
        }
        changed_.notify_all();
    }
}

}  // namespace twinlight::demo

#include "app/session/reference_worker.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

#include "app/session/session.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "base/threads/threads.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

constexpr int kCoarse = 4;  // the first picture is 1/4 of the size in each direction
constexpr int kNicer = 10;  // the interface goes first

Frame frame_of(const ReferenceJob& job, int divisor) {
    const WindowSize size{std::max(job.size.width / divisor, 1), std::max(job.size.height / divisor, 1)};
    StateOptions options;
    options.width = size.width;
    options.height = size.height;
    return make_frame(scaled(*job.commands, natural_size(*job.commands), size), options);
}

reference::Options options_of(const Look& look) {
    reference::Options options;
    static_cast<Look&>(options) = look;
    return options;
}

}  // namespace

bool ReferenceJob::is_same_work(const ReferenceJob& other) const {
    return revision == other.revision && size == other.size && allowed_of == other.allowed_of && looks == other.looks;
}

ReferenceWorker::ReferenceWorker() : thread_(try_start_thread([this] { run(); })) {}

ReferenceWorker::~ReferenceWorker() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
        next_.reset();
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void ReferenceWorker::request(ReferenceJob job) {
    {
        const std::lock_guard lock(mutex_);
        if (job.is_same_work(last_)) return;
        last_ = job;
        next_ = std::move(job);
    }
    changed_.notify_all();
    if (!thread_.joinable()) draw_next();
}

bool ReferenceWorker::is_busy() const {
    const std::lock_guard lock(mutex_);
    return is_drawing_ || next_ || !pictures_.empty() || allowed_;
}

std::vector<std::shared_ptr<const ReferencePicture>> ReferenceWorker::take_pictures() {
    const std::lock_guard lock(mutex_);
    return std::exchange(pictures_, {});
}

std::shared_ptr<const ReferenceAllowed> ReferenceWorker::take_allowed() {
    const std::lock_guard lock(mutex_);
    return std::exchange(allowed_, nullptr);
}

std::string ReferenceWorker::take_failure() {
    std::exception_ptr failure;
    {
        const std::lock_guard lock(mutex_);
        failure = std::exchange(failure_, nullptr);
    }
    if (!failure) return "";
    try {
        std::rethrow_exception(failure);
    } catch (const std::exception& error) {
        return tr("the reference's picture cannot be drawn: {}", reason_of(error));
    }
}

void ReferenceWorker::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !is_drawing_ && !next_; });
}

void ReferenceWorker::run() {
    // On Linux the priority is the thread's own, and threads that it starts have it, too.
    setpriority(PRIO_PROCESS, 0, kNicer);
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return is_ending_ || next_; });
            if (is_ending_) return;
        }
        draw_next();
    }
}

void ReferenceWorker::draw_next() {
    ReferenceJob job;
    {
        const std::lock_guard lock(mutex_);
        if (!next_) return;  // the worker is ending
        job = std::move(*next_);
        next_.reset();
        is_drawing_ = true;
    }
    std::exception_ptr failure;
    try {
        draw(job);
    } catch (const SceneError&) {
        // The window shows the error: it makes the same Frame.
    } catch (...) {
        failure = std::current_exception();
    }
    {
        const std::lock_guard lock(mutex_);
        is_drawing_ = false;
        if (failure) failure_ = std::move(failure);
    }
    changed_.notify_all();
}

void ReferenceWorker::draw(const ReferenceJob& job) {
    const auto is_outdated = [this] {
        const std::lock_guard lock(mutex_);
        return is_ending_ || next_.has_value();
    };
    const auto draw_one = [&](const Frame& frame, const Look& look, int divisor) {
        const auto start = std::chrono::steady_clock::now();
        reference::Options options = options_of(look);
        auto picture = std::make_shared<ReferencePicture>();
        picture->look = look;
        picture->revision = job.revision;
        picture->divisor = divisor;
        picture->image = reference::render(frame, options);
        picture->ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        if (divisor == 1 && job.allowed_of == look && reference::has_quadrilaterals(frame)) {
            options.quad_cut = reference::QuadCut::kSecondToFourth;
            picture->other_cut = reference::render(frame, options);
        }
        const std::lock_guard lock(mutex_);
        pictures_.push_back(std::move(picture));
    };
    for (const int divisor : {kCoarse, 1}) {
        if (job.looks.empty() || is_outdated()) continue;
        const Frame frame = frame_of(job, divisor);
        for (const Look& look : job.looks)
            if (!is_outdated()) draw_one(frame, look, divisor);
    }
    if (!job.allowed_of || is_outdated()) return;
    auto allowed = std::make_shared<ReferenceAllowed>();
    allowed->look = *job.allowed_of;
    allowed->revision = job.revision;
    allowed->difference = reference::allowed_difference(frame_of(job, 1), options_of(*job.allowed_of));
    const std::lock_guard lock(mutex_);
    allowed_ = std::move(allowed);
}

}  // namespace twinlight::session

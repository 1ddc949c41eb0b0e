// Patience: when a panel may do work that takes longer than a frame. Slow work waits until the scene stands still.
#pragma once

#include <chrono>

namespace twinlight::demo {

class Patience {
  public:
    // Whether to work for this revision now: the last work was quick, or the revision has not changed for a while.
    bool may_work(int revision) {
        const Clock::time_point now = Clock::now();
        if (revision != revision_) {
            revision_ = revision;
            since_ = now;
        }
        is_waiting_ = last_ > kQuick && now - since_ < kStill;
        return !is_waiting_;
    }
    template <class Work>
    void work(const Work& work) {
        const Clock::time_point start = Clock::now();
        work();
        last_ = Clock::now() - start;
    }
    // The window must go on drawing frames, so that the work is done in one of them.
    bool is_waiting() const { return is_waiting_; }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr auto kQuick = std::chrono::milliseconds(25);
    static constexpr auto kStill = std::chrono::milliseconds(250);

    int revision_ = -1;
    Clock::time_point since_{};
    Clock::duration last_{};
    bool is_waiting_ = false;
};

}  // namespace twinlight::demo

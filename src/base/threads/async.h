// For std::async: work in a thread, or, if the system gives none, in the call of get().
#pragma once

#include <chrono>
#include <future>

namespace twinlight {

inline constexpr std::launch kThreadIfPossible = std::launch::async | std::launch::deferred;

// Whether to call get(): the work has ended, or get() does it.
template <class Result>
bool is_ready(const std::future<Result>& work) {
    return work.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
}

}  // namespace twinlight

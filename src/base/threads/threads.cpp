#include "base/threads/threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace twinlight {

void for_each_on_threads(int count, const std::function<void(int)>& piece) {
    std::atomic<int> next = 0;
    std::mutex mutex;
    std::exception_ptr first;
    const auto work = [&] {
        try {
            for (int i = next++; i < count; i = next++) piece(i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!first) first = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> helpers;
        const int wanted = std::min(count, static_cast<int>(std::thread::hardware_concurrency())) - 1;
        try {
            helpers.reserve(static_cast<std::size_t>(std::max(wanted, 0)));
            for (int i = 0; i < wanted; ++i) helpers.emplace_back(work);
        } catch (const std::system_error&) {  // fewer threads do the work
        } catch (const std::bad_alloc&) {
        }
        work();
    }
    if (first) std::rethrow_exception(first);
}

std::thread try_start_thread(std::function<void()> work) {
    try {
        return std::thread(std::move(work));
    } catch (const std::system_error&) {
        return {};
    } catch (const std::bad_alloc&) {
        return {};
    }
}

}  // namespace twinlight

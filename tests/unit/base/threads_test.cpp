// Work on several threads: what a piece throws, and a system that gives no threads.
#include "base/threads/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "../no_threads.h"
#include "base/threads/async.h"

namespace twinlight::threads_test {
namespace {

constexpr int kPieces = 1000;

TEST(Threads, DoEachPieceOnce) {
    std::vector<std::atomic<int>> done(kPieces);
    for_each_on_threads(kPieces, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
    for_each_on_threads(0, [](int) { ADD_FAILURE(); });
}

TEST(Threads, GiveTheirExceptionToTheCaller) {
    // Piece 100 may run on any of the threads, also on the caller's own.
    for (int run = 0; run < 50; ++run)
        EXPECT_THROW(for_each_on_threads(kPieces,
                                         [](int i) {
                                             if (i == 100) throw std::bad_alloc();
                                         }),
                     std::bad_alloc);
    // All of them throw; one exception leaves.
    std::atomic<int> begun = 0;
    EXPECT_THROW(for_each_on_threads(kPieces,
                                     [&](int) {
                                         ++begun;
                                         throw std::runtime_error("no");
                                     }),
                 std::runtime_error);
    EXPECT_LE(begun, static_cast<int>(std::thread::hardware_concurrency()));
}

TEST(Threads, ThatTheSystemRefusesAreDoneWithout) {
    const NoThreads none;
    std::vector<int> done;
    for_each_on_threads(kPieces, [&](int i) { done.push_back(i); });
    EXPECT_EQ(done.size(), kPieces);
    EXPECT_THROW(for_each_on_threads(kPieces, [](int) { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_FALSE(try_start_thread([] { ADD_FAILURE(); }).joinable());
    std::future<int> later = std::async(kThreadIfPossible, [] { return 7; });
    ASSERT_TRUE(is_ready(later));
    EXPECT_EQ(later.get(), 7);
}

}  // namespace
}  // namespace twinlight::threads_test

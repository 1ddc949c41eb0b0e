// The thread that draws the reference's pictures for the window: too little memory, and no thread.
#include <gtest/gtest.h>

#include <memory>

#include "../no_threads.h"
#include "../sanitized.h"
#include "app/session/reference_worker.h"
#include "scene/command/text.h"

namespace twinlight::session::session_reference_test {
namespace {

ReferenceJob job_of(int revision, WindowSize size) {
    ReferenceJob job;
    job.revision = revision;
    job.commands = std::make_shared<const CommandList>(read_scene("glutSolidSphere(1, 8, 8);", "test.gl", "test"));
    job.size = size;
    job.looks = {Look{}};
    job.allowed_of = Look{{}, false};
    return job;
}

TEST(SessionReference, GoesOnAfterAPictureThatIsTooLarge) {
    if (kSanitized) GTEST_SKIP() << "the address sanitizer ends the program";
    ReferenceWorker worker;
    worker.request(job_of(1, {1 << 24, 1 << 24}));  // even a quarter of this is more than the address space
    worker.wait();
    EXPECT_EQ(worker.take_failure(), "the reference's picture cannot be drawn: out of memory");
    EXPECT_EQ(worker.take_failure(), "");
    EXPECT_TRUE(worker.take_pictures().empty());
    EXPECT_FALSE(worker.is_busy());
    worker.request(job_of(2, {32, 32}));
    worker.wait();
    EXPECT_EQ(worker.take_failure(), "");
    EXPECT_EQ(worker.take_pictures().size(), 2u);
}

TEST(SessionReference, IsDrawnAtOnceWithoutAThread) {
    const NoThreads none;
    ReferenceWorker worker;
    worker.request(job_of(1, {32, 32}));
    EXPECT_EQ(worker.take_pictures().size(), 2u);  // coarse and whole
    EXPECT_NE(worker.take_allowed(), nullptr);
    EXPECT_FALSE(worker.is_busy());
}

}  // namespace
}  // namespace twinlight::session::session_reference_test

// A frame at another size.
#include "scene/frame/resized.h"

#include <gtest/gtest.h>

namespace twinlight::resized_test {
namespace {

TEST(Resized, NeighboursStillTouch) {
    Frame frame;
    frame.width = 10;
    frame.height = 4;
    for (int i = 0; i < 10; ++i) {
        Draw draw;
        draw.raster.viewport = {i, 0, 1, 4};
        frame.items.emplace_back(draw);
    }
    frame.items.emplace_back(Clear{});
    const Frame small = resized(frame, 7, 2);
    EXPECT_EQ(small.width, 7);
    EXPECT_EQ(small.height, 2);
    int end = 0;
    for (const Draw* draw : small.draws()) {
        EXPECT_EQ(draw->raster.viewport.x, end);
        EXPECT_EQ(draw->raster.viewport.height, 2);
        end += draw->raster.viewport.width;
    }
    EXPECT_EQ(end, 7);
}

}  // namespace
}  // namespace twinlight::resized_test

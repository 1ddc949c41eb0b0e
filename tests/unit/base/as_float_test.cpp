#include "base/math/as_float.h"

#include <gtest/gtest.h>

namespace twinlight::as_float_test {
namespace {

struct Pair {
    double a = 0, b = 0;
};
// With two static_casts, g++ 12 returns the numbers as they are. (clang does not know this attribute.)
#ifndef __clang__
[[gnu::optimize("O2", "tree-slp-vectorize")]]
#endif
[[gnu::noinline]] Pair
as_floats(const Pair& pair) {
    return {as_float(pair.a), as_float(pair.b)};
}

TEST(AsFloat, RoundsTwoNeighbours) {
    const Pair rounded = as_floats({0.1, 1.0 / 3});
    EXPECT_EQ(rounded.a, 0.1F);
    EXPECT_EQ(rounded.b, 1.0F / 3);
    EXPECT_NE(rounded.a, 0.1);
}

TEST(AsFloat, RoundsToTheNearest) {
    EXPECT_EQ(as_float(1), 1);
    EXPECT_EQ(as_float(1e30), 1e30F);
    EXPECT_EQ(as_float(1 + 0x1p-25), 1);
    EXPECT_EQ(as_float(-0x1p-151), 0);
}

}  // namespace
}  // namespace twinlight::as_float_test

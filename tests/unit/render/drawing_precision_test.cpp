// The precision that is measured by drawing, and what it adds to the allowed differences.
#include "render/context/drawing_precision.h"

#include <gtest/gtest.h>

#include "judge/compare/tolerance.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"

namespace twinlight::drawing_precision_test {
namespace {

// Mesa's software drivers interpolate between the vertices as they are, and round colours to the nearest code: nothing is allowed
// for them.
TEST(DrawingPrecision, IsExactInMesasSoftwareDrivers) {
    const DrawingPrecision precision = measure_drawing_precision();
    EXPECT_EQ(precision.position, 0);
    EXPECT_EQ(precision.conversion, 0);
    // softpipe takes the largest of m_u and m_v.
    const auto context = make_offscreen_context(1, 1);
    EXPECT_EQ(precision.approximates_rho, current_driver().name == "softpipe");
}

// A ramp of 1/64 a pixel across, from 10.2/255.
struct Ramp {
    Image right{8, 1};
    AllowedDifference allowed{8, 1};

    explicit Ramp(double first_code) {
        for (int x = 0; x < 8; ++x) right.at(x, 0) = Rgba{static_cast<float>(first_code / 255 + x / 64.0), 0, 0, 1};
    }
    float allowed_at(int x) const { return allowed.channels(static_cast<std::size_t>(x))[0]; }
};

TEST(DrawingPrecision, AllowsWhatMayCrossTheMiddleBetweenTwoCodes) {
    constexpr double kPosition =
        1 / 512.0;  // changes a colour of this ramp by 255 / 64 / 512 = 0.0078 codes; kArithmetic adds 0.0026
    Ramp near(10.5 + 0.007), far(10.5 + 0.012);
    compare::allow_drawing(near.allowed, near.right, nullptr, {.position = kPosition});
    compare::allow_drawing(far.allowed, far.right, nullptr, {.position = kPosition});
    EXPECT_GT(near.allowed_at(0), 0);
    EXPECT_EQ(far.allowed_at(0), 0);

    Ramp rounded(10.5 + 0.04), nearest(10.5 + 0.06);
    compare::allow_drawing(rounded.allowed, rounded.right, nullptr, {.conversion = 0.05});
    compare::allow_drawing(nearest.allowed, nearest.right, nullptr, {.conversion = 0.05});
    EXPECT_GT(rounded.allowed_at(0), 0);
    EXPECT_EQ(nearest.allowed_at(0), 0);
}

// The other cut of a quadrilateral is right, too.
TEST(DrawingPrecision, AllowsForBothCuts) {
    Ramp first(10.7);
    const Ramp second(10.53);
    compare::allow_drawing(first.allowed, first.right, &second.right, {.conversion = 0.05});
    EXPECT_GT(first.allowed_at(0), 0);
}

// Where filters or blending allow a difference already, the conversion may add to it.
TEST(DrawingPrecision, AddsToWhatIsAllowedAlready) {
    Ramp ramp(10.2);
    ramp.allowed.part(Why::kTextures).at(0, 0)[0] = 0.01F;
    compare::allow_drawing(ramp.allowed, ramp.right, nullptr, {.conversion = 0.05});
    EXPECT_NEAR(ramp.allowed_at(0), 0.01 + 0.05 / 255 + compare::kArithmetic, 1e-7);
}

// A driver that is exact gets what allow_ties() gives, and no more.
TEST(DrawingPrecision, AddsNothingForExactDrivers) {
    Ramp tie(10.5), off(10.51);
    compare::allow_drawing(tie.allowed, tie.right, nullptr, {});
    compare::allow_drawing(off.allowed, off.right, nullptr, {});
    EXPECT_FLOAT_EQ(tie.allowed_at(0), static_cast<float>(compare::kArithmetic));
    EXPECT_EQ(off.allowed_at(0), 0);
}

}  // namespace
}  // namespace twinlight::drawing_precision_test

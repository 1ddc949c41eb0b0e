// Delta E 2000: the published pairs of colours, the numbers of the sRGB standard, and pictures.
#include "base/image/delta_e.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/math/srgb.h"

namespace twinlight::delta_e_test {
namespace {

struct Pair {
    Lab one, other;
    double delta_e;
};

// Sharma, Wu, Dalal 2005, table 1.
constexpr Pair kPublished[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};
static_assert(std::size(kPublished) == 34);

TEST(DeltaE2000, IsThatOfThePublishedPairs) {
    constexpr double kPrinted = 0.5e-4 * 1.001;  // four digits are printed; 0.1 % more because 0.5 itself is rounded
    for (const auto& [one, other, delta_e] : kPublished) {
        EXPECT_NEAR(delta_e_2000(one, other), delta_e, kPrinted) << one.lightness << ", " << one.a << ", " << one.b;
    }
}

TEST(DeltaE2000, IsSymmetricAndZeroOfEqualColours) {
    for (const auto& [one, other, delta_e] : kPublished) {
        EXPECT_NEAR(delta_e_2000(one, other), delta_e_2000(other, one), 1e-12) << "each side is one rounded sum";
        EXPECT_EQ(delta_e_2000(one, one), 0);
    }
}

TEST(Srgb, MatricesUndoEachOtherAndKeepWhite) {
    for (const Vec3<double> c : {Vec3<double>{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.5, 0.9}}) {
        const Vec3<double> back = kSrgbFromXyz * (kXyzFromSrgb * c);
        EXPECT_NEAR(length(back - c), 0, 8 * std::numeric_limits<double>::epsilon());
    }
    EXPECT_NEAR(length(kXyzFromSrgb * Vec3<double>{1, 1, 1} - kSrgbWhite), 0, 4e-16);
    // IEC 61966-2-1 prints these four digits.
    EXPECT_NEAR(kXyzFromSrgb.row_x.x, 0.4124, 0.5e-4);
    EXPECT_NEAR(kXyzFromSrgb.row_y.y, 0.7152, 0.5e-4);
    EXPECT_NEAR(kXyzFromSrgb.row_z.z, 0.9505, 0.5e-4);
}

TEST(Srgb, CodesAndLightAreEachOthersInverse) {
    // The standard's two limits, 0.0031308 and 0.04045, agree only to about 1e-8.
    for (int code = -255; code <= 2 * 255; ++code)
        EXPECT_NEAR(srgb_coded(srgb_linear(code / 255.0)), code / 255.0, 1e-7);
    EXPECT_EQ(srgb_coded(0), 0);
    EXPECT_NEAR(srgb_coded(1), 1, 1e-15);
    EXPECT_NEAR(srgb_coded(0.214041), 0.5, 1e-6) << "code 0.5 is 21 % of the light";
}

TEST(Lab, GreysHaveNoHueAndWhiteIs100) {
    for (const double code : {0.01, 0.2, 0.5, 0.9, 1.0}) {
        const Lab lab = lab_from_srgb_codes({code, code, code});
        EXPECT_NEAR(lab.a, 0, 1e-12);
        EXPECT_NEAR(lab.b, 0, 1e-12);
    }
    EXPECT_NEAR(lab_from_linear_srgb({1, 1, 1}).lightness, 100, 1e-12);
    EXPECT_NEAR(lab_from_linear_srgb({0, 0, 0}).lightness, 0, 1e-12);
    EXPECT_NEAR(lab_from_linear_srgb({0.18, 0.18, 0.18}).lightness, 116 * std::cbrt(0.18) - 16, 1e-12);
}

// ---- Pictures ----

TEST(PerceivedDifference, ReadsChannelsAsCodes) {
    const Image one(1, 1, {0.5F, 0.5F, 0.5F, 1}), other(1, 1, {0.6F, 0.6F, 0.6F, 0});
    const auto lab = [](float c) { return lab_from_srgb_codes({double{c}, double{c}, double{c}}); };
    const PerceivedDifference d = perceived_difference(one, other);
    EXPECT_EQ(d.mean, delta_e_2000(lab(0.5F), lab(0.6F)));
    EXPECT_EQ(d.max, d.mean);
    EXPECT_EQ(d.percentile_95, d.mean);
    EXPECT_GT(
        std::abs(d.max - delta_e_2000(lab_from_linear_srgb({0.5, 0.5, 0.5}), lab_from_linear_srgb({0.6, 0.6, 0.6}))), 1)
        << "as linear light the difference would be smaller";
}

TEST(PerceivedDifference, TellsMeanPercentileAndWorst) {
    Image one(10, 10), other(10, 10);
    other.at(3, 7) = {1, 1, 1, 1};  // black against white: 100
    for (int x = 0; x < 5; ++x) other.at(x, 2) = {1, 1, 1, 1};
    PerceivedDifference d = perceived_difference(one, other);
    EXPECT_EQ(d.pixels, 100U);
    EXPECT_NEAR(d.mean, 6, 1e-9);
    EXPECT_NEAR(d.max, 100, 1e-9);
    EXPECT_NEAR(d.percentile_95, 100, 1e-9) << "six of a hundred are off";
    EXPECT_EQ(d.worst_x, 0);
    EXPECT_EQ(d.worst_y, 2);
    other.at(0, 2) = one.at(0, 2);
    EXPECT_EQ(perceived_difference(one, other).percentile_95, 0) << "five of a hundred are off";

    PixelMask counted(100, false);
    counted[one.index(3, 7)] = counted[one.index(9, 9)] = true;
    d = perceived_difference(one, other, counted);
    EXPECT_EQ(d.pixels, 2U);
    EXPECT_NEAR(d.mean, 50, 1e-9);
    EXPECT_EQ(d.worst_x, 3);
    EXPECT_EQ(d.worst_y, 7);
    EXPECT_EQ(perceived_difference(one, other, PixelMask(100, false)).pixels, 0U);
}

TEST(PerceivedDifference, ClampsAsTheFramebufferDoes) {
    const float nan = std::nanf("");
    const Image one(1, 1, {2, -1, nan, 1}), other(1, 1, {1, 0, 0, 1});
    EXPECT_EQ(perceived_difference(one, other).max, 0);
}

TEST(PerceivedDifference, RefusesPicturesOfDifferentSizes) {
    EXPECT_THROW(perceived_difference(Image(2, 1), Image(1, 2)), std::invalid_argument);
    EXPECT_THROW(perceived_difference(Image(2, 1), Image(2, 1), PixelMask(3)), std::invalid_argument);
}

}  // namespace
}  // namespace twinlight::delta_e_test

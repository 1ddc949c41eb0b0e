// Compares spectra with published numbers, tests what samples preserve, and checks the figures of docs/spectra.md,
// "Spectra".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/image/delta_e.h"
#include "base/math/srgb.h"
#include "scene/command/command.h"
#include "scene/spectrum/samples.h"

namespace twinlight::spectrum_test {
namespace {

using Vec = Vec3<double>;

// The rounding error of a sum over the lines, for numbers near 1.
constexpr double kSum = kLines * 2.3e-16;

void expect_near(Vec a, Vec b, double tolerance, std::string_view what) {
    EXPECT_NEAR(a.x, b.x, tolerance) << what;
    EXPECT_NEAR(a.y, b.y, tolerance) << what;
    EXPECT_NEAR(a.z, b.z, tolerance) << what;
}

struct Chromaticity {
    double x, y;
};
Chromaticity chromaticity(Vec xyz) {
    const double sum = xyz.x + xyz.y + xyz.z;
    return {xyz.x / sum, xyz.y / sum};
}

// CIELAB of a linear sRGB colour, whose white is that of a light.
Lab lab_under(Vec rgb, Vec light_rgb) {
    const Vec xyz = kXyzFromSrgb * rgb, white = kXyzFromSrgb * light_rgb;
    return lab_from_xyz(
        {xyz.x / white.x * kSrgbWhite.x, xyz.y / white.y * kSrgbWhite.y, xyz.z / white.z * kSrgbWhite.z});
}

// ---- The data ----

TEST(Spectra, HaveThePublishedWhitePoints) {
    struct Published {
        const char* name;
        double x, y, digits;
    };
    // CIE 15:2004, tables T.3 and 8.2; CIE 15:2018, table 12.2.
    constexpr Published kPublished[] = {{"A", 0.44758, 0.40745, 1e-5},   {"D50", 0.34567, 0.35851, 1e-5},
                                        {"D65", 0.31272, 0.32903, 1e-5}, {"F2", 0.3721, 0.3751, 1e-4},
                                        {"F11", 0.3805, 0.3769, 1e-4},   {"LED_B3", 0.3756, 0.3723, 1e-4}};
    for (const Published& p : kPublished) {
        const Spectrum* light = find_illuminant(p.name);
        ASSERT_NE(light, nullptr) << p.name;
        const Chromaticity c = chromaticity(xyz_of_light(light->lines));
        // Half of the last printed digit, and another half because they sum over more digits or lines.
        EXPECT_NEAR(c.x, p.x, p.digits) << p.name;
        EXPECT_NEAR(c.y, p.y, p.digits) << p.name;
        EXPECT_NEAR(xyz_of_light(light->lines).y, 1, kSum) << p.name;
    }
    EXPECT_EQ(illuminants().size(), std::size(kPublished));
}

TEST(Spectra, GiveD65OnWhiteTheColorWhite) {
    Lines white;
    white.fill(1);
    expect_near(rgb_of_reflectance(white), {1, 1, 1}, kSum, "white");
    expect_near(rgb_of_light(find_illuminant("D65")->lines), {1, 1, 1}, kSum, "D65");
    // The largest factor that this scales the channels by.
    expect_near(kSrgbFromXyz * xyz_of_light(find_illuminant("D65")->lines), {1, 1, 1}, 3e-4, "unscaled");
}

TEST(Spectra, AreAllWordsOfPragmas) {
    for (const auto& all : {reflectances(), illuminants()})
        for (const Spectrum& spectrum : all) {
            EXPECT_TRUE(std::ranges::any_of(words(), [&](const auto& word) { return word.name == spectrum.name; }))
                << spectrum.name;
            for (const double value : spectrum.lines) EXPECT_GE(value, 0) << spectrum.name;
        }
    for (const Spectrum& r : reflectances())
        for (const double value : r.lines) EXPECT_LE(value, 1) << r.name;
    EXPECT_EQ(find_reflectance("D65"), nullptr);
    EXPECT_EQ(find_illuminant("dark_skin"), nullptr);
}

// xyY under D50 from the maker of the chart (GretagMacbeth 2005): another chart, year and instrument.
TEST(Spectra, HaveThePatchesPublishedColors) {
    constexpr Vec kPublished[] = {
        {0.4316, 0.3777, 0.1008}, {0.4197, 0.3744, 0.3495}, {0.2760, 0.3016, 0.1836}, {0.3703, 0.4499, 0.1325},
        {0.2999, 0.2856, 0.2304}, {0.2848, 0.3911, 0.4178}, {0.5295, 0.4055, 0.3118}, {0.2305, 0.2106, 0.1126},
        {0.5012, 0.3273, 0.1938}, {0.3319, 0.2482, 0.0637}, {0.3984, 0.5008, 0.4446}, {0.4957, 0.4427, 0.4357},
        {0.2018, 0.1692, 0.0575}, {0.3253, 0.5032, 0.2318}, {0.5686, 0.3303, 0.1257}, {0.4697, 0.4734, 0.5981},
        {0.4159, 0.2688, 0.2009}, {0.2131, 0.3023, 0.1930}, {0.3469, 0.3608, 0.9131}, {0.3440, 0.3584, 0.5894},
        {0.3432, 0.3581, 0.3632}, {0.3446, 0.3579, 0.1915}, {0.3401, 0.3548, 0.0883}, {0.3406, 0.3537, 0.0311}};
    const Lines& d50 = find_illuminant("D50")->lines;
    const Vec white = xyz_of_light(d50);
    const auto lab = [&](Vec xyz) {
        return lab_from_xyz(
            {xyz.x / white.x * kSrgbWhite.x, xyz.y / white.y * kSrgbWhite.y, xyz.z / white.z * kSrgbWhite.z});
    };
    double sum = 0, worst = 0;
    for (std::size_t i = 0; i < 24; ++i) {
        Lines power;
        for (std::size_t l = 0; l < kLines; ++l) power[l] = d50[l] * reflectances()[i].lines[l];
        const auto [x, y, luminance] = kPublished[i];
        const double e =
            delta_e_2000(lab(xyz_of_light(power)), lab({luminance * x / y, luminance, luminance * (1 - x - y) / y}));
        sum += e;
        worst = std::max(worst, e);
        EXPECT_LT(e, 4) << reflectances()[i].name << ": charts differ, but each patch is still recognisable";
    }
    EXPECT_LT(sum / 24, 1.5);
    EXPECT_GT(worst, 0.5) << "the two charts should not have the same numbers";
}

TEST(Primaries, AddUpToWhiteAndStayReflectances) {
    for (std::size_t l = 0; l < kLines; ++l) {
        double sum = 0;
        for (const Spectrum& p : primaries()) {
            EXPECT_GE(p.lines[l], 0);
            EXPECT_LE(p.lines[l], 1);
            sum += p.lines[l];
        }
        EXPECT_NEAR(sum, 1, 1e-5) << "as printed; " << wavelength_nm(static_cast<int>(l)) << " nm";
    }
    // The colours of the printed primaries under D65 are only approximate; the samples correct the rest.
    expect_near(rgb_of_reflectance(primaries()[0].lines), {1, 0, 0}, 5e-4, "red");
    expect_near(rgb_of_reflectance(primaries()[1].lines), {0, 1, 0}, 5e-4, "green");
    expect_near(rgb_of_reflectance(primaries()[2].lines), {0, 0, 1}, 5e-4, "blue");
}

// ---- Samples ----

class Samples : public testing::TestWithParam<int> {
  protected:
    const SpectralSamples samples_{GetParam()};
};

TEST_P(Samples, KeepEveryColor) {
    // A sum over the samples with the inverse of a matrix, which magnifies rounding by some tens.
    constexpr double kTolerance = 100 * kSum;
    for (const Vec c : {Vec{1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0.2, 0.5, 0.9}, {0, 1, 1}, {-0.5, 2, 7}})
        expect_near(samples_.color(samples_.of_color(c)), c, kTolerance * (1 + length(c)), "a colour");
    for (const Spectrum& r : reflectances())
        expect_near(samples_.color(samples_.of_reflectance(r)), rgb_of_reflectance(r.lines), kTolerance, r.name);
    for (const Spectrum& l : illuminants())
        expect_near(samples_.color(samples_.of_illuminant(l)), rgb_of_light(l.lines), kTolerance, l.name);
}

TEST_P(Samples, OfWhiteAreOnes) {
    for (const double s : samples_.of_color({1, 1, 1})) EXPECT_NEAR(s, 1, 2e-5) << "the printed primaries' sum";
    for (const double s : samples_.of_illuminant(*find_illuminant("D65"))) EXPECT_NEAR(s, 1, 100 * kSum);
}

// So under D65 one reflection is exact even with three samples: the result is the colour.
TEST_P(Samples, UnderD65GiveThePatchesTheirColors) {
    const auto& d65 = samples_.of_illuminant(*find_illuminant("D65"));
    for (const Spectrum& r : reflectances())
        expect_near(samples_.color_of_product(d65, samples_.of_reflectance(r)), rgb_of_reflectance(r.lines), 200 * kSum,
                    r.name);
}

INSTANTIATE_TEST_SUITE_P(Counts, Samples, testing::Values(3, 4, 5, 9, 16, 31, 80, 81));

TEST(SpectralSamples, AreTheLinesThemselvesWhereThereAreAsMany) {
    const SpectralSamples all(kLines);
    const Spectrum& patch = reflectances()[14];
    for (std::size_t l = 0; l < kLines; ++l) EXPECT_NEAR(all.of_reflectance(patch)[l], patch.lines[l], 100 * kSum);
}

TEST(SpectralSamples, AreSmoothWhereTheColorIs) {
    for (const double s : SpectralSamples(81).of_color({0.8, 0.5, 0.3})) {
        EXPECT_GE(s, 0.3 - 1e-3);
        EXPECT_LE(s, 0.8 + 1e-3);
    }
}

// ---- Delta E ----

struct Off {
    double mean = 0, max = 0;
};

// For the 24 patches under a light, relative to the light's white; n = 0 means the product of red, green and blue.
Off off_by(const Spectrum& light, int n) {
    const SpectralSamples all(kLines), some(n == 0 ? 3 : n);
    const Vec light_rgb = rgb_of_light(light.lines);
    Off off;
    for (const Spectrum& r : reflectances()) {
        const Vec truth = all.color_of_product(all.of_illuminant(light), all.of_reflectance(r));
        const Vec seen = n == 0 ? light_rgb * rgb_of_reflectance(r.lines)
                                : some.color_of_product(some.of_illuminant(light), some.of_reflectance(r));
        const double e = delta_e_2000(lab_under(truth, light_rgb), lab_under(seen, light_rgb));
        off.mean += e / 24;
        off.max = std::max(off.max, e);
    }
    return off;
}

TEST(SpectralSamples, ConvergeUnderEveryLight) {
    for (const Spectrum& light : illuminants()) {
        if (light.name == "D65") continue;  // exact with any number of samples
        EXPECT_LT(off_by(light, 9).mean, off_by(light, 3).mean) << light.name;
        EXPECT_LT(off_by(light, 16).mean, off_by(light, 9).mean) << light.name;
        EXPECT_LT(off_by(light, 61).mean, 0.1) << light.name;
        EXPECT_LT(off_by(light, kLines).max, 1e-6) << light.name;
    }
}

// Samples that do not preserve colours: means over bands of equal width, 380 to 780 nm.
Off off_by_plain_bands(const Spectrum& light, int n) {
    const Vec light_rgb = rgb_of_light(light.lines);
    const Lines& d65 = find_illuminant("D65")->lines;
    const auto band = [&](std::size_t line) { return std::min(n - 1, 5 * static_cast<int>(line) * n / 400); };
    Off off;
    for (const Spectrum& r : reflectances()) {
        Vec truth, seen;
        for (int b = 0; b < n; ++b) {
            double lines = 0, mean_light = 0, mean_reflectance = 0;
            Vec weight;
            for (std::size_t l = 0; l < kLines; ++l) {
                if (band(l) != b) continue;
                lines += 1;
                mean_light += light.lines[l];
                mean_reflectance += r.lines[l];
                weight += rgb_weights()[l] / d65[l];
                truth += light.lines[l] * r.lines[l] / d65[l] * rgb_weights()[l];
            }
            seen += mean_light * mean_reflectance / (lines * lines) * weight;
        }
        const double e = delta_e_2000(lab_under(truth, light_rgb), lab_under(seen, light_rgb));
        off.mean += e / 24;
        off.max = std::max(off.max, e);
    }
    return off;
}

// Half of the last digit that docs/spectra.md prints.
TEST(SpectralSamples, AreOffByWhatTheDocumentationSays) {
    const Spectrum& a = *find_illuminant("A");
    EXPECT_NEAR(off_by(a, 0).mean, 4.19, 0.005);
    EXPECT_NEAR(off_by(a, 0).max, 12.56, 0.005);
    EXPECT_NEAR(off_by(a, 9).mean, 0.32, 0.005);
    EXPECT_NEAR(off_by(a, 9).max, 0.97, 0.005);
    EXPECT_LT(off_by(*find_illuminant("D65"), 0).max, 1e-9) << "red, green and blue are exact";
    EXPECT_NEAR(off_by_plain_bands(a, 9).mean, 1.25, 0.005);
    EXPECT_NEAR(off_by_plain_bands(a, 9).max, 2.75, 0.005);
}

}  // namespace
}  // namespace twinlight::spectrum_test

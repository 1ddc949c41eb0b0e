// Rulings: our choices where the specification is silent (docs/hard-cases.md). No result is NaN or infinite. Where the
// equation has a limit, the result is that limit; otherwise the term contributes 0.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../lighting_case.h"

namespace twinlight::lighting::equation_rulings_test {
namespace {

void expect_finite(const MeasuredLit<double>& lit) {
    for (const D& c : {lit.primary, lit.secondary, lit.magnitude})
        EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)) << c.x << ' ' << c.y << ' ' << c.z;
}

TEST(Ruling, HighlightsBeyondTheLargestNumberWithBothSignsContributeNothing) {
    Case c;
    c.only_specular(128);
    c.surface.normal_eye = {0, 0, 1000};
    c.lights.push_back(c.light());
    c.lights[1].specular = {-1, 1, 0};
    EXPECT_EQ(c.lit().primary, (D{0, std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}));
}

TEST(Ruling, ALightAtTheVertexAddsItsAmbientOnly) {
    Case c;
    c.material.ambient = c.material.specular = {1, 1, 1};
    c.material.shininess = 1;
    c.light().ambient = {0.25, 0.25, 0.25};
    c.light().specular = {1, 1, 1};
    c.place_light({0, 0, 0});
    EXPECT_EQ(c.red(), 0.25);  // d = 0, so att = 1 / k0 = 1; no direction, so no cosine
    c.light().constant_attenuation = 0;
    c.light().linear_attenuation = 1;
    EXPECT_EQ(c.red(), 0);  // 1 / 0 has no limit
}

TEST(Ruling, AnAttenuationWithoutAPositiveDenominatorContributesNothing) {
    Case c;
    c.place_light({0, 0, 2});
    c.light().constant_attenuation = 0;
    EXPECT_EQ(c.red(), 0);
    c.light().constant_attenuation = -1;
    EXPECT_EQ(c.red(), 0);
}

TEST(Ruling, AZeroNormalIsReachedByAmbientLightOnly) {
    Case c;
    c.only_specular(0);
    c.material.diffuse = {1, 1, 1};
    c.material.ambient = {1, 1, 1};
    c.light().ambient = {0.125, 0.125, 0.125};
    c.surface.normal_eye = {0, 0, 0};
    EXPECT_EQ(c.red(), 0.125);
}

TEST(Ruling, AHalfVectorOfLengthZeroHasNoHighlight) {  // light and viewer are in opposite directions
    Case c;
    c.only_specular(3);
    c.surface.normal_eye = unit(D{1, 0, -1});  // n . VP is still positive
    c.place_light({0, 0, -1}, 0);
    EXPECT_EQ(c.red(), 0);
    expect_finite(c.lit());
}

TEST(Ruling, SquaresMayOverflowOrUnderflow) {
    for (const double scale : {1e-320, 1e-300, 1e-160, 1e160, 1e300}) {
        Case c;
        c.place_light({0, 3 * scale, 4 * scale}, 0);
        // A denormal number has few digits: 1e-320 is 2024 units, so the error of its direction is up to 4e-4.
        const double digits_lost = scale < 1e-307 ? 1e-3 : 0;
        EXPECT_NEAR(c.red(), 0.8, kArithmetic + digits_lost) << scale;
        c.place_light({0, 3 * scale, 4 * scale});
        EXPECT_NEAR(c.red(), 0.8, kArithmetic + digits_lost) << scale;
        c.light().quadratic_attenuation = 1;  // 1 / (1 + d^2): 1 or 0 here
        EXPECT_NEAR(c.red(), scale < 1 ? 0.8 : 0, kArithmetic + digits_lost) << scale;
    }
}

TEST(Ruling, NoCornerOfTheParametersGivesNaNOrInfinity) {
    const double big = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
    for (const double coordinate : {0.0, tiny, -1.0, big, -big})
        for (const double w : {0.0, 1.0, -1.0, tiny, big})
            for (const double k : {0.0, tiny, 1.0, -1.0, big})
                for (const double exponent : {0.0, 1.0, 128.0, -1.0})
                    for (const double color : {0.0, 1.0, big, -big}) {
                        Case c;
                        c.model = {.ambient = {color, 1, 1}, .local_viewer = true, .separate_specular = k == 0};
                        c.model.reflection = exponent == 1;
                        c.material = {{color, 1, 1}, {1, color, 1}, {color, 1, 1}, {1, 1, color}, 1, exponent};
                        c.surface = {{coordinate, 0, -coordinate}, {color, 0, 1}};
                        c.place_light({coordinate, -coordinate, 0}, w);
                        c.light().ambient = c.light().diffuse = c.light().specular = {color, color, color};
                        c.light().constant_attenuation = k;
                        c.light().linear_attenuation = c.light().quadratic_attenuation = -k;
                        c.light().spot_exponent = exponent;
                        c.aim_spot({coordinate, 0, coordinate}, 90);
                        expect_finite(c.lit());
                    }
}

TEST(Unit, OfVectorsWithoutADirectionIsZero) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(unit(D{0, 0, 0}), (D{0, 0, 0}));
    const D u = unit(D{infinity, 1, 0});
    EXPECT_TRUE(std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z));
}

TEST(Clamp, TakesComponentsToTheUnitInterval) {  // 2.14.6
    EXPECT_EQ(clamp01(-0.5), 0);
    EXPECT_EQ(clamp01(0.25), 0.25);
    EXPECT_EQ(clamp01(7.0), 1);
    EXPECT_EQ(clamp01(std::nan("")), 0);
}

}  // namespace
}  // namespace twinlight::lighting::equation_rulings_test

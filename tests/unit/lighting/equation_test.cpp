// The lighting equation, term by term: GL 2.1 section 2.14.1. Expected values are calculated by hand.
#include "lighting/equation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../lighting_case.h"

namespace twinlight::lighting::equation_test {
namespace {

// ---- The sum ----

TEST(Equation, WithoutLightsIsEmissionPlusMaterialAmbientTimesSceneAmbient) {
    Case c;
    c.lights.clear();
    c.material.emission = {0.1, 0.2, 0.3};
    c.material.ambient = {0.5, 0.25, 1};
    c.model.ambient = {0.2, 0.4, 0.6};
    EXPECT_EQ(c.lit().primary, (D{0.1 + 0.5 * 0.2, 0.2 + 0.25 * 0.4, 0.3 + 1 * 0.6}));
}

TEST(Equation, AlphaIsTheDiffuseMaterialsWhateverTheLights) {
    Case c;
    c.lights.push_back(c.lights[0]);
    EXPECT_EQ(c.lit().alpha, 0.5);
}

TEST(Equation, ChannelsDoNotMix) {
    Case c;
    c.material.diffuse = {0.25, 0.5, 1};
    c.light().diffuse = {1, 0.5, 0};
    EXPECT_EQ(c.lit().primary, (D{0.25, 0.25, 0}));
}

TEST(Equation, TwoLightsAddUp) {
    Case c;
    c.lights.push_back(c.lights[0]);
    c.lights[1].diffuse = {0.5, 0, 0};
    EXPECT_EQ(c.lit().primary, (D{1.5, 1, 1}));
}

TEST(Equation, MagnitudeSumsTheSizesOfTermsThatCancel) {
    Case c;
    c.material.emission = {-1, 0, 0};  // colours have no bounds (2.14.2)
    EXPECT_EQ(c.lit().primary.x, 0);
    EXPECT_EQ(c.lit().magnitude.x, 2);
}

// ---- Diffuse ----

TEST(Diffuse, FollowsTheCosineOfTheAngle) {
    for (const double angle_deg : {0.0, 30.0, 60.0, 89.0}) {
        Case c;
        c.place_light({std::sin(angle_deg * std::numbers::pi / 180), 0, cos_deg(angle_deg)}, 0);
        EXPECT_NEAR(c.red(), std::cos(angle_deg * std::numbers::pi / 180), kArithmetic) << angle_deg;
    }
}

TEST(Diffuse, IsZeroForALightBehind) {
    Case c;
    c.place_light({0, 0, -1}, 0);
    EXPECT_EQ(c.red(), 0);
}

TEST(Diffuse, TakesTheNormalAsItIs) {  // the equation does not normalise n
    Case c;
    c.surface.normal_eye = {0, 0, 2};
    EXPECT_EQ(c.red(), 2);
}

TEST(Diffuse, OfAPositionalLightDoesNotDependOnItsDistance) {
    Case c;
    c.place_light({0, 3, 4});
    EXPECT_NEAR(c.red(), 0.8, kArithmetic);
    c.place_light({0, 3e8, 4e8});
    EXPECT_NEAR(c.red(), 0.8, kArithmetic);
}

// ---- Positions and w ----

TEST(LightPosition, IsDividedByW) {
    Case c;
    c.surface.position_eye = {1, 0, 0};
    c.place_light({8, 0, 8}, 2);  // (4, 0, 4); from (1, 0, 0) the vector to it is (3, 0, 4)
    c.light().linear_attenuation = 1;
    c.light().constant_attenuation = 0;
    EXPECT_NEAR(c.terms().n_dot_vp, 0.8, kArithmetic);
    EXPECT_NEAR(c.terms().attenuation, 1.0 / 5, kArithmetic);
}

TEST(LightPosition, WithNegativeWLiesOnTheOtherSide) {
    Case c;
    c.place_light({0, 0, -2}, -1);  // (0, 0, 2)
    EXPECT_EQ(c.red(), 1);
    c.place_light({0, 0, 2}, -1);
    EXPECT_EQ(c.red(), 0);
}

TEST(LightPosition, WithZeroWIsADirectionWhereverTheVertexIs) {
    Case c;
    c.place_light({0, 3, 4}, 0);
    const double at_origin = c.red();
    c.surface.position_eye = {-50, 7, -20};
    EXPECT_EQ(c.red(), at_origin);
    EXPECT_NEAR(at_origin, 0.8, kArithmetic);
}

TEST(LightPosition, WithATinyWNearsTheDirection) {
    Case c;
    c.surface.position_eye = {1, 2, -3};
    c.place_light({0, 3, 4}, 1e-15);
    EXPECT_NEAR(c.red(), 0.8, kArithmetic + 4e-15);  // the vertex moves the light by |V| w
}

// ---- Attenuation ----

TEST(Attenuation, IsTheReciprocalOfTheQuadraticInTheDistance) {
    Case c;
    c.place_light({0, 0, 2});
    c.light().constant_attenuation = 1;
    c.light().linear_attenuation = 0.5;
    c.light().quadratic_attenuation = 0.25;
    EXPECT_EQ(c.red(), 1 / (1 + 0.5 * 2 + 0.25 * 4));
}

TEST(Attenuation, MayMakeALightBrighterThanTheLargestNumber) {
    Case c;
    c.place_light({0, 0, 2});
    c.light().constant_attenuation = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(c.red(), std::numeric_limits<double>::max());
}

TEST(Attenuation, DoesNotActOnDirectionalLights) {
    Case c;
    c.light().constant_attenuation = 5;
    c.light().quadratic_attenuation = 7;
    EXPECT_EQ(c.red(), 1);
}

TEST(Attenuation, ActsOnTheLightsAmbientButNotOnTheScenes) {
    Case c;
    c.material = {.ambient = {1, 1, 1}};
    c.model.ambient = {0.5, 0.5, 0.5};
    c.light().ambient = {1, 1, 1};
    c.place_light({0, 0, 4});
    c.light().linear_attenuation = 0.75;  // 1 / (1 + 3)
    EXPECT_EQ(c.red(), 0.5 + 0.25);
}

// ---- Spot ----

TEST(Spotlight, LightsEverythingAtCutoff180) {
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({0, 0, 1}, 180);  // away from the surface
    c.light().spot_exponent = 8;
    EXPECT_EQ(c.red(), 1);
}

TEST(Spotlight, IsDarkOutsideItsCutoffAndFullInsideWithExponentZero) {
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({1, 0, -1}, 50);  // the surface is 45 degrees off the axis
    EXPECT_EQ(c.red(), 1);
    c.aim_spot({1, 0, -1}, 40);
    EXPECT_EQ(c.red(), 0);
}

TEST(Spotlight, OfCutoffZeroLightsItsAxis) {  // the comparison is >=
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({0, 0, -1}, 0);
    EXPECT_EQ(c.red(), 1);
    c.place_light({1, 2, 3});  // an axis whose unit vector is rounded
    c.aim_spot({-1, -2, -3}, 0);
    EXPECT_EQ(c.terms().spot, 1);
    c.aim_spot({-1.0001, -2, -3}, 0);
    EXPECT_EQ(c.terms().spot, 0);
}

TEST(Spotlight, OfCutoff90LightsWhatIsSquareToItsAxis) {
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({1, 0, 0}, 90);
    EXPECT_EQ(c.red(), 1);  // cos = 0 >= 0, and 0^0 = 1
    c.light().spot_exponent = 1;
    EXPECT_EQ(c.red(), 0);
}

TEST(Spotlight, OfCutoff90AndExponent0LightsWhatIsBehindIt) {  // max(PV . s, 0) = 0 = cos 90, and 0^0 = 1
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({0, 0, 1}, 90);  // away from the surface
    EXPECT_EQ(c.red(), 1);
    c.light().spot_exponent = 1e-9;
    EXPECT_EQ(c.red(), 0);
    c.light().spot_exponent = 0;
    c.aim_spot({0, 0, 1}, 89.999999);
    EXPECT_EQ(c.red(), 0);
}

TEST(Spotlight, FallsOffByThePowerOfTheCosine) {
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({1, 0, -1}, 60);
    c.light().spot_exponent = 4;
    EXPECT_NEAR(c.terms().spot, 0.25, kArithmetic);  // cos(45 degrees)^4
}

TEST(Spotlight, ActsOnDirectionalLightsToo) {
    Case c;
    c.aim_spot({0, 0, 1}, 30);  // the light falls along -z
    EXPECT_EQ(c.red(), 0);
    c.aim_spot({0, 0, -1}, 30);
    EXPECT_EQ(c.red(), 1);
}

TEST(Spotlight, ActsOnTheLightsAmbient) {
    Case c;
    c.material = {.ambient = {1, 1, 1}};
    c.light().ambient = {1, 1, 1};
    c.place_light({0, 0, 1});
    c.aim_spot({0, 0, 1}, 30);
    EXPECT_EQ(c.red(), 0);
}

// ---- Specular ----

TEST(Specular, IsThePowerOfTheNormalsCosineToTheHalfVector) {
    Case c;
    c.only_specular(4);
    c.place_light({std::sqrt(0.75), 0, 0.5}, 0);            // 60 degrees: the half vector is at 30
    EXPECT_NEAR(c.red(), 0.75 * 0.75, kArithmetic);         // cos(30 degrees)^4
    EXPECT_NEAR(c.terms().highlight, 0.5625, kArithmetic);  // f_i (n . h)^s
}

TEST(Specular, LooksAlongZForTheInfiniteViewerAndFromTheOriginForTheLocalOne) {
    Case c;
    c.only_specular(1);
    c.surface.position_eye = {-3, 0, -4};  // the eye is along (3, 0, 4) / 5
    c.place_light({0, 0, 1}, 0);
    EXPECT_NEAR(c.red(), 1, kArithmetic);  // h = (0, 0, 1)
    c.model.local_viewer = true;
    const double sum_length = std::sqrt(0.6 * 0.6 + 1.8 * 1.8);  // (0, 0, 1) + (0.6, 0, 0.8)
    EXPECT_NEAR(c.red(), 1.8 / sum_length, kArithmetic);
}

TEST(Specular, IsOffWhereTheLightIsNotInFront) {  // f_i: n . h is positive here, n . VP is not
    Case c;
    c.only_specular(1);
    c.place_light({1, 0, -0.5}, 0);
    EXPECT_EQ(c.red(), 0);
    c.place_light({1, 0, 0}, 0);  // exactly at 90 degrees: n . VP is 0
    EXPECT_EQ(c.red(), 0);
    c.place_light({1, 0, 1e-9}, 0);
    EXPECT_GT(c.red(), 0.7);
}

TEST(Specular, OfShininessZeroIsOneWhereverTheLightIsInFront) {  // 0^0 = 1 (2.1.1)
    Case c;
    c.only_specular(0);
    c.place_light({1, 0, 0.01}, 0);
    EXPECT_EQ(c.red(), 1);
}

TEST(Specular, BeyondTheLargestNumberIsTheLargest) {  // 2.14.6 clamps it; 0 times it is 0
    constexpr double kLargest = std::numeric_limits<double>::max();
    Case c;
    c.only_specular(128);
    c.surface.normal_eye = {0, 0, 1000};  // 1e384
    c.material.specular = {1, 0, -1};     // colours have no bounds (2.14.2)
    EXPECT_EQ(c.lit().primary, (D{kLargest, 0, -kLargest}));
    EXPECT_EQ(c.lit().magnitude, (D{kLargest, 0, kLargest}));
    c.light().specular = {1e-10, 1e-10, 0};
    EXPECT_EQ(c.lit().primary, (D{kLargest, 0, 0}));
    c.model.separate_specular = true;
    EXPECT_EQ(c.lit().secondary, (D{kLargest, 0, 0}));
    c.aim_spot({0, 0, 1}, 10);  // the light comes from +z, so the surface is outside
    EXPECT_EQ(c.lit().secondary, (D{0, 0, 0}));
}

TEST(Specular, GoesToTheSecondaryColourWhenSeparate) {
    Case c;
    c.only_specular(1);
    c.material.diffuse = {0.25, 0.25, 0.25};
    c.material.diffuse_alpha = 0.5;
    c.model.separate_specular = true;
    const MeasuredLit<double> lit = c.lit();
    EXPECT_EQ(lit.primary, (D{0.25, 0.25, 0.25}));
    EXPECT_EQ(lit.secondary, (D{1, 1, 1}));
    EXPECT_EQ(lit.alpha, 0.5);
    EXPECT_EQ(lit.magnitude.x, 0.25);  // only of the primary colour
    c.model.separate_specular = false;
    EXPECT_EQ(c.lit().primary, (D{1.25, 1.25, 1.25}));
    EXPECT_EQ(c.lit().secondary, (D{0, 0, 0}));
}

// ---- The lecture's variants ----

TEST(Reflection, IsThePowerOfTheMirroredLightsCosineToTheViewer) {
    Case c;
    c.only_specular(2);
    c.model.reflection = true;
    c.place_light({std::sqrt(0.75), 0, 0.5},
                  0);  // mirrored: 60 degrees on the other side; the viewer is along z
    EXPECT_NEAR(c.red(), 0.25, kArithmetic);
}

TEST(Reflection, DiffersFromTheHalfVectorAtTheSameExponent) {
    Case half, mirrored;
    half.only_specular(8);
    mirrored.only_specular(8);
    mirrored.model.reflection = true;
    for (Case* c : {&half, &mirrored}) c->place_light({0.5, 0, std::sqrt(0.75)}, 0);  // 30 degrees
    EXPECT_NEAR(half.red(), std::pow(std::cos(std::numbers::pi / 12), 8), kArithmetic);
    EXPECT_NEAR(mirrored.red(), std::pow(std::cos(std::numbers::pi / 6), 8), kArithmetic);
}

TEST(Reflection, HasNoTestForALightBehind) {
    Case c;
    c.only_specular(1);
    c.model.reflection = true;
    c.surface.normal_eye = {1, 0, 0};
    c.place_light({-1, 0, 1},
                  0);  // behind the surface; mirrored about x it is (-1, 0, -1): away from the viewer
    EXPECT_EQ(c.red(), 0);
    c.place_light({-1, 0, -1}, 0);  // behind; mirrored (-1, 0, 1), which the viewer sees at 45 degrees
    EXPECT_NEAR(c.red(), std::sqrt(0.5), kArithmetic);
}

TEST(UnattenuatedAmbient, IsOutsideAttenuationAndSpot) {
    Case c;
    c.material = {.ambient = {1, 1, 1}, .diffuse = {1, 1, 1}};
    c.light().ambient = {0.25, 0.25, 0.25};
    c.model.ambient_unattenuated = true;
    c.place_light({0, 0, 2});
    c.light().constant_attenuation = 4;
    EXPECT_EQ(c.red(), 0.25 + 1.0 / 4);
    c.aim_spot({0, 0, 1}, 10);
    EXPECT_EQ(c.red(), 0.25);
}

TEST(SmoothCone, RisesLinearlyInTheCosineBetweenItsCones) {
    Case c;
    c.place_light({0, 0, 1});
    c.light().has_smooth_cone = true;
    c.light().cos_inner = 0.9;
    c.light().cos_outer = 0.5;
    const auto aim_at_cosine = [&](double cosine) {
        c.light().spot_dir_eye = {std::sqrt(1 - cosine * cosine), 0, -cosine};
        return c.red();
    };
    EXPECT_EQ(aim_at_cosine(0.95), 1);
    EXPECT_NEAR(aim_at_cosine(0.7), 0.5, kArithmetic);
    EXPECT_EQ(aim_at_cosine(0.4), 0);
}

TEST(SmoothCone, ReplacesCutoffAndExponent) {
    Case c;
    c.place_light({0, 0, 1});
    c.aim_spot({0, 1, -1}, 10);
    c.light().spot_exponent = 9;
    c.light().has_smooth_cone = true;
    c.light().cos_inner = 0.6;
    c.light().cos_outer = 0.5;
    EXPECT_EQ(c.red(), 1);
}

TEST(SmoothCone, OfEqualConesIsAStepThatIncludesItsBorder) {
    Case c;
    c.place_light({0, 0, 1});
    c.light().has_smooth_cone = true;
    c.light().cos_inner = c.light().cos_outer = 1;
    EXPECT_EQ(c.red(), 1);  // on the axis
    c.light().spot_dir_eye = unit(D{0.01, 0, -1});
    EXPECT_EQ(c.red(), 0);
}

// ---- Number types ----

// A spotlight with all features, and a local viewer.
template <class Real>
Lit<Real> everything_on() {
    const Model<Real> model{.ambient = {Real(0.25), Real(0.5), Real(0.125)}, .local_viewer = true};
    const Material<Real> material{.emission = {Real(0.0625), 0, 0},
                                  .ambient = {Real(0.5), Real(0.25), Real(0.5)},
                                  .diffuse = {Real(0.75), Real(0.5), Real(0.25)},
                                  .specular = {1, Real(0.5), Real(0.25)},
                                  .shininess = 10};
    Light<Real> light{.ambient = {Real(0.125), Real(0.125), Real(0.5)},
                      .diffuse = {1, Real(0.75), Real(0.5)},
                      .specular = {1, 1, 1},
                      .position_eye = {2, 3, -1},
                      .directional = false};
    light.spot_dir_eye = unit(Vec3<Real>{-1, -1, -1});
    light.is_spot = true;
    light.cos_cutoff = Real(cos_deg(40));
    light.spot_exponent = 2;
    light.linear_attenuation = Real(0.125);
    const SurfacePoint<Real> surface{{Real(0.5), Real(-0.25), -4}, unit(Vec3<Real>{Real(0.25), Real(0.5), 1})};
    return light_surface<Real>(model, material, surface, std::span<const Light<Real>>(&light, 1));
}

TEST(NumberTypes, AgreeToThePrecisionOfTheCoarserOne) {
    const Lit<long double> exact = everything_on<long double>();
    // About forty operations; the power of 10 multiplies the relative error of its base by ten.
    constexpr double kOperations = 60;
    const Lit<double> in_double = everything_on<double>();
    const Lit<float> in_float = everything_on<float>();
    EXPECT_NEAR(in_double.primary.x, static_cast<double>(exact.primary.x),
                kOperations * std::numeric_limits<double>::epsilon());
    EXPECT_NEAR(in_float.primary.x, static_cast<double>(exact.primary.x),
                kOperations * std::numeric_limits<float>::epsilon());
    EXPECT_NE(static_cast<double>(in_float.primary.x), in_double.primary.x);  // the calculation really was in float
}

TEST(Breakdown, AddsUpToThePrimaryColour) {
    Case c;
    c.material = {{0.1, 0, 0}, {0.3, 0, 0}, {0.5, 0, 0}, {0.7, 0, 0}, 1, 3};
    c.model.ambient = {0.2, 0, 0};
    c.light().ambient = c.light().specular = {1, 1, 1};
    c.place_light({1, 2, 3});
    c.light().linear_attenuation = 0.1;
    const LightTerms<double> t = c.terms();
    EXPECT_NEAR(c.red(), 0.1 + 0.3 * 0.2 + t.ambient.x + t.diffuse.x + t.specular.x, kArithmetic);
    EXPECT_NEAR(t.diffuse.x, t.attenuation * t.spot * t.n_dot_vp * 0.5, kArithmetic);
    EXPECT_NEAR(t.specular.x, t.attenuation * t.spot * t.highlight * 0.7, kArithmetic);
}

}  // namespace
}  // namespace twinlight::lighting::equation_test

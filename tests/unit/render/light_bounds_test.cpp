// The planner: the bound of a light's brightness, which decides whether it is left out.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../planned_draws.h"
#include "render/effect/bounds.h"

namespace twinlight::light_bounds_test {
namespace {

LightBound bound(const Draw& draw, std::size_t light, const PlanOptions& options = {}) {
    return plan_effects(draw, options).light_bounds.at(light);
}

TEST(Plan, BoundsALightByItsNearestPoint) {
    Draw draw = with_positional_light();  // 5 above the triangle, whose sphere has radius 0.707 about (0.5, 0.5, 0)
    draw.lighting.lights[0].constant_attenuation = 0;
    draw.lighting.lights[0].quadratic_attenuation = 1;
    const double nearest = std::sqrt(25.5) - std::sqrt(0.5);
    const double by_hand = 0.8 / (nearest * nearest);
    EXPECT_GE(bound(draw, 0).largest(), by_hand);
    EXPECT_LE(bound(draw, 0).largest(), by_hand * (1 + 1e-6));
    draw.lighting.lights[0].position_eye = {0.5, 0.5, 0.1, 1};  // inside the sphere: 1 / d^2 has no bound
    EXPECT_EQ(bound(draw, 0).largest(), std::numeric_limits<double>::infinity());
}

TEST(Plan, LeavesOutALightWhoseConeMisses) {
    Draw draw = with_positional_light();
    LightSource& light = draw.lighting.lights[0];
    light.position_eye = {0.5, 0.5, 5, 1};
    light.spot_cutoff_deg = 20;
    light.spot_direction_eye = {1, 0, -1};
    // 45 degrees minus the cone's 20 and the sphere's asin(0.7071 / 5) = 8.13.
    EXPECT_EQ(reason(draw, "GL_LIGHT0", {{.shading = {}}, 0}),
              "its cone misses the draw's bounding sphere by 16.9 degrees");
    light.spot_cutoff_deg = 37;
    EXPECT_TRUE(bound(draw, 0).in());
}

TEST(Plan, LeavesOutALightBehindEveryNormal) {
    Draw draw = lit_triangle();
    draw.lighting.lights[0].position_eye = {1, 0, -1, 0};
    EXPECT_EQ(reason(draw, "GL_LIGHT0", {{.shading = {}}, 0}),
              "every normal faces away from it, by at least 45 degrees");
    draw.vertices.edit()[1].normal_object = {1, 0, 0};
    EXPECT_TRUE(bound(draw, 0).in());
    draw.vertices.edit()[1].normal_object = {0, 0, 1};
    draw.lighting.light_model.two_side = true;
    EXPECT_TRUE(bound(draw, 0).in());
}

TEST(Plan, LeavesOutFaintLightsWhileTheirSumIsWithinTheBudget) {
    Draw draw = lit_triangle();
    for (std::size_t i = 1; i < 4; ++i) {
        draw.lighting.lights[i] = draw.lighting.lights[0];
        draw.lighting.lights[i].diffuse = glm::dvec4(0.001 * static_cast<double>(i));
    }
    const Plan plan = plan_effects(draw, {{.shading = {}}, 0.003});  // bounds 0.8 * (0.001, 0.002, 0.003)
    EXPECT_EQ(plan.light_bounds[1].fate, LightFate::kFaint);
    EXPECT_EQ(plan.light_bounds[2].fate, LightFate::kFaint);
    EXPECT_EQ(plan.light_bounds[3].fate, LightFate::kIn);
    EXPECT_NEAR(plan.error_bound, 0.0024, 1e-8);
    EXPECT_GE(plan.error_bound, 0.0024);
    ASSERT_EQ(plan.lights.size(), 2U);
    EXPECT_EQ(plan.lights[0].number, 0);
    EXPECT_GT(plan.light_bounds[0].largest(), plan.light_bounds[3].largest());
    EXPECT_EQ(plan_effects(draw, {{.shading = {}}, 0}).lights.size(), 4U);
    EXPECT_EQ(plan_effects(draw, {{.shading = {}}, 0}).error_bound, 0);
}

TEST(Plan, HasNoBudgetWhereBlendingAddsUpWhatIsLeftOut) {
    Draw draw = lit_triangle();
    draw.lighting.lights[0].diffuse = glm::dvec4(0.001);
    draw.fragment.blend = true;
    draw.fragment.blend_src = kGL_SRC_ALPHA;
    draw.fragment.blend_dst = kGL_ONE_MINUS_SRC_ALPHA;
    EXPECT_FALSE(bound(draw, 0).in());
    draw.fragment.blend_dst = kGL_ONE;
    EXPECT_TRUE(bound(draw, 0).in());
}

TEST(Attenuation, IsBoundedForAnyFactors) {
    LightSource light;
    const auto largest = [&](double k0, double k1, double k2, double nearest, double farthest) {
        light.constant_attenuation = k0;
        light.linear_attenuation = k1;
        light.quadratic_attenuation = k2;
        return largest_attenuation(light, nearest, farthest);
    };
    EXPECT_NEAR(largest(1, 1, 1, 2, 9), 1.0 / 7, 1e-12);
    EXPECT_EQ(largest(0, 0, 0, 2, 9), 0);
    EXPECT_EQ(largest(0, 1, 0, 0, 9), std::numeric_limits<double>::infinity());
    EXPECT_EQ(largest(-1, 0, 0, 0, 9), 0);
    EXPECT_NEAR(largest(2, -1, 0.25, 1, 9), 1, 1e-6);    // (d/2 - 1)^2 + 1 is 1 at 2
    EXPECT_NEAR(largest(2, -1, 0.25, 4, 9), 0.5, 1e-6);  // and 2 at 4
    EXPECT_EQ(largest(1, -1, 0, 0, 2), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace twinlight::light_bounds_test

// Uniforms: the flat list, and programs that set only what differs from the last use.
#include "render/programmable/numbers/uniforms.h"

#include <gtest/gtest.h>

#include "../hand_built_draws.h"

namespace twinlight::programmable::uniforms_test {
namespace {

std::vector<float> values_of(const Uniforms& uniforms, std::string_view name) {
    const auto place = uniforms.find(name);
    if (!place) return {};
    return {uniforms[*place].values.begin(), uniforms[*place].values.end()};
}

TEST(Uniforms, KeepTheOrderInWhichTheyAreAdded) {
    Uniforms uniforms;
    uniforms.add("u_light0_", {"front", "_diffuse"});
    for (const float value : {1.0F, 2.0F, 3.0F}) uniforms.push_back(value);
    uniforms.set("u_fog_end", {4});
    ASSERT_EQ(uniforms.size(), 2u);
    EXPECT_EQ(uniforms[0].name, "u_light0_front_diffuse");
    EXPECT_EQ(values_of(uniforms, "u_light0_front_diffuse"), (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(values_of(uniforms, "u_fog_end"), std::vector<float>{4});
    EXPECT_FALSE(uniforms.contains("u_fog"));
}

TEST(Uniforms, AreReplacedByValuesOfAnyLength) {
    Uniforms uniforms = {{"u_a", {1, 2}}, {"u_b", {3}}};
    uniforms.set("u_a", {5, 6});
    uniforms.set("u_b", {7, 8, 9});
    EXPECT_EQ(values_of(uniforms, "u_a"), (std::vector<float>{5, 6}));
    EXPECT_EQ(values_of(uniforms, "u_b"), (std::vector<float>{7, 8, 9}));
    EXPECT_EQ(uniforms, (Uniforms{{"u_a", {5, 6}}, {"u_b", {7, 8, 9}}})) << "whatever was there before";
    EXPECT_NE(uniforms, (Uniforms{{"u_a", {5, 6}}, {"u_b", {7, 8, 1}}}));
    EXPECT_NE(uniforms, (Uniforms{{"u_a", {5, 6}}, {"u_c", {7, 8, 9}}}));
    EXPECT_TRUE(uniforms.has_same_names({{"u_a", {}}, {"u_b", {}}}));
    EXPECT_EQ(uniforms.filtered([](std::size_t i) { return i == 1; }), (Uniforms{{"u_b", {7, 8, 9}}}));
}

// A program remembers what it has set.
TEST(Uniforms, ThatReturnToAnEarlierValueAreDrawnWithIt) {
    const auto context = make_offscreen_context(1, 1, ColorBuffer::kFloat);
    Renderer renderer;
    for (const double red : {0.25, 0.75, 0.75, 0.25}) {
        Draw draw = square();
        draw.lighting.front.emission = {red, 0, 0, 1};
        draw.raster.viewport = {0, 0, 1, 1};
        const Frame frame{.width = 1, .height = 1, .items = {draw}};
        EXPECT_EQ(renderer.render(frame, {}).at(0, 0)[0], static_cast<float>(red));
    }
    EXPECT_EQ(renderer.counters().made, 1u);
}

TEST(Plan, WithoutReasonsHasTheSameEffectsAndNumbers) {
    LightingState lighting = dark();
    lighting.front.diffuse = {0.5, 0.5, 0.5, 1};
    PlanOptions quick;
    quick.reasons = false;
    const Plan plan = plan_effects(square(lighting), {}), without = plan_effects(square(lighting), quick);
    EXPECT_FALSE(plan.left_out.empty());
    EXPECT_TRUE(without.left_out.empty());
    EXPECT_EQ(without.effects, plan.effects);
    EXPECT_EQ(without.constant_ambient, plan.constant_ambient);
    EXPECT_EQ(without.error_bound, plan.error_bound);
}

}  // namespace
}  // namespace twinlight::programmable::uniforms_test

// Tiers: which programs are made, and that all tiers draw the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "../hand_built_draws.h"
#include "../quad_cuts.h"
#include "render/effect/plan.h"
#include "render/programmable/text/bake.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::programmable::programmable_tiers_test {
namespace {

constexpr Options with(Tier tier) {
    Options options;
    options.tier = tier;
    return options;
}

LightingState lit() {
    LightingState lighting = shiny(32);
    lighting.front.diffuse = {0.5, 0.25, 0.125, 1};
    lighting.lights[0].position_eye = {1, 2, 3, 1};
    return lighting;
}

Frame frame_of(Draw draw) {
    draw.raster.viewport = {0, 0, 4, 4};
    return {.width = 4, .height = 4, .items = {draw}};
}

class Tiers : public ::testing::Test {
  protected:
    void draw(const Draw& what, Tier tier, int times = 1) {
        for (int i = 0; i < times; ++i) renderer_.draw(frame_of(what), with(tier));
    }
    Counters counters() const { return renderer_.counters(); }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(4, 4);
    Renderer renderer_{{.programs = 4}};
};

TEST(Bake, PutsConstantsInThePlaceOfTheUniformsThatItIsGiven) {
    const ShaderSource source{"uniform vec3 u_a;  // kept\nuniform float u_b;\nvoid main() { uniform }\n",
                              "uniform float u_b;\n"};
    const ShaderSource baked = with_constants(source, {{"u_b", {1}}, {"u_c", {2}}});
    EXPECT_EQ(baked.vertex, "uniform vec3 u_a;  // kept\nconst float u_b = float(1.0);\nvoid main() { uniform }\n");
    EXPECT_EQ(baked.fragment, "const float u_b = float(1.0);\n");
    EXPECT_EQ(with_constants(source, {{"u_a", {0.1F, -1e-20F, 3e30F}}}).vertex.substr(0, 55),
              "const vec3 u_a = vec3(0.1, -1e-20, 3e+30);  // kept\nuni");
    EXPECT_EQ(uniform_names(source), (std::set<std::string, std::less<>>{"u_a", "u_b"}));
}

TEST(Bake, LeavesNoUniformOfAnyStageThatIsNotATextures) {
    for (const std::optional<Shading> shading : {std::optional<Shading>(), std::optional(Shading::kPhong)}) {
        Options options;
        options.shading = shading;
        Draw draw = square(lit());
        draw.fog.enabled = true;
        draw.raster.clip_planes_eye[1] = glm::dvec4(0, 1, 0, 2);
        const Plan plan = plan_effects(draw, options);
        const Code code = code_for(draw, plan);
        const ShaderSource source = assemble(code.effects, code.form);
        EXPECT_FALSE(uniform_names(source).empty());
        EXPECT_TRUE(uniform_names(with_constants(source, uniforms(draw, plan, code))).empty());
    }
}

TEST_F(Tiers, OneProgramWithUniformsServesAllThatDifferInNumbers) {
    draw(square(lit()), Tier::kUniform);
    LightingState other = lit();
    other.front.shininess = 7;
    draw(square(other), Tier::kUniform);
    EXPECT_EQ(counters().made, 1u);
    EXPECT_EQ(counters().hits, 1u);
    EXPECT_EQ(counters().baked, 0u);
}

TEST_F(Tiers, ABakedProgramServesTheSameNumbersAlone) {
    draw(square(lit()), Tier::kBaked, 2);
    EXPECT_EQ(counters().baked, 1u);
    EXPECT_EQ(counters().hits, 1u);
    LightingState other = lit();
    other.front.shininess = 7;
    draw(square(other), Tier::kBaked);
    EXPECT_EQ(counters().baked, 2u);
    EXPECT_EQ(counters().made, 0u);
}

TEST_F(Tiers, BakesWhatHasStoodStillForSomeFramesAndNoSooner) {
    draw(square(lit()), Tier::kAuto, 4);
    EXPECT_EQ(counters().baked, 0u);
    draw(square(lit()), Tier::kAuto, 20);
    EXPECT_EQ(counters().baked, 1u);
    EXPECT_EQ(counters().made, 1u);
}

TEST_F(Tiers, BakesWhatStandsStillBesideWhatMoves) {
    LightingState lighting = lit();
    for (int i = 0; i < 30; ++i) {
        lighting.lights[0].position_eye.x = 1 + 0.01 * i;  // little, so that the effects do not change
        draw(square(lighting), Tier::kAuto);
    }
    EXPECT_EQ(counters().made, 1u);
    EXPECT_EQ(counters().baked, 1u);
}

TEST_F(Tiers, BakesOneProgramAFrame) {
    Frame frame = frame_of(square(lit()));
    LightingState other = lit();
    other.front.shininess = 7;
    frame.items.emplace_back(square(other));
    for (int i = 0; i < 5; ++i) renderer_.draw(frame, with(Tier::kAuto));
    EXPECT_EQ(counters().baked, 1u);
    renderer_.draw(frame, with(Tier::kAuto));
    EXPECT_EQ(counters().baked, 2u);
}

TEST_F(Tiers, BakesOnlyWhenThatIsAllowed) {
    renderer_.allow_baking(false);
    draw(square(lit()), Tier::kAuto, 20);
    EXPECT_EQ(counters().baked, 0u);
    EXPECT_TRUE(renderer_.wants_to_bake());
    renderer_.allow_baking(true);
    draw(square(lit()), Tier::kAuto);
    EXPECT_EQ(counters().baked, 1u);
    EXPECT_FALSE(renderer_.wants_to_bake());
}

// Many Draws whose programs would differ only in numbers, or in which light reaches them.
Frame frame_of_many(int count) {
    Frame frame = frame_of(square(lit()));
    frame.items.clear();
    for (int i = 0; i < count; ++i) {
        LightingState lighting = lit();
        lighting.front.diffuse.r = i / 100.0;
        if (i % 2 == 1) lighting.lights[0].position_eye.z = -3;  // behind
        Draw draw = square(lighting);
        draw.raster.viewport = {0, 0, 4, 4};
        frame.items.emplace_back(draw);
    }
    return frame;
}

TEST_F(Tiers, ManyDrawsOfAKindShareAProgramWhoseConstantsAreTheirCommonNumbers) {
    const Frame frame = frame_of_many(60);
    const Image once = renderer_.render(frame, with(Tier::kUniform));
    Renderer renderer{{.programs = 4}};
    for (int i = 0; i < 30; ++i) renderer.draw(frame, with(Tier::kAuto));
    EXPECT_EQ(renderer.counters().made, 1u);
    EXPECT_EQ(renderer.counters().baked, 1u);
    EXPECT_EQ(renderer.counters().evicted, 0u);
    const Image again = read_pixels(4, 4);
    for (std::size_t i = 0; i < once.pixels.size(); ++i)
        for (std::size_t channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(again.pixels[i][channel], once.pixels[i][channel], 1.001 / 255);
}

TEST_F(Tiers, FewDrawsAreEachPlannedByThemselves) {
    const Frame frame = frame_of_many(4);
    renderer_.draw(UploadedFrame(frame, with(Tier::kUniform)));
    EXPECT_EQ(counters().made, 2u);  // with the light, and without it
}

TEST_F(Tiers, AFrameOfManyDrawsIsExplainedDrawByDraw) {
    std::size_t draws = 0;
    for (const ExplainedDraw& explained : explain_draws(frame_of_many(60), PlanOptions{})) {
        draws += explained.numbers.size();
        for (const int number : explained.numbers)  // from 1: every second one has its light behind it
            EXPECT_EQ(explained.plan.effects.lights.size(), static_cast<std::size_t>(number % 2)) << number;
    }
    EXPECT_EQ(draws, 60u);
}

TEST_F(Tiers, DropTheProgramThatWasNotUsedForTheLongestTime) {
    LightingState lighting = lit();
    for (int shininess = 1; shininess <= 6; ++shininess) {
        lighting.front.shininess = shininess;
        draw(square(lighting), Tier::kBaked);
    }
    EXPECT_EQ(counters().evicted, 2u);
    draw(square(lighting), Tier::kBaked);
    EXPECT_EQ(counters().baked, 6u);
    lighting.front.shininess = 1;
    draw(square(lighting), Tier::kBaked);
    EXPECT_EQ(counters().baked, 7u);
}

TEST_F(Tiers, ANumberThatMovesAfterAllIsDrawnAsItIs) {
    draw(square(lit()), Tier::kAuto, 10);
    LightingState other = lit();
    other.front.emission = {0, 0, 1, 1};
    other.lights[0].position_eye.z = -3;  // behind: only the emission is left
    draw(square(other), Tier::kAuto);
    const Rgba c = read_pixels(4, 4).at(1, 1);
    EXPECT_EQ((glm::vec3{c[0], c[1], c[2]}), glm::vec3(0, 0, 1));
}

TEST_F(Tiers, AnUploadedFrameIsDrawnAgainAndAgain) {
    const UploadedFrame frame(frame_of(square(lit())), with(Tier::kAuto));
    for (int i = 0; i < 10; ++i) renderer_.draw(frame);
    EXPECT_EQ(counters().baked, 1u);
    const Image again = read_pixels(4, 4);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    const Image once = renderer_.render(frame_of(square(lit())), with(Tier::kUniform));
    for (std::size_t i = 0; i < once.pixels.size(); ++i)
        for (std::size_t channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(again.pixels[i][channel], once.pixels[i][channel], 1.001 / 255);
}

// ---- The same pictures ----

// The number of pixels that differ by more than 1/255, the distance that two roundings of one value may have, and by more than
// `allowed`.
int differing(const Image& a, const Image& b, const Image& allowed) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < 4; ++c)
            differs = differs || std::abs(a.pixels[i][c] - b.pixels[i][c]) >= 1.5F / 255 + allowed.pixels[i][c];
        count += differs;
    }
    return count;
}

TEST(TiersPictures, OfTheBuiltInScenesAreTheSameToACode) {
    constexpr int kWidth = 320, kHeight = 240;
    const auto context = make_offscreen_context(kWidth, kHeight);
    Renderer renderer;
    for (const EmbeddedFile& file : kSceneFiles) {
        const auto scene = std::make_shared<const CommandList>(read_built_in(file));
        const Frame frame = make_frame(*scene, {.width = kWidth, .height = kHeight});
        for (const std::optional<Shading> shading : {std::optional<Shading>(), std::optional(Shading::kPhong)}) {
            Options options = with(Tier::kUniform);
            options.shading = shading;
            const Image uniform = renderer.render(frame, options);
            options.tier = Tier::kBaked;
            const Image baked = renderer.render(frame, options);
            EXPECT_EQ(differing(baked, uniform, between_cuts(frame, shading)), 0) << file.name;
        }
    }
}

// ---- Many lights ----

// Each light adds 1/1024, so that floats add up exactly.
LightingState many(std::size_t count) {
    LightingState lighting = dark();
    lighting.front.diffuse = {1, 0.5, 0.25, 1};
    lighting.lights.resize(std::max<std::size_t>(count, kMaxLights));
    for (std::size_t i = 0; i < count; ++i) {
        LightSource& light = lighting.lights[i];
        light.enabled = true;
        light.diffuse = {1.0 / 1024, 1.0 / 1024, 1.0 / 1024, 1};
        light.position_eye = {0, 0, 1.0 + static_cast<double>(i), i % 2 == 0 ? 0 : 1};
    }
    return lighting;
}

TEST(ManyLights, AllReachTheVertexInUniformsAndBaked) {
    Options options;
    options.budget = 0;  // each light is faint
    for (const Tier tier : {Tier::kUniform, Tier::kBaked})
        for (const std::optional<Shading> shading : {std::optional<Shading>(), std::optional(Shading::kPhong)})
            for (const int count : {1, 8, 31, 32, 33, 34, 200, 512}) {
                options.tier = tier;
                options.shading = shading;
                const double sum = count / 1024.0;
                expect_color(color(point({0, 0, 0}, many(static_cast<std::size_t>(count))), options),
                             {sum, sum / 2, sum / 4, 1});
            }
}

TEST(ManyLights, OfEachKindShareOneTextWhoseLengthDoesNotGrow) {
    const auto text = [](std::size_t count) {
        const Draw draw = point({0, 0, 0}, many(count));
        Options options;
        options.budget = 0;
        const Plan plan = plan_effects(draw, options);
        const Code code = code_for(draw, plan);
        return assemble(code.effects, code.form).vertex;
    };
    EXPECT_EQ(text(200), text(250));
    EXPECT_LT(text(512).size(), text(16).size());
}

TEST(ManyLights, OfTwoSidesAreChosenByTheFaceThatShows) {
    LightingState lighting = many(100);
    lighting.light_model.two_side = true;
    lighting.back.diffuse = {0, 0, 1, 1};
    Draw draw = square(lighting);
    Options options = kPhong;
    options.budget = 0;
    expect_color(color(draw, options), {100 / 1024.0, 50 / 1024.0, 25 / 1024.0, 1});
    draw.raster.front_face = kGL_CW;
    for (LightSource& light : draw.lighting.lights) light.position_eye.z = -light.position_eye.z;
    expect_color(color(draw, options), {0, 0, 100 / 1024.0, 1});
}

}  // namespace
}  // namespace twinlight::programmable::programmable_tiers_test

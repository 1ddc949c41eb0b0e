// More lights than GL has, drawn by the fixed function.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "render/context/context.h"
#include "render/effect/plan.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/path.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::lights_beyond_test {
namespace {

constexpr int kSide = 64;

// Ten lights from the viewer's side. One of GL's lights and one extra light have that brightness, the others 0.1.
Scene ten_lights(double brightness_of_two) {
    std::string text =
        "glMatrixMode(GL_PROJECTION); gluPerspective(40, 1, 1, 10); glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, "
        "-5);\n"
        "glEnable(GL_LIGHTING); glEnable(GL_DEPTH_TEST);\n";
    for (int i = 0; i < 10; ++i) {
        const bool is_gls = i < 8;
        const std::string begin =
            is_gls ? fmt::format("glLightfv(GL_LIGHT{}, ", i) : fmt::format("#pragma twinlight light({}, ", i);
        const double brightness = i == 3 || i == 9 ? brightness_of_two : 0.1;
        const auto values = [&](const char* name, const std::string& list) {
            text += is_gls ? fmt::format("{}{}, (GLfloat[]){{{}}});\n", begin, name, list)
                           : fmt::format("{}{}, {})\n", begin, name, list);
        };
        values("GL_DIFFUSE", fmt::format("{0}, {0}, {0}, 1", brightness));
        values("GL_SPECULAR", "0, 0, 0, 1");
        values("GL_POSITION", fmt::format("{}, {}, 1, 0", 0.1 * i - 0.5, 0.5 - 0.07 * i));
        if (is_gls) text += fmt::format("glEnable(GL_LIGHT{});\n", i);
    }
    text += "glutSolidSphere(1, 24, 16);\n";
    return make_scene(std::make_shared<const CommandList>(read_scene(text, "ten.gl", "ten")),
                      {.width = kSide, .height = kSide});
}

// The fixed function executes commands, and GL has no command for the extra lights.
TEST(LightsBeyondEight, AreNotDrawnByTheFixedFunctionAndSaid) {
    const Scene scene = ten_lights(0.05);
    ASSERT_EQ(scene.frame.unsupported.size(), 1u);
    const Unsupported& what = scene.frame.unsupported.front();
    EXPECT_EQ(what.name, "a light beyond GL_LIGHT7");
    EXPECT_EQ(what.first.line, 2 + 8 * 4 + 2 * 3 + 1);  // the sphere's, after the lights'
    EXPECT_TRUE(lacks(Path::kFixed, what));
    EXPECT_FALSE(lacks(Path::kProgrammable, what) || lacks(Path::kReference, what));

    Frame eight = scene.frame;
    for (auto& item : eight.items)
        if (Draw* draw = std::get_if<Draw>(&item)) draw->lighting.lights.resize(kMaxLights);
    const auto context = make_offscreen_context(kSide, kSide);
    const ImageDifference d =
        difference(fixed::render(scene), reference::render(eight, {}), reference::allowed_difference(eight, {}));
    EXPECT_LE(d.interior.max, 1 / 255.0);
    EXPECT_GT(d.interior.pixels, 1000u);
}

TEST(LightsBeyondEight, AreNotMissedWhereTheyAreOff) {
    const auto commands = std::make_shared<const CommandList>(
        read_scene("glEnable(GL_LIGHTING);\n#pragma twinlight light(8, GL_DIFFUSE, 1, 1, 1, 1)\n"
                   "glDisable(GL_LIGHTING);\nglutSolidSphere(1, 8, 8);\n",
                   "off.gl", "off"));
    EXPECT_TRUE(make_scene(commands, {}).frame.unsupported.empty());
}

// The fixed function as the study and --scrubbed use it.
TEST(LightsBeyondEight, LeaveTheEightOfTheLargestBoundsToScrubbedState) {
    Scene scene = ten_lights(0.0005);  // together 0.001 of a channel: less than 0.5/255
    const auto context = make_offscreen_context(kSide, kSide);
    const Image fixed = fixed::render_scrubbed(scene, {}, PlanOptions{}.budget);
    const ImageDifference d =
        difference(fixed, reference::render(scene.frame, {}), reference::allowed_difference(scene.frame, {}));
    EXPECT_LE(d.interior.max, 1 / 255.0);
    EXPECT_GT(d.interior.pixels, 1000u);
    // With only GL's eight lights, one of them faint, a tenth would be missing.
    EXPECT_GT(fixed.at(kSide / 2, kSide / 2)[0], 0.55);
}

TEST(LightsBeyondEight, AreBoundedByScrubbedState) {
    const Frame frame = ten_lights(0.05).frame;
    const auto draw = std::ranges::find_if(frame.items, [](const auto& i) { return std::holds_alternative<Draw>(i); });
    const ScrubbedState state = scrubbed_state(plan_effects(std::get<Draw>(*draw), {}), kMaxLights);
    EXPECT_EQ(state.lighting.lights.size(), 8u);
    std::vector<int> beyond = state.lights_beyond;
    std::ranges::sort(beyond);
    EXPECT_EQ(beyond, (std::vector{3, 9}));
    // The two faintest are left out: each adds at most 0.05 * 0.8.
    EXPECT_GT(state.bound_beyond, 0.07);
    EXPECT_LT(state.bound_beyond, 0.0801);
}

}  // namespace
}  // namespace twinlight::lights_beyond_test

// Fog on primitives that reach behind the eye, where |z| is not linear between the vertices (GL 2.1 section 3.10).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../compare_three_ways.h"
#include "judge/check/case.h"
#include "judge/compare/departures.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::fog_behind_the_eye_test {
namespace {

constexpr std::string_view kKnown = "exponential fog on primitives that reach behind the eye";

// How far the red channel may differ at the pixel 31,32 of a hard case.
float allowed_in(const std::string& text) {
    const Frame frame = check::read_case(text, "case.gl", "case").carried_out(check::kSide).scene.frame;
    const AllowedDifference allowed = reference::allowed_difference(frame);
    const std::size_t at = allowed.index(31, 32);
    EXPECT_FALSE(allowed.edge[at]);
    return allowed.channels(at)[0];
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, text.npos) << what;
    return text.replace(at, what.size(), by);
}

TEST(FogBehindTheEye, HasTwoAnswersWhereItIsLinear) {
    const std::string linear = check::load_cases({"fog-linear-behind-the-eye"})[0].scene_text;
    EXPECT_FLOAT_EQ(allowed_in(linear), 0.25F);  // from 0.5 to 0.75: the file derives both
    EXPECT_EQ(allowed_in(replaced(linear, "GL_LINEAR", "GL_EXP")), 0);
    EXPECT_EQ(allowed_in(replaced(linear, "-1, 0.5", "-1, -0.5")), 0);
    // The colour of the fog stays the same, however much fog there is.
    EXPECT_EQ(allowed_in(replaced(linear, "0, 0, 0, 1", "1, 1, 1, 1")), 0);
}

// A large ground and a low eye above its middle.
compare::Comparison compared(std::string_view mode) {
    const std::string text = fmt::format(
        "glMatrixMode(GL_PROJECTION); gluPerspective(50, 4.0 / 3.0, 0.1, 60); glMatrixMode(GL_MODELVIEW);\n"
        "gluLookAt(0, 1, 3,  0, 0, -10,  0, 1, 0); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
        "glEnable(GL_FOG); glFogi(GL_FOG_MODE, {}); glFogf(GL_FOG_END, 30); glFogf(GL_FOG_DENSITY, 0.07);\n"
        "glFogfv(GL_FOG_COLOR, (GLfloat[]){{0.7, 0.8, 0.9, 1}}); glColor3f(0.2, 0.4, 0.1);\n"
        "glBegin(GL_QUADS); glVertex3f(-20, 0, 20); glVertex3f(20, 0, 20); glVertex3f(20, 0, -20);\n"
        "glVertex3f(-20, 0, -20); glEnd();",
        mode);
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    StateOptions options;
    options.width = 160, options.height = 120;
    return compare_three_ways(make_scene(scene, options));
}

TEST(FogBehindTheEye, OfOneColourIsRightInBothFormsWhereItIsLinear) {
    const compare::Comparison comparison = compared("GL_LINEAR");
    EXPECT_TRUE(comparison.within_tolerance());
    EXPECT_TRUE(comparison.known_departures.empty());
}

TEST(FogBehindTheEye, IsAKnownBugWhereItIsExponential) {
    for (const char* mode : {"GL_EXP", "GL_EXP2"}) {
        const compare::Comparison comparison = compared(mode);
        const auto differs = [&](std::string_view name) {
            return std::ranges::any_of(comparison.pairs, [&](const compare::Pair& pair) {
                return comparison.renders[pair.a].name + " ~ " + comparison.renders[pair.b].name == name &&
                       pair.verdict == compare::Verdict::kBeyond;
            });
        };
        EXPECT_FALSE(differs("shaders ~ reference"));
        if (!compare::is_measured(current_driver())) continue;
        EXPECT_TRUE(differs("fixed ~ reference"));
        ASSERT_EQ(comparison.known_departures.size(), 1U);
        EXPECT_TRUE(comparison.known_departures[0].starts_with(kKnown));
    }
}

}  // namespace
}  // namespace twinlight::fog_behind_the_eye_test

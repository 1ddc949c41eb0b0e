// A known bug is called the cause only if the fixed function is right without it, and bugs without a part are not named.
#include "judge/compare/causes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string>

#include "../compare_three_ways.h"
#include "judge/check/case.h"
#include "judge/compare/rewrites.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::compare::causes_test {
namespace {

constexpr StateOptions kSmall{.width = 64, .height = 64};

Comparison compared(const std::string& text) {
    const auto scene = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return compare_three_ways(make_scene(scene, kSmall));
}

const Departure& departure_named(std::string_view name) {
    return *std::ranges::find(departures(), name, &Departure::name);
}

// As a comparison names it.
std::string named(std::string_view name) { return fmt::format("{} ({})", name, departure_named(name).section); }
using Names = std::vector<std::string>;

constexpr const char* kEarlyTracking = "glMaterial before glEnable(GL_COLOR_MATERIAL)";
constexpr const char* kColorBeforePop = "glColor right before glPopAttrib";
constexpr const char* kRectangle = "glRect as a quadrilateral";

struct Row {
    const char* cause;
    std::string text;  // "": the hard case of this name
    const char* hard_case = "";
};

const std::string kLit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n";
const std::string kTriangle =
    "glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1); glEnd();\n";

const Row kRows[] = {
    // Colour material that is enabled after glMaterial, and glColorMaterial later still; glRect has no part.
    {kEarlyTracking,
     kLit + "glColor4f(1, 1, 1, 1); glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0.05, 0.05, 0.1, 1});\n"
            "glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.5, 0.5, 0.5, 1}); glEnable(GL_COLOR_MATERIAL);"
            "glColorMaterial(GL_FRONT, GL_DIFFUSE); glColor3f(0.2, 0.4, 0.7); glutSolidSphere(1, 40, 30);"},
    {kEarlyTracking,
     "glEnable(GL_LIGHTING); glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n"
     "glEnable(GL_COLOR_MATERIAL); glColorMaterial(GL_FRONT, GL_DIFFUSE); glColor3f(0, 0, 1);\n"
     "glRectf(-0.5, -0.5, 0.5, 0.5);"},
    {kEarlyTracking, kLit +
                         "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});\n"
                         "glEnable(GL_COLOR_MATERIAL); glDisable(GL_COLOR_MATERIAL);\n" +
                         kTriangle},
    {kColorBeforePop,
     "glPushAttrib(GL_CURRENT_BIT); glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1});\n"
     "glColor3f(0, 0.8, 0.5); glPopAttrib();\n" +
         kTriangle},
    {kRectangle, "", "flat-rect-first"},
    {"flat shading of glEvalMesh2", "", "flat-evaluated-mesh"},
    {"glShadeModel after glPopAttrib in a display list", "", "flat-model-in-a-list"},
    {"shininess 0 with attenuation or a spot", "", "highlight-shininess-0-attenuated"},
    {"a direction whose square does not fit a float", "", "normal-1e30-normalized"},
    {"a direction whose square does not fit a float", "", "light-directional-1e-30"},
    {"a vertex whose w is not 1 under a positional light", "", "vertex-w-2"},
    {"GL_RESCALE_NORMAL under a large scale", "", "rescale-1e7"},
    {"glMaterial, a tracked glColor, glNewList", "", "color-material-before-a-list"},
    {"glColor before a new glColorMaterial", "", "state-color-material-mode"},
    {"colour material after glPopAttrib", "", "state-color-material-after-pop"},
    {"lights after glPopAttrib of GL_ENABLE_BIT", "", "state-lights-after-pop"},
    {"glMaterial right before glPopAttrib", "", "state-material-before-pop"},
    {"vertex materials that differ between two sides", "", "face-material-back-in-begin"},
    {"glColor3 after glColor4",
     "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ZERO);\n"
     "glBegin(GL_POINTS); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0); glEnd();\n"
     "glBegin(GL_POINTS); glColor3f(1, 1, 1); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0); glColor3f(0.5, 0.5, 0.5);"
     "glEnd();\n" +
         kTriangle},
};

Driver driver_of_tests() {
    const auto context = make_offscreen_context(8, 8);
    return current_driver();
}

TEST(Causes, AreProvedWhereARewriteTakesTheBugOut) {
    const Driver driver = driver_of_tests();
    for (const Row& row : kRows) {
        SCOPED_TRACE(row.text.empty() ? row.hard_case : row.text);
        const std::string text = row.text.empty() ? check::load_cases({row.hard_case})[0].scene_text : row.text;
        const Comparison comparison = compared(text);
        if (!departure_named(row.cause).is_known_on(driver)) {
            EXPECT_EQ(comparison.proved_causes, Names{});
            continue;
        }
        EXPECT_EQ(comparison.verdict(), Verdict::kBeyond);
        EXPECT_EQ(comparison.proved_causes, Names{named(row.cause)});
        EXPECT_EQ(comparison.known_departures, Names{});
    }
}

// Every order of four of these commands.
TEST(Causes, AreTheSameInEveryOrderOfColorMaterial) {
    const std::string kCommands[] = {"glMaterialfv(GL_FRONT, GL_AMBIENT, (GLfloat[]){0.9, 0, 0, 1});\n",
                                     "glColor3f(0, 0, 1);\n", "glEnable(GL_COLOR_MATERIAL);\n",
                                     "glDisable(GL_COLOR_MATERIAL);\n", "glColorMaterial(GL_FRONT, GL_DIFFUSE);\n"};
    std::array<std::size_t, 5> order{0, 1, 2, 3, 4};
    int differing = 0;
    do {
        std::string text = kLit + "glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.5, 0.5, 0.5, 1});\n";
        for (std::size_t i = 0; i < 4; ++i) text += kCommands[order[i]];
        const Comparison comparison = compared(text + kTriangle);
        if (comparison.verdict() != Verdict::kBeyond) continue;
        ++differing;
        EXPECT_EQ(comparison.proved_causes, Names{named(kEarlyTracking)}) << text;
    } while (std::ranges::next_permutation(order).found);
    EXPECT_EQ(differing > 0, departure_named(kEarlyTracking).is_known_on(driver_of_tests()));
}

// Two bugs in one scene: neither alone is the cause.
TEST(Causes, MayBeSeveral) {
    if (!departure_named(kEarlyTracking).is_known_on(driver_of_tests()))
        GTEST_SKIP() << "this driver has only one of them";
    const Comparison comparison =
        compared(kLit +
                 "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1}); glEnable(GL_COLOR_MATERIAL);\n"
                 "glDisable(GL_COLOR_MATERIAL); glShadeModel(GL_FLAT);\n"
                 "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){-0.5, -0.5, 0.5, 1}); glRectf(-0.5, -0.5, 0.5, 0.5);");
    EXPECT_EQ(comparison.proved_causes, (Names{named(kEarlyTracking), named(kRectangle)}));
}

// glRect is not the cause: normals under a singular matrix are undefined (2.11.3).
TEST(Causes, AreNotBugsThatChangeNothing) {
    const Comparison comparison = compared(kLit + "glScalef(1, 1, 0); glRectf(-0.5, -0.5, 0.5, 0.5);");
    EXPECT_EQ(comparison.proved_causes, Names{});
    EXPECT_EQ(comparison.known_departures, Names{});
}

// By more than one code.
int different_pixels(const Image& a, const Image& b) {
    const auto differ = [](const Rgba& p, const Rgba& q) {
        for (int channel = 0; channel < 4; ++channel)
            if (std::abs(channel_code(p[channel]) - channel_code(q[channel])) > 1) return true;
        return false;
    };
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += differ(a.pixels[i], b.pixels[i]) ? 1 : 0;
    return count;
}

// OpenGL draws a rewritten scene as before.
TEST(Rewrites, ChangeNothingInTheReference) {
    std::set<const Rewrite*> rewrites;
    int changed = 0;
    for (const Departure& departure : departures())
        if (departure.rewrite) rewrites.insert(departure.rewrite);
    for (const EmbeddedFile& file : kSceneFiles) {
        const auto whole = std::make_shared<const CommandList>(read_built_in(file));
        const Image expected = reference::render(make_scene(whole, kSmall).frame, {});
        for (const Rewrite* rewrite : rewrites) {
            CommandList less = *whole;
            less.commands.clear();
            rewritten(whole, *rewrite, kSmall)->for_each([&](const Step& step) {
                less.commands.push_back(step.command);
                return true;
            });
            if (less.commands == whole->commands) continue;
            ++changed;
            const Image image = reference::render(make_frame(less, kSmall), {});
            EXPECT_EQ(different_pixels(image, expected), 0) << whole->name;
        }
    }
    EXPECT_GE(changed, 100);
}

}  // namespace
}  // namespace twinlight::compare::causes_test

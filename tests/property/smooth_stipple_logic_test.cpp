// Smooth lines and points (3.3, 3.4.2, 3.11), the stipples of lines (3.4.2) and polygons (3.5.2), logical operations
// (4.1.10): the reference by hand calculation, and the driver with the same colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../unit/compare_three_ways.h"
#include "judge/compare/comparison.h"
#include "render/context/context.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::smooth_stipple_logic_test {
namespace {

constexpr int kSize = 32;

Scene scene_of(const std::string& text) {
    const auto list = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
    return make_scene(list, {.width = kSize, .height = kSize});
}

// Object space in pixels; white, whose alpha is added to black.
constexpr const char* kWindow =
    "glMatrixMode(GL_PROJECTION); glOrtho(0, 32, 0, 32, -1, 1); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, "
    "GL_ONE);\n";

Image reference_of(const std::string& text) { return reference::render(scene_of(kWindow + text).frame, {}); }
float red(const Image& image, int x, int y) { return image.at(x, kSize - 1 - y)[0]; }

constexpr float kCode = 0.51F / 255;  // the buffer has 8 bits

TEST(SmoothLines, HaveTheAlphaOfTheShareThatTheyCover) {
    const auto line = [](double y, double width) {
        return reference_of(
            fmt::format("glEnable(GL_LINE_SMOOTH); glLineWidth({}); glBegin(GL_LINES); "
                        "glVertex2f(4.5, {}); glVertex2f(20, {}); glEnd();",
                        width, y, y));
    };
    const Image thin = line(8.5, 1);
    EXPECT_NEAR(red(thin, 10, 8), 1, kCode);
    EXPECT_NEAR(red(thin, 4, 8), 0.5, kCode) << "it begins in the middle of the pixel";
    EXPECT_EQ(red(thin, 3, 8), 0);
    EXPECT_EQ(red(thin, 10, 7), 0);
    EXPECT_NEAR(red(line(8, 1), 10, 8), 0.5, kCode);
    EXPECT_NEAR(red(line(8, 1), 10, 7), 0.5, kCode);
    EXPECT_NEAR(red(line(8.25, 1), 10, 8), 0.75, kCode);
    EXPECT_NEAR(red(line(8.5, 2.5), 10, 9), 0.75, kCode);
    EXPECT_NEAR(red(line(8.5, 0.2), 10, 8), 1, kCode) << "at least one pixel wide";
}

// 3.2: the sum of coverage is the area, wherever the line lies. Each of some 40 pixels is rounded.
TEST(SmoothLines, CoverTheirArea) {
    for (const double angle : {0.1, 0.7, 1.3, 2.9, 4.4}) {
        const Image image =
            reference_of(fmt::format("glEnable(GL_LINE_SMOOTH); glLineWidth(3); glBegin(GL_LINES); glVertex2f({}, {}); "
                                     "glVertex2f({}, {}); glEnd();",
                                     16.3 - 9 * std::cos(angle), 15.8 - 9 * std::sin(angle), 16.3 + 9 * std::cos(angle),
                                     15.8 + 9 * std::sin(angle)));
        double sum = 0;
        for (const Rgba& pixel : image.pixels) sum += static_cast<double>(pixel[0]);
        EXPECT_NEAR(sum, 3 * 18, 90 * 0.5 / 255) << angle;
    }
}

TEST(SmoothPoints, AreDiscs) {
    const Image image =
        reference_of("glEnable(GL_POINT_SMOOTH); glPointSize(9); glBegin(GL_POINTS); glVertex2f(16.2, 15.6); glEnd();");
    double sum = 0;
    for (const Rgba& pixel : image.pixels) sum += static_cast<double>(pixel[0]);
    EXPECT_NEAR(sum, std::numbers::pi * 4.5 * 4.5, 60 * 0.5 / 255);
    EXPECT_NEAR(red(image, 16, 15), 1, kCode);
    EXPECT_EQ(red(image, 12, 11), 0) << "a corner of the square";
}

// Which pixels of a row are drawn, from pixel 4 on.
std::string dashes(const std::string& text) {
    const Image image = reference_of("glEnable(GL_LINE_STIPPLE); " + text);
    std::string row;
    for (int x = 4; x < 24; ++x) row += red(image, x, 8) > 0 ? '#' : '.';
    return row;
}

TEST(LineStipple, CountsFragments) {
    const std::string line = "glBegin(GL_LINES); glVertex2f(4.5, 8.5); glVertex2f(24.5, 8.5); glEnd();";
    EXPECT_EQ(dashes(line), "####################") << "the initial pattern";
    EXPECT_EQ(dashes("glLineStipple(1, 0x3F0D);" + line), "#.##....######..#.##");
    EXPECT_EQ(dashes("glLineStipple(3, 5);" + line), "###...###...........");
    EXPECT_EQ(dashes("glLineStipple(0, 0x3F0D);" + line), "#.##....######..#.##") << "the factor is at least 1";
    EXPECT_EQ(
        dashes("glLineStipple(1, 0x3F0D); glBegin(GL_LINES); glVertex2f(23.5, 8.5); glVertex2f(3.5, 8.5); glEnd();"),
        "##.#..######....##.#")
        << "from the first vertex";
    EXPECT_EQ(dashes("glLineStipple(1, 7); glLineWidth(3);" + line), "###.............###.");
}

TEST(LineStipple, GoesOnInStripsAndBeginsWithEachLine) {
    const auto lines = [](const char* mode) {
        return dashes(
            fmt::format("glLineStipple(1, 0x0F0F); glBegin({}); glVertex2f(4.5, 8.5); glVertex2f(10.5, 8.5);"
                        "{} glVertex2f(24.5, 8.5); glEnd();",
                        mode, std::string_view(mode) == "GL_LINES" ? "glVertex2f(10.5, 8.5);" : ""));
    };
    EXPECT_EQ(lines("GL_LINE_STRIP"), "####....####....####");
    EXPECT_EQ(lines("GL_LINES"), "####..####....####..");
}

TEST(LineStipple, BeginsWithEachGlBeginAndFollowsTheLongerAxis) {
    EXPECT_EQ(
        dashes("glLineStipple(1, 0x0F0F); glBegin(GL_LINE_STRIP); glVertex2f(4.5, 8.5); glVertex2f(10.5, 8.5); glEnd();"
               "glBegin(GL_LINE_STRIP); glVertex2f(10.5, 8.5); glVertex2f(24.5, 8.5); glEnd();"),
        "####..####....####..");
    // From the right to the left and up: 16 rows, but only 8 columns. Then down.
    const Image image = reference_of(
        "glEnable(GL_LINE_STIPPLE); glLineStipple(4, 0x5555); glBegin(GL_LINE_STRIP);"
        "glVertex2f(20.5, 4.25); glVertex2f(12.5, 20.25); glVertex2f(12.5, 4.25); glEnd();");
    std::string up, down;
    for (int y = 4; y < 20; ++y) {
        int drawn = 0;
        for (int x = 13; x < 22; ++x) drawn += red(image, x, y) > 0;
        up += drawn > 0 ? '#' : '.';
        down += red(image, 12, y) > 0 ? '#' : '.';
    }
    EXPECT_EQ(up, "####....####....");
    EXPECT_EQ(down, ".....####....###") << "the next line, downwards: rows 20 to 17 are drawn";
}

TEST(PolygonStipple, DrawsWhereItsBitIs1) {
    // 0x81 in byte 0, 0x40 in byte 5, 1 in byte 127.
    std::string bytes = "0x81, 0, 0, 0, 0, 0x40";
    for (int i = 6; i < 127; ++i) bytes += ", 0";
    bytes += ", 1";
    const auto stippled = [&](const std::string& before) {
        return reference_of(before + "glPolygonStipple((GLubyte[128]){" + bytes +
                            "}); glEnable(GL_POLYGON_STIPPLE); glRectf(0, 0, 32, 32);");
    };
    const Image image = stippled("");
    int drawn = 0;
    for (const Rgba& pixel : image.pixels) drawn += pixel[0] > 0;
    EXPECT_EQ(drawn, 4);
    EXPECT_EQ(red(image, 0, 0), 1);
    EXPECT_EQ(red(image, 7, 0), 1);
    EXPECT_EQ(red(image, 9, 1), 1);
    EXPECT_EQ(red(image, 31, 31), 1);
    EXPECT_EQ(red(stippled("glPixelStorei(GL_UNPACK_LSB_FIRST, 1);"), 14, 1), 1);
    const Image lines = reference_of(
        "glPolygonStipple((GLubyte[128]){0}); glEnable(GL_POLYGON_STIPPLE); glBegin(GL_LINES); glVertex2f(0, 8.5);"
        "glVertex2f(32, 8.5); glEnd(); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); glRectf(4.5, 14.5, 9.5, 20.5);");
    EXPECT_EQ(red(lines, 10, 8), 1);
    EXPECT_EQ(red(lines, 7, 14), 1) << "only filled polygons are stippled";
}

TEST(LogicOp, CombinesBits) {
    const std::pair<const char*, int> ops[] = {{"GL_CLEAR", 0},
                                               {"GL_AND", 0x0C & 0x0A},
                                               {"GL_AND_REVERSE", 0x0C & ~0x0A},
                                               {"GL_COPY", 0x0C},
                                               {"GL_AND_INVERTED", ~0x0C & 0x0A},
                                               {"GL_NOOP", 0x0A},
                                               {"GL_XOR", 0x0C ^ 0x0A},
                                               {"GL_OR", 0x0C | 0x0A},
                                               {"GL_NOR", ~(0x0C | 0x0A)},
                                               {"GL_EQUIV", ~(0x0C ^ 0x0A)},
                                               {"GL_INVERT", ~0x0A},
                                               {"GL_OR_REVERSE", 0x0C | ~0x0A},
                                               {"GL_COPY_INVERTED", ~0x0C},
                                               {"GL_OR_INVERTED", ~0x0C | 0x0A},
                                               {"GL_NAND", ~(0x0C & 0x0A)},
                                               {"GL_SET", 0xFF}};
    for (const auto& [name, expected] : ops) {
        const Image image =
            reference_of(fmt::format("glDisable(GL_BLEND); glColor3ub(10, 10, 10); glRectf(0, 0, 32, 32);"
                                     "glEnable(GL_COLOR_LOGIC_OP); glLogicOp({}); glEnable(GL_BLEND);"
                                     "glColor3ub(12, 12, 12); glRectf(0, 0, 32, 32);",
                                     name));
        EXPECT_EQ(std::lround(255 * red(image, 20, 8)), expected & 0xFF) << name;
    }
}

// The driver gives the same colours, inside what coverage leaves open; and most of these pictures is judged.
TEST(SmoothStippleLogic, AgreeThreeWays) {
    std::string bytes;
    for (int i = 0; i < 128; ++i) bytes += fmt::format("{}{}", i == 0 ? "" : ", ", i * 37 % 256);
    for (const std::string& text : std::vector<std::string>{
             "glEnable(GL_LINE_SMOOTH); glLineWidth(7); glColor4f(0.3, 0.9, 0.2, 0.8); glBegin(GL_LINES); "
             "glVertex2f(3, "
             "4); glVertex2f(29, 25); glEnd();",
             "glEnable(GL_LINE_STIPPLE); glLineStipple(3, 0x3C35); glLineWidth(7); glColor4f(0.3, 0.9, 0.2, 0.8);"
             "glBegin(GL_LINE_STRIP); glVertex2f(3.3, 4.1); glVertex2f(29, 10.2); glVertex2f(12.6, 28.1); glEnd();",
             // Two strips, which are drawn as one array in shaders; then the edges of a polygon.
             "glEnable(GL_LINE_STIPPLE); glLineStipple(4, 0x00FF); glLineWidth(5);"
             "glBegin(GL_LINE_STRIP); glVertex2f(2, 4); glVertex2f(12, 5); glVertex2f(30, 4); glEnd();"
             "glBegin(GL_LINE_STRIP); glVertex2f(2, 12); glVertex2f(12, 13); glVertex2f(30, 12); glEnd();"
             "glBegin(GL_LINE_LOOP); glVertex2f(2, 20); glVertex2f(30, 21); glVertex2f(12, 30); glEnd();",
             "glEnable(GL_LINE_STIPPLE); glLineStipple(3, 0x3C35); glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);"
             "glLineWidth(3); glBegin(GL_TRIANGLES); glVertex2f(2, 2); glVertex2f(30, 5); glVertex2f(9, 29); glEnd();",
             "glEnable(GL_POINT_SMOOTH); glPointSize(19); glColor4f(0.3, 0.9, 0.2, 1); glBegin(GL_POINTS); "
             "glVertex2f(13, 14.4); glEnd();",
             "glPolygonStipple((GLubyte[128]){" + bytes +
                 "});"
                 "glEnable(GL_POLYGON_STIPPLE); glRectf(2.2, 3.3, 30.3, 29.2);",
             "glColor3f(0.3, 0.6, 0.7); glRectf(0, 0, 20, 32); glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_EQUIV); "
             "glColor3f(0.9, 0.2, 0.4); glRectf(10, 2, 29, 29);",
             "glNewList(1, GL_COMPILE); glBegin(GL_QUADS); glColor3f(1, 0, 0); glVertex2f(2, 2); glColor3f(0, 1, 0); "
             "glVertex2f(30, 3);"
             "glColor3f(0, 0, 1); glVertex2f(28, 30); glColor3f(1, 1, 0); glVertex2f(4, 27); glEnd(); glEndList(); "
             "glCallList(1);"}) {
        const compare::Comparison comparison = compare_three_ways(scene_of(std::string(kWindow) + text));
        EXPECT_TRUE(comparison.unsupported.empty()) << text;
        EXPECT_TRUE(comparison.within_tolerance()) << text;
        const RegionDifference& interior = comparison.pairs.front().difference.interior;
        EXPECT_GT(interior.pixels, static_cast<std::size_t>(kSize * kSize / 2)) << text;
        EXPECT_EQ(interior.differing, 0U) << "shaders do what fixed function does" << text;
    }
}

// Mesa lengthens a smooth line by half a pixel at each end. What changes along it is off by as much of the change.
TEST(SmoothLines, ThatChangeFromEndToEndAreEdges) {
    const auto comparison_of = [](const std::string& first, const std::string& second) {
        return compare_three_ways(scene_of(
            fmt::format("{}glDisable(GL_BLEND); glEnable(GL_LINE_SMOOTH); glLineWidth(8); glBegin(GL_LINES); {} "
                        "glVertex2f(4, 16); {} glVertex2f(28, 16); glEnd();",
                        kWindow, first, second)));
    };
    const compare::Comparison constant = comparison_of("glColor3f(0.2, 0.4, 0.6);", "");
    const compare::Comparison ramp = comparison_of("glColor3f(0, 0, 0);", "glColor3f(1, 1, 1);");
    EXPECT_EQ(constant.verdict(), compare::Verdict::kWithin);
    EXPECT_EQ(ramp.verdict(), compare::Verdict::kUnjudged) << "all of its pixels have a range";
    const auto interior = [](const compare::Comparison& comparison) {
        return comparison.pairs.at(1).difference.interior.pixels;
    };
    EXPECT_GT(interior(constant), interior(ramp) + 30);
    EXPECT_GT(ramp.pairs.at(1).difference.edge.max * 255, 3) << "fixed and reference";
}

}  // namespace
}  // namespace twinlight::smooth_stipple_logic_test

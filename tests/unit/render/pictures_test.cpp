// Pictures draws a picture again only where other options can change it: the result is the same as a whole new picture.
#include "render/reference/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "judge/fuzz/fuzzer.h"
#include "render/reference/allowed_difference.h"
#include "render/reference/copied_pixels.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::reference::pictures_test {
namespace {

constexpr int kWidth = 48, kHeight = 36;

const Look kAsInGl{.shading = std::nullopt, .lecture_variants = false},
    kPerPixel{.shading = Shading::kPhong, .lecture_variants = true};

// Colours are floats; rounding in double may change the last place of one (lighting/points.h).
double largest_difference(const Image& a, const Image& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            largest = std::max(largest, static_cast<double>(std::abs(a.pixels[i][c] - b.pixels[i][c])));
    return largest;
}

// Both cuts over the whole window, without any rectangle.
OpenDifference whole_difference(const Frame& given, const Look& look) {
    const Options in_gl{look};
    CopyRanges ranges;
    const DrawableFrame drawable = drawable_with_ranges(given, in_gl, ranges);
    const Frame& frame = *drawable;
    OpenDifference found(kWidth, kHeight);
    for (const QuadCut cut : {QuadCut::kFirstToThird, QuadCut::kSecondToFourth}) {
        Options options{look, cut};
        options.in_clip_plane = InClipPlane::kPerhaps;
        find_differences(run_stages(frame, options, &ranges), options, {0, 0, kWidth, kHeight}, found,
                         cut == QuadCut::kFirstToThird ? Joining::kReplaces : Joining::kAdds);
    }
    return found;
}

void expect_same(const Frame& frame, const std::string& name) {
    Pictures pictures(frame);
    for (const Look& look : {kAsInGl, kPerPixel, kAsInGl})
        for (const QuadCut cut : {QuadCut::kFirstToThird, QuadCut::kSecondToFourth}) {
            const Options options{look, cut};
            EXPECT_LE(largest_difference(pictures.render(options), render(frame, options)), 0x1p-23) << name;
        }
    for (const Look& look : {kAsInGl, kPerPixel, kAsInGl}) {
        const AllowedDifference found = pictures.allowed_difference({look});
        const OpenDifference whole = whole_difference(frame, look);
        EXPECT_TRUE(std::ranges::equal(found.edge, whole.edge, [](bool a, char b) { return a == (b != 0); })) << name;
        EXPECT_EQ(largest_difference(found.channels(), whole.channels), 0) << name;
        EXPECT_EQ(found.ranges, whole.ranges) << name;
        EXPECT_EQ(found.open, whole.open) << name;
        EXPECT_TRUE(std::ranges::equal(found.drawn, whole.drawn, [](bool a, char b) { return a == (b != 0); })) << name;
    }
}

// Bands have 16 rows. The line begins two rows above the border between two of them.
TEST(Pictures, HaveNoEdgeBelowALineThatBeginsInTheNextBand) {
    const CommandList line = read_scene(
        "glOrtho(0, 48, 0, 36, -1, 1);\nglLineWidth(3);\nglBegin(GL_LINES);\nglVertex2f(24.4, 17.9);\n"
        "glVertex2f(24.3, 21.3);\nglEnd();\n",
        "line.gl", "line");
    const Frame frame = make_frame(line, {.width = kWidth, .height = kHeight});
    const OpenDifference found = whole_difference(frame, kAsInGl);
    const auto is_drawn = [&](int x, int y) { return found.drawn[found.channels.index(x, kHeight - 1 - y)] != 0; };
    EXPECT_TRUE(is_drawn(24, 18));
    for (int x = 0; x < kWidth; ++x) EXPECT_FALSE(is_drawn(x, 15)) << x;
}

TEST(Pictures, OfBuiltInScenesAreDrawnAgainOnlyWhereTheyChange) {
    for (const EmbeddedFile& file : kSceneFiles) {
        if (file.name == "spectral.gl") continue;  // slow
        const CommandList commands = read_built_in(file, {});
        expect_same(make_frame(commands, {.width = kWidth, .height = kHeight}), std::string(file.name));
    }
}

TEST(Pictures, OfRandomScenesAreDrawnAgainOnlyWhereTheyChange) {
    int pictures = 0;
    for (std::uint64_t state = 0; pictures < 60; ++state) {
        if (!fuzz::is_picture(state)) continue;
        ++pictures;
        const CommandList commands = fuzz::random_scene({{.seed = 7}}, state);
        expect_same(make_frame(commands, {.width = kWidth, .height = kHeight}), "state " + std::to_string(state));
    }
}

// Three corners are directions, so the quadrilateral is half of the picture if it is cut from its first corner, and nothing if it
// is cut from its second.
TEST(Pictures, OfAQuadrilateralWhoseCutsReachOtherPixelsAreDrawnWhole) {
    for (const char* const order : {"GL_QUADS); V0; V1; V2; V3", "GL_QUADS); V1; V2; V3; V0"}) {
        std::string text =
            std::string("glFrustum(-1, 0, -1, 0, 1, 10); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glBegin(") +
            order + "; glEnd();";
        const std::array<const char*, 4> corners = {"glVertex3f(0, 0, -3)", "glVertex3f(0, 1, 0)",
                                                    "glVertex3f(-2, -2, 0)", "glVertex3f(-3, 0, 0)"};
        for (std::size_t i = 0; i < corners.size(); ++i)
            text.replace(text.find("V" + std::to_string(i)), 2, corners.at(i));
        const CommandList commands = read_scene(text, "quadrilateral.gl", "quadrilateral", no_images, {});
        expect_same(make_frame(commands, {.width = kWidth, .height = kHeight}), order);
    }
}

// The rectangle saves work: a small lit square in a large unlit picture.
TEST(Pictures, KeepPixelsThatOtherOptionsDoNotChange) {
    const CommandList commands = read_scene(
        "glClear(GL_COLOR_BUFFER_BIT); glBegin(GL_TRIANGLES); glColor3f(1, 0, 0); glVertex2f(-1, -1); glVertex2f(1, "
        "-1); "
        "glVertex2f(-1, 1); glEnd(); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glRectf(0.5, 0.5, 0.6, 0.6);",
        "square.gl", "square", no_images, {});
    Frame frame = make_frame(commands, {.width = kWidth, .height = kHeight});
    Pictures pictures(frame);
    const Image first = pictures.render({kAsInGl});
    // What was drawn is taken from the first picture, not from the frame: the red triangle stays.
    std::get<Draw>(frame.items[1]).vertices.edit().clear();
    const Image again = pictures.render({kPerPixel});
    EXPECT_EQ(again.at(2, kHeight - 3), first.at(2, kHeight - 3));
    EXPECT_EQ(again.at(2, kHeight - 3)[0], 1);
}

}  // namespace
}  // namespace twinlight::reference::pictures_test

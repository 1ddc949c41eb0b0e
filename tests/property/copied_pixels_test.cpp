// glCopyTexImage and glCopyTexSubImage (3.8.2): the driver, the shaders and the reference copy the same pixels, each from
// its own picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "../unit/compare_three_ways.h"
#include "../unit/frames_of_texts.h"
#include "../unit/one_pixel.h"
#include "render/fixed/replay.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"

namespace twinlight::copied_pixels_test {
namespace {

class CopiedPixelsTest : public OnePixel {};

// The picture: red, green, blue and yellow quarters of 8 x 8 pixels, from the lower left, in rows; then a texture.
constexpr const char* kQuarters =
    "glEnable(GL_SCISSOR_TEST);\n"
    "glScissor(0, 0, 8, 8); glClearColor(1, 0, 0, 0.2); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(8, 0, 8, 8); glClearColor(0, 1, 0, 0.4); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(0, 8, 8, 8); glClearColor(0, 0, 1, 0.6); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(8, 8, 8, 8); glClearColor(1, 1, 0, 0.8); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glDisable(GL_SCISSOR_TEST); glBindTexture(GL_TEXTURE_2D, 1); glBindTexture(GL_TEXTURE_1D, 2);\n"
    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
    "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
    "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
    "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n";

// The texture over the whole window, with its lower left corner at the window's.
std::string shown(const std::string& target = "GL_TEXTURE_2D") {
    return "glClearColor(0, 0, 0, 1); glClear(GL_COLOR_BUFFER_BIT); glEnable(" + target +
           ");\nglBegin(GL_QUADS); glTexCoord2f(0, 0); glVertex2f(-1, -1); glTexCoord2f(1, 0); glVertex2f(1, -1); "
           "glTexCoord2f(1, 1); glVertex2f(1, 1); glTexCoord2f(0, 1); glVertex2f(-1, 1); glEnd(); glDisable(" +
           target + ");\n";
}

TEST_F(CopiedPixelsTest, AreThoseOfTheRectangle) {
    const std::string text =
        kQuarters + std::string("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 8, 8, 0);\n") + shown();
    EXPECT_EQ(codes(text, 2, 2), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 13, 2), (Codes{0, 255, 0, 102}));
    EXPECT_EQ(codes(text, 2, 13), (Codes{0, 0, 255, 153}));
    EXPECT_EQ(codes(text, 13, 13), (Codes{255, 255, 0, 204}));
}

TEST_F(CopiedPixelsTest, HaveTheInternalFormat) {
    const auto with = [&](const std::string& format) {
        return codes(
            "glClearColor(0.8, 0.4, 0.2, 0.6); glClear(GL_COLOR_BUFFER_BIT);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
            "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); glColor4f(0.2, 0.2, 0.2, 0.2);\n"
            "glCopyTexImage2D(GL_TEXTURE_2D, 0, " +
            format + ", 0, 0, 16, 16, 0);\n" + shown());
    };
    EXPECT_EQ(with("GL_RGB"), (Codes{204, 102, 51, 51}));
    EXPECT_EQ(with("GL_RGBA"), (Codes{204, 102, 51, 153}));
    EXPECT_EQ(with("GL_LUMINANCE"), (Codes{204, 204, 204, 51}));  // 3.8.2: luminance is red
    EXPECT_EQ(with("GL_LUMINANCE_ALPHA"), (Codes{204, 204, 204, 153}));
    EXPECT_EQ(with("GL_INTENSITY"), (Codes{204, 204, 204, 204}));
    EXPECT_EQ(with("GL_ALPHA"), (Codes{51, 51, 51, 153}));
}

TEST_F(CopiedPixelsTest, ReplacePartOfAnImage) {
    const std::string text = kQuarters +
                             std::string(
                                 "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 8, 8, 0);\n"
                                 "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 8, 8, 4, 4);\n"
                                 "glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 2, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, "
                                 "(GLubyte[]){9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9});\n") +
                             shown();
    EXPECT_EQ(codes(text, 2, 2), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 9, 1), (Codes{255, 255, 0, 204}));
    EXPECT_EQ(codes(text, 9, 6), (Codes{9, 9, 9, 9}));
    EXPECT_EQ(codes(text, 9, 10), (Codes{255, 0, 0, 51}));
}

TEST_F(CopiedPixelsTest, MayHaveOneDimension) {
    const std::string text = kQuarters +
                             std::string(
                                 "glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 0, 3, 16, 0);\n"
                                 "glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 12, 4);\n") +
                             shown("GL_TEXTURE_1D");
    EXPECT_EQ(codes(text, 2, 2), (Codes{0, 0, 255, 255}));
    EXPECT_EQ(codes(text, 5, 8), (Codes{255, 0, 0, 255}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 255}));
}

TEST_F(CopiedPixelsTest, MakeMipmaps) {
    // So the means of each two are whole numbers: Mesa rounds halves up in 22.3, and down in 26.1.
    const std::string even =
        "glEnable(GL_SCISSOR_TEST);\n"
        "glScissor(0, 0, 8, 8); glClearColor(0.8, 0, 0, 0.2); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glScissor(8, 0, 8, 8); glClearColor(0, 0.8, 0, 0.6); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glScissor(0, 8, 8, 8); glClearColor(0, 0, 0.8, 0.2); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glScissor(8, 8, 8, 8); glClearColor(0.8, 0.8, 0, 0.6); glClear(GL_COLOR_BUFFER_BIT);\n"
        "glDisable(GL_SCISSOR_TEST);\n";
    const std::string small = kQuarters + even +
                              std::string(
                                  "glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);\n"
                                  "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 16, 16, 0);\n"
                                  "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, "
                                  "GL_NEAREST_MIPMAP_NEAREST);\n");
    EXPECT_EQ(codes(small + "glScalef(0.5, 0.5, 1);\n" + shown(), 6, 6), (Codes{204, 0, 0, 51}));
    // The mean of four colours.
    EXPECT_EQ(codes(small + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 4);\n" + shown()),
              (Codes{102, 102, 51, 102}));
}

TEST_F(CopiedPixelsTest, ShowInLaterCopies) {
    std::string text =
        "glClearColor(1, 1, 1, 1); glClear(GL_COLOR_BUFFER_BIT); glColor3f(0.5, 0.5, 1);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n";
    for (int i = 0; i < 3; ++i)  // each halves red and green
        text += "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 16, 16, 0);\n" + shown();
    EXPECT_EQ(codes(text), (Codes{32, 32, 255, 255}));
}

TEST_F(CopiedPixelsTest, ComeFromWhereTheCommandIsEvenInALists) {
    const std::string text = kQuarters +
                             std::string(
                                 "glNewList(1, GL_COMPILE); glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, "
                                 "8, 8, 0); glEndList();\n"
                                 "glScissor(0, 0, 8, 8); glEnable(GL_SCISSOR_TEST); glClearColor(0, 1, 1, 1); "
                                 "glClear(GL_COLOR_BUFFER_BIT); glDisable(GL_SCISSOR_TEST);\n"
                                 "glCallList(1);\n") +
                             shown();
    EXPECT_EQ(codes(text), (Codes{0, 255, 255, 255}));
}

TEST_F(CopiedPixelsTest, OfEarlierFramesStay) {
    const std::string copy = "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 16, 16, 0);\n";
    const std::string state = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n";
    const auto recording = std::make_shared<const FramesOfTexts>(std::vector<std::string>{
        state + "glClearColor(1, 0.5, 1, 1); glClear(GL_COLOR_BUFFER_BIT); glRectf(9, 9, 9, 9);\n" + copy,
        "glColor3f(0.5, 0.5, 0.5);\n" + shown() + copy, shown() + copy, shown(), shown()});
    const int expected[] = {255, 128, 64, 32, 32};
    for (int number = 1; number < 5; ++number) {
        SCOPED_TRACE(number);
        const RecordedFrame recorded =
            make_recorded_frame(recording, {.number = number, .width = kSide, .height = kSide});
        EXPECT_EQ(codes(recorded.scene, 8, 8, "")[0], expected[number]);
        EXPECT_EQ(recorded.scene.frame.earlier.size(), static_cast<std::size_t>(std::min(number, 3)));
    }
}

// Feedback that goes on for ever: each frame shows the one before, a little darker.
TEST_F(CopiedPixelsTest, OfTooManyFramesInARowAreRefusedByName) {
    std::vector<std::string> frames{"glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"};
    for (int i = 0; i < 60; ++i)
        frames.push_back(shown() + "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 16, 16, 0);\n");
    const auto recording = std::make_shared<const FramesOfTexts>(frames);
    const auto unsupported = [&](int number) {
        return make_recorded_frame(recording, {.number = number, .width = kSide, .height = kSide})
            .scene.frame.unsupported;
    };
    EXPECT_TRUE(unsupported(40).empty());
    ASSERT_EQ(unsupported(58).size(), 1u);
    EXPECT_EQ(unsupported(58)[0].name, "glCopyTexImage2D of a picture that shows 50 copies in a row");
}

// What lies between edges is judged; edges of the copied picture give texels of any colour.
TEST_F(CopiedPixelsTest, AllowWhatTheCopiedPictureAllows) {
    const std::string scene =
        "glClearColor(0.2, 0.3, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
        "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glScalef(0.9, 0.9, 0.9);\n"
        "glRotatef(30, 1, 1, 0); glutSolidCube(0.8); glDisable(GL_LIGHTING);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 128, 128, 0);\n"
        "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glRotatef(40, 1, 1, 0);\n" +
        shown();
    const Scene made = make_scene(list_of(scene), {.width = 128, .height = 128});
    const compare::Comparison comparison = compare_three_ways(made);
    EXPECT_EQ(comparison.verdict(), compare::Verdict::kWithin);
    const RegionDifference& at_edges = comparison.pairs[0].difference.edge;
    EXPECT_LT(at_edges.pixels, 128 * 128 / 8);
    double allowed = 0;
    for (const Rgba& pixel : comparison.allowed.channels().pixels) allowed += pixel[0];
    EXPECT_GT(allowed, 1);
    EXPECT_LT(allowed, 128 * 128 / 10);
}

}  // namespace
}  // namespace twinlight::copied_pixels_test

// Secondary colours of vertices with GL_COLOR_SUM (3.9) and fog coordinates (3.10): the driver's fixed function, the
// shaders and the reference give the same colours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/context/context.h"
#include "render/fixed/fixed.h"
#include "render/fixed/replay.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::color_sum_test {
namespace {

constexpr int kSide = 16;

class ColorSumAndFogCoordinates : public testing::Test {
  protected:
    // The colour at a pixel, which all renderers must agree on.
    Rgba color(const std::string& text, int x = 8, int y = 8) {
        const auto list = std::make_shared<const CommandList>(read_scene(text, "scene.gl", "scene"));
        const Scene scene = make_scene(list, {.width = kSide, .height = kSide});
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        const auto at = [&](const Image& image) { return image.at(x, kSide - 1 - y); };
        const Rgba expected = at(reference::render(scene.frame, {}));
        const auto expect = [&](const char* name, const Rgba& found) {
            constexpr float kRounding = 0.51F;  // to 8 bits, in 1/255
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(255 * found[i], 255 * expected[i], kRounding) << name << " channel " << i << "\n" << text;
        };
        expect("fixed", at(fixed::render(scene)));
        for (const fixed::Sending sending : {fixed::Sending::kBuffers, fixed::Sending::kImmediate}) {
            fixed::Replay(scene.frame, {.sending = sending}).draw();
            expect("replayed", at(read_pixels(kSide, kSide)));
        }
        expect("shaders", at(renderer_.render(scene.frame, {})));
        programmable::Options kept;
        kept.tier = programmable::Tier::kAuto;
        expect("shaders, kept", at(renderer_.render(scene.frame, kept)));
        return expected;
    }

    std::unique_ptr<OffscreenContext> context_ = make_offscreen_context(kSide, kSide);
    programmable::Renderer renderer_;
};

constexpr const char* kRect = "glRectf(-1, -1, 1, 1);\n";

TEST_F(ColorSumAndFogCoordinates, AddsTheSecondaryColorAfterTheTexture) {
    const std::string texture =
        "GLubyte texel[] = {128, 128, 128, 64};\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n";
    const std::string sum = texture + "glEnable(GL_COLOR_SUM); glColor4f(0.5, 1, 0, 1);\n";
    const Rgba found = color(sum + "glSecondaryColor3f(0.25, 0.75, 2);\n" + kRect);
    EXPECT_NEAR(found[0], 64.0 / 255 + 0.25, 1e-6);
    EXPECT_EQ(found[1], 1);                   // clamped
    EXPECT_EQ(found[2], 1);                   // the secondary colour is clamped, too
    EXPECT_NEAR(found[3], 64.0 / 255, 1e-6);  // alpha is the primary one's
    // GL_REPLACE hides the primary colour only.
    const Rgba replaced = color(sum +
                                "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
                                "glSecondaryColor3ub(51, 0, 0);\n" +
                                kRect);
    EXPECT_NEAR(replaced[0], 128.0 / 255 + 0.2, 1e-6);
    // Integers as in glColor.
    EXPECT_NEAR(color(sum + "glSecondaryColor3us(13107, 0, 0);\n" + kRect)[0], 64.0 / 255 + 0.2, 1e-6);
}

TEST_F(ColorSumAndFogCoordinates, NeedsTheCapabilityAndNoLighting) {
    const std::string red = "glColor3f(0, 0.5, 0); glSecondaryColor3f(1, 0, 0);\n";
    EXPECT_EQ(color(red + kRect)[0], 0);
    EXPECT_EQ(color(red + "glEnable(GL_COLOR_SUM);\n" + kRect)[0], 1);
    EXPECT_EQ(color(red +
                    "glEnable(GL_COLOR_SUM); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
                    "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0, 0.5, 0, 1});\n" +
                    kRect)[0],
              0);
    EXPECT_EQ(color("glEnable(GL_COLOR_SUM); glPushAttrib(GL_CURRENT_BIT);" + red + "glPopAttrib();\n" + kRect)[0], 1)
        << "white";
    EXPECT_EQ(color("glEnable(GL_COLOR_SUM); glColor3f(0, 0, 0); glPushAttrib(GL_CURRENT_BIT);\n" + red +
                    "glPopAttrib();\n" + kRect)[0],
              0);
}

TEST_F(ColorSumAndFogCoordinates, InterpolatesSecondaryColors) {
    const std::string text =
        "glEnable(GL_COLOR_SUM); glColor3f(0, 0, 0); glBegin(GL_TRIANGLE_STRIP);\n"
        "glSecondaryColor3f(0, 0, 1); glVertex2f(-1, -1); glVertex2f(-1, 1);\n"
        "glSecondaryColor3f(1, 0, 1); glVertex2f(1, -1); glVertex2f(1, 1); glEnd();\n";
    EXPECT_NEAR(color(text, 4, 8)[0], 4.5 / 16, 1e-6);
    EXPECT_EQ(color("glShadeModel(GL_FLAT);" + text, 3, 3)[0], 1);
    // The same twice, so that kept meshes are compared; then with other values.
    color(text);
    EXPECT_NEAR(color("glColor3f(0, 0, 0);" + text, 12, 8)[0], 12.5 / 16, 1e-6);
}

TEST_F(ColorSumAndFogCoordinates, TakesFogFromTheCoordinates) {
    const std::string fog =
        "glEnable(GL_FOG); glFogfv(GL_FOG_COLOR, (GLfloat[]){0, 0, 0, 1}); glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);\n"
        "glColor4f(1, 1, 1, 1);\n";
    EXPECT_NEAR(color(fog + "glFogCoordf(0.5);" + kRect)[0], std::exp(-0.5), 1e-6);  // GL_EXP, density 1
    EXPECT_NEAR(color(fog + "glFogi(GL_FOG_MODE, GL_EXP2); glFogCoordd(0.5);" + kRect)[0], std::exp(-0.25), 1e-6);
    EXPECT_NEAR(color(fog +
                      "glFogCoordf(0.5); glFogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH);"
                      "glTranslatef(0, 0, -0.25);" +
                      kRect)[0],
                std::exp(-0.25), 1e-6);
    const std::string linear =
        fog +
        "glFogi(GL_FOG_MODE, GL_LINEAR); glFogf(GL_FOG_END, 2); glBegin(GL_TRIANGLE_STRIP);\n"
        "glFogCoordf(0); glVertex2f(-1, -1); glVertex2f(-1, 1); glFogCoordf(2); glVertex2f(1, -1); "
        "glVertex2f(1, 1); glEnd();\n";
    EXPECT_NEAR(color(linear, 4, 8)[0], 1 - 4.5 / 16, 1e-6);
    EXPECT_NEAR(color(linear, 12, 8)[0], 1 - 12.5 / 16, 1e-6);
}

// c is the coordinate itself: below 0 f is clamped to 1. Mesa 22.3 takes its absolute value, so only shaders are compared.
TEST_F(ColorSumAndFogCoordinates, TakesNoFogFromCoordinatesBelow0) {
    const auto list = std::make_shared<const CommandList>(
        read_scene("glEnable(GL_FOG); glFogfv(GL_FOG_COLOR, (GLfloat[]){0, 0, 0, 1});\n"
                   "glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD); glColor3f(0.8, 0.8, 0.8); glFogCoordf(-3);\n"
                   "glRectf(-1, -1, 1, 1);\n",
                   "scene.gl", "scene"));
    const Scene scene = make_scene(list, {.width = kSide, .height = kSide});
    constexpr double kRounding = 0.51 / 255;  // to 8 bits
    EXPECT_NEAR(reference::render(scene.frame, {}).at(8, 8)[0], 0.8, kRounding);
    EXPECT_NEAR(renderer_.render(scene.frame, {}).at(8, 8)[0], 0.8, kRounding);
}

TEST(SecondaryColor, IsPartOfTheState) {
    State state;
    for (const Command& command :
         read_scene("glSecondaryColor3f(0.25, 0.5, 2); glFogCoordf(7); glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);\n"
                    "glPushAttrib(GL_CURRENT_BIT); glFogCoordf(8); glPopAttrib();\n",
                    "scene.gl", "scene")
             .commands)
        state.apply(command);
    EXPECT_EQ(answer(state, kGL_CURRENT_SECONDARY_COLOR), (Answer{0.25, 0.5, 2, 1}));
    EXPECT_EQ(answer(state, kGL_CURRENT_FOG_COORD), Answer{7});
    EXPECT_EQ(answer(state, kGL_FOG_COORD_SRC), Answer{kGL_FOG_COORD});
    // The names of GL 1.4, and of EXT_fog_coord.
    for (const Command& command : read_scene("glFogi(GL_FOG_COORDINATE_SOURCE, GL_FRAGMENT_DEPTH);\n"
                                             "glFogi(GL_FOG_COORDINATE_SOURCE_EXT, GL_FOG_COORDINATE_EXT);\n",
                                             "scene.gl", "scene")
                                      .commands) {
        state.apply(command);
        EXPECT_EQ(answer(state, kGL_CURRENT_FOG_COORDINATE), Answer{7});
        EXPECT_EQ(answer(state, kGL_FOG_COORD_SRC)[0], command.enumerant(1));
    }
}

}  // namespace
}  // namespace twinlight::color_sum_test

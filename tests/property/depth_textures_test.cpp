// Textures of depths (3.8.14): the driver, the shaders and the reference compare the same depths and give the same colour.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "../unit/compare_three_ways.h"
#include "../unit/one_pixel.h"
#include "render/context/driver_name.h"
#include "render/fixed/replay.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::depth_textures_test {
namespace {

class DepthTextures : public OnePixel {
  protected:
    int red(const std::string& text, int x = 8, int y = 8) { return codes(text, x, y)[0]; }
};

// Two depths side by side, 0.25 and 0.75, without a filter.
std::string two_depths(const std::string& format = "GL_DEPTH_COMPONENT", const std::string& filter = "GL_NEAREST") {
    return fmt::format(
        "glEnable(GL_TEXTURE_2D); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, {1}); "
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, {1});\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); "
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, {0}, 2, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){{0.25, 0.75}});\n",
        format, filter);
}

std::string comparing(const std::string& func) {
    return "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);\n"
           "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, " +
           func + ");\n";
}

std::string shown(double s, double r, double q = 1) {
    return fmt::format("glTexCoord4f({}, {}, {}, {}); glRectf(-1, -1, 1, 1);\n", s * q, 0.5 * q, r * q, q);
}

TEST_F(DepthTextures, ShowTheirDepths) {
    for (const char* format :
         {"GL_DEPTH_COMPONENT", "GL_DEPTH_COMPONENT16", "GL_DEPTH_COMPONENT24", "GL_DEPTH_COMPONENT32"}) {
        EXPECT_EQ(red(two_depths(format) + shown(0.2, 0.9)), 64);
        EXPECT_EQ(red(two_depths(format) + shown(0.8, 0.1)), 191);
    }
}

// 3.8.14: L_t, I_t or A_t; tables 3.22 and 3.23.
TEST_F(DepthTextures, AreLuminanceIntensityOrAlpha) {
    const auto with = [&](const char* mode, const std::string& compare) {
        return codes(two_depths() + compare + "glColor4f(0.2, 0.4, 0.6, 0.8);\n" +
                     fmt::format("glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, {});\n", mode) +
                     shown(0.2, 0.2));
    };
    EXPECT_EQ(with("GL_LUMINANCE", ""), (Codes{64, 64, 64, 204}));
    EXPECT_EQ(with("GL_INTENSITY", ""), (Codes{64, 64, 64, 64}));
    EXPECT_EQ(with("GL_ALPHA", ""), (Codes{51, 102, 153, 64}));
    const std::string greater = comparing("GL_GREATER");
    EXPECT_EQ(with("GL_LUMINANCE", greater), (Codes{0, 0, 0, 204}));
    EXPECT_EQ(with("GL_INTENSITY", greater), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(with("GL_ALPHA", greater), (Codes{51, 102, 153, 0}));
}

// Table 3.23 of the comparisons: r below, at and above the depth.
TEST_F(DepthTextures, CompareInEightWays) {
    const std::pair<const char*, std::array<int, 3>> functions[] = {
        {"GL_LEQUAL", {255, 255, 0}},   {"GL_GEQUAL", {0, 255, 255}}, {"GL_LESS", {255, 0, 0}},
        {"GL_GREATER", {0, 0, 255}},    {"GL_EQUAL", {0, 255, 0}},    {"GL_NOTEQUAL", {255, 0, 255}},
        {"GL_ALWAYS", {255, 255, 255}}, {"GL_NEVER", {0, 0, 0}},
    };
    // A depth of 1 is stored exactly, and r is clamped to it.
    const std::string ends =
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 2, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0, "
        "1});\n";
    for (const auto& [func, expected] : functions) {
        SCOPED_TRACE(func);
        EXPECT_EQ(red(two_depths() + comparing(func) + shown(0.2, 0.24)), expected[0]);
        EXPECT_EQ(red(two_depths() + comparing(func) + shown(0.2, 0.26)), expected[2]);
        EXPECT_EQ(red(two_depths() + ends + comparing(func) + shown(0.8, 1.5)), expected[1]);
        EXPECT_EQ(red(two_depths() + ends + comparing(func) + shown(0.2, -0.5)), expected[1]);
    }
}

TEST_F(DepthTextures, CompareROverQ) {
    const std::string setup = two_depths() + comparing("GL_LEQUAL");
    EXPECT_EQ(red(setup + shown(0.8, 0.7, 0.5)), 255);
    EXPECT_EQ(red(setup + shown(0.8, 0.8, 0.5)), 0);
    EXPECT_EQ(red(setup + shown(0.8, 0.7, 3)), 255);
    EXPECT_EQ(red(setup + shown(0.8, 0.8, 3)), 0);
    EXPECT_EQ(red(setup + "glMatrixMode(GL_TEXTURE); glTranslatef(0, 0, 0.5);\n" + shown(0.8, 0.2)), 255);
    EXPECT_EQ(red(setup + "glMatrixMode(GL_TEXTURE); glTranslatef(0, 0, 0.5);\n" + shown(0.8, 0.3)), 0);
    EXPECT_EQ(red(setup +
                      "glEnable(GL_TEXTURE_GEN_R); glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); "
                      "glTexGenfv(GL_R, GL_OBJECT_PLANE, (GLfloat[]){1, 0, 0, 0.5});\n" +
                      shown(0.8, 0.9),
                  4, 8),
              255);
}

// The border has the first component of its colour.
TEST_F(DepthTextures, CompareWithTheBorder) {
    const std::string setup = two_depths() +
                              "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);\n"
                              "glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){0.5, 1, 0, 0});\n";
    EXPECT_EQ(red(setup + shown(1.5, 0)), 128);
    EXPECT_EQ(red(setup + comparing("GL_LEQUAL") + shown(1.5, 0.49)), 255);
    EXPECT_EQ(red(setup + comparing("GL_LEQUAL") + shown(1.5, 0.51)), 0);
}

// RULING: the outcomes are mixed. The reference says so; softpipe compares the mean of the depths (3.8.14 leaves it open).
TEST_F(DepthTextures, MixOutcomesInALinearFilter) {
    const std::string setup = two_depths("GL_DEPTH_COMPONENT", "GL_LINEAR") + comparing("GL_LEQUAL");
    const auto of_reference = [&](const std::string& text) {
        return channel_code(reference::render(scene_of(text).frame, {}).at(8, 8)[0]);
    };
    EXPECT_EQ(of_reference(setup + shown(0.375, 0.3)), 64);
    EXPECT_EQ(of_reference(setup + shown(0.5, 0.3)), 128);
    EXPECT_EQ(of_reference(setup + shown(0.625, 0.7)), 191);
    if (current_driver().name == "llvmpipe") {
        // The weights have 8 bits.
        for (const double s : {0.3125, 0.40625, 0.5625, 0.6875}) red(setup + shown(s, 0.5));
    }
    // What all depths agree on is the same everywhere.
    EXPECT_EQ(red(setup + shown(0.5, 0.2)), 255);
    EXPECT_EQ(red(setup + shown(0.5, 0.8)), 0);
    const std::string clamped = setup + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);\n";
    EXPECT_EQ(red(clamped + shown(0.5, 0.8)), 0);
    EXPECT_EQ(red(clamped + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n" + shown(0.4, 0.2)),
              255);
}

// Here t is r, because Mesa's fixed function compares with t.
TEST_F(DepthTextures, MayHaveOneDimension) {
    const auto with = [&](const std::string& compare, double s, double r, double q) {
        return red(
            "glEnable(GL_TEXTURE_1D); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
            "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); "
            "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
            "glTexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT16, 2, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, "
            "(GLushort[]){16384, 49152});\n" +
            compare + fmt::format("glTexCoord4f({}, {}, {}, {}); glRectf(-1, -1, 1, 1);\n", s * q, r * q, r * q, q));
    };
    const std::string compare = "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);\n";
    EXPECT_EQ(with("", 0.2, 0, 1), 64);
    EXPECT_EQ(with(compare, 0.8, 0.7, 1), 255);
    EXPECT_EQ(with(compare, 0.8, 0.8, 1), 0);
    EXPECT_EQ(with(compare, 0.2, 0.2, 2), 255);
    EXPECT_EQ(with(compare, 0.2, 0.3, 2), 0);
}

TEST_F(DepthTextures, HavePartsAndMipmaps) {
    const std::string part =
        "glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, (GLuint[]){2147483648});\n";
    EXPECT_EQ(red(two_depths() + part + shown(0.8, 0)), 128);
    EXPECT_EQ(red(two_depths() + part + shown(0.2, 0)), 64);
    EXPECT_EQ(red("glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);\n" + two_depths() +
                  "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);\n" + shown(0.2, 0)),
              128);
}

TEST_F(DepthTextures, AreTransferredByDepthScaleAndBias) {
    const std::string transfer =
        "glPixelTransferf(GL_DEPTH_SCALE, 0.5); glPixelTransferf(GL_DEPTH_BIAS, 0.25); "
        "glPixelTransferf(GL_RED_SCALE, 0);\n";
    EXPECT_EQ(red(transfer + two_depths() + shown(0.8, 0)), 159);  // 0.625
}

// In the second unit, by GL_COMBINE, where every component of the texel counts.
TEST_F(DepthTextures, AreCombined) {
    const auto with = [&](const char* mode, const char* operand, const std::string& compare) {
        return codes(
            "glColor4f(0.2, 0.4, 0.6, 0.8); glActiveTexture(GL_TEXTURE1);\n" + two_depths() + compare +
            fmt::format("glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, {});\n"
                        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE); glTexEnvi(GL_TEXTURE_ENV, "
                        "GL_COMBINE_RGB, GL_REPLACE); glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, {});\n"
                        "glMultiTexCoord4f(GL_TEXTURE1, 0.2, 0.5, 0.2, 1); glRectf(-1, -1, 1, 1);\n",
                        mode, operand));
    };
    EXPECT_EQ(with("GL_LUMINANCE", "GL_SRC_COLOR", ""), (Codes{64, 64, 64, 204}));
    EXPECT_EQ(with("GL_LUMINANCE", "GL_SRC_ALPHA", ""), (Codes{255, 255, 255, 204}));
    EXPECT_EQ(with("GL_INTENSITY", "GL_SRC_ALPHA", ""), (Codes{64, 64, 64, 51}));
    EXPECT_EQ(with("GL_ALPHA", "GL_SRC_COLOR", ""), (Codes{0, 0, 0, 51}));
    EXPECT_EQ(with("GL_ALPHA", "GL_SRC_ALPHA", ""), (Codes{64, 64, 64, 51}));
    EXPECT_EQ(with("GL_ALPHA", "GL_SRC_ALPHA", comparing("GL_LEQUAL")), (Codes{255, 255, 255, 204}));
    EXPECT_EQ(with("GL_ALPHA", "GL_SRC_COLOR", comparing("GL_LEQUAL")), (Codes{0, 0, 0, 204}));
    EXPECT_EQ(with("GL_LUMINANCE", "GL_SRC_ALPHA", comparing("GL_GREATER")), (Codes{255, 255, 255, 204}));
    EXPECT_EQ(with("GL_INTENSITY", "GL_SRC_COLOR", comparing("GL_GREATER")), (Codes{0, 0, 0, 0}));
}

// The depth buffer holds 0.75 at the left and 0.25 at the right.
TEST_F(DepthTextures, CopyTheDepthBuffer) {
    const std::string picture =
        "glEnable(GL_DEPTH_TEST); glColor3f(1, 0, 0);\n"
        "glPushMatrix(); glTranslatef(0, 0, 0.5); glRectf(-1, -1, 0, 1); glPopMatrix();\n"
        "glPushMatrix(); glTranslatef(0, 0, -0.5); glRectf(0, -1, 1, 1); glPopMatrix();\n";
    const std::string show = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n";
    for (const char* format : {"GL_DEPTH_COMPONENT", "GL_DEPTH_COMPONENT16", "GL_DEPTH_COMPONENT32"}) {
        const std::string copied = picture + two_depths() +
                                   fmt::format("glCopyTexImage2D(GL_TEXTURE_2D, 0, {}, 0, 0, 16, 16, 0);\n", format) +
                                   show;
        EXPECT_EQ(red(copied + shown(0.2, 0)), 191);
        EXPECT_EQ(red(copied + shown(0.8, 0)), 64);
        EXPECT_EQ(red(copied + comparing("GL_LESS") + shown(0.2, 0.74)), 255);
        EXPECT_EQ(red(copied + comparing("GL_LESS") + shown(0.2, 0.76)), 0);
    }
    const std::string part =
        picture + two_depths() + "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 9, 3, 1, 1);\n" + show;
    EXPECT_EQ(red(part + shown(0.8, 0)), 64);
    EXPECT_EQ(red(part + shown(0.2, 0)), 64);
    // Colours and depths of one picture.
    const std::string both = picture + two_depths() +
                             "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 16, 16, 0);\n"
                             "glBindTexture(GL_TEXTURE_2D, 2); glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 16, "
                             "16, 0);\n" +
                             show;
    EXPECT_EQ(red(both + "glBindTexture(GL_TEXTURE_2D, 0);\n" + shown(0.2, 0)), 191);
    EXPECT_EQ(codes(both + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n" + shown(0.2, 0)),
              (Codes{255, 0, 0, 255}));
}

// 3.8.1 and 3.8.2.
TEST_F(DepthTextures, TakeOnlyPixelsOfDepths) {
    const auto expect_error = [&](const std::string& text) {
        const auto commands = list_of(text)->commands;
        State state({.width = kSide, .height = kSide});
        fixed::Driver driver(kSide, kSide);
        for (const Command& command : commands) {
            state.apply(command);
            driver.execute(command);
        }
        ASSERT_EQ(state.errors().size(), 1u) << text;
        EXPECT_EQ(state.errors()[0].code, kGL_INVALID_OPERATION) << text;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION)) << text;
    };
    expect_error(
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 1, 1, 0, GL_LUMINANCE, GL_FLOAT, (GLfloat[]){0});");
    expect_error(
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0});");
    expect_error(
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 1, 1, 0, GL_DEPTH_COMPONENT, "
        "GL_UNSIGNED_BYTE_3_3_2, (GLfloat[]){0, 0, 0, 0});");
    expect_error(two_depths() + "glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, (GLfloat[]){0});");
    expect_error(
        "glTexImage1D(GL_TEXTURE_1D, 0, 3, 1, 0, GL_RED, GL_FLOAT, (GLfloat[]){0});\n"
        "glTexSubImage1D(GL_TEXTURE_1D, 0, 0, 1, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0});");
}

}  // namespace
}  // namespace twinlight::depth_textures_test

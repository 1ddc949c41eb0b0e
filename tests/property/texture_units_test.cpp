// More than one texture unit, and GL_COMBINE: the driver's fixed function, the shaders and the reference give the same
// colours, and those are the ones of 3.8.13.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../unit/effort.h"
#include "../unit/one_pixel.h"
#include "judge/fuzz/random.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::texture_units_test {
namespace {

class TextureUnits : public OnePixel {};

constexpr const char* kRect = "glRectf(-1, -1, 1, 1);\n";

// A unit with a texture of two texels side by side, each "r, g, b, a" in 1/255.
std::string unit(int number, const std::string& left, const std::string& right, const char* format = "GL_RGBA") {
    return fmt::format(
        "glActiveTexture(GL_TEXTURE{0}); glBindTexture(GL_TEXTURE_2D, {1});\nGLubyte texels{0}[] = {{{2}, {3}}};\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, {4}, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels{0});\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n",
        number, number + 5, left, right, format);
}
std::string environment(const char* name, const std::string& value) {
    return fmt::format("glTexEnvi(GL_TEXTURE_ENV, {}, {});\n", name, value);
}
std::string constant(const std::string& color) {
    return fmt::format("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (GLfloat[]){{{}}});\n", color);
}

TEST_F(TextureUnits, CombineGivesTheFunctionsOfTheTables) {
    const double a[] = {0.8, 0.2, 0.4, 0.6}, b[] = {0.6, 1, 0, 0.2}, c[] = {0.4, 0.6, 0.8, 0.4};
    const auto expect = [&](const char* function, int scale, const auto& value) {
        const std::string text =
            unit(0, "204, 51, 102, 153", "0, 0, 0, 0") + environment("GL_TEXTURE_ENV_MODE", "GL_COMBINE") +
            environment("GL_COMBINE_RGB", function) + environment("GL_SRC1_RGB", "GL_CONSTANT") +
            environment("GL_SRC2_RGB", "GL_PRIMARY_COLOR") + environment("GL_OPERAND2_RGB", "GL_SRC_COLOR") +
            environment("GL_RGB_SCALE", std::to_string(scale)) + environment("GL_COMBINE_ALPHA", "GL_REPLACE") +
            constant("0.6, 1, 0, 0.2") + "glColor4f(0.4, 0.6, 0.8, 0.4);" + kRect;
        const Rgba found = color(text);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(found[i], std::clamp(scale * value(i), 0.0, 1.0), 1e-6) << function << scale;
    };
    for (const int scale : {1, 2, 4}) {
        expect("GL_REPLACE", scale, [&](std::size_t i) { return a[i]; });
        expect("GL_MODULATE", scale, [&](std::size_t i) { return a[i] * b[i]; });
        expect("GL_ADD", scale, [&](std::size_t i) { return a[i] + b[i]; });
        expect("GL_ADD_SIGNED", scale, [&](std::size_t i) { return a[i] + b[i] - 0.5; });
        expect("GL_INTERPOLATE", scale, [&](std::size_t i) { return a[i] * c[i] + b[i] * (1 - c[i]); });
        expect("GL_SUBTRACT", scale, [&](std::size_t i) { return a[i] - b[i]; });
        const double dot = 4 * ((0.3 * 0.1) + (-0.3 * 0.5) + (-0.1 * -0.5));
        expect("GL_DOT3_RGB", scale, [&](std::size_t) { return dot; });
    }
}

TEST_F(TextureUnits, FollowEachOtherInTheOrderOfTheirNumbers) {
    const std::string text = "glColor4f(0.5, 0.5, 0.5, 1);\n" + unit(2, "0, 51, 0, 255", "0, 0, 0, 0") +
                             environment("GL_TEXTURE_ENV_MODE", "GL_ADD") +
                             unit(1, "255, 102, 0, 255", "0, 0, 0, 0");  // GL_MODULATE; unit 0 has no texture
    const Rgba found = color(text + kRect);
    EXPECT_NEAR(found[0], 0.5, 1e-6);
    EXPECT_NEAR(found[1], 0.5 * 0.4 + 0.2, 1e-6);
    EXPECT_NEAR(found[2], 0, 1e-6);
    // The active unit is not what counts, and a unit whose texture is disabled passes the colour on.
    const Rgba without = color(text + "glDisable(GL_TEXTURE_2D); glActiveTexture(GL_TEXTURE7);\n" + kRect);
    EXPECT_NEAR(without[0], 0.5, 1e-6);
    EXPECT_NEAR(without[1], 0.7, 1e-6);
}

TEST_F(TextureUnits, HaveCoordinatesMatricesAndGeneratedCoordinatesOfTheirOwn) {
    const std::string two = unit(0, "255, 255, 255, 255", "0, 255, 255, 255") +
                            unit(1, "255, 255, 255, 255", "255, 0, 255, 255") +
                            unit(2, "255, 255, 255, 255", "255, 255, 0, 255") + "glActiveTexture(GL_TEXTURE0);\n";
    const auto shows = [&](const std::string& text, bool red, bool green, bool blue) {
        const Rgba found = color(two + text);
        EXPECT_EQ(found[0], red ? 1 : 0) << text;
        EXPECT_EQ(found[1], green ? 1 : 0) << text;
        EXPECT_EQ(found[2], blue ? 1 : 0) << text;
    };
    shows(kRect, true, true, true);
    shows(std::string("glMultiTexCoord1f(GL_TEXTURE1, 0.75);") + kRect, true, false, true);
    shows(std::string("glTexCoord1f(0.75); glMultiTexCoord2s(GL_TEXTURE2, 3, 1); glMultiTexCoord4f(GL_TEXTURE1, 1.5, "
                      "0, 0, 2);") +
              kRect,
          false, false, true);
    shows(std::string(
              "glMultiTexCoord1f(GL_TEXTURE1, 0.75); glPushAttrib(GL_CURRENT_BIT); glMultiTexCoord1f(GL_TEXTURE1, "
              "0); glPopAttrib();") +
              kRect,
          true, false, true);
    shows(std::string("glActiveTexture(GL_TEXTURE1); glMatrixMode(GL_TEXTURE); glTranslatef(0.5, 0, 0);"
                      "glMatrixMode(GL_MODELVIEW);") +
              kRect,
          true, false, true);
    shows(std::string("glActiveTexture(GL_TEXTURE2); glTexGenfv(GL_S, GL_OBJECT_PLANE, (GLfloat[]){0, 0, 0, 0.75});"
                      "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); glEnable(GL_TEXTURE_GEN_S);") +
              kRect,
          true, true, false);
    // From the normal, in both units; the normal (0.75, 0, 0.66) points to the right texel.
    shows(std::string("glNormal3f(0.75, 0, 0.66);"
                      "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_S);"
                      "glActiveTexture(GL_TEXTURE2);"
                      "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_S);") +
              kRect,
          false, true, false);
}

TEST_F(TextureUnits, TakeCoordinatesFromTheirOwnArrays) {
    const std::string start = unit(0, "255, 0, 0, 255", "0, 255, 0, 255") +
                              unit(3, "255, 255, 255, 255", "0, 0, 0, 255") +
                              "GLfloat corners[] = {-1, -1, 1, -1, 1, 1, -1, 1}, zero[] = {0, 0, 0, 0}, far[] = {0.75, "
                              "0.75, 0.75, 0.75};\nglVertexPointer(2, GL_FLOAT, 0, corners); "
                              "glEnableClientState(GL_VERTEX_ARRAY);\nglTexCoordPointer(1, GL_FLOAT, 0, zero); "
                              "glEnableClientState(GL_TEXTURE_COORD_ARRAY);\n";
    const std::string third =
        "glClientActiveTexture(GL_TEXTURE3); glTexCoordPointer(1, GL_FLOAT, 0, far); "
        "glEnableClientState(GL_TEXTURE_COORD_ARRAY);\n";
    for (const std::string draw :
         {"glDrawArrays(GL_QUADS, 0, 4);\n",
          "glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, (GLubyte[]){0, 1, 2, 3});\n",
          "glBegin(GL_QUADS); glArrayElement(0); glArrayElement(1); glArrayElement(2); glArrayElement(3); glEnd();\n",
          "glNewList(1, GL_COMPILE); glDrawArrays(GL_QUADS, 0, 4); glEndList(); glCallList(1);\n"}) {
        EXPECT_EQ(color(start + draw)[0], 1) << draw;
        EXPECT_EQ(color(start + third + draw)[0], 0) << draw;
        EXPECT_EQ(color(start + "glMultiTexCoord1f(GL_TEXTURE3, 0.75);" + draw)[0], 0) << draw;
    }
}

// Vertices of one glBegin with several coordinates each; shapes and evaluators have the current ones.
TEST_F(TextureUnits, InterpolateTheirCoordinates) {
    const std::string two = unit(0, "255, 255, 255, 255", "255, 255, 255, 255") +
                            unit(1, "255, 0, 0, 255", "0, 0, 255, 255") + "glActiveTexture(GL_TEXTURE0);\n";
    std::string text = two + "glBegin(GL_TRIANGLE_STRIP);\n";
    for (const auto& [s, x, y] : {std::array{0, -1, -1}, {1, 1, -1}, {0, -1, 1}, {1, 1, 1}})
        text += fmt::format("glMultiTexCoord1i(GL_TEXTURE1, {}); glVertex2i({}, {});\n", s, x, y);
    EXPECT_EQ(color(text + "glEnd();\n", 5, 5)[0], 1);
    EXPECT_EQ(color(text + "glEnd();\n", 11, 5)[2], 1);
    for (const std::string shape :
         {"glutSolidCube(1.5);", "GLUquadric* q = gluNewQuadric(); gluDisk(q, 0, 1, 8, 1); gluDeleteQuadric(q);"}) {
        EXPECT_EQ(color(two + "glMultiTexCoord1f(GL_TEXTURE1, 0.75);" + shape)[2], 1) << shape;
        EXPECT_EQ(color(two + shape)[0], 1) << shape;
    }
}

TEST_F(TextureUnits, OfOneTextureMayHaveDifferentBiases) {
    const std::string levels =
        "GLubyte red[] = {255,0,0,255, 255,0,0,255, 255,0,0,255, 255,0,0,255}, blue[] = {0,0,255,255};\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, red);\n"
        "glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, blue);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glActiveTexture(GL_TEXTURE1); glEnable(GL_TEXTURE_2D);"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);\n"
        "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 9);\n";
    std::string text = levels + "glBegin(GL_QUADS);\n";
    for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        text += fmt::format("glTexCoord2i({0}, {1}); glMultiTexCoord2i(GL_TEXTURE1, {0}, {1}); glVertex2i({0}, {1});\n",
                            x, y);
    const Rgba found = color(text + "glEnd();\n");
    EXPECT_EQ(found[0], 1);
    EXPECT_EQ(found[2], 1);
    // The next picture has no bias left.
    const Rgba next = color(unit(0, "255, 0, 0, 255", "255, 0, 0, 255") + kRect);
    EXPECT_EQ(next[0], 1);
}

// Any environments of three units.
TEST_F(TextureUnits, AgreeForRandomEnvironments) {
    fuzz::Random random(3813);
    const auto one_of = [&](std::initializer_list<const char*> names) {
        return *(names.begin() + random.below(static_cast<int>(names.size())));
    };
    const auto bytes = [&] {
        return fmt::format("{}, {}, {}, {}", random.below(256), random.below(256), random.below(256),
                           random.below(256));
    };
    const auto numbers = [&] {
        return fmt::format("{:.4f}, {:.4f}, {:.4f}, {:.4f}", random.uniform(0, 1), random.uniform(0, 1),
                           random.uniform(0, 1), random.uniform(0, 1));
    };
    constexpr int kStates = 400, kWithShaders = 10;  // a program takes longer than the rest
    for (int state = 0; state < rounds(kStates); ++state) {
        std::string text = fmt::format("// state {}\n", state);
        for (const int number : {0, 1, 4}) {
            text +=
                unit(number, bytes(), bytes(),
                     one_of({"GL_ALPHA", "GL_LUMINANCE", "GL_LUMINANCE_ALPHA", "GL_INTENSITY", "GL_RGB", "GL_RGBA"}));
            text += constant(numbers());
            if (random.chance(0.3)) {
                text += environment("GL_TEXTURE_ENV_MODE",
                                    one_of({"GL_MODULATE", "GL_REPLACE", "GL_DECAL", "GL_BLEND", "GL_ADD"}));
                continue;
            }
            text += environment("GL_TEXTURE_ENV_MODE", "GL_COMBINE");
            text +=
                environment("GL_COMBINE_RGB", one_of({"GL_REPLACE", "GL_MODULATE", "GL_ADD", "GL_ADD_SIGNED",
                                                      "GL_INTERPOLATE", "GL_SUBTRACT", "GL_DOT3_RGB", "GL_DOT3_RGBA"}));
            text += environment("GL_COMBINE_ALPHA", one_of({"GL_REPLACE", "GL_MODULATE", "GL_ADD", "GL_ADD_SIGNED",
                                                            "GL_INTERPOLATE", "GL_SUBTRACT"}));
            for (int i = 0; i < 3; ++i)
                for (const std::string channel : {"RGB", "ALPHA"}) {
                    text += environment(fmt::format("GL_SRC{}_{}", i, channel).c_str(),
                                        one_of({"GL_TEXTURE", "GL_TEXTURE0", "GL_TEXTURE1", "GL_TEXTURE4",
                                                "GL_CONSTANT", "GL_PRIMARY_COLOR", "GL_PREVIOUS"}));
                    text += environment(fmt::format("GL_OPERAND{}_{}", i, channel).c_str(),
                                        channel == "RGB" ? one_of({"GL_SRC_COLOR", "GL_ONE_MINUS_SRC_COLOR",
                                                                   "GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA"})
                                                         : one_of({"GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA"}));
                }
            text += environment("GL_RGB_SCALE", std::to_string(1 << random.below(3)));
            text += environment("GL_ALPHA_SCALE", std::to_string(1 << random.below(3)));
        }
        text += fmt::format("glColor4f({}); glMultiTexCoord1f(GL_TEXTURE1, {}); glMultiTexCoord1f(GL_TEXTURE4, {});\n",
                            numbers(), random.chance(0.5) ? 0.25 : 0.75, random.chance(0.5) ? 0.25 : 0.75);
        color(text + kRect, 8, 8, state % kWithShaders == 0);
        if (HasFailure()) return;
    }
}

// 3.8.13: the result is undefined, so all that can be done is to say so.
TEST_F(TextureUnits, WithoutATextureCannotBeReadByCombine) {
    const std::string text = unit(0, "255, 0, 0, 255", "0, 0, 0, 0") +
                             environment("GL_TEXTURE_ENV_MODE", "GL_COMBINE") +
                             environment("GL_SRC1_RGB", "GL_TEXTURE1") + kRect;
    const Frame frame = scene_of(text).frame;
    ASSERT_EQ(frame.unsupported.size(), 1u);
    EXPECT_EQ(frame.unsupported[0].name, "glTexEnv(GL_COMBINE) that reads a unit without a texture");
    // A source of an argument that the function lacks does not count.
    EXPECT_TRUE(scene_of(unit(0, "0, 0, 0, 0", "0, 0, 0, 0") + environment("GL_TEXTURE_ENV_MODE", "GL_COMBINE") +
                         environment("GL_SRC2_RGB", "GL_TEXTURE1") + kRect)
                    .frame.unsupported.empty());
}

TEST_F(TextureUnits, ChangeNoProgramOfADrawWithOneTexture) {
    const auto effects = [this](const std::string& text) {
        return plan_effects(*scene_of(text).frame.draws().at(0), PlanOptions{}).effects;
    };
    const std::string one = unit(0, "255, 0, 0, 255", "0, 0, 0, 0");
    EXPECT_TRUE(effects(one + kRect).has_texture());
    EXPECT_TRUE(effects(one + kRect).units.empty());
    EXPECT_FALSE(effects(one + unit(1, "0, 0, 0, 0", "0, 0, 0, 0") + kRect).has_texture());
    EXPECT_EQ(effects(one + unit(1, "0, 0, 0, 0", "0, 0, 0, 0") + kRect).units.size(), 2u);
    // Another source of an argument that GL_REPLACE does not have needs no other program.
    const std::string replace =
        one + environment("GL_TEXTURE_ENV_MODE", "GL_COMBINE") + environment("GL_COMBINE_RGB", "GL_REPLACE");
    EXPECT_EQ(effects(replace + kRect), effects(replace + environment("GL_SRC1_RGB", "GL_CONSTANT") + kRect));
    EXPECT_NE(effects(replace + kRect), effects(replace + environment("GL_SRC0_RGB", "GL_CONSTANT") + kRect));
}

TEST(TextureUnitErrors, AreThoseOfGl) {
    const auto error_of = [](const std::string& text) {
        State state;
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
        return state.errors().empty() ? Enum{kGL_NO_ERROR} : state.errors().front().code;
    };
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGBA);"), kGL_NO_ERROR);
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGBA);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE7);"), kGL_NO_ERROR);
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE7 + 1);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error_of("glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 3);"), kGL_INVALID_VALUE);
    EXPECT_EQ(error_of("glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 4);"), kGL_NO_ERROR);
    EXPECT_EQ(error_of("glMultiTexCoord1f(GL_TEXTURE7 + 1, 0);"), kGL_INVALID_ENUM);
}

}  // namespace
}  // namespace twinlight::texture_units_test

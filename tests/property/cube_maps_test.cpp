// Cube maps (3.8.7, 2.11.4): the driver, the shaders and the reference find the same face and the same texel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "../unit/compare_three_ways.h"
#include "../unit/one_pixel.h"
#include "render/reference/textures/texture.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::cube_maps_test {
namespace {

class CubeMaps : public OnePixel {
  protected:
    // The red code at a pixel (y up).
    int red(const std::string& text, int x = 8, int y = 8) { return channel_code(color(text, x, y)[0]); }
};

const char* const kFaces[] = {"POSITIVE_X", "NEGATIVE_X", "POSITIVE_Y", "NEGATIVE_Y", "POSITIVE_Z", "NEGATIVE_Z"};

// Faces of 2 x 2 texels: those of face f have the codes 40 f, 40 f + 10, 40 f + 20 and 40 f + 30, in rows.
std::string faces(int size = 2) {
    std::string text =
        "glEnable(GL_TEXTURE_CUBE_MAP); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glPixelStorei(GL_UNPACK_ALIGNMENT, 1);\n";
    for (const char* filter : {"MIN", "MAG"})
        text += fmt::format("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_{}_FILTER, GL_NEAREST);\n", filter);
    for (int f = 0; f < 6; ++f) {
        std::string texels;
        for (int i = 0; i < size * size; ++i) texels += fmt::format("{}{}", i ? "," : "", 40 * f + 10 * i);
        text += fmt::format(
            "glTexImage2D(GL_TEXTURE_CUBE_MAP_{}, 0, GL_LUMINANCE, {}, {}, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, "
            "(GLubyte[]){{{}}});\n",
            kFaces[f], size, size, texels);
    }
    return text;
}

std::string shown(double s, double t, double r) {
    return fmt::format("glTexCoord3f({}, {}, {}); glRectf(-1, -1, 1, 1);\n", s, t, r);
}

// Table 3.21, written out.
TEST_F(CubeMaps, ShowTheFaceAndTheTexelOfADirection) {
    struct Direction {
        double s, t, r;
        int code;
    };
    const Direction directions[] = {
        {1, 0.5, 0.5, 0},     {1, 0.5, -0.5, 10},   {1, -0.5, 0.5, 20},   {1, -0.5, -0.5, 30},   {-1, 0.5, -0.5, 40},
        {-1, 0.5, 0.5, 50},   {-1, -0.5, -0.5, 60}, {-1, -0.5, 0.5, 70},  {-0.5, 1, -0.5, 80},   {0.5, 1, -0.5, 90},
        {-0.5, 1, 0.5, 100},  {0.5, 1, 0.5, 110},   {-0.5, -1, 0.5, 120}, {0.5, -1, 0.5, 130},   {-0.5, -1, -0.5, 140},
        {0.5, -1, -0.5, 150}, {-0.5, 0.5, 1, 160},  {0.5, 0.5, 1, 170},   {-0.5, -0.5, 1, 180},  {0.5, -0.5, 1, 190},
        {0.5, 0.5, -1, 200},  {-0.5, 0.5, -1, 210}, {0.5, -0.5, -1, 220}, {-0.5, -0.5, -1, 230},
    };
    for (const Direction& d : directions) EXPECT_EQ(red(faces() + shown(d.s, d.t, d.r)), d.code);
    for (const Direction& d : directions)  // the length of a direction does not matter
        EXPECT_EQ(red(faces() + shown(7 * d.s, 7 * d.t, 7 * d.r)), d.code);
}

TEST_F(CubeMaps, TakePrecedenceOverTwoDimensions) {
    const std::string flat =
        "GLubyte one[] = {9, 9, 9, 9}; glEnable(GL_TEXTURE_2D); glTexImage2D(GL_TEXTURE_2D, 0, "
        "GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, one);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n";
    EXPECT_EQ(red(flat + faces() + shown(1, 0.5, 0.5)), 0);
    EXPECT_EQ(red(flat + faces() + "glDisable(GL_TEXTURE_CUBE_MAP);\n" + shown(1, 0.5, 0.5)), 9);
}

TEST_F(CubeMaps, WithFacesOfDifferentSizesAreIncomplete) {
    const std::string other =
        "glTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, "
        "GL_UNSIGNED_BYTE, (GLubyte[]){9});\n";
    EXPECT_EQ(red(faces() + other + "glColor3f(0.2, 0, 0);\n" + shown(1, 0.5, 0.5)), 51);
}

TEST_F(CubeMaps, FollowNormalsAndReflections) {
    const auto generated = [&](const char* mode, double x, double y, double z) {
        std::string text = faces(1);
        for (const char coordinate : std::string_view("STR"))
            text += fmt::format("glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, {1}); glEnable(GL_TEXTURE_GEN_{0});\n",
                                coordinate, mode);
        return red(text + fmt::format("glNormal3f({}, {}, {}); glRectf(-1, -1, 1, 1);\n", x, y, z));
    };
    EXPECT_EQ(generated("GL_NORMAL_MAP", 0.6, 0, 0.5), 0);
    EXPECT_EQ(generated("GL_NORMAL_MAP", -0.6, 0, 0.5), 40);
    EXPECT_EQ(generated("GL_NORMAL_MAP", 0, -0.6, 0.5), 120);
    EXPECT_EQ(generated("GL_NORMAL_MAP", 0, 0.1, 0.8), 160);
    EXPECT_EQ(generated("GL_NORMAL_MAP", 0, 0.1, -0.8), 200);
}

TEST_F(CubeMaps, HaveMipmapsAndParts) {
    const std::string setup = "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_TRUE);\n" + faces() +
                              "glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BASE_LEVEL, 1);\n";
    EXPECT_EQ(red(setup + shown(1, 0.5, 0.5)), 15);  // the mean of 0, 10, 20 and 30
    EXPECT_EQ(red(setup + shown(0.5, 0.5, 1)), 175);
    const std::string part =
        "glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, 1, 0, 1, 1, GL_LUMINANCE, "
        "GL_UNSIGNED_BYTE, (GLubyte[]){250});\n";
    EXPECT_EQ(red(faces() + part + shown(0.5, 1, -0.5)), 250);
    EXPECT_EQ(red(faces() + part + shown(-0.5, 1, -0.5)), 80);
}

TEST_F(CubeMaps, CopyThePicture) {
    const std::string copy =
        "glClearColor(0.4, 0, 0, 1); glClear(GL_COLOR_BUFFER_BIT); "
        "glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, GL_LUMINANCE, 3, 3, 2, 2, 0);\n"
        "glCopyTexSubImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_X, 0, 1, 0, 3, 3, 1, 1);\n";
    EXPECT_EQ(red(faces() + copy + shown(0.5, -1, 0.5)), 102);
    EXPECT_EQ(red(faces() + copy + shown(-1, 0.5, 0.5)), 102);
    EXPECT_EQ(red(faces() + copy + shown(-1, 0.5, -0.5)), 40);
}

TEST_F(CubeMaps, InTheSecondUnitAreCombined) {
    const std::string first = "glColor3f(1, 1, 1); glActiveTexture(GL_TEXTURE1);\n" + faces() +
                              "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);\n";
    EXPECT_EQ(red(first + "glColor3f(0.5, 0, 0); glMultiTexCoord3f(GL_TEXTURE1, 0.5, -0.5, -1); "
                          "glRectf(-1, -1, 1, 1);\n"),
              110);
}

// Errors of images: table 3.20's targets, and square sides.
TEST_F(CubeMaps, HaveErrors) {
    const auto code = [](const std::string& text) {
        State state({.width = kSide, .height = kSide});
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
        return state.errors().empty() ? Enum{kGL_NO_ERROR} : state.errors().front().code;
    };
    const auto image = [](const char* target, int width, int height) {
        return fmt::format("glTexImage2D({}, 0, GL_RGB, {}, {}, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);", target, width,
                           height);
    };
    EXPECT_EQ(code(image("GL_TEXTURE_CUBE_MAP_POSITIVE_X", 4, 4)), kGL_NO_ERROR);
    EXPECT_EQ(code(image("GL_PROXY_TEXTURE_CUBE_MAP", 4, 4)), kGL_NO_ERROR);
    EXPECT_EQ(code(image("GL_TEXTURE_CUBE_MAP", 4, 4)), kGL_INVALID_ENUM);
    EXPECT_EQ(code(image("GL_TEXTURE_CUBE_MAP_POSITIVE_X", 4, 2)), kGL_INVALID_VALUE);
    EXPECT_EQ(code("glTexImage1D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGB, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);"),
              kGL_INVALID_ENUM);
    EXPECT_EQ(code("glBindTexture(GL_TEXTURE_2D, 1); glBindTexture(GL_TEXTURE_CUBE_MAP, 1);"), kGL_INVALID_OPERATION);
    EXPECT_EQ(code("glBindTexture(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 1);"), kGL_INVALID_ENUM);
}

// The derivative of the place on a face is the limit of differences.
TEST(CubePlaces, AreOnTheFaceOfTheLargestCoordinate) {
    using namespace reference;
    EXPECT_EQ(cube_place({3, 1, -2}).face, 0u);
    EXPECT_EQ(cube_place({-3, 1, -2}).face, 1u);
    EXPECT_EQ(cube_place({1, 3, -2}).face, 2u);
    EXPECT_EQ(cube_place({1, -3, -2}).face, 3u);
    EXPECT_EQ(cube_place({1, 2, 3}).face, 4u);
    EXPECT_EQ(cube_place({1, 2, -3}).face, 5u);
    const CubePlace place = cube_place({4, 1, -2});
    EXPECT_DOUBLE_EQ(place.st.x, 0.75);   // (2 / 4 + 1) / 2
    EXPECT_DOUBLE_EQ(place.st.y, 0.375);  // (-1 / 4 + 1) / 2
}

}  // namespace
}  // namespace twinlight::cube_maps_test

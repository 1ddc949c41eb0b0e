// Textures of three dimensions (3.8.1, 3.8.7 to 3.8.9): the driver, the shaders and the reference find the same texels.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "../unit/one_pixel.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::volumes_test {
namespace {

class Volumes : public OnePixel {
  protected:
    // The red code at a pixel (y up).
    int red(const std::string& text, int x = 8, int y = 8) { return codes(text, x, y)[0]; }
};

std::string parameter(const char* pname, const char* value) {
    return fmt::format("glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_{}, {});\n", pname, value);
}

std::string filters(const char* min, const char* mag) {
    return parameter("MIN_FILTER", min) + parameter("MAG_FILTER", mag);
}

const std::string kEnabled = "glEnable(GL_TEXTURE_3D); glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n" +
                             filters("GL_NEAREST", "GL_NEAREST");

std::string image(int width, int height, int depth, const std::string& codes, int level = 0) {
    return fmt::format(
        "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glTexImage3D(GL_TEXTURE_3D, {}, GL_LUMINANCE, {}, {}, {}, 0, "
        "GL_LUMINANCE, "
        "GL_UNSIGNED_BYTE, (GLubyte[]){{{}}});\n",
        level, width, height, depth, codes);
}

// 2 x 2 x 2 texels: texel i, j, k has the code 10 + 20 i + 40 j + 80 k.
const std::string kEight = kEnabled + image(2, 2, 2, "10, 30, 50, 70, 90, 110, 130, 150");

std::string shown(double s, double t, double r) {
    return fmt::format("glTexCoord3f({}, {}, {}); glRectf(-1, -1, 1, 1);\n", s, t, r);
}

TEST_F(Volumes, ShowTheTexelAtAPlace) {
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const int code = 10 + 20 * i + 40 * j + 80 * k;
                const double s = 0.2 + 0.5 * i, t = 0.3 + 0.5 * j, r = 0.1 + 0.5 * k;
                EXPECT_EQ(red(kEight + shown(s, t, r)), code);
                EXPECT_EQ(red(kEight + fmt::format("glTexCoord4f({}, {}, {}, 4); glRectf(-1, -1, 1, 1);\n", 4 * s,
                                                   4 * t, 4 * r)),
                          code);
            }
}

TEST_F(Volumes, MixEightTexelsByALinearFilter) {
    const std::string linear = kEight + filters("GL_LINEAR", "GL_LINEAR");
    EXPECT_EQ(red(linear + shown(0.5, 0.5, 0.5)), 80);
    EXPECT_EQ(red(linear + shown(0.25, 0.25, 0.5)), 50);    // between 10 and 90
    EXPECT_EQ(red(linear + shown(0.375, 0.75, 0.25)), 55);  // a quarter of the way from 50 to 70
}

// Two layers of 40 and 200, and a border of 204.
TEST_F(Volumes, WrapR) {
    struct Case {
        const char* wrap;
        int nearest_below, nearest_above;  // r = -0.3 and 1.2
        int linear_at_0, linear_far;       // r = 0 and 5
    };
    const Case cases[] = {{"GL_REPEAT", 200, 40, 120, 120},
                          {"GL_CLAMP", 40, 200, 122, 202},
                          {"GL_CLAMP_TO_EDGE", 40, 200, 40, 200},
                          {"GL_CLAMP_TO_BORDER", 204, 204, 122, 204},
                          {"GL_MIRRORED_REPEAT", 40, 200, 40, 200}};
    for (const Case& c : cases) {
        const std::string text =
            kEnabled + image(1, 1, 2, "40, 200") + parameter("WRAP_R", c.wrap) +
            "glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, (GLfloat[]){0.8, 0, 0, 0});\n";
        const std::string linear = text + filters("GL_LINEAR", "GL_LINEAR");
        EXPECT_EQ(red(text + shown(0.5, 0.5, -0.3)), c.nearest_below) << c.wrap;
        EXPECT_EQ(red(text + shown(0.5, 0.5, 1.2)), c.nearest_above) << c.wrap;
        EXPECT_EQ(red(linear + shown(0.5, 0.5, 0)), c.linear_at_0) << c.wrap;
        EXPECT_EQ(red(linear + shown(0.5, 0.5, 5)), c.linear_far) << c.wrap;
    }
}

// Each level has its own code. r alone changes, from 0 to `last` across 16 pixels: rho is 64 last / 16.
TEST_F(Volumes, FindTheLevelOfDetailWithThreeCoordinates) {
    std::string levels = kEnabled + filters("GL_NEAREST_MIPMAP_NEAREST", "GL_NEAREST");
    for (int level = 0, depth = 64; depth > 0; ++level, depth /= 2) {
        std::string codes;
        for (int k = 0; k < depth; ++k) codes += fmt::format("{}{}", k ? "," : "", 20 * level + 10);
        levels += image(1, 1, depth, codes, level);
    }
    const auto across = [](double last) {
        return fmt::format(
            "glBegin(GL_QUADS); glTexCoord3f(0.5, 0.5, 0); glVertex2f(-1, -1); glTexCoord3f(0.5, 0.5, {0}); "
            "glVertex2f(1, -1); glVertex2f(1, 1); glTexCoord3f(0.5, 0.5, 0); glVertex2f(-1, 1); glEnd();\n",
            last);
    };
    EXPECT_EQ(red(levels + across(0.2)), 10);
    EXPECT_EQ(red(levels + across(0.5)), 30);
    EXPECT_EQ(red(levels + across(2)), 70);
    EXPECT_EQ(red(levels + across(16)), 130);
    EXPECT_EQ(red(levels + parameter("MAX_LEVEL", "2") + across(16)), 50);
}

TEST_F(Volumes, HaveMipmaps) {
    const std::string small = parameter("BASE_LEVEL", "1") + shown(0.5, 0.5, 0.5);
    EXPECT_EQ(red("glTexParameteri(GL_TEXTURE_3D, GL_GENERATE_MIPMAP, GL_TRUE);\n" + kEight + small), 80);
    const std::string built =
        "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); gluBuild3DMipmaps(GL_TEXTURE_3D, GL_LUMINANCE, 2, 2, 2, GL_LUMINANCE, "
        "GL_UNSIGNED_BYTE, (GLubyte[]){10, 30, 50, 70, 90, 110, 130, 150});\n";
    EXPECT_EQ(red(kEnabled + built + small), 80);
    EXPECT_EQ(red(kEnabled + built + shown(0.7, 0.7, 0.7)), 150);
    // A level is missing: the texture is incomplete.
    EXPECT_EQ(red(kEight + filters("GL_LINEAR_MIPMAP_LINEAR", "GL_LINEAR") + "glColor3f(0.2, 0, 0);\n" +
                  shown(0.5, 0.5, 0.5)),
              51);
}

// 3.8.1: images of 4 rows, of which the texture takes 2 x 1 texels of 2 images, after one image, one row and one pixel.
TEST_F(Volumes, SkipImagesInMemory) {
    std::string codes;
    for (int i = 0; i < 4 * 3 * 3; ++i) codes += fmt::format("{}{}", i ? "," : "", i);
    const std::string text = kEnabled +
                             "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);\n"
                             "glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 4); glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1);\n"
                             "glPixelStorei(GL_UNPACK_SKIP_ROWS, 1); glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1);\n" +
                             image(2, 1, 2, codes);
    EXPECT_EQ(red(text + shown(0.2, 0.5, 0.2)), 12 + 3 + 1);
    EXPECT_EQ(red(text + shown(0.7, 0.5, 0.7)), 24 + 3 + 2);
    // They do not concern an image of two dimensions.
    const std::string flat =
        "glDisable(GL_TEXTURE_3D); glEnable(GL_TEXTURE_2D); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, "
        "GL_NEAREST);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){0, 0, 0, 0, "
        "99});\n";
    EXPECT_EQ(red(text + flat + shown(0.5, 0.5, 0.5)), 99);
}

TEST_F(Volumes, HaveParts) {
    const std::string part =
        "glTexSubImage3D(GL_TEXTURE_3D, 0, 1, 0, 0, 1, 1, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){250, 240});\n";
    EXPECT_EQ(red(kEight + part + shown(0.7, 0.2, 0.2)), 250);
    EXPECT_EQ(red(kEight + part + shown(0.7, 0.2, 0.7)), 240);
    EXPECT_EQ(red(kEight + part + shown(0.2, 0.2, 0.7)), 90);
}

TEST_F(Volumes, CopyThePictureToALayer) {
    const std::string copy_of =
        "glClear(GL_COLOR_BUFFER_BIT); glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 1, 1, 3, 3, 2, 1);\n";
    const std::string copy = "glClearColor(0.4, 0, 0, 1); " + copy_of;
    EXPECT_EQ(red(kEight + copy + shown(0.2, 0.7, 0.7)), 102);
    EXPECT_EQ(red(kEight + copy + shown(0.7, 0.7, 0.7)), 102);
    EXPECT_EQ(red(kEight + copy + shown(0.7, 0.2, 0.7)), 110);
    EXPECT_EQ(red(kEight + copy + shown(0.7, 0.7, 0.2)), 70);
    // A mipmap of the copied texels and the others, and a part over them.
    const std::string mipmaps = "glTexParameteri(GL_TEXTURE_3D, GL_GENERATE_MIPMAP, GL_TRUE);\n" + kEight +
                                "glClearColor(0.8, 0, 0, 1); " + copy_of;
    EXPECT_EQ(red(mipmaps + parameter("BASE_LEVEL", "1") + shown(0.5, 0.5, 0.5)), 96);  // (360 + 408) / 8
    const std::string part =
        "glTexSubImage3D(GL_TEXTURE_3D, 0, 1, 1, 0, 1, 1, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){250, 240});\n";
    EXPECT_EQ(red(kEight + copy + part + shown(0.7, 0.7, 0.7)), 240);
    EXPECT_EQ(red(kEight + copy + part + shown(0.2, 0.7, 0.7)), 102);
}

TEST_F(Volumes, TakePrecedenceOverTwoDimensionsAndGiveItToCubeMaps) {
    const auto one_texel = [](const char* target, const char* parameters, int code) {
        return fmt::format(
            "glEnable({1}); glTexParameteri({1}, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glTexImage2D({0}, 0, "
            "GL_LUMINANCE, 1, 1, 0, "
            "GL_LUMINANCE, GL_UNSIGNED_BYTE, (GLubyte[]){{{2}, 0, 0, 0}});\n",
            target, parameters, code);
    };
    const std::string flat = one_texel("GL_TEXTURE_2D", "GL_TEXTURE_2D", 9);
    std::string cube;
    for (const char* face : {"POSITIVE_X", "NEGATIVE_X", "POSITIVE_Y", "NEGATIVE_Y", "POSITIVE_Z", "NEGATIVE_Z"})
        cube += one_texel(fmt::format("GL_TEXTURE_CUBE_MAP_{}", face).c_str(), "GL_TEXTURE_CUBE_MAP", 7);
    EXPECT_EQ(red(flat + kEight + shown(0.2, 0.2, 0.2)), 10);
    EXPECT_EQ(red(flat + kEight + "glDisable(GL_TEXTURE_3D);\n" + shown(0.2, 0.2, 0.2)), 9);
    EXPECT_EQ(red(flat + kEight + cube + shown(0.2, 0.2, 0.2)), 7);
}

TEST_F(Volumes, TakeGeneratedCoordinates) {
    std::string generated;
    for (const char coordinate : std::string_view("STR"))
        generated += fmt::format(
            "glTexGeni(GL_{0}, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); glEnable(GL_TEXTURE_GEN_{0});\n", coordinate);
    generated +=
        "glTexGenfv(GL_S, GL_OBJECT_PLANE, (GLfloat[]){0, 0, 0, 0.2}); glTexGenfv(GL_T, GL_OBJECT_PLANE, "
        "(GLfloat[]){0, 0, 0, "
        "0.7});\nglTexGenfv(GL_R, GL_OBJECT_PLANE, (GLfloat[]){0.5, 0, 0, 0.5});\n";
    EXPECT_EQ(red(kEight + generated + "glRectf(-1, -1, 1, 1);\n", 2), 50);
    EXPECT_EQ(red(kEight + generated + "glRectf(-1, -1, 1, 1);\n", 13), 130);
}

TEST_F(Volumes, InTheSecondUnitAreCombined) {
    const std::string second = "glColor3f(1, 1, 1); glActiveTexture(GL_TEXTURE1);\n" + kEight +
                               "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);\n";
    EXPECT_EQ(red(second + "glColor3f(0.5, 0, 0); glMultiTexCoord3f(GL_TEXTURE1, 0.7, 0.2, 0.7); "
                           "glRectf(-1, -1, 1, 1);\n"),
              55);
}

State applied(const std::string& text) {
    State state({.width = kSide, .height = kSide});
    for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
    return state;
}

TEST_F(Volumes, HaveErrors) {
    const auto code = [](const std::string& text) {
        const State state = applied(text);
        return state.errors().empty() ? Enum{kGL_NO_ERROR} : state.errors().front().code;
    };
    const auto null_image = [](const char* target, int level, int width, int height, int depth, int border = 0) {
        return fmt::format("glTexImage3D({}, {}, GL_RGB, {}, {}, {}, {}, GL_RGB, GL_UNSIGNED_BYTE, NULL);", target,
                           level, width, height, depth, border);
    };
    const char* const target = "GL_TEXTURE_3D";
    EXPECT_EQ(code(null_image(target, 0, 4, 2, 3)), kGL_NO_ERROR);
    EXPECT_EQ(code(null_image("GL_PROXY_TEXTURE_3D", 0, 4, 2, 3)), kGL_NO_ERROR);
    EXPECT_EQ(code(null_image("GL_TEXTURE_2D", 0, 4, 2, 3)), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glTexImage2D(GL_TEXTURE_3D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL);"),
              kGL_INVALID_ENUM);
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_3D, 0, GL_RGB, 0, 0, 4, 4, 0);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code(null_image(target, 0, 4, 4, -1)), kGL_INVALID_VALUE);
    EXPECT_EQ(code(null_image(target, 0, 1, 1, 2049)), kGL_INVALID_VALUE);
    EXPECT_EQ(code(null_image(target, 12, 1, 1, 1)), kGL_INVALID_VALUE);
    EXPECT_EQ(code(null_image(target, 0, 4, 4, 4, 2)), kGL_INVALID_VALUE);
    EXPECT_EQ(code(null_image(target, 0, 2048, 2048, 2048)), kGL_OUT_OF_MEMORY);
    EXPECT_EQ(
        code("glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 2, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);"),
        kGL_INVALID_OPERATION);
    const auto part = [](int z, int depth) {
        return image(2, 2, 2, "0,0,0,0,0,0,0,0") +
               fmt::format(
                   "glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, {}, 1, 1, {}, GL_LUMINANCE, GL_UNSIGNED_BYTE, NULL);", z,
                   depth);
    };
    EXPECT_EQ(code(part(0, 2)), kGL_NO_ERROR);
    EXPECT_EQ(code(part(1, 2)), kGL_INVALID_VALUE);
    EXPECT_EQ(code(part(-1, 1)), kGL_INVALID_VALUE);
    const std::string copy = "glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 2, 0, 0, 1, 1);";
    EXPECT_EQ(code(copy), kGL_INVALID_OPERATION);
    EXPECT_EQ(code(image(2, 2, 2, "0,0,0,0,0,0,0,0") + copy), kGL_INVALID_VALUE);
    EXPECT_EQ(code("glBindTexture(GL_TEXTURE_2D, 1); glBindTexture(GL_TEXTURE_3D, 1);"), kGL_INVALID_OPERATION);
    // Too few bytes for the second image.
    EXPECT_EQ(code(image(2, 2, 2, "0,0,0,0,0,0,0")), kGL_INVALID_OPERATION);
}

TEST_F(Volumes, LoseTheirBorder) {
    std::string codes;
    for (int i = 0; i < 3 * 3 * 4; ++i) codes += fmt::format("{}{}", i ? "," : "", i);
    const State state = applied(
        "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glTexImage3D(GL_TEXTURE_3D, 0, GL_LUMINANCE, 3, 3, 4, 1, GL_LUMINANCE, "
        "GL_UNSIGNED_BYTE, (GLubyte[]){" +
        codes + "});");
    const TextureImage& level = state.bound_texture(kGL_TEXTURE_3D).levels.at(0);
    EXPECT_EQ(level.width, 1);
    EXPECT_EQ(level.height, 1);
    ASSERT_EQ(level.depth, 2);
    EXPECT_FLOAT_EQ(255 * level.texel(0, 0, 0).r, 9 + 4);
    EXPECT_FLOAT_EQ(255 * level.texel(0, 0, 1).r, 18 + 4);
}

}  // namespace
}  // namespace twinlight::volumes_test

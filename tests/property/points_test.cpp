// The size of points (3.3) and point sprites (3.3.1): the driver's fixed function, the shaders and the reference draw the same
// squares with the same texture coordinates.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../unit/all_renderers.h"
#include "scene/state/answers.h"

namespace twinlight::points_test {
namespace {

constexpr int kSide = 64;

class Points : public AllRenderers {
  protected:
    Points() : AllRenderers(kSide) {}

    std::vector<Picture> pictures_of(const std::string& text) {
        const Scene scene = scene_of(text);
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        return pictures(scene);
    }
    // How many pixels wide the only square is that is not black, which all renderers must agree on.
    int width(const std::string& text) {
        int expected = -1;
        for (const auto& [name, image] : pictures_of(text)) {
            const auto lit = std::ranges::count_if(image.pixels, [](const Rgba& pixel) { return pixel[1] > 0; });
            const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(lit))));
            EXPECT_EQ(side * side, lit) << name << "\n" << text;
            if (expected < 0) expected = side;
            EXPECT_EQ(side, expected) << name << "\n" << text;
        }
        return expected;
    }
    // The codes of red and green at a pixel, y up, which all renderers must agree on to `tolerance`.
    std::pair<int, int> color(const std::string& text, int x, int y, int tolerance = 0) {
        std::optional<Rgba> expected;
        for (const auto& [name, image] : pictures_of(text)) {
            const Rgba& found = image.at(x, kSide - 1 - y);
            if (!expected) expected = found;
            for (std::size_t i = 0; i < 2; ++i)
                EXPECT_NEAR(channel_code(found[i]), channel_code((*expected)[i]), tolerance) << name << "\n" << text;
        }
        return {channel_code((*expected)[0]), channel_code((*expected)[1])};
    }
};

// Object coordinates are those of the window; z reaches from 100 to -100.
constexpr const char* kWindow =
    "glMatrixMode(GL_PROJECTION); glOrtho(0, 64, 0, 64, -100, 100); glMatrixMode(GL_MODELVIEW);\n";
// Beside the grid of 1/2 pixel, where rounding decides. (0, 0, 0) of object coordinates is the eye.
std::string point(double x, double y, double z = 0) {
    return fmt::format("glBegin(GL_POINTS); glVertex3f({}, {}, {}); glEnd();\n", x, y, z);
}

std::string attenuated(double a, double b, double c) {
    return fmt::format("glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (GLfloat[]){{{}, {}, {}}});\n", a, b, c);
}

std::string limits(double low, double high) {
    return fmt::format("glPointParameterf(GL_POINT_SIZE_MIN, {}); glPointParameterf(GL_POINT_SIZE_MAX, {});\n", low,
                       high);
}

TEST_F(Points, AreNoSmallerAndNoLargerThanTheirLimits) {
    const std::string at = point(32.3, 32.2);
    EXPECT_EQ(width(kWindow + limits(6, 11) + "glPointSize(2);" + at), 6);
    EXPECT_EQ(width(kWindow + limits(6, 11) + "glPointSize(8);" + at), 8);
    EXPECT_EQ(width(kWindow + limits(6, 11) + "glPointSize(30);" + at), 11);
    EXPECT_EQ(width(kWindow + limits(0, 1000) + "glPointSize(30);" + at), 30);
}

// By hand: the root of 1 / (a + b d + c d^2). On the axis of the eye, where d is |z|.
TEST_F(Points, AreAsLargeAsTheirDistanceSays) {
    const std::string axis =
        "glMatrixMode(GL_PROJECTION); glOrtho(-31.7, 32.3, -31.8, 32.2, -100, 100); glMatrixMode(GL_MODELVIEW);\n";
    const auto at = [&](double z, const std::string& state) { return width(axis + state + point(0, 0, z)); };
    EXPECT_EQ(at(-10, attenuated(0, 0, 1) + "glPointSize(200);"), 20);
    EXPECT_EQ(at(-40, attenuated(0, 0, 1) + "glPointSize(200);"), 5);
    EXPECT_EQ(at(40, attenuated(0, 0, 1) + "glPointSize(200);"), 5);  // behind the eye
    EXPECT_EQ(at(-9, attenuated(0, 1, 0) + "glPointSize(21);"), 7);
    EXPECT_EQ(at(-3, attenuated(1, 2, 1) + "glPointSize(24);"), 6);
    EXPECT_EQ(at(-3, attenuated(4, 0, 0) + "glPointSize(24);"), 12);
    EXPECT_EQ(at(-3, attenuated(0, 0, 0) + limits(0, 40) + "glPointSize(24);"), 40);
    EXPECT_EQ(at(-40, attenuated(0, 0, 1) + limits(13, 50) + "glPointSize(200);"), 13);
    EXPECT_EQ(at(-3, attenuated(0, 0, 1) + limits(1, 17) + "glPointSize(200);"), 17);
    // The modelview matrix counts, and in a list of points each has its own size.
    EXPECT_EQ(at(-5, attenuated(0, 0, 1) + "glPointSize(200); glTranslatef(0, 0, -5);"), 20);
}

// RULING: where the limits are in the wrong order, the smallest size counts.
TEST_F(Points, HaveALeastSizeAboveTheLargest) {
    EXPECT_EQ(width(kWindow + limits(20, 10) + "glPointSize(15);" + point(32.3, 32.2)), 20);
}

// The corners are 20, 28.4 and 28.4 away: squares of 10, 7 and 7 pixels. Only in the driver's fixed function all have 10, a known
// bug.
TEST_F(Points, OfPolygonsHaveSizesByDistanceToo) {
    const Scene scene =
        scene_of("glMatrixMode(GL_PROJECTION); glOrtho(-32, 32, -32, 32, -100, 100); glMatrixMode(GL_MODELVIEW);\n" +
                 attenuated(0, 0, 1) +
                 "glPointSize(200); glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);\n"
                 "glBegin(GL_TRIANGLES); glVertex3f(0.3, 0.2, -20); glVertex3f(0.3, 20.2, -20); glVertex3f(20.3, 0.2, "
                 "-20); glEnd();\n");
    for (const Image& picture : {reference::render(scene.frame, {}), renderer_.render(scene.frame, {})})
        EXPECT_EQ(std::ranges::count_if(picture.pixels, [](const Rgba& pixel) { return pixel[1] > 0; }),
                  10 * 10 + 7 * 7 + 7 * 7);
}

// ---- Sprites ----

// Red is s, green is t, in 256 steps.
std::string sprite(const std::string& state, double size = 8) {
    std::string ramp;
    for (int t = 0; t < 16; ++t)
        for (int s = 0; s < 16; ++s) ramp += fmt::format("{}{}, {}, 0, 255", ramp.empty() ? "" : ",", 17 * s, 17 * t);
    return fmt::format(
        "{}GLubyte ramp[] = {{{}}}; glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
        "ramp);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); "
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); glEnable(GL_POINT_SPRITE);\n"
        "glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE); glPointSize({});\n{}",
        kWindow, ramp, size, state);
}

// Equation 3.1 at (28.5, 30.5) around (32.3, 32.2): s = 1/2 - 3.8/8 and t = 1/2 - 1.7/8, or t = 1/2 + 1.7/8 downwards.
TEST_F(Points, AsSpritesHaveCoordinatesFrom0To1) {
    using Color = std::pair<int, int>;
    const std::string at = point(32.3, 32.2),
                      lower = "glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);\n";
    EXPECT_EQ(color(sprite(at), 28, 30), Color(17 * 0, 17 * 11));
    EXPECT_EQ(color(sprite(lower + at), 28, 30), Color(17 * 0, 17 * 4));
    EXPECT_EQ(color(sprite(at), 35, 35), Color(17 * 14, 17 * 1));
    EXPECT_EQ(color(sprite(lower + at), 35, 35), Color(17 * 14, 17 * 14));
}

TEST_F(Points, AsSpritesNeedNoTextureMatrixAndNoVertexCoordinates) {
    using Color = std::pair<int, int>;
    const std::string at = point(32.3, 32.2);
    EXPECT_EQ(color(sprite("glTexCoord2f(0.9, 0.9);" + at), 28, 30), Color(0, 17 * 11));
    EXPECT_EQ(
        color(sprite("glMatrixMode(GL_TEXTURE); glScalef(0.3, 0.2, 1); glMatrixMode(GL_MODELVIEW);" + at), 28, 30),
        Color(0, 17 * 11));
    EXPECT_EQ(color(sprite("glEnable(GL_TEXTURE_GEN_S);" + at), 28, 30), Color(0, 17 * 11));
    const std::string off = "glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_FALSE);\n";
    EXPECT_EQ(color(sprite(off + "glTexCoord2f(0.9, 0.3);" + at), 28, 30), Color(17 * 14, 17 * 4));
    // Without sprites it does not count.
    EXPECT_EQ(color(sprite("glDisable(GL_POINT_SPRITE); glTexCoord2f(0.9, 0.3);" + at), 28, 30),
              Color(17 * 14, 17 * 4));
}

// 3.3.1: a square of any size, whose fragments are those with their centre in it.
TEST_F(Points, AsSpritesAreSquaresOfAnySize) {
    const auto side = [&](double size, double at) {
        return width(kWindow + std::string("glEnable(GL_POINT_SPRITE); ") + fmt::format("glPointSize({});", size) +
                     point(at, at));
    };
    EXPECT_EQ(side(2.3, 32.05), 2);  // from 30.9 to 33.2
    EXPECT_EQ(side(2.7, 32.05), 2);  // from 30.7 to 33.4
    EXPECT_EQ(side(2.7, 32.4), 3);   // from 31.05 to 33.75
    EXPECT_EQ(side(3.3, 32.05), 4);  // from 30.4 to 33.7
    EXPECT_EQ(side(8, 32.3), 8);
}

// In the driver's fixed function they lose theirs, a known bug.
TEST_F(Points, AsSpritesLeaveTheCoordinatesOfOtherPrimitives) {
    const Scene scene = scene_of(sprite("glTexCoord2f(0.9, 0.3); glRectf(0, 0, 64, 64);"));
    for (const Image& picture : {reference::render(scene.frame, {}), renderer_.render(scene.frame, {})}) {
        EXPECT_EQ(channel_code(picture.at(28, 30)[0]), 17 * 14);
        EXPECT_EQ(channel_code(picture.at(28, 30)[1]), 17 * 4);
    }
    fixed::Replay(scene.frame, {}).draw();  // with the state that counts for each Draw
    EXPECT_EQ(channel_code(read_pixels(kSide, kSide).at(28, 30)[0]), 17 * 14);
}

TEST_F(Points, AsSpritesIgnoreSmoothing) {
    EXPECT_EQ(width(kWindow + std::string("glEnable(GL_POINT_SPRITE); glEnable(GL_POINT_SMOOTH); glPointSize(7.3);") +
                    point(32.3, 32.3)),
              7);
}

TEST_F(Points, AsSpritesMayHaveSizesByDistance) {
    using Color = std::pair<int, int>;
    const std::string axis =
        "glMatrixMode(GL_PROJECTION); glLoadIdentity(); glOrtho(-32.3, 31.7, -32.2, 31.8, -100, 100); "
        "glMatrixMode(GL_MODELVIEW);\n";
    EXPECT_EQ(color(sprite(axis + attenuated(0, 0, 1) + point(0, 0, -10), 80), 28, 30), Color(0, 17 * 11));
}

TEST_F(Points, AsSpritesShowOneImageInTheSecondUnit) {
    const std::string second =
        "glDisable(GL_TEXTURE_2D); glActiveTexture(GL_TEXTURE1); glBindTexture(GL_TEXTURE_2D, 0); "
        "glEnable(GL_TEXTURE_2D);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, "
        "GL_TRUE);\n";
    EXPECT_EQ(color(sprite(second + point(32.3, 32.2)), 28, 30), (std::pair<int, int>(0, 17 * 11)));
}

TEST_F(Points, AsSpritesInOneFaceOfPolygonsAreNotForShaders) {
    const Scene scene = scene_of(sprite("glPolygonMode(GL_FRONT, GL_POINT); glRectf(9, 9, 30, 30);"));
    ASSERT_EQ(scene.frame.unsupported.size(), 1u);
    EXPECT_EQ(scene.frame.unsupported[0].missing_from, MissingFrom::kShaders);
}

// ---- State (3.3, 6.1.14) ----

TEST(PointParameters, AreAnsweredAndSaved) {
    const auto state_of = [](const std::string& text) {
        State state({.width = kSide, .height = kSide});
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
        return state;
    };
    const std::string set =
        attenuated(1, 0.5, 0) + limits(2, 9) +
        "glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT); glEnable(GL_POINT_SPRITE);\n"
        "glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);\n";
    const auto values = [](const State& state) {
        return std::vector<Answer>{answer(state, kGL_POINT_DISTANCE_ATTENUATION),
                                   answer(state, kGL_POINT_SIZE_MIN),
                                   answer(state, kGL_POINT_SIZE_MAX),
                                   answer(state, kGL_POINT_SPRITE_COORD_ORIGIN),
                                   answer(state, kGL_POINT_SPRITE),
                                   tex_env_answer(state, kGL_POINT_SPRITE, kGL_COORD_REPLACE)};
    };
    const std::vector<Answer> changed = {{1, 0.5, 0}, {2}, {9}, {kGL_LOWER_LEFT}, {1}, {1}};
    EXPECT_EQ(values(state_of(set)), changed);
    EXPECT_EQ(values(state_of("glPushAttrib(GL_POINT_BIT);" + set + "glPopAttrib();")), values(state_of("")));
    EXPECT_EQ(values(state_of("glPushAttrib(GL_TEXTURE_BIT);" + set + "glPopAttrib();")), changed);
    const auto error = [&](const std::string& text) { return state_of(text).errors().at(0).code; };
    EXPECT_EQ(error("glPointParameterf(GL_FOG, 0);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error("glPointParameterf(GL_POINT_SIZE_MIN, -1);"), kGL_INVALID_VALUE);
    EXPECT_EQ(error("glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, -1);"), kGL_INVALID_VALUE);
    EXPECT_EQ(error("glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LINEAR);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error("glTexEnvi(GL_POINT_SPRITE, GL_TEXTURE_ENV_MODE, GL_ADD);"), kGL_INVALID_ENUM);
    EXPECT_EQ(error("glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 2);"), kGL_INVALID_VALUE);
}

}  // namespace
}  // namespace twinlight::points_test

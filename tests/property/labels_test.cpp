// Labels and pixel rectangles: glRasterPos, glWindowPos, glBitmap, glDrawPixels (2.13, 3.6, 3.7).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <span>
#include <vector>

#include "../unit/compare_three_ways.h"
#include "../unit/one_pixel.h"
#include "../unit/run_program.h"
#include "judge/fuzz/random.h"
#include "scene/frame/pixel_image.h"
#include "scene/state/answers.h"

namespace twinlight::labels_test {
namespace {

// A bitmap of 4 x 4 pixels; the lowest row has its first pixel, the next one its first two, ...
constexpr const char* kStairs =
    "glPixelStorei(GL_UNPACK_ALIGNMENT, 1);\n"
    "GLubyte stairs[] = {0x80, 0xC0, 0xE0, 0xF0};\n";
const std::string kDraw = "glBitmap(4, 4, 0, 0, 5, 1, stairs);\n";

class LabelsTest : public OnePixel {
  protected:
    // The pixels that are not black, which all renderers must agree on, as rows from the top.
    std::string picture(const std::string& text) {
        const Scene scene = scene_of(kStairs + text);
        EXPECT_TRUE(scene.frame.unsupported.empty()) << text;
        const auto rows = [](const Image& image) {
            std::string text_of_rows;
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) text_of_rows += image.at(x, y)[0] > 0.5F ? '#' : '.';
                text_of_rows += '\n';
            }
            return text_of_rows;
        };
        const std::vector<Picture> all = pictures(scene);
        const std::string expected = rows(all.front().image);
        for (const auto& [name, image] : all) EXPECT_EQ(rows(image), expected) << name << "\n" << text;
        return expected;
    }
    // How many pixels of the picture are not black.
    int count(const std::string& text) {
        const std::string rows = picture(text);
        return static_cast<int>(std::count(rows.begin(), rows.end(), '#'));
    }
    // The lowest rows of a picture that is black above.
    static std::string at_the_bottom(const std::vector<std::string>& rows) {
        std::string picture;
        for (std::size_t i = rows.size(); i < kSide; ++i) picture += std::string(kSide, '.') + "\n";
        for (const std::string& row : rows) picture += row + "\n";
        return picture;
    }
};

TEST_F(LabelsTest, FollowEachOtherAsTheirMovesSay) {
    EXPECT_EQ(picture("glWindowPos2i(1, 0);\n" + kDraw + kDraw), at_the_bottom({
                                                                     "......####......",
                                                                     ".####.###.......",
                                                                     ".###..##........",
                                                                     ".##...#.........",
                                                                     ".#..............",
                                                                 }));
}

// 3.7: the lower left corner is at floor(x - xorig).
TEST_F(LabelsTest, BeginAtTheirOrigin) {
    const std::string there = picture("glWindowPos2i(3, 4);\n" + kDraw);
    EXPECT_EQ(picture("glWindowPos2f(3.75, 4.25);\n" + kDraw), there);
    EXPECT_EQ(picture("glWindowPos2f(5.25, 4.25); glBitmap(4, 4, 2, 0, 0, 0, stairs);\n"), there);
    EXPECT_EQ(picture("glWindowPos2f(5.25, 4.25); glBitmap(4, 4, 1.5, -0.5, 0, 0, stairs);\n"), there);
    EXPECT_EQ(picture("glRasterPos2f(-0.59375, -0.46875);\n" + kDraw), there);  // (3.25, 4.25)
}

// 3.6.4: bits from the highest of each byte, or from the lowest; rows are padded.
TEST_F(LabelsTest, AreUnpackedByPixelStore) {
    const std::string there = picture("glWindowPos2i(3, 4);\n" + kDraw);
    const auto with = [&](const std::string& store, const std::string& bytes) {
        return picture("glWindowPos2i(3, 4);\n" + store + "glBitmap(4, 4, 0, 0, 0, 0, (GLubyte[]){" + bytes + "});\n");
    };
    EXPECT_EQ(with("glPixelStorei(GL_UNPACK_LSB_FIRST, 1);", "1, 3, 7, 15"), there);
    EXPECT_EQ(with("glPixelStorei(GL_UNPACK_ALIGNMENT, 2);", "0x80, 1, 0xC0, 2, 0xE0, 3, 0xF0"), there);
    EXPECT_EQ(with("glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);", "0x10, 0x18, 0x1C, 0x1E"), there);
    EXPECT_EQ(with("glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);", "0xFF, 0x80, 0xC0, 0xE0, 0xF0"), there);
    EXPECT_EQ(with("glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);", "0x80, 0, 0xC0, 0, 0xE0, 0, 0xF0"), there);
}

// 5.4: a list keeps the pixels, with the glPixelStore of the time it was made; as glutBitmapCharacter draws.
TEST_F(LabelsTest, AreDrawnByLists) {
    const std::string there = picture("glWindowPos2i(3, 4);\n" + kDraw + kDraw);
    EXPECT_EQ(picture("glNewList(70, GL_COMPILE);\n" + kDraw +
                      "glEndList();\n"
                      "glPixelStorei(GL_UNPACK_ALIGNMENT, 4); glPixelStorei(GL_UNPACK_LSB_FIRST, 1);\n"
                      "glWindowPos2i(3, 4); glListBase(5); glCallLists(2, GL_UNSIGNED_BYTE, (GLubyte[]){65, 65});\n"),
              there);
}

TEST_F(LabelsTest, AreReadFromBuffers) {
    EXPECT_EQ(
        picture("glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 1);\n"
                "glBufferData(GL_PIXEL_UNPACK_BUFFER, 5, (GLubyte[]){1, 0x80, 0xC0, 0xE0, 0xF0}, GL_STATIC_DRAW);\n"
                "glWindowPos2i(3, 4); glBitmap(4, 4, 0, 0, 0, 0, (void*)1);\n"),
        picture("glWindowPos2i(3, 4);\n" + kDraw));
}

// 2.13: the position must be inside the clip volume; then it may be moved out of the window.
TEST_F(LabelsTest, NeedAValidPosition) {
    EXPECT_EQ(count("glWindowPos2i(3, 4);\n" + kDraw), 10);
    EXPECT_EQ(count("glWindowPos2i(-2, 4);\n" + kDraw), 3);
    EXPECT_EQ(count("glRectf(-1, -1, -0.875, -0.875); glRasterPos2f(-1.1, 0);\n" + kDraw), 1);
    EXPECT_EQ(count("glRectf(-1, -1, -0.875, -0.875); glRasterPos3f(0, 0, 2);\n" + kDraw), 1);
    EXPECT_EQ(count("glRasterPos2f(0.03, 0.03); glBitmap(0, 0, 0, 0, -10, 0, NULL);\n" + kDraw), 3);
    EXPECT_EQ(count("glViewport(8, 8, 4, 4); glRasterPos2f(0.1, 0.1);\n" + kDraw), 10);  // not clipped to the viewport
    const std::string plane =
        "glRectf(-1, -1, -0.875, -0.875); glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){1, 0, 0, 0});\n";
    EXPECT_EQ(count(plane + "glEnable(GL_CLIP_PLANE0); glRasterPos2f(-0.3, 0.1);\n" + kDraw), 1);
    EXPECT_EQ(count(plane + "glRasterPos2f(-0.3, 0.1); glEnable(GL_CLIP_PLANE0);\n" + kDraw), 11);
}

TEST_F(LabelsTest, HaveTheDepthOfTheirPosition) {
    const std::string wall =
        "glEnable(GL_DEPTH_TEST); glColor3f(0, 0, 0); glRectf(-1, -1, 1, 1); glColor3f(1, 1, 1);\n";
    EXPECT_EQ(count(wall + "glRasterPos3f(0, 0.01, 0.5);\n" + kDraw), 0);
    EXPECT_EQ(count(wall + "glRasterPos3f(0.01, 0.01, -0.5);\n" + kDraw), 10);
    EXPECT_EQ(count(wall + "glWindowPos3f(4, 4, 0.6);\n" + kDraw), 0);
    EXPECT_EQ(count(wall + "glDepthRange(0, 0.2); glWindowPos3f(4, 4, 0.6);\n" + kDraw), 10);
}

// 2.13: lit as a vertex; front material; n.VP is 0.8.
TEST_F(LabelsTest, AreLitLikeVertices) {
    const std::string lit =
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0.6, 0.8, 0});\n"
        "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (GLfloat[]){0, 0, 0, 1});\n"
        "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5, 0.25, 1});\n" +
        std::string(kStairs);
    const auto codes = [&](const std::string& text) {
        const Rgba found = color(lit + text + "glBitmap(4, 4, 1, 3, 0, 0, stairs);\n");
        return std::array<int, 3>{channel_code(found[0]), channel_code(found[1]), channel_code(found[2])};
    };
    EXPECT_EQ(codes("glRasterPos2f(0.03, 0.03);\n"), (std::array{204, 102, 51}));
    // The values of the time of glRasterPos.
    EXPECT_EQ(codes("glRasterPos2f(0.03, 0.03); glNormal3f(0, 0, -1); glDisable(GL_LIGHTING);\n"),
              (std::array{204, 102, 51}));
    EXPECT_EQ(codes("glPushAttrib(GL_CURRENT_BIT); glRasterPos2f(0.03, 0.03); glPopAttrib(); glWindowPos2i(8, 8);\n"),
              (std::array{255, 255, 255}));  // glWindowPos does not light
    EXPECT_EQ(codes("glRasterPos2f(0.03, 0.03); glPushAttrib(GL_CURRENT_BIT); glNormal3f(0, 0, -1);\n"
                    "glRasterPos2f(-0.9, 0.9); glPopAttrib();\n"),
              (std::array{204, 102, 51}));
    EXPECT_EQ(codes("glEnable(GL_COLOR_MATERIAL); glColor3f(0.5, 1, 0); glRasterPos2f(0.03, 0.03);\n"),
              (std::array{102, 204, 0}));
}

// The fixed function is left out, because Mesa loses the texture coordinates of what is drawn beside sprites.
TEST_F(LabelsTest, AreNoPointSprites) {
    const Scene scene = scene_of(
        kStairs +
        std::string("GLubyte texels[] = {255, 0, 0, 0};\n"  // at s = 1/4 white, in the middle black
                    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
                    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
                    "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glEnable(GL_TEXTURE_2D);\n"
                    "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);\n"
                    "glEnable(GL_POINT_SPRITE); glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);\n"
                    "glPointParameterf(GL_POINT_SIZE_MIN, 9);\n"
                    "glColor3f(1, 1, 1); glTexCoord2f(0.25, 0.5); glWindowPos2i(1, 0);\n") +
        kDraw);
    const Draw& draw = *scene.frame.draws().at(0);
    EXPECT_FALSE(draw.draws_sprites() || draw.texture.coord_replace);
    for (const Image& image : {reference::render(scene.frame, {}), renderer_.render(scene.frame, {})}) {
        EXPECT_EQ(image.at(1, kSide - 1)[0], 1);
        EXPECT_EQ(image.at(5, kSide - 1)[0], 0) << "the lowest row of the bitmap has one pixel";
    }
}

TEST_F(LabelsTest, AreBlendedOnceForEachBitmap) {
    const Rgba found =
        color(kStairs + std::string("glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE);\n"
                                    "glColor3f(0.2, 0, 0.4); glWindowPos2i(8, 5);\n"
                                    "glBitmap(4, 4, 0, 0, 0, 0, stairs); glBitmap(4, 4, 0, 0, 0, 0, stairs);"));
    EXPECT_EQ(channel_code(found[0]), 102);
    EXPECT_EQ(channel_code(found[2]), 204);
}

// ---- Pixel rectangles ----

// 3.6.4: a pixel is drawn where its rectangle contains the pixel's centre.
TEST_F(LabelsTest, PixelsCoverTheCentresInTheirRectangle) {
    const std::string two = "glDrawPixels(2, 1, GL_RED, GL_UNSIGNED_BYTE, (GLubyte[]){255, 255});\n";
    EXPECT_EQ(count("glWindowPos2i(3, 4);\n" + two), 2);
    EXPECT_EQ(count("glWindowPos2i(3, 4); glPixelZoom(3, 2);\n" + two), 12);
    EXPECT_EQ(count("glWindowPos2i(8, 8); glPixelZoom(-3, -2);\n" + two), 12);
    EXPECT_EQ(count("glWindowPos2i(15, 4); glPixelZoom(3, 2);\n" + two), 2);
    EXPECT_EQ(count("glRectf(-1, -1, -0.875, -0.875); glWindowPos2i(3, 4); glPixelZoom(0, 2);\n" + two), 1);
    EXPECT_EQ(picture("glWindowPos2f(3.25, 4.25);\n" + two), picture("glWindowPos2i(3, 4);\n" + two));
    EXPECT_EQ(picture("glWindowPos2f(2.75, 3.75);\n" + two), picture("glWindowPos2i(3, 4);\n" + two));
}

TEST_F(LabelsTest, PixelsHaveTheirFormat) {
    const auto codes = [&](const std::string& format, const std::string& values,
                           const std::string& type = "GL_UNSIGNED_BYTE, (GLubyte[])") {
        const Rgba found = color(
            "glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glPixelZoom(4, 4); glWindowPos2i(6, 6);\n"
            "glColor3f(0.3, 0.6, 0.9); glDrawPixels(1, 1, " +
            format + ", " + type + "{" + values + "});\n");
        return Codes{channel_code(found[0]), channel_code(found[1]), channel_code(found[2]), channel_code(found[3])};
    };
    EXPECT_EQ(codes("GL_RGB", "10, 20, 30"), (Codes{10, 20, 30, 255}));
    EXPECT_EQ(codes("GL_RGBA", "10, 20, 30, 40"), (Codes{10, 20, 30, 40}));
    EXPECT_EQ(codes("GL_BGR", "10, 20, 30"), (Codes{30, 20, 10, 255}));
    EXPECT_EQ(codes("GL_BGRA", "10, 20, 30, 40"), (Codes{30, 20, 10, 40}));
    EXPECT_EQ(codes("GL_LUMINANCE", "10"), (Codes{10, 10, 10, 255}));
    EXPECT_EQ(codes("GL_LUMINANCE_ALPHA", "10, 40"), (Codes{10, 10, 10, 40}));
    EXPECT_EQ(codes("GL_RED", "10"), (Codes{10, 0, 0, 255}));
    EXPECT_EQ(codes("GL_GREEN", "10"), (Codes{0, 10, 0, 255}));
    EXPECT_EQ(codes("GL_BLUE", "10"), (Codes{0, 0, 10, 255}));
    EXPECT_EQ(codes("GL_ALPHA", "10"), (Codes{0, 0, 0, 10}));
    EXPECT_EQ(codes("GL_RGB", "0.2, -1, 7", "GL_FLOAT, (GLfloat[])"), (Codes{51, 0, 255, 255}));
    EXPECT_EQ(codes("GL_RGB", "13107, 0, 65535", "GL_UNSIGNED_SHORT, (GLushort[])"), (Codes{51, 0, 255, 255}));
    EXPECT_EQ(codes("GL_RGBA", "0x336699CC", "GL_UNSIGNED_INT_8_8_8_8, (GLuint[])"), (Codes{51, 102, 153, 204}));
    EXPECT_EQ(codes("GL_RGB", "0xF81F", "GL_UNSIGNED_SHORT_5_6_5, (GLushort[])"), (Codes{255, 0, 255, 255}));
}

TEST_F(LabelsTest, PixelsAreTransferred) {
    const Rgba found = color(
        "glPixelZoom(4, 4); glWindowPos2i(6, 6);\n"
        "glPixelTransferf(GL_RED_SCALE, 0.5); glPixelTransferf(GL_GREEN_BIAS, -1);\n"
        "glPixelTransferf(GL_BLUE_SCALE, -1); glPixelTransferf(GL_BLUE_BIAS, 1);\n"
        "glDrawPixels(1, 1, GL_RGB, GL_FLOAT, (GLfloat[]){0.8, 0.8, 0.4});\n");
    EXPECT_EQ(channel_code(found[0]), 102);
    EXPECT_EQ(channel_code(found[1]), 0);
    EXPECT_EQ(channel_code(found[2]), 153);
}

// Renderers draw many pixels as an image. They pass the fragment operations, and no state of polygons, points or planes counts.
TEST_F(LabelsTest, ManyPixelsAreFragmentsLikeAFew) {
    const std::string before =
        "glClearColor(0.2, 0.4, 0.6, 0.8); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | "
        "GL_STENCIL_BUFFER_BIT);\n"
        "glEnable(GL_DEPTH_TEST); glColor4f(0.6, 0.2, 0.4, 0.4); glRectf(-1, -1, 0, 1);"
        "glDepthRange(0, 0.4); glRectf(-1, -1, 1, -0.5); glDepthRange(0, 1); glDisable(GL_DEPTH_TEST);\n";
    const std::string pixels =
        "glDrawPixels(4, 4, GL_RGBA, GL_FLOAT, (GLfloat[]){0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 0.05, "
        "0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95, 0, 0.1, 0.2, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, "
        "1, 0, 0, 1, 0, 1, 0, 0.5, 0, 0, 1, 0.25, 1, 1, 1, 0.75, 0.3, 0.1, 0.4, 0.1, 0.5, 0.9, 0.2, 0.6, "
        "0.7, 0.8, 0.3, 0.8, 0.2, 0.4, 0.6, 1});\n";
    for (const char* const place :
         {"glWindowPos3f(2, 1, 0.4); glPixelZoom(3, 3);", "glWindowPos3f(14, 1, 0.4); glPixelZoom(-3, 2);",
          "glWindowPos3f(10, 15, 0.4); glPixelZoom(3, -3);", "glWindowPos3f(-1, -2, 0.4); glPixelZoom(4, 4);"})
        for (const char* const state :
             {"", "glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);",
              "glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.4);",
              "glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_COPY_INVERTED);", "glColorMask(1, 0, 1, 0);",
              "glEnable(GL_SCISSOR_TEST); glScissor(4, 3, 7, 10);", "glEnable(GL_DEPTH_TEST);",
              "glEnable(GL_DEPTH_TEST); glDepthFunc(GL_GREATER);",
              "glEnable(GL_DEPTH_TEST); glEnable(GL_POLYGON_OFFSET_FILL); glPolygonOffset(0, 1e7);",
              "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT_AND_BACK);", "glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);",
              "glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); glPointSize(3);",
              "glEnable(GL_POLYGON_STIPPLE); glPolygonStipple((GLubyte[128]){0});",
              "glEnable(GL_POINT_SMOOTH); glPointSize(5); glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ZERO);",
              "glClipPlane(GL_CLIP_PLANE0, (GLdouble[]){1, 0, 0, 0}); glEnable(GL_CLIP_PLANE0);",
              "glViewport(5, 5, 3, 3); glShadeModel(GL_FLAT);"}) {
            const std::string text = before + place + state + pixels;
            const Scene scene = scene_of(text);
            ASSERT_TRUE(scene.frame.draws().back()->shows_only_image()) << text;
            const std::vector<Picture> all = pictures(scene);
            EXPECT_NE(all[0].image.pixels, reference::render(scene_of(before).frame, {}).pixels) << "draws nothing:\n"
                                                                                                 << text;
            EXPECT_EQ(compare_three_ways(scene).verdict(), compare::Verdict::kWithin) << text;
            context_->make_current();  // not compare_three_ways()'s
            for (const auto& [name, image] : std::span(all).subspan(2))
                EXPECT_TRUE(image.pixels == all[1].image.pixels) << name << "\n" << text;
            programmable::Options constants;
            constants.tier = programmable::Tier::kBaked;
            EXPECT_TRUE(renderer_.render(scene.frame, constants).pixels == all[1].image.pixels) << text;
        }
}

// 4.1.5. The fixed function is left out, because Mesa's mirrored rectangles have a back.
TEST_F(LabelsTest, ManyPixelsHaveTheStencilStateOfTheFront) {
    for (const char* const front : {"GL_CW", "GL_CCW"})
        for (const char* const place :
             {"glWindowPos2i(3, 4); glPixelZoom(9, 9);", "glWindowPos2i(12, 4); glPixelZoom(-9, 9);"}) {
            const std::string text = fmt::format(
                "glEnable(GL_STENCIL_TEST); glStencilFuncSeparate(GL_BACK, GL_NEVER, 0, 255); glFrontFace({});\n"
                "{} glDrawPixels(1, 1, GL_RGBA, GL_FLOAT, (GLfloat[]){{0.2, 0.4, 0.6, 0.8}});\n",
                front, place);
            const Scene scene = scene_of(text);
            ASSERT_TRUE(scene.frame.draws().back()->shows_only_image()) << text;
            for (const auto& [name, image] : pictures(scene))
                if (name != std::string_view("fixed"))
                    expect_color(name, image.at(8, 8), {0.2F, 0.4F, 0.6F, 0.8F}, text);
        }
}

TEST_F(LabelsTest, ManyPixelsHaveThePlanOfOne) {
    const auto plans = [&](const std::string& zoom) {
        return explain_draws(scene_of("glWindowPos2i(3, 4); glPixelZoom(" + zoom +
                                      "); glDrawPixels(1, 1, GL_RGB, GL_FLOAT, (GLfloat[]){0.2, 0.4, 0.6});\n")
                                 .frame,
                             {});
    };
    const std::vector<ExplainedDraw> one = plans("1, 1"), many = plans("9, 9");
    ASSERT_EQ(one.size(), 1U);
    ASSERT_EQ(many.size(), 1U);
    EXPECT_TRUE(many[0].plan.effects == one[0].plan.effects);
    EXPECT_EQ(many[0].numbers, one[0].numbers);
}

// A texel for each, with all bits of a float.
TEST(PixelImages, HaveTheColorsOfARectangle) {
    const auto image = [](int width, int height, const std::vector<glm::ivec2>& further = {}) {
        std::vector<glm::ivec2> places;
        std::vector<Vertex> vertices;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) places.emplace_back(20 + x, 30 + y);
        places.insert(places.end(), further.begin(), further.end());
        for (const glm::ivec2& place : places)
            vertices.push_back({.color = {place.x / 100.0, place.y / 100.0, 1 / 3.0, 1}});
        return image_of_pixels(places, vertices);
    };
    const auto found = image(12, 8);
    ASSERT_TRUE(found);
    const TextureImage& level = found->levels.at(0);
    EXPECT_EQ(level.width, 12);
    EXPECT_EQ(level.height, 8);
    EXPECT_EQ(level.texel(0, 0), glm::vec4(glm::dvec4(0.2, 0.3, 1 / 3.0, 1)));
    EXPECT_EQ(level.texel(11, 0), glm::vec4(glm::dvec4(0.31, 0.3, 1 / 3.0, 1)));
    EXPECT_EQ(level.texel(5, 7), glm::vec4(glm::dvec4(0.25, 0.37, 1 / 3.0, 1)));
    EXPECT_FALSE(image(3, 3)) << "points are as fast";
    EXPECT_FALSE(image(12, 8, {{20, 38}}));
    EXPECT_FALSE(image(12, 8, {{31, 38}}));
    EXPECT_FALSE(image(0, 0, std::vector<glm::ivec2>(100, {5, 5})));
}

TEST_F(LabelsTest, PixelsOfColorIndicesAreNamed) {
    const Scene scene = scene_of(
        "glRectf(-1, -1, 1, 1); glWindowPos2i(0, 0);\n"
        "glDrawPixels(1, 1, GL_COLOR_INDEX, GL_FLOAT, (GLfloat[]){0.5});\n");
    ASSERT_EQ(scene.frame.unsupported.size(), 1U);
    EXPECT_EQ(scene.frame.unsupported[0].name, "glDrawPixels(GL_COLOR_INDEX)");
}

// ---- What drivers may find otherwise ----

// A raster position near the border between two pixels leaves the label's pixels open.
TEST_F(LabelsTest, BesideABorderOfPixelsAreOpen) {
    const auto open_pixels = [&](const std::string& text) {
        const Scene scene = scene_of(kStairs + text);
        int open = 0;
        for (const auto edge : reference::allowed_difference(scene.frame, {}).edge) open += edge ? 1 : 0;
        return open;
    };
    EXPECT_EQ(open_pixels("glWindowPos2i(3, 4);\n" + kDraw), 0);
    EXPECT_EQ(open_pixels("glRasterPos2f(0.07, 0.07);\n" + kDraw), 0);
    EXPECT_GE(open_pixels("glRasterPos2f(0, 0.07);\n" + kDraw), 10);
    // Beside the far plane: inside it in one driver, beyond it in another.
    EXPECT_GE(open_pixels("glTranslatef(0, 0, 0.1); glRasterPos3f(0.07, 0.07, 0.9);\n" + kDraw), 10);
    EXPECT_GE(open_pixels("glTranslatef(0, 0, 0.1); glRasterPos3f(0.07, 0.07, 0.900001);\n" + kDraw), 10);
}

TEST_F(LabelsTest, AreComparedThreeWays) {
    const Scene scene =
        make_scene(list_of(kStairs + ("glRectf(-0.5, -0.5, 0, 0); glRasterPos2f(0.07, 0.07);\n" + kDraw)),
                   {.width = 32, .height = 32});
    EXPECT_EQ(compare_three_ways(scene).verdict(), compare::Verdict::kWithin);
}

// Mesa finds the label at 5 in column 5, doubles find it in column 4: 5 * 2/800 - 1 is no float. Both are allowed.
TEST_F(LabelsTest, AtWholePixelsMayBeAPixelAside) {
    for (const char* blending : {"", "glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE);\n"}) {
        const std::string text =
            "glMatrixMode(GL_PROJECTION); glOrtho(0, 800, 0, 600, -1, 1);\nglColor3f(0.5, 1, 1);\n" +
            std::string(blending) + "glRasterPos2f(5, 580);\n" + kDraw;
        const Scene scene = make_scene(list_of(kStairs + text), {.width = 800, .height = 600});
        EXPECT_EQ(compare_three_ways(scene).verdict(), compare::Verdict::kWithin);
        const auto allowed = reference::allowed_difference(scene.frame, {});
        const auto background = [&](int x) { return allowed.edge[static_cast<std::size_t>(19 * 800 + x)] != 0; };
        EXPECT_TRUE(background(4));
        EXPECT_FALSE(background(40));
    }
}

// ---- The raster position itself ----

// Where floats compute a position without rounding, no driver can find another.
TEST_F(LabelsTest, AreCertainAtACornerOfTheWindow) {
    const auto is_certain = [&](const std::string& commands) {
        const Scene scene = scene_of(kStairs + (commands + kDraw));
        const std::vector<const Draw*> draws = scene.frame.draws();
        return draws.size() == 1 && draws.front()->pixels->doubtful.empty();
    };
    EXPECT_TRUE(is_certain("glRasterPos2i(-1, -1);"));
    EXPECT_TRUE(
        is_certain("gluOrtho2D(0, 640, 0, 480); glRasterPos2i(0, 0);"));  // 2/640 is no float, but 0 times it is
    EXPECT_TRUE(is_certain("glTranslatef(-0.25, 0.5, 0); glRasterPos2f(-0.75, -1.5);"));
    EXPECT_TRUE(is_certain("glRasterPos4f(-3, -3, 0, 3);"));
    EXPECT_FALSE(is_certain("gluOrtho2D(-3, 0, 0, 1); glRasterPos2i(-3, 0);"));  // 2/3 times -3
    EXPECT_FALSE(is_certain("glTranslatef(0.1, 0, 0); glRasterPos2d(-1.1, -1);"));
}

// softpipe draws points right above the window in its highest row. A new process, because a process chooses its driver with its first
// context.
TEST(Labels, AboveTheWindowAreNotDrawnInSoftpipe) {
    const TemporaryFolder folder;
    write_file_atomically(
        folder / "above.gl",
        "glWindowPos2i(3, 62); glBitmap(8, 5, 0, 0, 0, 0, (GLubyte[20]){255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, "
        "255, 0, 0, 0, 255, 0, 0, 0});\n"
        "glColor3f(1, 0, 0); glWindowPos2i(20, 64); glBitmap(8, 1, 0, 0, 0, 0, (GLubyte[4]){255, 0, 0, 0});\n");
    const ProgramResult result =
        run_shell("twinlight", "GALLIUM_DRIVER=softpipe \"$PROGRAM\" compare '" + (folder / "above.gl") +
                                   "' --size 64x64 -o '" + (folder / "report") + "'");
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("All three agree"), std::string::npos) << result.out;
}

TEST(RasterPositions, AreTheDrivers) {
    const auto context = make_offscreen_context(64, 48);
    int valid = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        fuzz::Random random(seed);
        const auto number = [&](double low, double high) { return random.uniform(low, high); };
        std::string text = fmt::format(
            "glMatrixMode(GL_PROJECTION); glFrustum(-1, 1, -1, 1, 1, 10); glMatrixMode(GL_MODELVIEW);\n"
            "glTranslatef({:.3f}, {:.3f}, {:.3f}); glRotatef({:.2f}, 1, {:.3f}, 0.5); glViewport({}, {}, {}, {});\n"
            "glDepthRange({:.3f}, {:.3f}); glColor4f({:.3f}, 1, 0.25, 0.5); glTexCoord4f(0.25, 0.5, 0, {:.3f});\n",
            number(-1, 1), number(-1, 1), number(-7, -3), number(0, 360), number(-1, 1), random.below(9) - 4,
            random.below(9), 20 + random.below(80), 20 + random.below(80), number(0, 1), number(0, 1), number(0, 1),
            number(1, 2));
        if (random.chance(0.3))
            text += fmt::format(
                "glClipPlane(GL_CLIP_PLANE1, (GLdouble[]){{{:.3f}, {:.3f}, 1, 4}}); "
                "glEnable(GL_CLIP_PLANE1);\n",
                number(-1, 1), number(-1, 1));
        text += random.chance(0.2) ? fmt::format("glWindowPos3f({:.3f}, {:.3f}, {:.3f});\n", number(-9, 70),
                                                 number(-9, 70), number(-0.5, 1.5))
                                   : fmt::format("glRasterPos4f({:.3f}, {:.3f}, {:.3f}, {:.3f});\n", number(-5, 5),
                                                 number(-5, 5), number(-5, 5), number(0.5, 2));
        text += "glBitmap(0, 0, 0, 0, 2.5, -1.25, NULL); glPixelZoom(2, -0.5);\n";
        SCOPED_TRACE(text);
        fixed::Driver driver(64, 48);
        State state({.width = 64, .height = 48});
        const auto list = list_of(text);
        for (const Command& command : list->commands) {
            driver.execute(command);
            state.apply(command);
        }
        const auto compare = [&](Enum name, double allowed) {
            const Answer expected = answer(state, name);
            std::array<GLdouble, 4> found{};
            glGetDoublev(name, found.data());
            for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], allowed);
            return !expected.empty();
        };
        if (!compare(GL_CURRENT_RASTER_POSITION_VALID, 0)) continue;
        constexpr double kFloats = 1e-3;  // of a pixel: a window of 80 pixels, products of a few matrices
        valid += compare(GL_CURRENT_RASTER_POSITION, kFloats) ? 1 : 0;
        compare(GL_CURRENT_RASTER_COLOR, 1e-6);
        compare(GL_CURRENT_RASTER_TEXTURE_COORDS, 1e-6);
        compare(GL_ZOOM_X, 0);
        compare(GL_ZOOM_Y, 0);
    }
    EXPECT_GT(valid, 100);
}

}  // namespace
}  // namespace twinlight::labels_test

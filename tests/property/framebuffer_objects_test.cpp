// Framebuffer objects: the driver executes the commands, the shaders and the reference draw each object's picture by themselves.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "../unit/compare_three_ways.h"
#include "../unit/one_pixel.h"
#include "scene/command/text.h"

namespace twinlight::framebuffer_objects_test {
namespace {

class FramebufferObjectsTest : public OnePixel {};

// Texture 1 has `size` x `size` texels of this format. Framebuffer 1 draws into it, with a renderbuffer of depths.
std::string object(int size, const std::string& format = "GL_RGBA8") {
    return fmt::format(
        "glBindTexture(GL_TEXTURE_2D, 1);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, {1}, {0}, {0}, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glBindRenderbuffer(GL_RENDERBUFFER, 1);\n"
        "glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, {0}, {0});\n"
        "glBindFramebuffer(GL_FRAMEBUFFER, 1);\n"
        "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);\n"
        "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 1);\n"
        "glViewport(0, 0, {0}, {0});\n",
        size, format);
}

constexpr const char* kClear =
    "glClearColor(1, 0, 0, 0.2); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glClearColor(0, 0, 0, 0);\n";

std::string square(const std::string& color, const std::string& corners) {
    return "glColor4f(" + color + "); glRectf(" + corners + ");\n";
}

// Texture 1 over the whole window.
std::string shown(double most = 1) {
    return fmt::format(
        "glBindFramebuffer(GL_FRAMEBUFFER, 0); glViewport(0, 0, 16, 16); glClear(GL_COLOR_BUFFER_BIT | "
        "GL_DEPTH_BUFFER_BIT);\n"
        "glBindTexture(GL_TEXTURE_2D, 1); glEnable(GL_TEXTURE_2D);\nglBegin(GL_QUADS); glTexCoord2f(0, 0); "
        "glVertex2f(-1, -1); "
        "glTexCoord2f({0}, 0); glVertex2f(1, -1); glTexCoord2f({0}, {0}); glVertex2f(1, 1); glTexCoord2f(0, {0}); "
        "glVertex2f(-1, 1); glEnd(); glDisable(GL_TEXTURE_2D);\n",
        most);
}

TEST_F(FramebufferObjectsTest, DrawIntoTheirTexture) {
    const std::string text = object(16) + kClear + square("0, 1, 0, 0.8", "0, 0, 1, 1") + shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
    EXPECT_EQ(codes(text, 3, 12), (Codes{255, 0, 0, 51}));
}

// A list with the arrays of its commands, as real programs make them.
TEST_F(FramebufferObjectsTest, AreDrawnIntoByArraysInLists) {
    const std::string list =
        "GLfloat corners[] = {0, 0, 1, 0, 1, 1, 0, 1};\nglVertexPointer(2, GL_FLOAT, 0, corners);\n"
        "glEnableClientState(GL_VERTEX_ARRAY);\nglNewList(1, GL_COMPILE); glDrawArrays(GL_QUADS, 0, 4); glEndList();\n";
    const std::string call = "glColor4f(0, 1, 0, 0.8); glCallList(1);\n";
    const std::string bind = "glBindFramebuffer(GL_FRAMEBUFFER, 0); glBindFramebuffer(GL_FRAMEBUFFER, 1);\n";
    const std::string text = list + object(16) + kClear + bind + call + shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
    const std::string incomplete =
        list + object(16) + "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);\n" +
        "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);\n" + call;
    try {
        make_frame(read_scene(incomplete, "scene.gl", "scene"), {.width = 16, .height = 16});
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("the bound framebuffer object is not complete"), std::string::npos);
    }
}

TEST_F(FramebufferObjectsTest, LeaveTheWindowAsItIs) {
    const std::string text = "glClearColor(0, 0, 1, 1); glClear(GL_COLOR_BUFFER_BIT);\n" + object(16) + kClear +
                             "glBindFramebuffer(GL_FRAMEBUFFER, 0); glViewport(0, 0, 16, 16);\n" +
                             square("0, 1, 0, 1", "0, 0, 1, 1");
    EXPECT_EQ(codes(text, 3, 3), (Codes{0, 0, 255, 255}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 255}));
}

// Their viewport is their own; so is the scissor.
TEST_F(FramebufferObjectsTest, MayBeLargerOrSmallerThanTheWindow) {
    for (const int size : {2, 8, 64, 200}) {
        SCOPED_TRACE(size);
        const std::string text =
            object(size) + kClear + square("0, 1, 0, 0.8", "0, 0, 1, 1") +
            fmt::format(
                "glEnable(GL_SCISSOR_TEST); glScissor({0}, 0, {0}, {0}); glClearColor(0, 0, 1, 1);\n"
                "glClear(GL_COLOR_BUFFER_BIT); glClearColor(0, 0, 0, 0); glDisable(GL_SCISSOR_TEST);\n",
                size / 2) +
            shown();
        EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
        EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
        EXPECT_EQ(codes(text, 12, 3), (Codes{0, 0, 255, 255}));
    }
}

TEST_F(FramebufferObjectsTest, HaveTheFormatOfTheTexture) {
    // Without alpha, what blending reads is 1.
    const std::string blended = "glEnable(GL_BLEND); glBlendFunc(GL_DST_ALPHA, GL_ZERO);\n" +
                                square("0, 1, 0, 0.4", "0, 0, 1, 1") + "glDisable(GL_BLEND);\n";
    const std::string text = object(16, "GL_RGB8") + kClear + blended + shown();
    EXPECT_EQ(codes("glColor4f(1, 1, 1, 0.6);\n" + text, 3, 3), (Codes{255, 0, 0, 102}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 102}));
    EXPECT_EQ(codes(object(16) + kClear + blended + shown(), 12, 12), (Codes{0, 51, 0, 20}));
}

// Framebuffer 2 reads the 2 x 2 texels of texture 2, into which nothing was drawn.
TEST_F(FramebufferObjectsTest, GiveTheTexelsOfTexturesThatNothingWasDrawnInto) {
    const auto of_four = [](const char* format) {
        return fmt::format(
            "GLubyte four[] = {{255, 0, 0, 255, 0, 255, 0, 153, 0, 0, 255, 255, 255, 255, 0, 102}};\n"
            "glBindTexture(GL_TEXTURE_2D, 2);\n"
            "glTexImage2D(GL_TEXTURE_2D, 0, {}, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, four);\n"
            "glBindFramebuffer(GL_READ_FRAMEBUFFER, 2);\n"
            "glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 2, 0);\n"
            "glBindTexture(GL_TEXTURE_2D, 1);\n",
            format);
    };
    const std::string copy = "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 12, 1, 0, 1, 2);\n";
    const std::string drawn = kClear + square("0, 0, 1, 0.8", "0, 0, 1, 1");
    for (const std::string& before : {drawn, std::string()}) {
        SCOPED_TRACE(before);
        const std::string text = object(16) + before + of_four("GL_RGBA8") + copy + shown();
        EXPECT_EQ(codes(text, 3, 12), (Codes{0, 255, 0, 153}));
        EXPECT_EQ(codes(text, 3, 13), (Codes{255, 255, 0, 102}));
    }
    EXPECT_EQ(codes(object(16) + drawn + of_four("GL_RGB8") + copy + shown(), 3, 12), (Codes{0, 255, 0, 255}));
    // A texture without alpha leaves the alpha of the colour.
    EXPECT_EQ(codes(object(16, "GL_RGB8") + drawn + of_four("GL_RGBA8") + copy + shown(), 3, 13),
              (Codes{255, 255, 0, 204}));
    EXPECT_EQ(codes(object(16) + drawn + of_four("GL_RGBA8") + copy + shown(), 12, 12), (Codes{0, 0, 255, 204}));
    const std::string whole = "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 2, 2, 0);\n";
    EXPECT_EQ(codes(object(16) + drawn + of_four("GL_RGBA8") + whole + shown(), 12, 3), (Codes{0, 255, 0, 153}));
}

constexpr const char *kNear = "glTranslatef(0, 0, -0.5);\n", *kFar = "glTranslatef(0, 0, 0.5);\n";

TEST_F(FramebufferObjectsTest, TestDepthsIfTheyHaveSome) {
    const std::string drawn = "glEnable(GL_DEPTH_TEST);\n" + std::string(kNear) + square("0, 1, 0, 1", "-1, -1, 1, 1") +
                              "glLoadIdentity();\n" + kFar + square("0, 0, 1, 1", "-1, -1, 1, 1") +
                              "glLoadIdentity(); glDisable(GL_DEPTH_TEST);\n";
    EXPECT_EQ(codes(object(16) + kClear + drawn + shown()), (Codes{0, 255, 0, 255}));
    const std::string without =
        object(16) + "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);\n";
    EXPECT_EQ(codes(without + kClear + drawn + shown()), (Codes{0, 0, 255, 255}));
}

TEST_F(FramebufferObjectsTest, GoOnWhereTheyEnded) {
    const std::string again =
        "glBindFramebuffer(GL_FRAMEBUFFER, 1); glViewport(0, 0, 16, 16); glEnable(GL_DEPTH_TEST);\n";
    const std::string text = object(16) + kClear + "glEnable(GL_DEPTH_TEST);\n" + kNear +
                             square("0, 1, 0, 0.8", "0, 0, 1, 1") + "glLoadIdentity(); glDisable(GL_DEPTH_TEST);\n" +
                             shown() + again + kFar + square("0, 0, 1, 1", "0, -1, 1, 1") +
                             "glLoadIdentity(); glDisable(GL_DEPTH_TEST);\n" + shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
    EXPECT_EQ(codes(text, 12, 3), (Codes{0, 0, 255, 255}));
}

// Each texture keeps what it showed when it was drawn with.
TEST_F(FramebufferObjectsTest, MayBeRedrawnBetweenUses) {
    const std::string left = "glEnable(GL_TEXTURE_2D); glRectf(-1, -1, 0, 1); glDisable(GL_TEXTURE_2D);\n";
    const std::string right = "glEnable(GL_TEXTURE_2D); glRectf(0, -1, 1, 1); glDisable(GL_TEXTURE_2D);\n";
    const std::string window = "glBindFramebuffer(GL_FRAMEBUFFER, 0);\n",
                      object_1 = "glBindFramebuffer(GL_FRAMEBUFFER, 1);\n";
    const std::string text =
        object(16) + kClear + window + left + object_1 + square("0, 1, 0, 0.8", "-1, -1, 1, 1") + window + right;
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 12, 3), (Codes{0, 255, 0, 204}));
}

// Two textures take turns, each drawn with the other.
TEST_F(FramebufferObjectsTest, MayShowEachOther) {
    std::string text = object(16) + kClear +
                       "glBindTexture(GL_TEXTURE_2D, 2);\n"
                       "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);\n"
                       "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
                       "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
                       "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);\n";
    for (const int target : {2, 1, 2, 1})
        text += fmt::format(
            "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, {}, 0);\n"
            "glBindTexture(GL_TEXTURE_2D, {}); glEnable(GL_TEXTURE_2D); glColor4f(0.5, 1, 1, 1);\n"
            "glRectf(-1, -1, 1, 1); glDisable(GL_TEXTURE_2D);\n",
            target, 3 - target);
    text += "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n";
    EXPECT_EQ(codes(text + shown())[0], 16);
}

// What was in the texture before is below what is drawn into it.
TEST_F(FramebufferObjectsTest, StartWithTheImagesOfTheTexture) {
    const std::string text = object(2) +
                             "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
                             "(GLubyte[]){10, 0, 0, 1, 20, 0, 0, 2, 30, 0, 0, 3, 40, 0, 0, 4});\n" +
                             square("0, 1, 0, 0.8", "0, 0, 1, 1") + shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{10, 0, 0, 1}));
    EXPECT_EQ(codes(text, 12, 3), (Codes{20, 0, 0, 2}));
    EXPECT_EQ(codes(text, 3, 12), (Codes{30, 0, 0, 3}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
}

// Depths that one texture was drawn with count for another as well.
TEST_F(FramebufferObjectsTest, ShareTheDepthsOfARenderbuffer) {
    const std::string text = object(16) + kClear + "glEnable(GL_DEPTH_TEST);\n" + kNear +
                             square("0, 1, 0, 0.8", "0, 0, 1, 1") +
                             "glLoadIdentity(); glBindTexture(GL_TEXTURE_2D, 2);\n"
                             "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);\n"
                             "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 2, 0);\n"
                             "glClearColor(1, 1, 0, 1); glClear(GL_COLOR_BUFFER_BIT); glClearColor(0, 0, 0, 0);\n" +
                             kFar + square("0, 0, 1, 1", "-1, -1, 1, 1") +
                             "glLoadIdentity(); glDisable(GL_DEPTH_TEST); glTexParameteri(GL_TEXTURE_2D, "
                             "GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n" +
                             shown() +
                             "glBindTexture(GL_TEXTURE_2D, 2); glEnable(GL_TEXTURE_2D); glTexCoord2f(0.75, 0.75); "
                             "glRectf(-1, 0, 1, 1); glTexCoord2f(0.25, 0.25); glRectf(-1, -1, 1, 0);\n";
    EXPECT_EQ(codes(text, 3, 12), (Codes{255, 255, 0, 255}));
    EXPECT_EQ(codes(text, 3, 3), (Codes{0, 0, 255, 255}));
}

// The shadow map's way: only depths, without a buffer to draw to.
TEST_F(FramebufferObjectsTest, DrawIntoATextureOfDepths) {
    const std::string text =
        "glBindTexture(GL_TEXTURE_2D, 1);\n"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 32, 32, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, NULL);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);\n"
        "glBindFramebuffer(GL_FRAMEBUFFER, 1); glDrawBuffer(GL_NONE); glReadBuffer(GL_NONE); glViewport(0, 0, 32, "
        "32);\n"
        "glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 1, 0);\n"
        "glEnable(GL_DEPTH_TEST); glClear(GL_DEPTH_BUFFER_BIT); glTranslatef(0, 0, -0.6); glRectf(0, 0, 1, 1);\n"
        "glLoadIdentity(); glDisable(GL_DEPTH_TEST);\n" +
        shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 255, 255, 255}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{51, 51, 51, 255}));  // z = -0.6 in NDC is the depth 0.2
}

TEST_F(FramebufferObjectsTest, TestAPackedStencil) {
    const std::string text = object(16) +
                             "glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 16, 16);\n"
                             "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 1);\n"
                             "glClearStencil(0); glClear(GL_STENCIL_BUFFER_BIT);\n" +
                             kClear +
                             "glEnable(GL_STENCIL_TEST); glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE); "
                             "glStencilFunc(GL_ALWAYS, 1, 255);\n" +
                             square("0, 1, 0, 0.8", "0, 0, 1, 1") + "glStencilFunc(GL_EQUAL, 0, 255);\n" +
                             square("0, 0, 1, 1", "0, -1, 1, 1") + "glDisable(GL_STENCIL_TEST);\n" + shown();
    EXPECT_EQ(codes(text, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 12, 12), (Codes{0, 255, 0, 204}));
    EXPECT_EQ(codes(text, 12, 3), (Codes{0, 0, 255, 255}));
}

// The means of two colours are whole numbers: Mesa rounds 127.5 up in 22.3, and down in 26.1.
TEST_F(FramebufferObjectsTest, MakeMipmaps) {
    const std::string text = object(16) + kClear + square("0.2, 0.8, 0, 0.6", "0, -1, 1, 1") +
                             "glGenerateMipmap(GL_TEXTURE_2D);\n"
                             "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);\n"
                             "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 4);\n" +
                             shown();
    EXPECT_EQ(codes(text), (Codes{153, 102, 0, 102}));
}

TEST_F(FramebufferObjectsTest, CanBeCopied) {
    const std::string copied =
        object(32) + kClear + square("0, 1, 0, 0.8", "0, 0, 1, 1") +
        "glBindTexture(GL_TEXTURE_2D, 2); glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 12, 12, 8, 8, 0);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);\n" +
        shown() +
        "glBindTexture(GL_TEXTURE_2D, 2); glEnable(GL_TEXTURE_2D); glBegin(GL_QUADS); "
        "glTexCoord2f(0, 0); glVertex2f(-1, -1); glTexCoord2f(1, 0); glVertex2f(1, -1); "
        "glTexCoord2f(1, 1); glVertex2f(1, 1); glTexCoord2f(0, 1); glVertex2f(-1, 1); glEnd();\n";
    EXPECT_EQ(codes(copied, 7, 7), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(copied, 8, 8), (Codes{0, 255, 0, 204}));
    const std::string pixels =
        object(16) + kClear + square("0, 1, 0, 0.8", "0, 0, 1, 1") +
        "glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0); glViewport(0, 0, 16, 16); glRasterPos2f(-1, -1);\n"
        "glCopyPixels(4, 4, 8, 8, GL_COLOR);\n";
    EXPECT_EQ(codes(pixels, 3, 3), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(pixels, 4, 4), (Codes{0, 255, 0, 204}));
}

// A lit scene in a smaller picture, and that on a lit quadrilateral.
TEST_F(FramebufferObjectsTest, AllowWhatTheirPictureAllows) {
    const std::string text =
        "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);\n" +
        object(64, "GL_RGB") +
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);\n"
        "glClearColor(0.2, 0.3, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
        "glPushMatrix(); glRotatef(30, 1, 1, 0); glutSolidCube(0.8); glPopMatrix();\n"
        "glBindFramebuffer(GL_FRAMEBUFFER, 0); glViewport(0, 0, 128, 128);\n"
        "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glEnable(GL_TEXTURE_2D); glRotatef(20, 1, 1, 0);\n"
        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);\n"
        "glBegin(GL_QUADS); glNormal3f(0, 0, 1); glTexCoord2f(0, 0); glVertex2f(-0.8, -0.8); glTexCoord2f(1, 0); "
        "glVertex2f(0.8, -0.8); glTexCoord2f(1, 1); glVertex2f(0.8, 0.8); glTexCoord2f(0, 1); glVertex2f(-0.8, 0.8); "
        "glEnd();\n";
    const Scene made = make_scene(list_of(text), {.width = 128, .height = 128});
    EXPECT_TRUE(made.frame.unsupported.empty());
    const compare::Comparison comparison = compare_three_ways(made);
    EXPECT_TRUE(comparison.within_tolerance());
    EXPECT_LT(comparison.pairs[0].judged.open_share(), 0.03) << "texels at the cube's border have a range";
    EXPECT_LT(comparison.pairs[0].difference.edge.pixels, 128 * 128 / 8);
}

}  // namespace
}  // namespace twinlight::framebuffer_objects_test

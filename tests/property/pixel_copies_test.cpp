// glCopyPixels (4.3.3): the driver, the shaders and the reference copy the same pixels, each from its own picture.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../unit/compare_three_ways.h"
#include "../unit/one_pixel.h"
#include "scene/frame/resized.h"

namespace twinlight::pixel_copies_test {
namespace {

class PixelCopiesTest : public OnePixel {
  protected:
    // What the pixel shows in the reference alone, for what a known bug hides in the driver.
    Codes reference_codes(const std::string& text, int x, int y) {
        const Rgba color = reference::render(scene_of(text).frame, {}).at(x, kSide - 1 - y);
        Codes result{};
        for (std::size_t i = 0; i < 4; ++i) result[i] = channel_code(color[i]);
        return result;
    }
};

// Red, green, blue and yellow squares of 4 x 4 pixels, from the lower left, in rows.
const std::string kSquares =
    "glEnable(GL_SCISSOR_TEST);\n"
    "glScissor(0, 0, 4, 4); glClearColor(1, 0, 0, 0.2); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(4, 0, 4, 4); glClearColor(0, 1, 0, 0.4); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(0, 4, 4, 4); glClearColor(0, 0, 1, 0.6); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glScissor(4, 4, 4, 4); glClearColor(1, 1, 0, 0.8); glClear(GL_COLOR_BUFFER_BIT);\n"
    "glDisable(GL_SCISSOR_TEST);\n";

TEST_F(PixelCopiesTest, AreDrawnAtTheRasterPosition) {
    const std::string text = kSquares + "glWindowPos2i(8, 8); glCopyPixels(2, 2, 4, 4, GL_COLOR);\n";
    EXPECT_EQ(codes(text, 8, 8), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 11, 8), (Codes{0, 255, 0, 102}));
    EXPECT_EQ(codes(text, 8, 11), (Codes{0, 0, 255, 153}));
    EXPECT_EQ(codes(text, 11, 11), (Codes{255, 255, 0, 204}));
    EXPECT_EQ(codes(text, 12, 11), (Codes{0, 0, 0, 0}));
}

TEST_F(PixelCopiesTest, AreZoomedAndMirrored) {
    const std::string text =
        kSquares + "glPixelZoom(-2, 3); glWindowPos2i(16, 4); glCopyPixels(2, 2, 4, 4, GL_COLOR);\n";
    EXPECT_EQ(codes(text, 15, 4), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 11, 9), (Codes{0, 255, 0, 102}));
    EXPECT_EQ(codes(text, 12, 10), (Codes{0, 0, 255, 153}));
    EXPECT_EQ(codes(text, 8, 15), (Codes{255, 255, 0, 204}));
    EXPECT_EQ(codes(text, 7, 7), (Codes{255, 255, 0, 204}));
}

// A rectangle may lie over its own copy.
TEST_F(PixelCopiesTest, ComeFromThePictureBeforeThem) {
    const std::string text = kSquares + "glWindowPos2i(2, 2); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n";
    EXPECT_EQ(codes(text, 5, 5), (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(text, 9, 9), (Codes{255, 255, 0, 204}));
    const std::string copy = "glWindowPos2i(8, 0); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n";
    // Later drawing changes no copy; a copy may be copied.
    EXPECT_EQ(codes(kSquares + copy +
                        "glClearColor(1, 1, 1, 1); glScissor(0, 0, 8, 8); glEnable(GL_SCISSOR_TEST); "
                        "glClear(GL_COLOR_BUFFER_BIT);\n",
                    9, 1),
              (Codes{255, 0, 0, 51}));
    EXPECT_EQ(codes(kSquares + copy + "glWindowPos2i(0, 8); glCopyPixels(8, 0, 8, 8, GL_COLOR);\n", 1, 13),
              (Codes{0, 0, 255, 153}));
    EXPECT_EQ(codes(kSquares + "glNewList(1, GL_COMPILE);\n" + copy +
                        "glEndList(); glClearColor(1, 1, 1, 1); glClear(GL_COLOR_BUFFER_BIT); glCallList(1);\n",
                    9, 1),
              (Codes{255, 255, 255, 255}));
}

TEST_F(PixelCopiesTest, AreTransferred) {
    const std::string text = kSquares +
                             "glPixelTransferf(GL_RED_SCALE, 0.5); glPixelTransferf(GL_BLUE_BIAS, 0.25);\n"
                             "glPixelTransferf(GL_ALPHA_SCALE, 2); glPixelTransferf(GL_GREEN_SCALE, -1); "
                             "glPixelTransferf(GL_GREEN_BIAS, 1);\n"
                             "glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n";
    EXPECT_EQ(codes(text, 8, 8), (Codes{128, 255, 64, 102}));
    EXPECT_EQ(codes(text, 15, 15), (Codes{128, 0, 64, 255}));
    EXPECT_EQ(reference_codes("glPixelTransferi(GL_MAP_COLOR, 1); glPixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, "
                              "(GLfloat[]){0.6, 0.2});\n" +
                                  kSquares + "glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n",
                              8, 8)[2],
              153);
}

TEST_F(PixelCopiesTest, PassTheFragmentOperations) {
    const auto with = [&](const std::string& state) {
        return kSquares + state + "glPixelZoom(2, 1); glWindowPos2i(0, 8); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n";
    };
    EXPECT_EQ(codes(with("glEnable(GL_BLEND); glBlendFunc(GL_SRC_ALPHA, GL_ONE);\n"), 1, 9), (Codes{51, 0, 0, 10}));
    EXPECT_EQ(codes(with("glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.3);\n"), 1, 9), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(codes(with("glEnable(GL_ALPHA_TEST); glAlphaFunc(GL_GREATER, 0.3);\n"), 9, 9), (Codes{0, 255, 0, 102}));
    EXPECT_EQ(codes(with("glEnable(GL_COLOR_LOGIC_OP); glLogicOp(GL_COPY_INVERTED);\n"), 1, 9),
              (Codes{0, 255, 255, 204}));
    EXPECT_EQ(codes(with("glColorMask(0, 1, 1, 1);\n"), 1, 9), (Codes{0, 0, 0, 51}));
    EXPECT_EQ(codes(with("glEnable(GL_DEPTH_TEST); glDepthFunc(GL_NEVER);\n"), 1, 9), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(codes(with("glEnable(GL_STENCIL_TEST); glStencilFunc(GL_EQUAL, 1, 255);\n"), 1, 9), (Codes{0, 0, 0, 0}));
    // A known bug of the driver: without zoom the mask and the stencil do not count.
    const std::string copy = "glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 8, GL_COLOR);\n";
    EXPECT_EQ(reference_codes(kSquares + "glColorMask(0, 1, 1, 1);\n" + copy, 9, 9), (Codes{0, 0, 0, 51}));
}

// The left half is near, the right half far; a white rectangle between them shows what the depths are.
const std::string kDepths =
    "glEnable(GL_DEPTH_TEST); glDepthFunc(GL_ALWAYS); glClear(GL_DEPTH_BUFFER_BIT); glColorMask(0, 0, 0, 0);\n"
    "glBegin(GL_QUADS); glVertex3f(-1, -1, -0.5); glVertex3f(0, -1, -0.5); glVertex3f(0, 1, -0.5); "
    "glVertex3f(-1, 1, -0.5); glEnd();\n";
const std::string kBetween =
    "glColorMask(1, 1, 1, 1); glDepthFunc(GL_LESS); glColor3f(1, 1, 1); glRectf(-1, -1, 1, 1);\n";

TEST_F(PixelCopiesTest, MayBeDepths) {
    const std::string text = kDepths + "glPixelZoom(1, 2); glWindowPos2i(10, 4); glCopyPixels(6, 0, 4, 4, GL_DEPTH);\n";
    EXPECT_EQ(codes(text + kBetween, 10, 4), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(codes(text + kBetween, 11, 11), (Codes{0, 0, 0, 0}));
    EXPECT_EQ(codes(text + kBetween, 12, 4), (Codes{255, 255, 255, 255}));
    EXPECT_EQ(codes(text + kBetween, 11, 12), (Codes{255, 255, 255, 255}));
    // 4.1.6: the depth test of the copied depths.
    EXPECT_EQ(
        codes(kDepths + "glDepthFunc(GL_LESS); glWindowPos2i(0, 0); glCopyPixels(8, 0, 4, 4, GL_DEPTH);\n" + kBetween,
              1, 1),
        (Codes{0, 0, 0, 0}));
    // The fragments have the raster position's colour.
    EXPECT_EQ(codes(kDepths + "glColorMask(1, 1, 1, 1); glColor4f(0.2, 0.4, 0.6, 0.8); glWindowPos2i(8, 0); "
                              "glCopyPixels(0, 0, 4, 4, GL_DEPTH);\n",
                    9, 1),
              (Codes{51, 102, 153, 204}));
    // Known bugs of the driver: the colour of the raster position, and pixel transfer.
    EXPECT_EQ(reference_codes(kDepths + "glColorMask(1, 1, 1, 1); glColor4f(0.2, 0.4, 0.6, 0.8); glWindowPos2i(8, 0); "
                                        "glColor3f(1, 0, 0); glCopyPixels(0, 0, 4, 4, GL_DEPTH);\n",
                              9, 1),
              (Codes{51, 102, 153, 204}));
    EXPECT_EQ(reference_codes(kDepths +
                                  "glPixelTransferf(GL_DEPTH_BIAS, 0.5); glWindowPos2i(0, 0); "
                                  "glCopyPixels(0, 0, 4, 4, GL_DEPTH);\n" +
                                  kBetween,
                              1, 1),
              (Codes{255, 255, 255, 255}));
}

// 4.3.2 leaves pixels outside the window undefined; the judge allows any colour there.
TEST_F(PixelCopiesTest, FromOutsideTheWindowAreEdgePixels) {
    const Scene scene =
        scene_of(kSquares + "glPixelZoom(2, 2); glWindowPos2i(4, 4); glCopyPixels(-2, 0, 4, 2, GL_COLOR);\n");
    const AllowedDifference allowed = reference::allowed_difference(scene.frame, {});
    const auto is_edge = [&](int x, int y) {
        return allowed.edge[static_cast<std::size_t>((kSide - 1 - y) * kSide + x)];
    };
    EXPECT_TRUE(is_edge(7, 4));
    EXPECT_FALSE(is_edge(8, 4));
    EXPECT_EQ(codes(scene, 8, 4, ""), (Codes{255, 0, 0, 51}));
}

TEST_F(PixelCopiesTest, OfTooManyInARowAreRefusedByName) {
    std::string text = kSquares;
    for (int i = 0; i < 51; ++i) text += "glCopyPixels(0, 0, 1, 1, GL_COLOR);\n";
    const Frame frame = scene_of("glWindowPos2i(8, 8);\n" + text).frame;
    ASSERT_EQ(frame.unsupported.size(), 1u);
    EXPECT_EQ(frame.unsupported[0].name, "glCopyPixels of a picture that shows 50 copies in a row");
    EXPECT_EQ(frame.draws().size(), 50u);
}

// The stencil value 5 in the lower left square of 4 x 4 pixels, 6 to the right of it, elsewhere 0; and what shows a value.
const std::string kStencils =
    "glEnable(GL_SCISSOR_TEST);\n"
    "glScissor(0, 0, 4, 4); glClearStencil(5); glClear(GL_STENCIL_BUFFER_BIT);\n"
    "glScissor(4, 0, 4, 4); glClearStencil(6); glClear(GL_STENCIL_BUFFER_BIT);\n"
    "glDisable(GL_SCISSOR_TEST);\n";
std::string has(int value) {
    return fmt::format(
        "glDisable(GL_SCISSOR_TEST); glDisable(GL_DEPTH_TEST); glEnable(GL_STENCIL_TEST);\n"
        "glStencilFunc(GL_EQUAL, {}, 255); glColor3f(1, 1, 1); glRectf(-1, -1, 1, 1);\n",
        value);
}
const std::array kWhite{255, 255, 255, 255}, kNothing{0, 0, 0, 0};

TEST_F(PixelCopiesTest, MayBeStencilValues) {
    const std::string copy = kStencils + "glWindowPos2i(8, 8); glCopyPixels(2, 0, 4, 4, GL_STENCIL);\n";
    EXPECT_EQ(codes(copy + has(5), 9, 9), kWhite);
    EXPECT_EQ(codes(copy + has(5), 10, 9), kNothing);
    EXPECT_EQ(codes(copy + has(6), 11, 11), kWhite);
    EXPECT_EQ(codes(copy + has(0), 12, 11), kWhite);
    // They may lie over their own place.
    const std::string zoomed =
        kStencils + "glPixelZoom(2, -3); glWindowPos2i(0, 12); glCopyPixels(0, 0, 8, 4, GL_STENCIL);\n";
    EXPECT_EQ(codes(zoomed + has(5), 7, 0), kWhite);
    EXPECT_EQ(codes(zoomed + has(6), 8, 11), kWhite);
    EXPECT_EQ(codes(zoomed + has(0), 8, 12), kWhite);
}

// 4.3.1: nothing but the scissor test and the stencil mask applies to them.
TEST_F(PixelCopiesTest, OfStencilValuesPassOnlyTheScissorAndTheMask) {
    const std::string copy = "glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 4, GL_STENCIL);\n";
    EXPECT_EQ(codes(kStencils +
                        "glEnable(GL_STENCIL_TEST); glStencilFunc(GL_NEVER, 0, 0); glEnable(GL_DEPTH_TEST); "
                        "glDepthFunc(GL_NEVER); glColorMask(0, 0, 0, 0);\n" +
                        copy + "glColorMask(1, 1, 1, 1);\n" + has(5),
                    9, 9),
              kWhite);
    EXPECT_EQ(codes(kStencils + "glEnable(GL_SCISSOR_TEST); glScissor(9, 0, 4, 16);\n" + copy + has(0), 8, 9), kWhite);
    EXPECT_EQ(codes(kStencils + "glStencilMaskSeparate(GL_FRONT, 6);\n" + copy + has(4), 9, 9), kWhite);
    EXPECT_EQ(codes(kStencils + "glStencilMaskSeparate(GL_BACK, 6);\n" + copy + has(5), 9, 9), kWhite);
}

// 3.6.5. A known bug of the driver: it writes the values as they are.
TEST_F(PixelCopiesTest, OfStencilValuesAreTransferred) {
    const std::string copy = "glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 4, GL_STENCIL);\n";
    const auto is_at = [&](const std::string& transfer, int value) {
        return reference_codes(kStencils + transfer + copy + has(value), 9, 9) == kWhite;
    };
    EXPECT_TRUE(is_at("glPixelTransferi(GL_INDEX_SHIFT, 3); glPixelTransferi(GL_INDEX_OFFSET, 1);\n", 41));
    EXPECT_TRUE(is_at("glPixelTransferi(GL_INDEX_SHIFT, 6);\n", 64));  // the lowest 8 bits of 320
    EXPECT_TRUE(is_at("glPixelTransferi(GL_INDEX_SHIFT, -1);\n", 2));
    EXPECT_TRUE(is_at("glPixelTransferi(GL_INDEX_OFFSET, -6);\n", 255));
    EXPECT_TRUE(
        is_at("glPixelTransferi(GL_MAP_STENCIL, 1); glPixelMapuiv(GL_PIXEL_MAP_S_TO_S, 4, (GLuint[]){9, 8, 7, "
              "6});\n",
              8));
}

// GL 3.0, section 4.3.1: only the scissor test and both masks apply.
TEST_F(PixelCopiesTest, MayBeDepthsAndStencilValues) {
    const std::string copy = kStencils + kDepths +
                             "glDepthFunc(GL_ALWAYS); glWindowPos2i(8, 8);\n"
                             "glCopyPixels(0, 0, 8, 4, GL_DEPTH_STENCIL); glColorMask(1, 1, 1, 1);\n";
    EXPECT_EQ(codes(copy + kBetween, 9, 9), kNothing);
    EXPECT_EQ(codes(copy + kBetween, 9, 13), kWhite);
    EXPECT_EQ(codes(copy + has(5), 9, 9), kWhite);
}

TEST_F(PixelCopiesTest, OfWhatAFramebufferObjectLacksAreErrors) {
    const std::string object =
        "glBindFramebuffer(GL_FRAMEBUFFER, 1); glBindRenderbuffer(GL_RENDERBUFFER, 1);\n"
        "glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 8, 8);\n"
        "glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 1);\n";
    for (const std::string type : {"GL_STENCIL", "GL_DEPTH_STENCIL"}) {
        try {
            scene_of(object + "glCopyPixels(0, 0, 1, 1, " + type + ");\n");
            ADD_FAILURE() << type;
        } catch (const std::exception& error) {
            EXPECT_NE(std::string(error.what()).find("has no stencil buffer"), std::string::npos) << error.what();
        }
    }
}

TEST_F(PixelCopiesTest, DrawnFromMemoryMayBeStencilValuesOrDepths) {
    const std::string stencils =
        "glPixelZoom(4, 4); glWindowPos2i(4, 4);\n"
        "glDrawPixels(2, 2, GL_STENCIL_INDEX, GL_INT, (GLint[]){1, 2, 259, -1});\n";
    EXPECT_EQ(codes(stencils + has(1), 4, 4), kWhite);
    EXPECT_EQ(codes(stencils + has(2), 11, 7), kWhite);
    EXPECT_EQ(codes(stencils + has(3), 4, 8), kWhite);
    EXPECT_EQ(codes(stencils + has(255), 11, 11), kWhite);
    EXPECT_EQ(codes(stencils + has(0), 12, 11), kWhite);
    const std::string depths =
        "glEnable(GL_DEPTH_TEST); glDepthFunc(GL_ALWAYS); glColorMask(0, 0, 0, 0); glPixelZoom(4, 4);\n"
        "glWindowPos2i(4, 4); glDrawPixels(2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0.25, 0.75});\n";
    EXPECT_EQ(codes(depths + kBetween, 4, 4), kNothing);
    EXPECT_EQ(codes(depths + kBetween, 8, 4), kWhite);
}

// Where another renderer may have another stencil value, its copy may be any.
TEST_F(PixelCopiesTest, OfStencilValuesAtEdgesAreEdges) {
    const Scene scene = scene_of(
        "glEnable(GL_STENCIL_TEST); glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE); glStencilFunc(GL_ALWAYS, 3, 255);\n"
        "glColorMask(0, 0, 0, 0); glBegin(GL_TRIANGLES); glVertex2f(-1, -1); glVertex2f(0, -1); glVertex2f(-1, 0); "
        "glEnd(); glColorMask(1, 1, 1, 1); glWindowPos2i(8, 8); glCopyPixels(0, 0, 8, 8, GL_STENCIL);\n"
        "glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);\n" +
        has(3));
    const AllowedDifference allowed = reference::allowed_difference(scene.frame, {});
    const auto is_edge = [&](int x, int y) {
        return allowed.edge[static_cast<std::size_t>((kSide - 1 - y) * kSide + x)] != 0;
    };
    EXPECT_TRUE(is_edge(11, 12));
    EXPECT_FALSE(is_edge(9, 12));
    EXPECT_FALSE(is_edge(14, 15));
    EXPECT_EQ(codes(scene, 9, 12, ""), kWhite);
}

// Only the rectangle grows with the picture; labels and pixel rectangles keep their size.
TEST_F(PixelCopiesTest, StayTheSameInALargerPicture) {
    const Frame frame =
        scene_of(
            "glBegin(GL_QUADS); glColor3f(1, 0, 0); glVertex2f(-1, -1); glVertex2f(0, -1); glVertex2f(0, 1); "
            "glVertex2f(-1, 1); glEnd();\nglWindowPos2i(8, 0); glCopyPixels(6, 0, 4, 4, GL_COLOR);\n")
            .frame;
    const Image large = reference::render(resized(frame, 2 * kSide, 2 * kSide), {});
    EXPECT_EQ(large.at(9, 2 * kSide - 1)[0], 1);
    EXPECT_EQ(large.at(10, 2 * kSide - 1)[0], 0);
}

// What lies between edges is judged; edges of the copied picture give edges.
TEST_F(PixelCopiesTest, AllowWhatTheCopiedPictureAllows) {
    const std::string scene =
        "glClearColor(0.2, 0.3, 0.4, 1); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
        "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glScalef(0.9, 0.9, 0.9);\n"
        "glRotatef(30, 1, 1, 0); glutSolidCube(0.8); glDisable(GL_LIGHTING); glDisable(GL_DEPTH_TEST);\n"
        "glPixelTransferf(GL_GREEN_SCALE, 3); glPixelZoom(2, 2); glWindowPos2i(64, 0);\n"
        "glCopyPixels(32, 48, 32, 32, GL_COLOR);\n";
    const Scene made = make_scene(list_of(scene), {.width = 128, .height = 128});
    const compare::Comparison comparison = compare_three_ways(made);
    EXPECT_EQ(comparison.verdict(), compare::Verdict::kWithin);
    EXPECT_LT(comparison.pairs[0].difference.edge.pixels, 128 * 128 / 8);
    EXPECT_GT(comparison.pairs[0].difference.edge.pixels, 0U);
}

}  // namespace
}  // namespace twinlight::pixel_copies_test

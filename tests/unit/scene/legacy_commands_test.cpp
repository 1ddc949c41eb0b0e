// Commands of old programs that not every renderer supports: their effect on State, the names that State reports as
// unsupported, and the calls that reach a driver.
#include <gtest/gtest.h>

#include <algorithm>

#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::legacy_commands_test {
namespace {

CommandList read(const std::string& text) { return read_scene(text, "scene.gl", "scene"); }

State run(const std::string& text) {
    State state({.width = 16, .height = 16});
    for (const Command& command : read(text).commands) state.apply(command);
    return state;
}

Frame frame_of(const std::string& text) { return make_frame(read(text), {.width = 16, .height = 16}); }

// Their names, in order.
std::vector<std::string> unsupported(const std::string& text) {
    std::vector<std::string> names;
    for (const Unsupported& item : frame_of(text).unsupported) names.push_back(item.name);
    return names;
}

std::string refused(const std::string& text) {
    try {
        frame_of(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

using Names = std::vector<std::string>;

constexpr const char* kPoint = "glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();\n";
constexpr const char* kSquare = "glRectf(-1, -1, 1, 1);\n";

// ---- Texture coordinates by unit (2.7) ----

TEST(MultiTexCoord, SetsTheCoordinatesOfUnit0) {
    EXPECT_EQ(answer(run("glMultiTexCoord2f(GL_TEXTURE0, 0.25, 0.5);"), kGL_CURRENT_TEXTURE_COORDS),
              (std::vector<double>{0.25, 0.5, 0, 1}));
    EXPECT_EQ(answer(run("glMultiTexCoord4sv(GL_TEXTURE0, (GLshort[]){1, 2, 3, 4});"), kGL_CURRENT_TEXTURE_COORDS),
              (std::vector<double>{1, 2, 3, 4}));
    const Frame frame = frame_of("glBegin(GL_POINTS); glMultiTexCoord1i(GL_TEXTURE0, 3); glVertex2f(0, 0); glEnd();");
    EXPECT_EQ(std::get<Draw>(frame.items[0]).vertices[0].tex_coord, glm::dvec4(3, 0, 0, 1));
}

TEST(MultiTexCoord, LeavesUnit0AsItIsForOthers) {
    const State state = run("glTexCoord2f(0.5, 0.5); glMultiTexCoord2f(GL_TEXTURE1, 0.25, 0.25);");
    EXPECT_TRUE(state.errors().empty());
    EXPECT_EQ(answer(state, kGL_CURRENT_TEXTURE_COORDS), (std::vector<double>{0.5, 0.5, 0, 1}));
    EXPECT_EQ(run("glMultiTexCoord2f(GL_FOG, 0, 0);").errors()[0].code, kGL_INVALID_ENUM);
}

// ---- Names of extensions ----

TEST(Extensions, AreReadAsTheCoreCommandsOfTheSameMeaning) {
    const CommandList scene = read(
        "glActiveTextureARB(GL_TEXTURE0_ARB); glMultiTexCoord2fARB(GL_TEXTURE0_ARB, 0, 1);\n"
        "glBlendFuncSeparateEXT(GL_ONE, GL_ZERO, GL_ONE, GL_ZERO); glBlendEquationEXT(GL_MAX_EXT);\n"
        "glPointParameterfARB(GL_POINT_SIZE_MIN_ARB, 1); glSecondaryColor3fEXT(0, 0, 0); glFogCoordfEXT(0);\n"
        "GLuint buffer[1]; glGenBuffersARB(1, buffer);\n");
    const std::vector<CommandId> expected = {CommandId::glActiveTexture,     CommandId::glMultiTexCoord2f,
                                             CommandId::glBlendFuncSeparate, CommandId::glBlendEquation,
                                             CommandId::glPointParameterf,   CommandId::glSecondaryColor3f,
                                             CommandId::glFogCoordf,         CommandId::glGenBuffers};
    ASSERT_EQ(scene.commands.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(scene.commands[i].id, expected[i]);
    EXPECT_EQ(find_command_or_extension("glVertexPointerEXT"), std::nullopt);
    EXPECT_EQ(find_command_or_extension("glPolygonOffsetEXT"), std::nullopt);
    EXPECT_EQ(find_command_or_extension("glNothingARB"), std::nullopt);
}

// ---- Commands are reported as unsupported only if they change a picture ----

TEST(Evaluators, AreNotNamed) {
    const std::string map =
        "glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, (GLfloat[]){0, 0, 0, 1, 1, 0});\n"
        "glEnable(GL_MAP1_VERTEX_3); glMapGrid1d(4, 0, 1);\n";
    EXPECT_EQ(unsupported(map + kPoint), Names());
    EXPECT_EQ(unsupported(map + "glBegin(GL_POINTS); glEvalCoord1f(0.5); glEvalPoint1(2); glEnd();"), Names());
    EXPECT_EQ(answer(run(map), kGL_MAP1_VERTEX_3), std::vector<double>{1});
    EXPECT_EQ(answer(run("glPushAttrib(GL_EVAL_BIT);" + map + "glPopAttrib();"), kGL_MAP1_VERTEX_3),
              std::vector<double>{0});
}

TEST(Evaluators, ReadAsManyValuesAsTheirOrderAndStrideSay) {
    const auto points = [](const std::string& call) { return read(call).commands[0].array().size(); };
    EXPECT_EQ(points("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, (GLfloat[]){0, 0, 0, 1, 1, 0});"), 6U);
    EXPECT_EQ(points("glMap1f(GL_MAP1_COLOR_4, 0, 1, 5, 2, (GLfloat[9]){0});"), 9U);
    EXPECT_EQ(points("glMap2d(GL_MAP2_INDEX, 0, 1, 1, 3, 0, 1, 3, 4, (GLdouble[99]){0});"), 2U * 1 + 3 * 3 + 1);
    EXPECT_EQ(points("glMap1f(GL_FOG, 0, 1, 3, 2, (GLfloat[9]){0});"), 0U);
    EXPECT_EQ(points("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, (GLfloat[9]){0});"), 0U);
    EXPECT_THROW(read("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, (GLfloat[5]){0});"), SceneError);
    EXPECT_THROW(read("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2147483647, 60, (GLfloat[5]){0});"), SceneError);
}

TEST(PixelTransfer, ScalesAndMapsTheTexelsOfAnImage) {
    const auto texel = [](const std::string& transfer) {
        State state = run(transfer +
                          "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_FLOAT, "
                          "(GLfloat[]){0.2, 0.4, 0.6, 0.8});\n");
        return state.bound_texture(kGL_TEXTURE_2D).levels.at(0).texels.at(0);
    };
    EXPECT_EQ(texel(""), glm::vec4(51, 102, 153, 204) / 255.0F);
    EXPECT_EQ(texel("glPixelTransferf(GL_RED_SCALE, 2); glPixelTransferf(GL_ALPHA_BIAS, -0.6);"),
              glm::vec4(102, 102, 153, 51) / 255.0F);
    // 3.6.5: the nearest of five entries; tables of one entry of 0 for the others.
    EXPECT_EQ(texel("glPixelTransferi(GL_MAP_COLOR, 1);\n"
                    "glPixelMapusv(GL_PIXEL_MAP_G_TO_G, 5, (GLushort[]){0, 0, 65535, 0, 0});"),
              glm::vec4(0, 1, 0, 0));
    EXPECT_EQ(unsupported("glPixelTransferf(GL_RED_SCALE, 2);" + std::string(kPoint)), Names());
    EXPECT_EQ(
        unsupported("glPixelTransferf(GL_RED_SCALE, 2); glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 4, 0);" +
                    std::string(kPoint)),
        Names{"glCopyTexImage2D with glPixelTransfer"});
}

TEST(PixelMaps, HaveOneTo256Entries) {
    EXPECT_NE(refused("glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, (GLfloat[]){0});").find("takes 1 to 256"),
              std::string::npos);
    EXPECT_EQ(answer(run("glPixelMapuiv(GL_PIXEL_MAP_A_TO_A, 3, (GLuint[]){0, 1, 2});"), kGL_PIXEL_MAP_A_TO_A_SIZE),
              std::vector<double>{3});
}

TEST(CopiedImages, AreImagesWithParts) {
    const std::string copy = "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 4, 0);\n";
    EXPECT_EQ(unsupported(copy + kPoint), Names());
    const State state = run(copy + "glTexSubImage2D(GL_TEXTURE_2D, 0, 7, 3, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, NULL);");
    EXPECT_TRUE(state.errors().empty());
    EXPECT_EQ(tex_level_answer(state, kGL_TEXTURE_2D, 0, kGL_TEXTURE_WIDTH)[0], 8);
    EXPECT_EQ(state.bound_texture(kGL_TEXTURE_2D).levels[0].parts.size(), 2u);
    const State whole = run(copy + "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 4);");
    EXPECT_EQ(whole.bound_texture(kGL_TEXTURE_2D).levels[0].parts.size(), 1u) << "the first copy cannot be seen";
}

TEST(CopiedImages, HaveErrors) {
    const auto code = [](const std::string& text) { return run(text).errors().at(0).code; };
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, -1, 4, 0);"), kGL_INVALID_VALUE);
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_2D, 99, GL_RGB, 0, 0, 1, 4, 0);"), kGL_INVALID_VALUE);
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 4, 2);"), kGL_INVALID_VALUE);
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_1D, 0, GL_RGB, 0, 0, 1, 4, 0);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_LIGHTING, 0, 0, 1, 4, 0);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glCopyTexImage1D(GL_TEXTURE_1D, 0, 3, 0, 0, 1, 0);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glCopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, 1);"), kGL_INVALID_OPERATION);
    const std::string image = "glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 4, 0);\n";
    EXPECT_EQ(code(image + "glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 0, 0, 8, 4);"), kGL_INVALID_VALUE);
    EXPECT_EQ(code(image + "glCopyTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 0, 0, 8, 4);"), kGL_INVALID_VALUE);
}

// 3.8.1: only textures of one and two dimensions have depths.
TEST(CopiedImages, OfDepthsAreErrorsForCubeMaps) {
    const auto code = [](const std::string& text) { return run(text).errors().at(0).code; };
    EXPECT_EQ(code("glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_DEPTH_COMPONENT, 0, 0, 4, 4, 0);"),
              kGL_INVALID_OPERATION);
    EXPECT_EQ(code("glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, "
                   "GL_FLOAT, (GLfloat[]){0});"),
              kGL_INVALID_OPERATION);
}

TEST(TextureParametersOfLaterVersions, AreNamedAndStayForTheNextPicture) {
    const std::string red = "glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RED);";
    EXPECT_EQ(unsupported(red + kPoint), Names{"glTexParameter(GL_DEPTH_TEXTURE_MODE, GL_RED)"});
    State state = run(red);
    state.drop_picture();
    EXPECT_EQ(state.take_frame().unsupported.size(), 1U);
}

TEST(DepthTextureParameters, HaveValuesOfTheirOwn) {
    const auto code = [](const std::string& text) { return run(text).errors().at(0).code; };
    EXPECT_EQ(code("glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RGB);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_LEQUAL);"), kGL_INVALID_ENUM);
    EXPECT_EQ(code("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_NONE);"), kGL_INVALID_ENUM);
    const State state =
        run("glTexParameteri(GL_TEXTURE_1D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);"
            "glTexParameterf(GL_TEXTURE_1D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);"
            "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_COMPARE_FUNC, GL_GREATER);");
    const Texture &set = state.bound_texture(kGL_TEXTURE_1D), &initial = state.bound_texture(kGL_TEXTURE_2D);
    EXPECT_EQ(set.depth_mode, kGL_ALPHA);
    EXPECT_EQ(set.compare_mode, kGL_COMPARE_R_TO_TEXTURE);
    EXPECT_EQ(set.compare_func, kGL_GREATER);
    EXPECT_EQ(initial.depth_mode, kGL_LUMINANCE);
    EXPECT_EQ(initial.compare_mode, kGL_NONE);
    EXPECT_EQ(initial.compare_func, kGL_LEQUAL);
}

TEST(TextureLevels, InUseAreThoseFromBaseToMaxLevel) {
    const auto levels = [](const std::string& calls) {
        State state =
            run("GLubyte t[64] = {0}; glEnable(GL_TEXTURE_2D);\n"
                "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n"
                "glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n"
                "glTexImage2D(GL_TEXTURE_2D, 2, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n" +
                calls + kPoint);
        EXPECT_TRUE(state.errors().empty());
        std::vector<int> widths;
        const Frame frame = state.take_frame();
        if (const auto& texture = frame.draws().at(0)->texture.texture)
            for (const TextureImage& image : texture->levels) widths.push_back(image.width);
        return widths;
    };
    const std::string base = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);";
    const std::string no_mipmaps = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);";
    EXPECT_EQ(levels(""), (std::vector{4, 2, 1}));
    EXPECT_EQ(levels(base), (std::vector{2, 1}));
    EXPECT_EQ(levels(base + no_mipmaps), (std::vector{2}));
    EXPECT_EQ(levels("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);"), (std::vector{4, 2}));
    // 3.8.10: incomplete, if the first is after the last, or has no image.
    EXPECT_EQ(levels(base + "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);"), std::vector<int>());
    EXPECT_EQ(levels("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 3);"), std::vector<int>());
}

TEST(TextureLevels, AreGeneratedFromTheBaseLevelOn) {
    State state = run(
        "GLubyte t[64] = {0}; glEnable(GL_TEXTURE_2D); glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);\n"
        "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);\n"
        "glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n" +
        std::string(kPoint));
    const Frame frame = state.take_frame();
    ASSERT_TRUE(frame.draws().at(0)->texture.texture);
    EXPECT_EQ(frame.draws().at(0)->texture.texture->levels.size(), 3u);
}

TEST(TextureLevels, OfDrawsAreSharedAndKeptWhileTheTextureChanges) {
    const std::string image = "glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n";
    const std::string white =
        "glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[]){255, 255, 255, "
        "255});\n";
    State state =
        run("GLubyte t[64] = {0}; glEnable(GL_TEXTURE_2D);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);\n" +
            image + kPoint + kPoint + white + kPoint);
    const Frame frame = state.take_frame();
    const auto texture = [&](std::size_t i) { return frame.draws().at(i)->texture.texture; };
    EXPECT_EQ(texture(0), texture(1));
    EXPECT_EQ(texture(1)->levels[0].texels[0].r, 0);
    EXPECT_EQ(texture(2)->levels[0].texels[0].r, 1);
}

TEST(TextureParameters, ComeBackWithTheAttributeStackInEveryUnit) {
    const State state =
        run("glPushAttrib(GL_TEXTURE_BIT); glActiveTexture(GL_TEXTURE3); glBindTexture(GL_TEXTURE_2D, 5);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP); glBindTexture(GL_TEXTURE_2D, 0);\n"
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP); glPopAttrib();\n");
    EXPECT_EQ(tex_parameter_answer(state, kGL_TEXTURE_2D, kGL_TEXTURE_WRAP_T)[0], kGL_REPEAT);
}

TEST(LevelOfDetail, HasTheBiasOfTheUnitAndOfTheTextureUpToALimit) {
    const auto bias = [](const std::string& unit, const std::string& texture) {
        State state =
            run("GLubyte t[4] = {0}; glEnable(GL_TEXTURE_2D);\n"
                "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, t);\n"
                "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, " +
                unit + ");\nglTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, " + texture + ");\n" + kPoint);
        return state.take_frame().draws().at(0)->texture.lod_bias;
    };
    EXPECT_EQ(bias("0.25", "-1"), -0.75);
    EXPECT_EQ(bias("10", "10"), 16);
    EXPECT_EQ(bias("-10", "-10"), -16);
}

// ---- Bitmaps and stipples: memory of bits (3.6.4) ----

TEST(Bitmap, ReadsNoFurtherThanItsMemory) {
    const std::string five_rows =
        "glBitmap(9, 5, 0, 0, 10, 0, (GLubyte[20]){0});\n";  // two bytes per row, padded to four
    EXPECT_EQ(unsupported(five_rows + kPoint), Names());
    EXPECT_EQ(unsupported("glBitmap(0, 0, 0, 0, 10, 0, NULL);" + std::string(kPoint)), Names());
    EXPECT_NE(refused("glBitmap(9, 5, 0, 0, 10, 0, (GLubyte[17]){0});").find("reads 18 bytes"), std::string::npos);
    EXPECT_EQ(refused("glBitmap(9, 5, 0, 0, 10, 0, (GLubyte[18]){0});").find("reads"), std::string::npos);
    EXPECT_NE(refused("glBitmap(9, 5, 0, 0, 10, 0, NULL);").find("reads 18 bytes"), std::string::npos);
    EXPECT_NE(refused("glBitmap(-1, 5, 0, 0, 10, 0, NULL);").find("-1 x 5"), std::string::npos);
    EXPECT_EQ(
        refused("glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glBitmap(9, 5, 0, 0, 1, 0, (GLubyte[10]){0});").find("reads"),
        std::string::npos);
}

TEST(PolygonStippleState, IsDrawnByAllAndReadsNoFurtherThanItsMask) {
    const std::string mask = "glPolygonStipple((GLubyte[128]){0});\n";
    EXPECT_EQ(unsupported(mask + kSquare), Names());
    EXPECT_EQ(unsupported(mask + "glEnable(GL_POLYGON_STIPPLE);" + kSquare), Names());
    EXPECT_NE(refused("glPixelStorei(GL_UNPACK_ROW_LENGTH, 40);" + mask).find("reads"), std::string::npos);
    EXPECT_NE(refused("glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);" + mask).find("reads 132 bytes"), std::string::npos);
}

// The driver must not get commands that read beyond an array; the sanitizers would report that.
TEST(Driver, ReadsNoFurtherThanItsMemory) {
    const auto context = make_offscreen_context(16, 16);
    fixed::Driver driver(16, 16);
    for (const char* text :
         {"glBitmap(4096, 4096, 0, 0, 0, 0, (GLubyte[1]){0});", "glBitmap(64, 64, 0, 0, 0, 0, NULL);",
          "glPixelStorei(GL_UNPACK_SKIP_ROWS, 100000); glPolygonStipple((GLubyte[128]){0});",
          "glDrawPixels(512, 512, GL_DEPTH_COMPONENT, GL_FLOAT, (GLubyte[1]){0});",
          "glDrawPixels(512, 512, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, (GLubyte[1]){0});",
          "glDrawPixels(512, 512, GL_COLOR_INDEX, GL_BITMAP, (GLubyte[1]){0});",
          "glDrawPixels(512, 512, 0x8227, GL_FLOAT, (GLubyte[1]){0});",  // GL_RG, of GL 3.0
          "glDrawPixels(512, 512, GL_RGBA, 0x140B, (GLubyte[1]){0});",   // GL_HALF_FLOAT
          "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 512, 512, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, (GLubyte[1]){0});",
          "glGetIntegerv(0x86A3, (GLint[1]){0});",  // GL_COMPRESSED_TEXTURE_FORMATS
          "glReadPixels(0, 0, 16, 16, GL_RGBA, GL_FLOAT, (GLubyte[1]){0});"}) {
        for (const Command& command : read(text).commands) driver.execute(command);
    }
}

// A display list may call glBegin between glBegin and glEnd; then Mesa stays there. The next picture does not.
TEST(Driver, StartsEachPictureOutsideBegin) {
    const auto context = make_offscreen_context(16, 16);
    const CommandList simple = read(std::string("glColor3f(1, 0, 0);") + kSquare);
    const Scene scene = make_scene(std::make_shared<const CommandList>(simple), {.width = 16, .height = 16});
    for (const char* text : {"glBegin(GL_TRIANGLES); glVertex2f(0, 0);",
                             "glNewList(5, GL_COMPILE); glBegin(GL_TRIANGLES); glVertex2f(0, 0); glBegin(GL_LINES);"
                             "glVertex2f(0, 1); glEndList(); glBegin(GL_POINTS); glCallList(5); glEnd();",
                             "glNewList(5, GL_COMPILE); glBegin(GL_TRIANGLES); glEndList(); glCallList(5);",
                             "glNewList(5, GL_COMPILE); glBegin(GL_TRIANGLES);"}) {
        {
            fixed::Driver driver(16, 16);
            for (const Command& command : read(text).commands) driver.execute(command);
        }
        EXPECT_EQ(fixed::render(scene).at(8, 8), (Rgba{1, 0, 0, 1})) << text;
    }
}

// ---- Selection and feedback (5.2, 5.3) ----

constexpr const char* kPicking =
    "GLuint hits[16]; GLint count; glColor3f(1, 0, 0); glRectf(-1, -1, 1, 1);\n"
    "glSelectBuffer(16, hits); glRenderMode(GL_SELECT); glInitNames(); glPushName(1);\n"
    "glColor3f(0, 1, 0); glRectf(-1, -1, 1, 1); glClear(GL_COLOR_BUFFER_BIT); glAccum(GL_LOAD, 1);\n"
    "count = glRenderMode(GL_RENDER);\n";

TEST(Selection, DrawsNothingInAnyRenderer) {
    const Scene scene = make_scene(std::make_shared<const CommandList>(read(kPicking)), {.width = 16, .height = 16});
    const Frame& frame = scene.frame;
    EXPECT_EQ(frame.items.size(), 1U);
    EXPECT_TRUE(frame.unsupported.empty());
    const auto context = make_offscreen_context(16, 16);
    const Rgba red{1, 0, 0, 1};
    EXPECT_EQ(fixed::render(scene).at(8, 8), red);
    EXPECT_EQ(reference::render(frame, {}).at(8, 8), red);
    GLint mode = 0;
    glGetIntegerv(GL_RENDER_MODE, &mode);
    EXPECT_EQ(mode, GL_RENDER);
}

TEST(Selection, IsTheDriversModeWhereItHasABuffer) {
    const auto context = make_offscreen_context(16, 16);
    fixed::Driver driver(16, 16);
    State state({.width = 16, .height = 16});
    const auto both = [&](const std::string& text) {
        const std::size_t before = state.errors().size();
        for (const Command& command : read(text).commands) {
            state.apply(command);
            driver.execute(command);
        }
        GLint mode = 0;
        glGetIntegerv(GL_RENDER_MODE, &mode);
        EXPECT_EQ(answer(state, kGL_RENDER_MODE)[0], mode) << text;
        const Enum expected = state.errors().size() > before ? state.errors().back().code : kGL_NO_ERROR;
        EXPECT_EQ(glGetError(), expected) << text;
    };
    both("glSelectBuffer(-1, (GLuint[1]){0});");
    both("glFeedbackBuffer(4, GL_FOG, (GLfloat[4]){0});");
    both("glSelectBuffer(4, (GLuint[4]){0}); glRenderMode(GL_SELECT);");
    both("glSelectBuffer(4, (GLuint[4]){0});");
    both("glRenderMode(GL_FOG);");
    both("glPushName(1);");
    both("glFeedbackBuffer(4, GL_3D_COLOR, (GLfloat[4]){0}); glRenderMode(GL_FEEDBACK);");
    both("glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();");
    both("glFeedbackBuffer(4, GL_3D_COLOR, (GLfloat[4]){0});");
    both("glRenderMode(GL_RENDER);");
}

TEST(DisplayLists, AreKnownToTheirDraws) {
    const std::string draw = "glBegin(GL_POINTS); glVertex2f(0, 0); glEnd();\n";
    const Frame frame = frame_of("glNewList(1, GL_COMPILE);\n" + draw + "glEndList();\n" +
                                 "glNewList(2, GL_COMPILE); glTranslatef(1, 0, 0); glCallList(1);\n" + draw +
                                 "glEndList();\nglScalef(2, 2, 2); glCallList(2);\nglCallList(1);\n" + draw);
    const std::vector<const Draw*> draws = frame.draws();
    ASSERT_EQ(draws.size(), 4U);
    const ListCall &inner = *draws[0]->list, &outer = *draws[1]->list, &again = *draws[2]->list;
    EXPECT_EQ(inner.outer, draws[1]->list);
    EXPECT_EQ(outer.outer, nullptr);
    EXPECT_EQ(again.outer, nullptr);
    EXPECT_EQ(draws[3]->list, nullptr);
    EXPECT_EQ((std::vector{inner.name, outer.name, again.name}), (std::vector<std::uint32_t>{1, 2, 1}));
    EXPECT_EQ((std::vector{inner.place.line, outer.place.line, again.place.line}), (std::vector{4, 7, 8}));
    // The matrices at the calls: the list 2 moves what is scaled, and leaves that behind.
    EXPECT_EQ(outer.eye_from_object[3], glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(inner.eye_from_object[3], glm::dvec4(2, 0, 0, 1));
    EXPECT_EQ(again.eye_from_object, inner.eye_from_object);
}

TEST(Selection, IsNotCompiledIntoLists) {
    const State state =
        run("glSelectBuffer(4, (GLuint[4]){0}); glNewList(1, GL_COMPILE); glRenderMode(GL_SELECT); glEndList();");
    EXPECT_EQ(answer(state, kGL_RENDER_MODE)[0], kGL_SELECT);
}

TEST(RenderMode, ChangesNothingInTheModeThatItNames) {
    EXPECT_EQ(unsupported("glRenderMode(GL_RENDER);" + std::string(kPoint)), Names());
}

// ---- Queries (6.1) ----

TEST(Queries, DropTheirAnswers) {
    EXPECT_EQ(unsupported("GLfloat m[16]; GLint i[4]; GLboolean b; GLenum e; GLubyte pixels[1024];\n"
                          "glGetFloatv(GL_MODELVIEW_MATRIX, m); glGetIntegerv(GL_VIEWPORT, i); e = glGetError();\n"
                          "glGetString(GL_VERSION); b = glIsEnabled(GL_FOG); glIsList(3); glIsTexture(3);\n"
                          "glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, i);\n"
                          "glReadPixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels);\n"
                          "glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);\n" +
                          std::string(kPoint)),
              Names());
    for (const char* text : {"GLint i[4]; glGetIntegerv(GL_VIEWPORT, i); glViewport(i[0], i[1], i[2], i[3]);",
                             "GLenum e = glGetError(); glEnable(e);",
                             "GLubyte p[4]; glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, p); glColor4ubv(p);"}) {
        EXPECT_THROW(read(text), SceneError) << text;
    }
    EXPECT_THROW(read("glGetFloatv(GL_MODELVIEW_MATRIX, (GLfloat[4]){0});"), SceneError);
    EXPECT_THROW(read("glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, (const void*)16);"), SceneError);
    EXPECT_THROW(read("glAreTexturesResident(2, (GLuint[]){1, 2}, (GLboolean[1]){0});"), SceneError);
}

TEST(Queries, AreRefusedBetweenBeginAndEnd) {
    for (const char* query : {"glGetError();", "glIsEnabled(GL_FOG);", "glGetIntegerv(GL_VIEWPORT, (GLint[4]){0});",
                              "glRenderMode(GL_RENDER);"}) {
        EXPECT_EQ(run(std::string("glBegin(GL_POINTS);") + query).errors().at(0).code, kGL_INVALID_OPERATION) << query;
    }
}

// The table of lengths matches what State returns.
TEST(Queries, HaveTheLengthOfTheirAnswers) {
    const State state;
    int longer = 0;
    for (const NamedValue& name : gl_names()) {
        const std::size_t length = answer(state, name.value).size();
        if (length == 0 || name.value <= kGL_POLYGON || name.name.ends_with("_BIT")) continue;
        EXPECT_EQ(static_cast<std::size_t>(array_length(CommandId::glGetDoublev, name.value).value_or(1)), length)
            << name.name;
        longer += length > 1 ? 1 : 0;
    }
    EXPECT_GT(longer, 15);
}

TEST(Priorities, AreOfTheTexturesThatThereAre) {
    const State state =
        run("glBindTexture(GL_TEXTURE_2D, 3); glPrioritizeTextures(3, (GLuint[]){0, 3, 9}, (GLfloat[]){1, 0.25, 1});");
    EXPECT_EQ(tex_parameter_answer(state, kGL_TEXTURE_2D, kGL_TEXTURE_PRIORITY)[0], 0.25);
    EXPECT_FALSE(state.textures().named.contains(9));
    EXPECT_EQ(run("glPrioritizeTextures(-1, (GLuint[]){0}, (GLfloat[]){1});").errors()[0].code, kGL_INVALID_VALUE);
}

}  // namespace
}  // namespace twinlight::legacy_commands_test

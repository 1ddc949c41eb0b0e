// Generated texture coordinates (GL 2.1, section 2.11.4): the state, the reference's vertex stage, and the plan, by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "../planned_draws.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::tex_gen_test {
namespace {

constexpr double kExact = 1e-12;

State after(std::string_view text) {
    State state;
    for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
    return state;
}

const std::string kTexture =
    "GLubyte texel[] = {9, 9, 9, 9}; glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, "
    "texel);"
    "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); glEnable(GL_TEXTURE_2D);";

Draw drawn(const std::string& text) {
    const State state =
        after(kTexture + text + "glBegin(GL_POINTS); glTexCoord4f(7, 8, 9, 1); glVertex3f(1, 2, 3); glEnd();");
    EXPECT_TRUE(state.errors().empty()) << state.errors().front().message;
    return std::get<Draw>(state.items().back());
}

glm::dvec4 tex_coord(const std::string& text) { return reference::vertex_stage(drawn(text)).front().tex_coord; }

void expect_near(const glm::dvec4& a, const glm::dvec4& b) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], kExact) << i;
}

TEST(TexGen, LeavesTheVertexsOwnCoordinatesWhereNoneIsGenerated) {
    expect_near(tex_coord("glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);"), {7, 8, 9, 1});
    EXPECT_TRUE(drawn("").texture.generated.empty());
    expect_near(tex_coord("glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); glEnable(GL_TEXTURE_GEN_S);"),
                {1, 8, 9, 1});
}

TEST(TexGen, OfObjectCoordinatesIgnoresTheModelview) {
    expect_near(
        tex_coord("glTranslatef(5, 6, 7); glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);"
                  "glTexGenfv(GL_T, GL_OBJECT_PLANE, (GLfloat[]){1, 10, 100, 1000}); glEnable(GL_TEXTURE_GEN_T);"),
        {7, 1 + 20 + 300 + 1000, 9, 1});
}

// The plane is given where the modelview matrix is a translation by (5, 0, 0): there x_eye - 5 is x. Then the object is drawn under
// another matrix: x_eye is 1 + 2.
TEST(TexGen, OfEyeCoordinatesTakesTheInverseModelviewOfTheCall) {
    expect_near(
        tex_coord("glEnable(GL_TEXTURE_GEN_S); glPushMatrix(); glTranslatef(5, 0, 0);"
                  "glTexGenfv(GL_S, GL_EYE_PLANE, (GLfloat[]){1, 0, 0, 0}); glPopMatrix(); glTranslatef(2, 0, 0);"),
        {3 - 5, 8, 9, 1});
    const State state = after("glScalef(2, 1, 1); glTexGenfv(GL_Q, GL_EYE_PLANE, (GLfloat[]){1, 0, 0, 3});");
    EXPECT_EQ(tex_gen_answer(state, kGL_Q, kGL_EYE_PLANE), (Answer{0.5, 0, 0, 3}));
}

// RULING.
TEST(TexGen, OfEyeCoordinatesIs0WhereTheMatrixOfTheCallIsSingular) {
    expect_near(tex_coord("glEnable(GL_TEXTURE_GEN_S); glPushMatrix(); glScalef(0, 1, 1);"
                          "glTexGenfv(GL_S, GL_EYE_PLANE, (GLfloat[]){1, 1, 1, 1}); glPopMatrix();"),
                {0, 8, 9, 1});
}

// The vertex is at (1, 2, 3) - (1, 2, 13) = (0, 0, -10): u = (0, 0, -1). The normal is (0.6, 0, 0.8): n . u = -0.8, so
// r = u + 1.6 n = (0.96, 0, 0.28) and m = 2 sqrt(0.96^2 + 1.28^2) = 3.2.
TEST(TexGen, OfReflectionsFollowsTheEquation) {
    const auto text = [](const char* mode) {
        return std::string("glTranslatef(-1, -2, -13); glNormal3f(0.6, 0, 0.8);") +
               "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, " + mode + "); glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, " + mode +
               "); glEnable(GL_TEXTURE_GEN_S); glEnable(GL_TEXTURE_GEN_T);";
    };
    const std::string r = "glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP); glEnable(GL_TEXTURE_GEN_R);";
    constexpr double kFloat = 1e-7;  // 0.6 and 0.8 are floats
    const glm::dvec4 reflection = tex_coord(text("GL_REFLECTION_MAP") + r), sphere = tex_coord(text("GL_SPHERE_MAP"));
    EXPECT_NEAR(reflection.s, 0.96, kFloat);
    EXPECT_NEAR(reflection.t, 0, kFloat);
    EXPECT_NEAR(reflection.p, 0.28, kFloat);
    EXPECT_NEAR(sphere.s, 0.96 / 3.2 + 0.5, kFloat);
    EXPECT_NEAR(sphere.t, 0.5, kFloat);
    EXPECT_EQ(sphere.p, 9);
    const glm::dvec4 normal = tex_coord(text("GL_NORMAL_MAP"));
    EXPECT_NEAR(normal.s, 0.6, kFloat);
    EXPECT_NEAR(normal.t, 0, kFloat);
}

// RULING: the ray is reflected straight away from the eye, so that r = (0, 0, -1) and m = 0.
TEST(TexGen, OfASphereMapIsAHalfWhereMIs0) {
    expect_near(
        tex_coord("glTranslatef(-1, -2, -13); glNormal3f(1, 0, 0); glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);"
                  "glEnable(GL_TEXTURE_GEN_S);"),
        {0.5, 8, 9, 1});
}

TEST(TexGen, NormalsAreScaledTo1OnlyIfGlNormalizeIsOn) {
    const std::string text =
        "glScalef(0.5, 0.5, 0.5); glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glEnable(GL_TEXTURE_GEN_R);";
    expect_near(tex_coord(text), {7, 8, 2, 1});
    expect_near(tex_coord(text + "glEnable(GL_NORMALIZE);"), {7, 8, 1, 1});
    expect_near(tex_coord(text + "glEnable(GL_RESCALE_NORMAL);"), {7, 8, 1, 1});
}

TEST(TexGen, ComesBeforeTheTextureMatrix) {
    expect_near(tex_coord("glMatrixMode(GL_TEXTURE); glScalef(10, 1, 1); glMatrixMode(GL_MODELVIEW);"
                          "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR); glEnable(GL_TEXTURE_GEN_S);"),
                {10, 8, 9, 1});
}

TEST(TexGen, IsRefusedAsGlRefusesIt) {
    const auto error = [](std::string_view text) {
        const State state = after(text);
        return state.errors().empty() ? std::string() : state.errors().front().message;
    };
    EXPECT_EQ(
        error("glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);"),
        "glTexGeni is given GL_SPHERE_MAP; expected GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_REFLECTION_MAP, GL_NORMAL_MAP");
    EXPECT_NE(error("glTexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);"), "");
    EXPECT_NE(error("glTexGeni(GL_LINEAR, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);"), "");
    EXPECT_NE(error("glTexGeni(GL_S, GL_LINEAR, GL_OBJECT_LINEAR);"), "");
    EXPECT_EQ(error("glTexGenf(GL_S, GL_EYE_PLANE, 1);"),
              "glTexGenf sets a single value, but GL_EYE_PLANE has 4; use glTexGenfv");
    EXPECT_EQ(error("glTexGeniv(GL_S, GL_TEXTURE_GEN_MODE, (GLint[]){GL_SPHERE_MAP});"), "");
}

TEST(TexGen, IsSavedByGlPushAttrib) {
    const auto enabled = [](const char* mask) {
        return *after(std::string("glPushAttrib(") + mask + "); glEnable(GL_TEXTURE_GEN_S);" +
                      "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glPopAttrib();")
                    .capability(kGL_TEXTURE_GEN_S);
    };
    EXPECT_FALSE(enabled("GL_ENABLE_BIT"));
    EXPECT_FALSE(enabled("GL_TEXTURE_BIT"));
    EXPECT_TRUE(enabled("GL_LIGHTING_BIT"));
    const State state =
        after("glPushAttrib(GL_ENABLE_BIT); glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP); glPopAttrib();");
    EXPECT_EQ(tex_gen_answer(state, kGL_S, kGL_TEXTURE_GEN_MODE), (Answer{kGL_NORMAL_MAP}));
}

TEST(TexGen, BelongsToTheActiveUnit) {
    EXPECT_TRUE(drawn("glActiveTexture(GL_TEXTURE1); glEnable(GL_TEXTURE_GEN_S); glActiveTexture(GL_TEXTURE0);")
                    .texture.generated.empty());
}

// ---- The plan ----

Draw generating(Enum mode, int coordinate = 0) {
    Draw draw = lit_triangle();
    auto texture = std::make_shared<Texture>();
    texture->levels = {{.width = 1, .height = 1, .texels = {glm::vec4(1)}}};
    texture->min_filter = kGL_LINEAR;
    draw.texture.texture = texture;
    draw.texture.generated = {{.coordinate = coordinate, .mode = mode, .plane = {1, 0, 0, 0}}};
    return draw;
}

TEST(TexGenPlan, TreatsBothKindsOfPlanesAlike) {
    EXPECT_EQ(facts(generating(kGL_EYE_LINEAR)), facts(generating(kGL_OBJECT_LINEAR)));
    EXPECT_NE(facts(generating(kGL_NORMAL_MAP)), facts(generating(kGL_OBJECT_LINEAR)));
}

TEST(TexGenPlan, LeavesOutWhatTheTextureDoesNotUse) {
    EXPECT_FALSE(facts(generating(kGL_NORMAL_MAP, 2)).texture.generates());
    EXPECT_EQ(reason(generating(kGL_NORMAL_MAP, 2), "the generated texture coordinate r"),
              "the texture does not use it");
    Draw mixed = generating(kGL_NORMAL_MAP, 2);
    mixed.texture.texture_matrix[2][0] = 1;
    EXPECT_TRUE(facts(mixed).texture.generates());
    Draw projected = generating(kGL_EYE_LINEAR, 3);
    EXPECT_TRUE(facts(projected).texture.q);
}

TEST(TexGenPlan, SendsTextureCoordinatesOnlyIfOneIsNotGenerated) {
    Draw draw = generating(kGL_SPHERE_MAP);
    EXPECT_TRUE(facts(draw).takes_tex_coord());
    draw.texture.generated.push_back({.coordinate = 1, .mode = kGL_SPHERE_MAP});
    EXPECT_FALSE(facts(draw).takes_tex_coord());
    draw.lighting.enabled = false;
    EXPECT_TRUE(facts(draw).takes_normal());
    EXPECT_FALSE(facts(draw).needs_normal());
}

}  // namespace
}  // namespace twinlight::tex_gen_test

// Evaluators (GL 2.1, section 5.1), by hand.
#include "scene/state/evaluators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::evaluators_test {
namespace {

constexpr double kExact = 1e-12;

State after(const std::string& text) {
    State state;
    for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
    return state;
}

std::string error_of(const std::string& text) {
    const State state = after(text);
    return state.errors().empty() ? "" : state.errors().front().message;
}

std::vector<Draw> draws(const std::string& text) {
    const State state = after(text);
    EXPECT_TRUE(state.errors().empty()) << state.errors().front().message;
    std::vector<Draw> all;
    for (const auto& item : state.items()) all.push_back(std::get<Draw>(item));
    return all;
}

void expect_near(const glm::dvec4& a, const glm::dvec4& b) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], kExact) << i;
}

// A parabola: x = u, y = 2 u (1 - u).
const std::string kCurve =
    "glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 3, (GLfloat[]){0, 0, 0, 0.5, 1, 0, 1, 0, 0}); glEnable(GL_MAP1_VERTEX_3);\n";
// The unit square with z = x y; x goes with u.
const std::string kPatch =
    "glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, (GLfloat[]){0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1});\n"
    "glEnable(GL_MAP2_VERTEX_3);\n";

Vertex point(const std::string& text) {
    const std::vector<Draw> all = draws("glBegin(GL_POINTS);" + text + "glEnd();");
    return all.back().vertices.at(0);
}
Vertex after_state(const std::string& state, const std::string& text) {
    return draws(state + "glBegin(GL_POINTS);" + text + "glEnd();").back().vertices.at(0);
}

TEST(Evaluators, SendPointsOfACurve) {
    expect_near(after_state(kCurve, "glEvalCoord1f(0.25);").position_object, {0.25, 0.375, 0, 1});
    expect_near(after_state(kCurve, "glEvalCoord1f(0);").position_object, {0, 0, 0, 1});
    expect_near(after_state(kCurve, "glEvalCoord1f(1);").position_object, {1, 0, 0, 1});
    expect_near(after_state(kCurve, "glEvalCoord1f(2);").position_object, {2, -4, 0, 1});  // beyond the domain
}

TEST(Evaluators, ScaleTheDomainAndStepOverTheStride) {
    const std::string curve =
        "glMap1f(GL_MAP1_VERTEX_4, 2, 6, 5, 2, (GLfloat[]){0, 0, 0, 1, 99, 4, 0, 0, 3}); glEnable(GL_MAP1_VERTEX_4);";
    expect_near(after_state(curve, "glEvalCoord1d(3);").position_object, {1, 0, 0, 1.5});
}

TEST(Evaluators, SendNothingWithoutAMapOfVertices) {
    EXPECT_EQ(draws("glBegin(GL_POINTS); glVertex2f(0, 0); glEvalCoord1f(0.5); glEnd();").back().vertices.size(), 1U);
    EXPECT_TRUE(draws("glEnable(GL_MAP2_NORMAL); glEvalMesh2(GL_FILL, 0, 4, 0, 4);").empty());
    EXPECT_EQ(point("glVertex2f(3, 4);").position_object.x, 3);
}

// 5.1: the current values stay as they are.
TEST(Evaluators, ReplaceOnlyWhatAMapGivesAndOnlyForThisVertex) {
    const std::string maps =
        kCurve +
        "glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 2, (GLfloat[]){0, 0, 0, 1, 1, 0.5, 0, 1}); glEnable(GL_MAP1_COLOR_4);"
        "glMap1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, (GLfloat[]){5, 6, 7, 8}); glEnable(GL_MAP1_TEXTURE_COORD_2);"
        "glColor4f(0.1, 0.2, 0.3, 0.4); glNormal3f(1, 0, 0);";
    const Draw draw = draws(maps + "glBegin(GL_POINTS); glEvalCoord1f(0.5); glVertex2f(9, 9); glEnd();").back();
    expect_near(draw.vertices[0].color, {0.5, 0.25, 0, 1});
    expect_near(draw.vertices[0].tex_coord, {6, 7, 0, 1});
    EXPECT_EQ(draw.vertices[0].normal_object, glm::dvec3(1, 0, 0));
    EXPECT_NEAR(draw.vertices[1].color.a, 0.4, 1e-7);
    expect_near(draw.vertices[1].tex_coord, {0, 0, 0, 1});
}

TEST(Evaluators, PreferTheMapOfMoreCoordinates) {
    const std::string both =
        kCurve + "glMap1f(GL_MAP1_VERTEX_4, 0, 1, 4, 1, (GLfloat[]){1, 2, 3, 4}); glEnable(GL_MAP1_VERTEX_4);";
    expect_near(after_state(both, "glEvalCoord1f(0.5);").position_object, {1, 2, 3, 4});
}

// The tangents at (u, v) are (1, 0, v) and (0, 1, u), their cross product (-v, -u, 1).
TEST(Evaluators, FindNormalsOfSurfacesByThemselves) {
    const std::string automatic = kPatch + "glEnable(GL_AUTO_NORMAL); glEnable(GL_MAP2_NORMAL);";
    const Vertex vertex = after_state(automatic, "glEvalCoord2f(0.5, 0.25);");
    expect_near(vertex.position_object, {0.5, 0.25, 0.125, 1});
    const glm::dvec3 expected = glm::dvec3(-0.25, -0.5, 1) / std::sqrt(0.0625 + 0.25 + 1);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(vertex.normal_object[i], expected[i], kExact);
    EXPECT_EQ(after_state(kPatch + "glNormal3f(0, 1, 0);", "glEvalCoord2f(0.5, 0.25);").normal_object,
              glm::dvec3(0, 1, 0));
}

// The same surface with w = 2 everywhere, and with w = 1 + u: x / w and y / w have other tangents, but z / w = 0.
TEST(Evaluators, FindNormalsOfRationalSurfaces) {
    const auto normal = [](const char* points) {
        return after_state(std::string("glEnable(GL_AUTO_NORMAL); glEnable(GL_MAP2_VERTEX_4);"
                                       "glMap2f(GL_MAP2_VERTEX_4, 0, 1, 8, 2, 0, 1, 4, 2, (GLfloat[]){") +
                               points + "});",
                           "glEvalCoord2f(0.5, 0.5);")
            .normal_object;
    };
    for (const char* points :
         {"0, 0, 0, 2,  0, 2, 0, 2,  2, 0, 0, 2,  2, 2, 0, 2", "0, 0, 0, 1,  0, 1, 0, 1,  2, 0, 0, 2,  2, 2, 0, 2"}) {
        EXPECT_NEAR(glm::length(normal(points) - glm::dvec3(0, 0, 1)), 0, kExact) << points;
    }
}

// RULING.
TEST(Evaluators, GiveNoNormalWhereASurfaceEndsInAPoint) {
    const std::string cone =
        "glMap2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, (GLfloat[]){0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 0});"
        "glEnable(GL_MAP2_VERTEX_3); glEnable(GL_AUTO_NORMAL);";
    EXPECT_EQ(after_state(cone, "glEvalCoord2f(0, 0.5);").normal_object, glm::dvec3(0));
}

TEST(Evaluators, DrawMeshesAsTheLoopsOfTheSpecification) {
    const std::string grid = kPatch + "glMapGrid2f(2, 0, 1, 3, 0, 1);";
    const std::vector<Draw> fill = draws(grid + "glEvalMesh2(GL_FILL, 0, 2, 0, 3);");
    ASSERT_EQ(fill.size(), 3U);
    EXPECT_EQ(fill[0].mode, kGL_QUAD_STRIP);
    ASSERT_EQ(fill[0].vertices.size(), 6U);
    expect_near(fill[1].vertices[2].position_object, {0.5, 1.0 / 3, 1.0 / 6, 1});
    expect_near(fill[1].vertices[3].position_object, {0.5, 2.0 / 3, 1.0 / 3, 1});
    const std::vector<Draw> lines = draws(grid + "glEvalMesh2(GL_LINE, 0, 2, 0, 3);");
    ASSERT_EQ(lines.size(), 4U + 3U);
    EXPECT_EQ(lines[0].mode, kGL_LINE_STRIP);
    EXPECT_EQ(lines[0].vertices.size(), 3U);
    EXPECT_EQ(lines[4].vertices.size(), 4U);
    const std::vector<Draw> points = draws(grid + "glEvalMesh2(GL_POINT, 1, 2, 1, 1);");
    ASSERT_EQ(points.size(), 1U);
    ASSERT_EQ(points[0].vertices.size(), 2U);
    expect_near(points[0].vertices[0].position_object, {0.5, 1.0 / 3, 1.0 / 6, 1});
    const std::vector<Draw> curve = draws(kCurve + "glMapGrid1d(4, 0, 1); glEvalMesh1(GL_LINE, 0, 4);");
    ASSERT_EQ(curve.size(), 1U);
    expect_near(curve[0].vertices[1].position_object, {0.25, 0.375, 0, 1});
    expect_near(after_state(kCurve + "glMapGrid1d(4, 0, 1);", "glEvalPoint1(1);").position_object, {0.25, 0.375, 0, 1});
    expect_near(after_state(grid, "glEvalPoint2(1, 2);").position_object, {0.5, 2.0 / 3, 1.0 / 3, 1});
}

TEST(Evaluators, WorkInDisplayLists) {
    EXPECT_EQ(
        draws(kCurve + "glNewList(1, GL_COMPILE); glEvalMesh1(GL_POINT, 0, 1); glEndList(); glCallList(1);").size(),
        1U);
}

TEST(Evaluators, AreRefusedAsGlRefusesThem) {
    EXPECT_EQ(error_of("glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, (GLfloat[6]){0});"),
              "glMap1f is given a domain that starts and ends at 1");
    EXPECT_EQ(error_of("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, (GLfloat[93]){0});"),
              "glMap1f is given the order 31; it must be from 1 to 30");
    EXPECT_EQ(error_of("glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, (GLfloat[9]){0});"),
              "glMap1f is given the stride 2; GL_MAP1_VERTEX_3 has 3 numbers a control point");
    EXPECT_EQ(error_of("glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, (GLfloat[6]){0});"),
              "glMap1f is given GL_MAP2_VERTEX_3; expected GL_MAP1_VERTEX_3, GL_MAP1_COLOR_4, ...");
    EXPECT_NE(error_of("glActiveTexture(GL_TEXTURE1); glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, (GLfloat[6]){0});"), "");
    EXPECT_EQ(error_of("glMapGrid1f(0, 0, 1);"), "glMapGrid1f is given 0 segments; the number must be 1 or more");
    EXPECT_NE(error_of("glEvalMesh1(GL_FILL, 0, 1);"), "");
    EXPECT_NE(error_of("glBegin(GL_POINTS); glEvalMesh1(GL_LINE, 0, 1); glEnd();"), "");
}

TEST(Evaluators, GridsAreSavedByGlPushAttribAndMapsAreNot) {
    const State state = after("glPushAttrib(GL_EVAL_BIT); glMapGrid1f(7, 2, 3); glMapGrid2f(4, 0, 1, 5, 2, 3);" +
                              kCurve + "glPopAttrib();");
    EXPECT_EQ(answer(state, kGL_MAP1_GRID_SEGMENTS), Answer{1});
    EXPECT_EQ(answer(state, kGL_MAP2_GRID_SEGMENTS), (Answer{1, 1}));
    EXPECT_EQ(answer(state, kGL_MAP1_VERTEX_3), Answer{0});
    EXPECT_EQ(answer(after("glMapGrid2f(4, 0, 1, 5, 2, 3);"), kGL_MAP2_GRID_DOMAIN), (Answer{0, 1, 2, 3}));
}

}  // namespace
}  // namespace twinlight::evaluators_test

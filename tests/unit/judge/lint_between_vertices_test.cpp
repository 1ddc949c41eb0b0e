// Light that falls between the vertices of a surface: the linter finds it where the picture would show it, and only there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "lint_warnings.h"

namespace twinlight::lint_between_vertices_test {
namespace {

using lint_test::changed, lint_test::names, lint_test::warnings_of;
using Names = std::set<std::string>;

// A floor of one quadrilateral, seen from the front.
const std::string kView =
    "glMatrixMode(GL_PROJECTION); gluPerspective(60, 4.0 / 3.0, 0.1, 100); glMatrixMode(GL_MODELVIEW);"
    "gluLookAt(0, 5, 16,  0, 3, 0,  0, 1, 0); glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n";
const std::string kFloor =
    "glBegin(GL_QUADS); glNormal3f(0, 1, 0); glVertex3f(-10, 0, 10); glVertex3f(10, 0, 10); glVertex3f(10, 0, -10);"
    "glVertex3f(-10, 0, -10); glEnd();\n";
// The same floor, divided.
std::string tiles(int count) {
    std::string text = "glNormal3f(0, 1, 0);\n";
    const double size = 20.0 / count;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
            text += fmt::format("glRectf({}, {}, {}, {});", -10 + i * size, -10 + j * size, -10 + (i + 1) * size,
                                -10 + (j + 1) * size);
    // glRect draws in the plane z = 0.
    return "glPushMatrix(); glRotatef(-90, 1, 0, 0); " + changed(text, "(0, 1, 0)", "(0, 0, 1)") + "glPopMatrix();\n";
}
const std::string kSpot =
    "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 7.5, 0, 1});"
    "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 35);\n";
const std::string kLamp =
    "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1});"
    "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1);\n";
const std::string kShiny =
    "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 8, -6, 1}); glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){0, 0, "
    "0, 1});"
    "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 60);\n";
const std::string kBall = "glTranslatef(0, 2, 0); glutSolidSphere(0.5, 30, 20);\n";

// 2.14.1: the diffuse light straight below is 0.8 n . VP = 0.8, and 0.8 / (1 + 0.1 * 1^2) = 0.73 with the attenuation.
TEST(LintBetweenVertices, FindsEachKindOfLightThatASurfaceLoses) {
    const auto spot = warnings_of(kView + kSpot + kFloor + kBall);  // a ball in the cone does not help the floor
    EXPECT_EQ(names(spot), Names{"spot-between-vertices"});
    EXPECT_NE(spot[0].message.find("would add 0.80"), std::string::npos) << spot[0].message;
    EXPECT_EQ(spot[0].place.line, 3);
    const auto lamp = warnings_of(kView + kLamp + kFloor);
    EXPECT_EQ(names(lamp), Names{"lamp-between-vertices"});
    EXPECT_NE(lamp[0].message.find("would add 0.73"), std::string::npos) << lamp[0].message;
    EXPECT_EQ(names(warnings_of(kView + kShiny + kFloor)), Names{"highlight-between-vertices"});
}

TEST(LintBetweenVertices, IsSilentWhereVerticesGetTheLight) {
    for (const std::string& light : {kSpot, kLamp, kShiny}) {
        EXPECT_EQ(names(warnings_of(kView + light + tiles(40))), Names{}) << light;
        EXPECT_EQ(names(warnings_of(kView + light + kBall)), Names{}) << light;
    }
    // Coarse, but a vertex is in the middle of the light.
    EXPECT_EQ(names(warnings_of(kView + kSpot + tiles(2))), Names{});
    EXPECT_EQ(names(warnings_of(kView + kLamp + tiles(2))), Names{});
    // A lamp far above: the corners are darker, but not black.
    EXPECT_EQ(
        names(warnings_of(kView + changed(changed(kLamp, "{0, 1, 0, 1}", "{0, 12, 0, 1}"), "0.1", "0.001") + kFloor)),
        Names{});
    // Another light is so bright that nothing is missing.
    const std::string sun =
        "glEnable(GL_LIGHT1); glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){0, 1, 0, 0});"
        "glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1.2, 1.2, 1.2, 1});";
    EXPECT_EQ(names(warnings_of(kView + sun + kLamp + kFloor)), Names{});
}

TEST(LintBetweenVertices, IsSilentWhereThePictureDoesNotShowThePlace) {
    const std::string wall =
        "glBegin(GL_QUADS); glNormal3f(0, 0, 1); glVertex3f(-20, -5, 12); glVertex3f(20, -5, 12); glVertex3f(20, 15, "
        "12);"
        "glVertex3f(-20, 15, 12); glEnd();\n";
    EXPECT_EQ(names(warnings_of(kView + kSpot + wall + kFloor + kBall)), Names{});
    EXPECT_EQ(names(warnings_of(kView + kSpot + kFloor + kBall + wall)), Names{});
    // Culled: the floor's front is its top, so nothing of it is left.
    const std::string culls = "glEnable(GL_CULL_FACE); glCullFace(GL_FRONT);\n";
    EXPECT_EQ(names(warnings_of(kView + culls + kSpot + kFloor + "glDisable(GL_CULL_FACE);" + kBall)), Names{});
    // The camera looks above the floor.
    EXPECT_EQ(names(warnings_of(changed(kView, "0, 3, 0", "0, 12, 0") + kSpot + kFloor +
                                changed(kBall, "0, 2, 0", "0, 6, 0"))),
              Names{});
}

// Each surface by itself, whatever other walls of the same glBegin get.
TEST(LintBetweenVertices, ComparesTheVerticesOfOnePlane) {
    const std::string room =
        changed(kFloor, "glEnd();",
                "glNormal3f(0, 0, 1); glVertex3f(-10, 0, -10); glVertex3f(10, 0, -10); glVertex3f(10, 1, -10);"
                "glVertex3f(0, 1, -10); glEnd();");
    EXPECT_EQ(names(warnings_of(kView + changed(kSpot, "{0, 7.5, 0, 1}", "{0, 7.5, -5.5, 1}") + room)),
              Names{"spot-between-vertices"});
}

}  // namespace
}  // namespace twinlight::lint_between_vertices_test

// Normals on the wrong side of a surface, and one normal for faces in many directions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "judge/lint/watch.h"
#include "lint_warnings.h"

namespace twinlight::lint_normals_test {
namespace {

using lint_test::changed, lint_test::names, lint_test::warnings_of;
using Names = std::set<std::string>;

const std::string kView =
    "glMatrixMode(GL_PROJECTION); gluPerspective(45, 4.0 / 3.0, 1, 50); glMatrixMode(GL_MODELVIEW);"
    "gluLookAt(3, 3, 5,  0, 0, 0,  0, 1, 0); glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){4, 6, 3, 1});"
    "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n";

// A quadrilateral with this normal.
struct Quad {
    std::string normal;
    std::array<const char*, 4> corners;
};
std::string text_of(const Quad& quad) {
    std::string text = "glBegin(GL_QUADS); glNormal3f(" + quad.normal + ");";
    for (const char* corner : quad.corners) text += fmt::format("glVertex3f({});", corner);
    return text + " glEnd();\n";
}
Quad reversed(Quad quad) {
    std::ranges::reverse(quad.corners);
    return quad;
}
Quad turned(Quad quad, const std::string& normal) {
    quad.normal = normal;
    return quad;
}
// The front, top and right of a cube, counter-clockwise from outside.
const Quad kFront{"0, 0, 1", {"-1, -1, 1", "1, -1, 1", "1, 1, 1", "-1, 1, 1"}};
const Quad kTop{"0, 1, 0", {"-1, 1, 1", "1, 1, 1", "1, 1, -1", "-1, 1, -1"}};
const Quad kRight{"1, 0, 0", {"1, -1, 1", "1, -1, -1", "1, 1, -1", "1, 1, 1"}};
const Quad kBottom{"0, -1, 0", {"-1, -1, -1", "1, -1, -1", "1, -1, 1", "-1, -1, 1"}};

TEST(LintNormals, FindsAFaceWithATurnedNormalInAnyOrderOfItsVertices) {
    const Quad top = turned(kTop, "0, -1, 0");
    for (const Quad& quad : {top, reversed(top)}) {
        for (const bool is_first : {false, true}) {
            const auto warnings = warnings_of(kView + (is_first ? text_of(quad) + "\n" : "") + text_of(kFront) +
                                              (is_first ? "" : text_of(quad)) + text_of(kRight));
            ASSERT_EQ(names(warnings), Names{"normals-turned"});
            EXPECT_EQ(warnings[0].place.line, is_first ? 2 : 3);
            EXPECT_NE(warnings[0].fix.find("glNormal3f(0, 1, 0)"), std::string::npos) << warnings[0].fix;
        }
    }
}

TEST(LintNormals, IsSilentAboutRightNormalsWhateverTheOrder) {
    for (const Quad& top : {kTop, reversed(kTop)})
        EXPECT_EQ(names(warnings_of(kView + text_of(kFront) + text_of(top) + text_of(kRight))), Names{});
    // A room: all normals point inwards, to the viewer or, where a wall is seen from outside, not.
    const std::string inwards =
        text_of(turned(kFront, "0, 0, -1")) + text_of(turned(kTop, "0, -1, 0")) + text_of(turned(kRight, "-1, 0, 0"));
    EXPECT_EQ(names(warnings_of(changed(kView, "{4, 6, 3, 1}", "{0, 0, 0, 1}") + inwards)), Names{});
    // Not seen: the bottom.
    EXPECT_EQ(names(warnings_of(kView + text_of(kFront) + text_of(kTop) + text_of(turned(kBottom, "0, 1, 0")))),
              Names{});
    // Each face twice, once for each side.
    std::string both;
    for (const auto& [quad, back] : {std::pair{kFront, "0, 0, -1"}, {kTop, "0, -1, 0"}, {kRight, "-1, 0, 0"}})
        both += text_of(quad) + text_of(turned(reversed(quad), back));
    EXPECT_EQ(names(warnings_of(kView + both)), Names{});
    // Faces that do not meet are no surface: each may show its back.
    EXPECT_EQ(
        names(warnings_of(kView + text_of(kFront) + "glTranslatef(0, 0.2, 0);" + text_of(turned(kTop, "0, -1, 0")))),
        Names{"back-seen"});
    // A wall that stands on a floor, with the same border: the wall shows its lit side.
    EXPECT_EQ(names(warnings_of(kView + text_of(turned(kBottom, "0, 1, 0")) + text_of(kFront))), Names{});
}

// 2.14.1: with two-sided lighting, GL turns the normals of back faces.
TEST(LintNormals, KnowsTheNormalsThatTwoSidedLightingTurns) {
    const std::string two_sided = kView + "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);";
    const Quad top = turned(kTop, "0, -1, 0");
    EXPECT_EQ(names(warnings_of(two_sided + text_of(kFront) + text_of(kRight) + text_of(kTop))), Names{});
    EXPECT_EQ(names(warnings_of(two_sided + text_of(kFront) + text_of(kRight) + text_of(reversed(top)))), Names{});
}

// A ring whose normals are its positions, as those of a ball are: wrong where it faces its hole.
TEST(LintNormals, FindsASmoothSurfaceWhoseNormalsTurnGradually) {
    const auto ring = [](bool is_right) {
        std::string text;
        const double kTurn = 2 * std::acos(-1);
        for (int i = 0; i < 24; ++i) {
            text += "glBegin(GL_QUAD_STRIP);";
            for (int j = 0; j <= 16; ++j) {
                for (const int k : {i, i + 1}) {
                    const double u = kTurn * k / 24, v = kTurn * j / 16, r = 1 + 0.35 * std::cos(v);
                    const glm::dvec3 position(r * std::cos(u), r * std::sin(u), 0.35 * std::sin(v));
                    const glm::dvec3 normal =
                        is_right ? glm::dvec3(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v))
                                 : glm::normalize(position);
                    text += fmt::format("glNormal3f({}, {}, {}); glVertex3f({}, {}, {});", normal.x, normal.y, normal.z,
                                        position.x, position.y, position.z);
                }
            }
            text += "glEnd();\n";
        }
        return text;
    };
    EXPECT_EQ(names(warnings_of(kView + ring(false))), Names{"normals-turned"});
    EXPECT_EQ(names(warnings_of(kView + ring(true))), Names{});
}

// 2.7: without glNormal, all normals are (0, 0, 1), whatever the slope.
TEST(LintNormals, FindsAMissingNormalOfASlope) {
    const auto triangle = [](double depth) {
        return kView +
               fmt::format(
                   "glBegin(GL_TRIANGLES); glVertex3f(0, 1, {}); glVertex3f(-1, -1, 0); glVertex3f(1, -1, 0); glEnd();",
                   -depth);
    };
    EXPECT_EQ(names(warnings_of(triangle(2))), Names{"normal-missing"});  // 45 degrees
    EXPECT_EQ(names(warnings_of(triangle(0.3))), Names{});
    EXPECT_EQ(names(warnings_of(changed(triangle(2), "glBegin", "glNormal3f(0, 0, 1); glBegin"))), Names{});
}

// 2.14.1: one-sided lighting lights a back face like its front.
TEST(LintNormals, FindsABackThatIsSeenInTheLight) {
    const std::string wrong = lint::wrong_scene(*lint::find_rule("back-seen"));
    EXPECT_EQ(names(warnings_of(wrong)), Names{"back-seen"});
    // Closed; culled; the light on the other side.
    EXPECT_EQ(names(warnings_of(wrong + "glTranslatef(0, 0, 1.2); gluDisk(tube, 0, 1.5, 40, 10);")), Names{});
    EXPECT_EQ(names(warnings_of(changed(wrong, "glRotatef(-60", "glEnable(GL_CULL_FACE); glRotatef(-60"))), Names{});
    EXPECT_EQ(names(warnings_of(changed(wrong, "{3, 4, 5, 1}", "{0, 0, -9, 1}"))), Names{});
    // A projection that is never set looks along z.
    EXPECT_EQ(names(warnings_of("glClear(GL_DEPTH_BUFFER_BIT); glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING);"
                                "glEnable(GL_LIGHT0); glutSolidSphere(0.8, 20, 20);")),
              Names{});
}

// A tent of four slopes of this height over a square.
std::string tent(double height) {
    return fmt::format(
        "glNormal3f(0, 1, 0);\nglBegin(GL_TRIANGLE_FAN); glVertex3f(0, {}, 0); glVertex3f(-2, 0, 2); glVertex3f(2, 0, "
        "2);"
        "glVertex3f(2, 0, -2); glVertex3f(-2, 0, -2); glVertex3f(-2, 0, 2); glEnd();",
        height);
}
TEST(LintNormals, FindsOneNormalForFacesInManyDirections) {
    const auto warnings = warnings_of(kView + tent(1.68));
    ASSERT_EQ(names(warnings), Names{"one-normal"});
    EXPECT_NE(warnings[0].fix.find("glNormal3f(0, 0.766, 0.643)"), std::string::npos) << warnings[0].fix;  // 40 degrees
    EXPECT_EQ(names(warnings_of(kView + tent(0.5))), Names{});
    EXPECT_EQ(names(warnings_of(kView + "glDisable(GL_LIGHTING);" + tent(1.68))), Names{});
    EXPECT_EQ(names(warnings_of(kView + text_of(kFront) + text_of(kTop) + text_of(kRight))), Names{});
}

TEST(LintNormals, AreRightOfWallsThatAreDrawnInBothOrders) {
    const std::string back = "glNormal3f(0, 0, -1);\n", side = "glNormal3f(-1, 0, 0);\n",
                      walls =
                          "glBegin(GL_QUADS);\nglNormal3f(0, 0, 1);\nglVertex3f(-1, -1, 0); glVertex3f(1, -1, 0); "
                          "glVertex3f(1, 1, 0); glVertex3f(-1, 1, 0);\n" +
                          back +
                          "glVertex3f(-1, 1, 0); glVertex3f(1, 1, 0); glVertex3f(1, -1, 0); glVertex3f(-1, -1, 0);\n"
                          "glNormal3f(1, 0, 0);\nglVertex3f(1, -1, 0); glVertex3f(1, -1, -2); glVertex3f(1, 1, -2); "
                          "glVertex3f(1, 1, 0);\n" +
                          side +
                          "glVertex3f(1, 1, 0); glVertex3f(1, 1, -2); glVertex3f(1, -1, -2); glVertex3f(1, -1, 0);\n"
                          "glEnd();\n",
                      seen = std::string(lint::view_lines()) + std::string(lint::light_lines());
    for (const std::string switched : {"", "glEnable(GL_CULL_FACE);\n", "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);\n"})
        EXPECT_EQ(names(warnings_of(seen + switched + walls)), std::set<std::string>{}) << switched;
    // With one normal for both orders, two-sided lighting turns it.
    EXPECT_EQ(names(warnings_of(seen + "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);\n" +
                                changed(changed(walls, back, ""), side, ""))),
              std::set<std::string>{});
}

}  // namespace
}  // namespace twinlight::lint_normals_test

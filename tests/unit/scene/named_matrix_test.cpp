// Matrices of GLU, as recordings have them. Each is derived by hand from the formulas of gluPerspective and gluLookAt.
#include <gtest/gtest.h>

#include <string>

#include "scene/command/text.h"

namespace twinlight::named_matrix_test {
namespace {

// The comment of the first command, or "".
std::string comment_of(const std::string& commands) {
    const std::string text = print_scene(read_scene(commands, "a.gl", "a", {}));
    return text.starts_with("// the matrix of ") ? text.substr(17, text.find('\n') - 17) : "";
}

// f = cot 45 degrees = 1; (far + near) / (near - far) = -2, 2 far near / (near - far) = -3.
TEST(NamedMatrix, IsThatOfGluPerspective) {
    EXPECT_EQ(comment_of("glMultMatrixd((GLdouble[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0});"),
              "gluPerspective(90, 1, 1, 3)");
    EXPECT_EQ(comment_of("glLoadMatrixf((GLfloat[]){0.75, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0});"),
              "gluPerspective(90, 4.0 / 3, 1, 3)");
    // 1001 / -999 and 2000 / -999 as floats.
    EXPECT_EQ(
        comment_of("glLoadMatrixf((GLfloat[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.00200200, -1, 0, 0, -2.00200200, 0});"),
        "gluPerspective(90, 1, 1, 1000)");
}

// The eye is on the x axis: s = (0, 0, -1), u = (0, 1, 0), -f = (1, 0, 0) are the rows.
TEST(NamedMatrix, IsThatOfGluLookAt) {
    const std::string turn = "(GLfloat[]){0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1});";
    EXPECT_EQ(comment_of("glMultMatrixf(" + turn + "glTranslated(-5, 0, 0);"), "gluLookAt(5, 0, 0, 0, 0, 0, 0, 1, 0)");
    // Straight along the z axis gluLookAt multiplies with the identity first.
    EXPECT_EQ(
        comment_of(
            "glMultMatrixf((GLfloat[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}); glTranslated(0, 0, -30);"),
        "gluLookAt(0, 0, 30, 0, 0, 0, 0, 1, 0)");
    EXPECT_EQ(comment_of("glMultMatrixf(" + turn), "") << "without an eye it is a turn";
}

TEST(NamedMatrix, IsNamedOnlyWhereItFits) {
    EXPECT_EQ(comment_of("glMultMatrixd((GLdouble[]){1, 0, 0, 0, 0, 1.00001, 0, 0, 0, 0, -2, -1, 0.001, 0, -3, 0});"),
              "");
    EXPECT_EQ(
        comment_of(
            "glMultMatrixf((GLfloat[]){0, 0, 1, 0, 0, 1.01, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1}); glTranslated(-5, 0, 0);"),
        "");
    EXPECT_EQ(comment_of("glMultMatrixd((GLdouble[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1});"), "");
}

}  // namespace
}  // namespace twinlight::named_matrix_test

// Labels: #pragma twinlight label(x, y, z, "text") (docs/scene-language.md).
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "homework.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::labels_test {
namespace {

// A unit square that GL draws, in a view volume from -4 to 4 and -3 to 3; then these commands.
std::vector<SceneLabel> labels(const std::string& commands) {
    const std::string scene =
        "glMatrixMode(GL_PROJECTION); glOrtho(-4, 4, -3, 3, -10, 10); glMatrixMode(GL_MODELVIEW);\n"
        "glRectf(0, 0, 1, 1);\n" +
        commands;
    return make_frame(read_scene(scene, "scene.gl", "scene"), {}).labels;
}

std::vector<std::string> texts(const std::string& commands) {
    std::vector<std::string> result;
    for (const SceneLabel& label : labels(commands)) result.push_back(label.text);
    return result;
}

using Strings = std::vector<std::string>;

std::string label(const std::string& arguments) { return "#pragma twinlight label(" + arguments + ")\n"; }

TEST(Labels, AreAtTheirPointOfTheObject) {
    const auto found = labels("glTranslatef(1, 0, 0); glScalef(2, 2, 2);\n" + label("0.5, 0.75, 0, \"here\""));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].text, "here");
    EXPECT_EQ(found[0].place_picture, glm::dvec2((2 + 4) / 8.0, (1.5 + 3) / 6.0));
}

TEST(Labels, FollowTheViewport) {
    const auto found = labels("glViewport(320, 0, 320, 240);\n" + label("0, 0, 0, \"middle\""));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place_picture, glm::dvec2(0.75, 0.25));
}

TEST(Labels, OfAPerspectiveAreDividedByW) {
    const auto found = labels(
        "glMatrixMode(GL_PROJECTION); glLoadIdentity(); glFrustum(-1, 1, -1, 1, 1, 10); glMatrixMode(GL_MODELVIEW);\n" +
        label("2, 0, -4, \"right\""));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].place_picture, glm::dvec2(0.75, 0.5));
}

TEST(Labels, OutsideTheViewVolumeAreLeftOut) {
    EXPECT_EQ(texts(label("4.1, 0, 0, \"a\"") + label("0, -3.1, 0, \"b\"") + label("0, 0, 11, \"c\"") +
                    label("4, 3, 10, \"corner\"")),
              Strings{"corner"});
    // Behind the eye of a perspective, w is negative.
    EXPECT_EQ(texts("glMatrixMode(GL_PROJECTION); glLoadIdentity(); glFrustum(-1, 1, -1, 1, 1, 10); "
                    "glMatrixMode(GL_MODELVIEW);\n" +
                    label("0, 0, 5, \"behind\"")),
              Strings{});
}

TEST(Labels, OfADisplayListAreAtEachCall) {
    const auto found = labels("glNewList(1, GL_COMPILE);\n" + label("0, 0, 0, \"a\"") +
                              "glEndList(); glCallList(1); glTranslatef(2, 0, 0); glCallList(1);");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].place_picture.x, 0.5);
    EXPECT_EQ(found[1].place_picture.x, 0.75);
}

TEST(Labels, GoWithThePictureThatIsCleared) {
    const std::string clear = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glRectf(0, 0, 1, 1);\n";
    EXPECT_EQ(texts(label("0, 0, 0, \"a\"") + clear + label("0, 0, 0, \"b\"")), Strings{"b"});
    EXPECT_EQ(texts(label("0, 0, 0, \"a\"") + "glClear(GL_DEPTH_BUFFER_BIT);"), Strings{"a"});
    EXPECT_EQ(texts("GLuint hits[4]; glSelectBuffer(4, hits); glRenderMode(GL_SELECT);\n" + label("0, 0, 0, \"a\"")),
              Strings{});
}

TEST(Labels, PrintNumbersAsPrintfDoes) {
    EXPECT_EQ(texts("GLfloat n[] = {2, 32};\n" + label("0, 0, 0, \"n = %g, 50 %%\", 2 * n[1]")),
              Strings{"n = 64, 50 %"});
    EXPECT_EQ(texts(label("0, 0, 0, \"%d of %.2f\", 4 / 3, 4.0 / 3")), Strings{"1 of 1.33"});
}

TEST(Labels, OfALoopHaveTheLoopsNumbers) {
    const CommandList program = homework::read_program(
        "void display(void) { int i; char name[20]; for (i = 1; i < 3; ++i) { glTranslatef(0.1, 0, 0);\n" +
        label("0, 0, 0, \"n = %d\", 1 << i") + "sprintf(name, \"sphere %d\", i);\n" + label("0, 0.5, 0, name") +
        "glutSolidSphere(0.1, 8, 8); } }\n"
        "int main(int argc, char** argv) { glutInit(&argc, argv); glutCreateWindow(\"a\"); "
        "glutDisplayFunc(display); glutMainLoop(); return 0; }\n");
    std::vector<std::string> found;
    for (const SceneLabel& made : make_frame(program, {}).labels) found.push_back(made.text);
    EXPECT_EQ(found, (Strings{"n = 2", "sphere 1", "n = 4", "sphere 2"}));
}

TEST(Labels, ArePrintedWithTheirNumbers) {
    const CommandList scene = read_scene(label("0, 1, 0, \"n = %g, 50 %%\", 8"), "scene.gl", "scene");
    EXPECT_EQ(print_scene(scene), "#pragma twinlight label(0, 1, 0, \"n = 8, 50 %%\")\n");
}

// No Draw and no state of a Draw comes from a label.
TEST(Labels, ChangeNoDraw) {
    const std::string square = "glRectf(0, 0, 1, 1);\n";
    const Frame with = make_frame(read_scene(square + label("0, 0, 0, \"a\"") + square, "scene.gl", "scene"), {});
    ASSERT_EQ(with.items.size(), 2u);
    EXPECT_EQ(with.draws()[0]->place.line, 1);
    EXPECT_EQ(with.draws()[1]->place.line, 3);
}

}  // namespace
}  // namespace twinlight::labels_test

// Scenes with steps: #pragma twinlight step("...") (docs/scene-language.md).
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/command/text.h"
#include "scene/scenes/load.h"

namespace twinlight::steps_test {
namespace {

using Strings = std::vector<std::string>;

CommandList read(std::string_view text, const std::string& step = {}) {
    return read_scene(text, "scene.gl", "scene", no_images, {.step = step});
}

std::string error_of(std::string_view text, const std::string& step = {}) {
    try {
        read(text, step);
        return "no error";
    } catch (const SceneError& error) {
        return error.what();
    }
}

std::size_t errors_in(std::string_view text) {
    try {
        read(text);
        return 0;
    } catch (const SceneError& error) {
        return error.errors.size();
    }
}

constexpr std::string_view kThree = R"(glEnable(GL_LIGHTING);
#pragma twinlight step("Diffuse only")
glEnable(GL_LIGHT1);
#pragma twinlight step("With ambient")
glEnable(GL_LIGHT2);
#pragma twinlight step("With specular")
glEnable(GL_LIGHT3);
#pragma twinlight step()
glutSolidCube(1);
#pragma twinlight step("With ambient")
glDisable(GL_LIGHT2);
#pragma twinlight step()
glFlush();
)";

std::string with_light(const std::string& lines) { return "glEnable(GL_LIGHTING);\n" + lines + "glutSolidCube(1);\n"; }

TEST(Steps, EachHasTheCommonLinesAndItsOwn) {
    EXPECT_EQ(print_scene(read(kThree, "1")), with_light("glEnable(GL_LIGHT1);\n") + "glFlush();\n");
    EXPECT_EQ(print_scene(read(kThree, "2")),
              with_light("glEnable(GL_LIGHT2);\n") + "glDisable(GL_LIGHT2);\nglFlush();\n");
    EXPECT_EQ(print_scene(read(kThree, "With specular")), with_light("glEnable(GL_LIGHT3);\n") + "glFlush();\n");
    EXPECT_EQ(read(kThree).commands, read(kThree, "1").commands);
}

TEST(Steps, AreNumberedByTheirTitlesFirstPlace) {
    const CommandList list = read(kThree, "With ambient");
    EXPECT_EQ(list.steps, (Strings{"Diffuse only", "With ambient", "With specular"}));
    EXPECT_EQ(list.step, 2U);
    EXPECT_EQ(list.title(), "scene, step 2: With ambient");
    EXPECT_EQ(read("glFlush();").step, 0U);
    EXPECT_EQ(read("glFlush();").title(), "scene");
}

TEST(Steps, MayBeInsideTheFunctionOfTheScene) {
    const std::string text = "void display(void) {\n" + std::string(kThree) + "}\n";
    EXPECT_EQ(read(text, "2").commands, read(kThree, "2").commands);
}

// The scene of a step is the text without the lines of the others.
TEST(Steps, MayDeclareTheSameNames) {
    const std::string text = R"(
#pragma twinlight step("a")
GLfloat red[] = {1, 0, 0, 1};
GLuint list = glGenLists(1);
#pragma twinlight step("b")
GLfloat red[] = {0.5, 0, 0, 1};
#pragma twinlight step()
glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
GLuint other = glGenLists(1);
glNewList(other, GL_COMPILE);
)";
    EXPECT_EQ(read(text, "a").commands[1].number(2), 1.0);
    EXPECT_EQ(read(text, "b").commands[0].number(2), 0.5);
    EXPECT_EQ(read(text, "a").commands[3].number(0), 2);
    EXPECT_EQ(read(text, "b").commands[2].number(0), 1) << "the other step's list counts";
}

TEST(Steps, ShowTheErrorsOfAllSteps) {
    const std::string text = R"(glEnable(GL_LIGTH0);
#pragma twinlight step("a")
GLfloat red[] = {1, 0, 0, 1};
#pragma twinlight step("b")
glEnable(GL_LIGTH1);
#pragma twinlight step()
glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
)";
    try {
        read(text, "a");
        FAIL() << "no error";
    } catch (const SceneError& error) {
        ASSERT_EQ(error.errors.size(), 3U);
        EXPECT_EQ(error.errors[0].message, "unknown name 'GL_LIGTH0'; did you mean GL_LIGHT0?");
        EXPECT_EQ(error.errors[1].message, "unknown name 'GL_LIGTH1'; did you mean GL_LIGHT1? (in step 2, \"b\")");
        EXPECT_EQ(error.errors[1].place.line, 5);
        EXPECT_EQ(error.errors[2].message, "unknown name 'red' (in step 2, \"b\")");
    }
    EXPECT_EQ(errors_in("@\n#pragma twinlight step(\"a\")\n@\n#pragma twinlight step(\"b\")\n@\n"), 3U);
}

TEST(Steps, MissingOnesAreNamed) {
    EXPECT_EQ(error_of(kThree, "4"),
              "scene.gl: this scene has no step '4'; its steps are 1 \"Diffuse only\", 2 \"With ambient\", 3 \"With "
              "specular\"");
    EXPECT_EQ(error_of(kThree, "0").substr(0, 37), "scene.gl: this scene has no step '0';");
    EXPECT_EQ(error_of("glFlush();", "1"), "scene.gl: this scene has no steps; leave out --step");
    EXPECT_EQ(error_of("glFlush()\nglFoo();\n" + std::string(kThree), "9").substr(0, 13), "scene.gl:2:1:")
        << "errors in the text come first";
}

TEST(Steps, RefuseTitlesThatCannotBeChosen) {
    const auto step = [](const std::string& title) { return "#pragma twinlight step(" + title + ")\nglFlush();\n"; };
    EXPECT_NE(error_of(step("diffuse")).find("1:24: expected the step's title in quotes"), std::string::npos);
    for (const std::string title : {"\"\"", "\"12\""})
        EXPECT_NE(error_of(step(title)).find("a step needs a title in words"), std::string::npos) << title;
    EXPECT_NE(error_of(step("\"\xC3\"")).find("not UTF-8"), std::string::npos);
    EXPECT_NE(error_of(step("\"" + std::string(81, 'a') + "\"")).find("at most 80 bytes"), std::string::npos);
    EXPECT_EQ(error_of(step("\"" + std::string(80, 'a') + "\"")), "no error");
    EXPECT_EQ(read(step("\"只有漫反射\""), "只有漫反射").step, 1U);
    std::string many;
    for (int i = 0; i < 33; ++i) many += step("\"a" + std::to_string(i) + "\"");
    EXPECT_NE(error_of(many).find("at most 32 steps"), std::string::npos);
}

TEST(Steps, AreNotForWholePrograms) {
    const std::string program = R"(#include <GL/glut.h>
void display(void) {
#pragma twinlight step("a")
    glFlush();
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutCreateWindow("a");
    glutDisplayFunc(display);
    glutMainLoop();
}
)";
    EXPECT_NE(error_of(program).find("scene.gl:3:19: a program with main cannot have steps"), std::string::npos)
        << error_of(program);
}

TEST(Steps, OfALargeSceneHaveALimit) {
    // Each step is another reading of the text.
    std::string text = "#pragma twinlight step(\"a\")\n#pragma twinlight step(\"b\")\n";
    text += "//" + std::string(kMaxSceneBytes / 2, ' ');
    EXPECT_NE(error_of(text).find("a scene with 2 steps can have at most"), std::string::npos) << error_of(text);
}

TEST(Steps, PrintedAreReadAsTheStep) {
    for (const std::string step : {"1", "2", "3"})
        EXPECT_EQ(read(print_scene(read(kThree, step))).commands, read(kThree, step).commands);
}

}  // namespace
}  // namespace twinlight::steps_test

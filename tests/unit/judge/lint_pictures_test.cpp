// The linter's several pictures of a program: its second one, one after a second, one after a key. And the fixes, which are tried in all of them.
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "judge/lint/lint.h"
#include "judge/lint/tried.h"
#include "lint_warnings.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::lint_pictures_test {
namespace {

using lint_test::names;
using lint_test::scene_of;

using Names = std::set<std::string>;

// A GLUT program with a lit view of 300 x 300. `display`: the statements after the camera and GL_LIGHT0's position.
std::string program(const std::string& display, const std::string& functions = "", const std::string& registers = "") {
    return "#include <GL/glut.h>\nfloat angle = 0;\nGLfloat light_at[] = {3, 4, 5, 1}, green[] = {0, 1, 0, 1};\n" +
           functions +
           "void display(void) {\n"
           "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n"
           "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(45, 1, 1, 50);\n"
           "glMatrixMode(GL_MODELVIEW); glLoadIdentity(); gluLookAt(0, 0, 7, 0, 0, 0, 0, 1, 0);\n"
           "glLightfv(GL_LIGHT0, GL_POSITION, light_at);\n" +
           display +
           "\nglutSwapBuffers();\n}\n"
           "int main(int argc, char **argv) {\n"
           "glutInit(&argc, argv); glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH); glutCreateWindow(\"x\");\n"
           "glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
           "glutDisplayFunc(display);\n" +
           registers + "\nglutMainLoop(); return 0;\n}\n";
}

const std::string kBall = "glutSolidSphere(1, 30, 20);\n",
                  kAxis = "glBegin(GL_LINES); glVertex3f(-3, 0, 0); glVertex3f(3, 0, 0); glEnd();\n";

Scene scene(const std::string& text) {
    const auto list = std::make_shared<CommandList>(read_scene(text, "lamp.c", "lamp.c"));
    return make_scene(list, {.width = 300, .height = 300});
}

std::vector<lint::Warning> warnings_of(const std::string& text) { return lint::lint(scene(text)); }

// With tried fixes.
std::vector<lint::Warning> tried(const std::string& text) {
    const Scene shown = scene(text);
    std::vector<lint::Warning> warnings = lint::lint(shown);
    lint::try_fixes(shown, lint::later_scenes(shown), warnings);
    return warnings;
}

TEST(LintPictures, FindWhatAPictureLeavesForTheNext) {
    const Names left{"left-for-next-picture"};
    EXPECT_EQ(names(warnings_of(program(kBall + "glDisable(GL_LIGHTING);\n" + kAxis))), left);
    EXPECT_EQ(names(warnings_of(program(kBall + "glDisable(GL_LIGHTING);\n" + kAxis + "glEnable(GL_LIGHTING);"))),
              Names{});
    EXPECT_EQ(names(warnings_of(program("glEnable(GL_LIGHTING);\n" + kBall + "glDisable(GL_LIGHTING);\n" + kAxis))),
              Names{});
    // A material, a light and a depth test.
    const std::string right = "glTranslatef(2, 0, 0);\n";
    EXPECT_EQ(names(warnings_of(program(kBall + right + "glMaterialfv(GL_FRONT, GL_DIFFUSE, green);\n" + kBall))),
              left);
    EXPECT_EQ(names(warnings_of(program(kBall + right + "glLightfv(GL_LIGHT0, GL_DIFFUSE, green);\n" + kBall))), left);
    EXPECT_EQ(names(warnings_of(program("glRotatef(70, 1, 0, 0);\nglutSolidTorus(0.5, 1, 20, "
                                        "30);\nglDisable(GL_DEPTH_TEST); glDisable(GL_LIGHTING);\n" +
                                        kAxis + "glEnable(GL_LIGHTING);"))),
              left);
    EXPECT_EQ(names(warnings_of(program(kBall + right + "glLightfv(GL_LIGHT1, GL_POSITION, light_at);\n" + kBall, "",
                                        "glEnable(GL_LIGHT1); glLightfv(GL_LIGHT1, GL_DIFFUSE, green);"))),
              left);
    // glPopAttrib takes it back. A state that changes nothing that is seen is no mistake.
    EXPECT_EQ(names(warnings_of(program(kBall + "glPushAttrib(GL_ENABLE_BIT); glDisable(GL_LIGHTING);\n" + kAxis +
                                        "glPopAttrib();"))),
              Names{});
    EXPECT_EQ(names(warnings_of(program(kBall + "glEnable(GL_BLEND);\n" + kAxis))), Names{});
    // What the idle function sets is meant.
    EXPECT_EQ(names(warnings_of(program(kBall, "void idle(void) { glLightfv(GL_LIGHT0, GL_DIFFUSE, green); }\n",
                                        "glutIdleFunc(idle);"))),
              Names{});
}

TEST(LintPictures, SayWhichOneOfThemAWarningIsAbout) {
    const std::string count = "int count = 0;\n";
    const auto when = [](const std::string& text) {
        const std::vector<lint::Warning> warnings = warnings_of(text);
        EXPECT_EQ(names(warnings), Names{"scale-without-normalize"}) << text;
        return warnings.empty() ? "none" : warnings[0].when;
    };
    const std::string large = "glPushMatrix(); glScalef(2, 2, 2); glutSolidSphere(0.5, 30, 20); glPopMatrix();\n";
    EXPECT_EQ(when(program(large)), "");
    EXPECT_EQ(when(program("if (count++ > 0) { " + large + "} else { " + kBall + "}", count)),
              "from the second picture on");
    EXPECT_EQ(when(program("if (count > 20) { " + large + "} else { " + kBall + "}",
                           count + "void idle(void) { ++count; }\n", "glutIdleFunc(idle);")),
              "after 1 s");
    const std::string key =
        "void key(unsigned char k, int x, int y) {\nswitch (k) {\ncase 'q': exit(0);\n"
        "case 'b': break;\ncase 'l': count = 1; }\n}\n";
    EXPECT_EQ(when(program("if (count) { " + large + "} else { " + kBall + "}", count + key, "glutKeyboardFunc(key);")),
              "after the key 'l'");
    const std::string scaled =
        "glPushMatrix(); glScalef(s, s, s); glutSolidSphere(0.5, 30, 20); glPopMatrix(); s = 1;\n";
    EXPECT_EQ(when(program(scaled, "double s = 2;\n")), "in the first picture only");
    const std::string headline =
        lint::headline(warnings_of(program("if (count++ > 0) { " + large + "} else { " + kBall + "}", count))[0]);
    EXPECT_NE(headline.find(" (from the second picture on) [scale-without-normalize]"), std::string::npos) << headline;
}

TEST(LintPictures, FindLightsThatMoveByMistake) {
    const std::string turn = "angle += 10;\nglRotatef(angle, 0, 1, 0);\n",
                      light = "glLightfv(GL_LIGHT0, GL_POSITION, light_at);\n", cube = "glutSolidCube(2);\n";
    EXPECT_EQ(names(warnings_of(program(turn + light + cube))), Names{"light-turns-with-objects"});
    EXPECT_EQ(names(warnings_of(program(light + turn + cube))), Names{});
    // A lamp that an object carries past others, and a light on the axis.
    EXPECT_EQ(names(warnings_of(program(cube + turn + light + cube))), Names{});
    EXPECT_EQ(names(warnings_of(program("glPushMatrix();\n" + turn + light + "glPopMatrix();\n" + cube))), Names{});
    EXPECT_EQ(names(warnings_of(
                  program(turn + "{ GLfloat up[] = {0, 5, 0, 0}; glLightfv(GL_LIGHT0, GL_POSITION, up); }" + cube))),
              Names{});
    const auto without_camera = [&](const std::string& statements) {
        return lint_test::changed(
            lint_test::changed(program(statements), "glLoadIdentity(); gluLookAt(0, 0, 7, 0, 0, 0, 0, 1, 0);", ""),
            light, "");
    };
    // One object that turns; of several, the matrices may be the camera.
    const std::string back = "glTranslatef(0, 0, -7);\n";
    EXPECT_EQ(names(warnings_of(without_camera("glLoadIdentity();\n" + back + turn + light + cube))),
              Names{"light-turns-with-objects"});
    EXPECT_EQ(names(warnings_of(without_camera("glLoadIdentity();\n" + back + turn + light + cube +
                                               "glTranslatef(2, 0, 0);\n" + kBall))),
              Names{});
    EXPECT_EQ(names(warnings_of(without_camera(light + "glLoadIdentity();\n" + back + turn + cube))),
              Names{"light-before-identity"});
}

TEST(LintPictures, AreChosenByTheirNumbers) {
    const TemporaryFolder folder;
    const std::string file = folder / "balls.c";
    const std::string large = "glPushMatrix(); glScalef(2, 2, 2); glutSolidSphere(0.5, 30, 20); glPopMatrix();\n";
    write_file_atomically(file, program("if (count++ > 0) { " + large + "} else { " + kBall + "}", "int count = 0;\n"));
    EXPECT_EQ(run_program("twinlight", {"lint", file}).status, 1);
    EXPECT_EQ(run_program("twinlight", {"lint", file, "--frame", "0"}).status, 0);
    const ProgramResult second = run_program("twinlight", {"lint", file, "--frame", "1"});
    EXPECT_EQ(second.status, 1);
    EXPECT_NE(second.out.find("[scale-without-normalize]"), std::string::npos) << second.out;
    EXPECT_EQ(second.out.find("second picture"), std::string::npos) << second.out;
    const ProgramResult third = run_program("twinlight", {"lint", file, "--frame", "2"});
    EXPECT_EQ(third.status, 2);
    EXPECT_NE(third.err.find("--frame 2: of a program that is read, not recorded, there are frames 0 and 1"),
              std::string::npos)
        << third.err;
}

// ---- Fixes ----

TEST(LintFixes, AreKeptOnlyIfTheyChangeTheRightObjectsInEachPicture) {
    // glDisable(GL_COLOR_MATERIAL) alone would stay for the red ball of the next picture.
    const std::string balls = "glColor3f(1, 0, 0);\n" + kBall +
                              "glTranslatef(2, 0, 0);\n"
                              "glMaterialfv(GL_FRONT, GL_DIFFUSE, green);\nglutSolidSphere(1, 40, 20);\n",
                      tracks = "glColorMaterial(GL_FRONT, GL_DIFFUSE); glEnable(GL_COLOR_MATERIAL);";
    const std::string text = program(balls, "", tracks);
    const std::vector<lint::Warning> warnings = tried(text);
    ASSERT_EQ(names(warnings), Names{"material-overridden"});
    EXPECT_EQ(warnings[0].fix,
              "glDisable(GL_COLOR_MATERIAL); before it, and glEnable(GL_COLOR_MATERIAL); after line 13");
    const std::string corrected = lint::corrected(text, warnings[0]);
    EXPECT_EQ(names(warnings_of(corrected)), Names{}) << corrected;
    const Scene shown = scene(corrected);
    std::vector<Image> pictures = {reference::render(shown.frame, {})};
    for (const lint::LaterScene& later : lint::later_scenes(shown))
        pictures.push_back(reference::render(later.scene.frame, {}));
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[0].pixels, pictures[1].pixels);
    // A ball that is drawn later depends on the missing GL_NORMALIZE as well: its own normals are long on purpose.
    const std::string large = "glPushMatrix(); glScalef(3, 3, 3); glutSolidSphere(0.3, 30, 20); glPopMatrix();\n";
    ASSERT_EQ(tried(program(large)).size(), 1u);
    EXPECT_FALSE(tried(program(large))[0].edits.empty());
}

TEST(LintFixes, OfEachRuleAreTriedInItsOwnScene) {
    int kept = 0;
    Names refused;
    for (const lint::Rule& rule : lint::rules()) {
        const Scene shown = scene_of(lint::wrong_scene(rule));
        std::vector<lint::Warning> warnings = lint::lint(shown);
        ASSERT_FALSE(warnings.empty()) << rule.name;
        if (warnings[0].edits.empty()) continue;
        lint::try_fixes(shown, lint::later_scenes(shown), warnings);
        if (warnings[0].edits.empty())
            refused.emplace(rule.name);
        else
            ++kept;
    }
    EXPECT_EQ(refused, Names{});
    EXPECT_GE(kept, 30);
}

}  // namespace
}  // namespace twinlight::lint_pictures_test

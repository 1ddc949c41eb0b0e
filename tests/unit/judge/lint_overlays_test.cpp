// A state that is left on for text and other drawing over the picture, and where the fix puts its calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "judge/lint/watch.h"
#include "lint_warnings.h"
#include "render/reference/reference.h"

namespace twinlight::lint_overlays_test {
namespace {

using lint_test::changed, lint_test::names;
using Names = std::set<std::string>;

Scene program_of(const std::string& text) {
    const auto list = std::make_shared<CommandList>(read_scene(text, "scene.c", "scene.c"));
    return make_scene(list, {.width = list->window->width, .height = list->window->height});
}
std::vector<lint::Warning> warnings_of(const std::string& text) { return lint::lint(program_of(text)); }

// A ball with a texture, then text or a panel over it: the words between @ are replaced.
const std::string kProgram = R"(#include <GL/glut.h>
GLubyte img[] = {200, 60, 60,  60, 60, 200,  60, 60, 200,  200, 60, 60};
GLubyte letter[] = {0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
const char *word = "ab", *s;
void text(int x, int y) {
    glRasterPos2i(x, y);
    for (s = word; *s; s++) glutBitmapCharacter(GLUT_BITMAP_8_BY_13, *s);
}
void display(void) {
    GLfloat pos[4] = {2, 2, 1, 0};
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(40, 1.5, 1, 20);
    glMatrixMode(GL_MODELVIEW); glLoadIdentity(); glTranslatef(0, 0, -5);
    glEnable(GL_DEPTH_TEST);
    glLightfv(GL_LIGHT0, GL_POSITION, pos);
    glColor3f(1, 1, 1);
    glutSolidTeapot(1);
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluOrtho2D(0, 300, 0, 200);
    glMatrixMode(GL_MODELVIEW); glLoadIdentity();
    glDisable(GL_DEPTH_TEST);
    @OFF@
    glColor3f(1, 1, 0);
    @DRAWING@
    glutSwapBuffers();
}
int main(int argc, char** argv) {
    glutInit(&argc, argv); glutInitWindowSize(300, 200); glutCreateWindow("t");
    glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_COLOR_MATERIAL);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1); glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, img);
    @ON@
    glutDisplayFunc(display); glutMainLoop(); return 0;
}
)";

enum class LeftOn { kLighting, kTexture };
std::string program(LeftOn left_on, const std::string& text) {
    const std::string off = left_on == LeftOn::kTexture ? "glDisable(GL_LIGHTING);" : "",
                      on = left_on == LeftOn::kTexture ? "glEnable(GL_TEXTURE_2D);" : "",
                      again = left_on == LeftOn::kTexture ? "glEnable(GL_LIGHTING);" : "";
    return changed(changed(changed(kProgram, "@OFF@", off), "@ON@", on), "@DRAWING@", text + again);
}

// The pixels of the second picture in the text's own colour, and in that of the teapot where all is right.
std::size_t yellow_pixels(const std::string& text) {
    const Image image = reference::render(lint::shown_frame(program_of(text)), {});
    return static_cast<std::size_t>(std::ranges::count_if(
        image.pixels, [](const auto& p) { return p[0] > 0.999F && p[1] > 0.999F && p[2] < 0.001F; }));
}

const char* const kTexts[] = {
    "glRasterPos2i(10, 10); glBitmap(8, 8, 0, 0, 10, 0, letter); glBitmap(8, 8, 0, 0, 10, 0, letter);",
    "text(10, 10); text(10, 40);",
    "for (int i = 0; i < 3; i++) {\n glRasterPos2i(10, 10 + 20 * i);\n glutBitmapString(GLUT_BITMAP_8_BY_13, (const "
    "unsigned "
    "char*)\"ab\");\n }",
    "glRectf(10, 10, 60, 30);",
    "glBegin(GL_TRIANGLES); glVertex2f(10, 10); glVertex2f(90, 10); glVertex2f(10, 90); glEnd();",
};

TEST(LintOverlays, TheFixSwitchesTheStateOffForThatDrawingOnly) {
    for (const LeftOn left_on : {LeftOn::kLighting, LeftOn::kTexture}) {
        const std::string rule = left_on == LeftOn::kLighting ? "lit-overlay" : "texture-left-on",
                          state = left_on == LeftOn::kLighting ? "GL_LIGHTING" : "GL_TEXTURE_2D";
        for (const char* text : kTexts) {
            const std::string wrong = program(left_on, text);
            const auto warnings = warnings_of(wrong);
            ASSERT_EQ(names(warnings), Names{rule}) << text;
            EXPECT_EQ(yellow_pixels(wrong), 0u) << text;
            const std::string corrected = lint::corrected(wrong, warnings[0]);
            EXPECT_EQ(names(warnings_of(corrected)), Names{}) << corrected;
            EXPECT_GT(yellow_pixels(corrected), 30u) << corrected;
            // The teapot of the second picture is that of the first.
            const auto shown = [&](const std::string& source, bool second) {
                const Scene scene = program_of(source);
                const Image image = reference::render(second ? lint::shown_frame(scene) : scene.frame, {});
                return image.pixels[static_cast<std::size_t>(90 * image.width + 150)];
            };
            EXPECT_EQ(shown(corrected, true), shown(wrong, false)) << corrected;
        }
    }
}

// A flat window without a lit scene.
TEST(LintOverlays, FindsTextThatNoLightReaches) {
    const auto with = [](const std::string& light) {
        return names(lint_test::warnings_of(
            "glClear(GL_COLOR_BUFFER_BIT); glMatrixMode(GL_PROJECTION); gluOrtho2D(0, 160, 0, 120);"
            "glMatrixMode(GL_MODELVIEW); glPixelStorei(GL_UNPACK_ALIGNMENT, 1); GLubyte letter[] = {0xff, 0xff, 0xff, "
            "0xff, 0xff, 0xff, 0xff, 0xff};" +
            light + "glRasterPos2f(10, 20); glBitmap(8, 8, 0, 0, 10, 0, letter);"));
    };
    EXPECT_TRUE(with("glEnable(GL_LIGHTING);").contains("lit-overlay"));
    EXPECT_EQ(with("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);"), Names{});  // may be meant
    EXPECT_EQ(with(""), Names{});
}

TEST(LintOverlays, IsSilentWhereTheStateIsMeant) {
    const char* const text = kTexts[0];
    for (const LeftOn left_on : {LeftOn::kLighting, LeftOn::kTexture}) {
        const std::string off = left_on == LeftOn::kLighting ? "GL_LIGHTING" : "GL_TEXTURE_2D";
        EXPECT_EQ(names(warnings_of(program(left_on, "glDisable(" + off + ");" + text + "glEnable(" + off + ");"))),
                  Names{});
    }
    const auto textured = [&](const std::string& drawing) {
        return names(warnings_of(program(LeftOn::kTexture, drawing)));
    };
    // With coordinates of its own; with one for the whole panel, as from a palette; with generated ones.
    EXPECT_EQ(
        textured(
            "glBegin(GL_TRIANGLES); glTexCoord2f(0, 0); glVertex2f(10, 10); glTexCoord2f(1, 0); glVertex2f(90, 10);"
            "glTexCoord2f(0, 1); glVertex2f(10, 90); glEnd();"),
        Names{});
    EXPECT_EQ(textured("glTexCoord2f(0.75, 0.25); glRectf(10, 10, 60, 30); glTexCoord2f(0, 0);"), Names{});
    EXPECT_EQ(textured("glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); glEnable(GL_TEXTURE_GEN_S);"
                       "glRectf(10, 10, 60, 30); glDisable(GL_TEXTURE_GEN_S);"),
              Names{});
    // A white texel changes nothing.
    EXPECT_EQ(names(warnings_of(changed(program(LeftOn::kTexture, text), "{200, 60, 60,", "{255, 255, 255,"))),
              Names{});
}

}  // namespace
}  // namespace twinlight::lint_overlays_test

// twinlight export --as c, to its end: the program is compiled, runs with the real freeglut under Xvfb, and draws what
// `twinlight render --with fixed` draws.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "render/reference/reference.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"
#include "window_release.h"
#include "xvfb.h"

namespace twinlight::exported_c_test {
namespace {

constexpr int kWidth = 640, kHeight = 480;  // of the exported window

// Takes the place of glutSwapBuffers: the picture goes to standard output, rows from the bottom.
constexpr const char* kKeepPicture = R"(
#include <GL/gl.h>
#include <stdio.h>
#include <stdlib.h>
void keep_picture(void) {
    static unsigned char rgb[640 * 480 * 3];
    glReadPixels(0, 0, 640, 480, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    exit(fwrite(rgb, sizeof rgb, 1, stdout) == 1 ? 0 : 1);
}
)";

// The shapes of freeglut and GLU, which the exported program gets from the libraries themselves.
constexpr const char* kShapes = R"(
GLUquadric* q = gluNewQuadric(), *flat = gluNewQuadric();
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_NORMALIZE);
glMatrixMode(GL_PROJECTION); gluPerspective(40, 4.0 / 3.0, 0.1, 100);
glMatrixMode(GL_MODELVIEW); gluLookAt(0, 3, 10,  0, 0, 0,  0, 1, 0);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){3, 5, 6, 1});
gluQuadricNormals(flat, GLU_FLAT); gluQuadricOrientation(flat, GLU_INSIDE);
glPushMatrix(); glTranslatef(-3.5, 0, 0); gluSphere(q, 1, 16, 12); glPopMatrix();
glPushMatrix(); glTranslatef(-1.2, 0, 0); gluSphere(flat, 1, 16, 12); glPopMatrix();
glPushMatrix(); glTranslatef(1.2, -1, 0); glRotatef(-90, 1, 0, 0); gluCylinder(q, 0.9, 0.5, 1.8, 24, 4); glPopMatrix();
glPushMatrix(); glTranslatef(3.5, 0, 0); gluPartialDisk(q, 0.3, 1, 24, 3, 30, 250); glPopMatrix();
glPushMatrix(); glTranslatef(-3.5, 2.2, 0); glutSolidTeapot(1); glPopMatrix();
glPushMatrix(); glTranslatef(-1, 2.2, 0); glutSolidTeacup(1); glPopMatrix();
glPushMatrix(); glTranslatef(1, 2.2, 0); glutSolidIcosahedron(); glPopMatrix();
glPushMatrix(); glTranslatef(3.5, 2.2, 0); glutSolidSierpinskiSponge(3, (GLdouble[]){0, 0, 0}, 1); glPopMatrix();
glPushMatrix(); glTranslatef(-3.5, -2.2, 0); glutSolidTeaspoon(2); glPopMatrix();
glPushMatrix(); glTranslatef(-1, -2.2, 0); glutSolidRhombicDodecahedron(); glPopMatrix();
glPushMatrix(); glTranslatef(1, -2.2, 0); glutSolidDodecahedron(); glPopMatrix();
glPushMatrix(); glTranslatef(3.5, -2.2, 0); glutSolidOctahedron(); glPopMatrix();
gluDeleteQuadric(q); gluDeleteQuadric(flat);
)";

// A picture from a file, which the exported program holds as an array.
constexpr const char* kPicture = R"(
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glEnable(GL_TEXTURE_2D);
#pragma twinlight texture("picture.png")
glBegin(GL_QUADS);
glTexCoord2f(0, 0); glVertex2f(-0.9, -0.8);
glTexCoord2f(1, 0); glVertex2f(0.9, -0.9);
glTexCoord2f(1, 1); glVertex2f(0.8, 0.9);
glTexCoord2f(0, 1); glVertex2f(-0.7, 0.8);
glEnd();
)";

Image picture_of(const std::string& rgb) {
    Image image(kWidth, kHeight, {0, 0, 0, 1});
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (int c = 0; c < 3; ++c) {
                const auto code =
                    static_cast<unsigned char>(rgb[static_cast<std::size_t>(((kHeight - 1 - y) * kWidth + x) * 3 + c)]);
                image.pixels[static_cast<std::size_t>(y * kWidth + x)][static_cast<std::size_t>(c)] =
                    static_cast<float>(code) / 255;
            }
        }
    }
    return image;
}

TEST(ExportedC, DrawsWhatTheFixedFunctionDraws) {
    const std::string compiler = "${CC:-gcc}";
    if (run_shell("", "command -v " + compiler).status != 0) GTEST_SKIP() << "there is no C compiler";
    const Xvfb server;
    if (!server.running()) GTEST_SKIP() << server.reason();

    const bool is_other = has_another_release(server.display());
    const TemporaryFolder folder;
    write_file_atomically(folder / "keep.c", kKeepPicture);
    write_file_atomically(folder / "shapes.gl", kShapes);
    write_file_atomically(folder / "picture.gl", kPicture);
    Image picture(5, 3);  // of a size that GLU scales
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = {static_cast<float>(i % 4) / 3, static_cast<float>(i % 3) / 2, i % 2 == 0 ? 1.0F : 0.2F, 1};
    }
    write_png(folder / "picture.png", picture);
    for (const std::string& scene : {std::string("report"), std::string("lab"), std::string("commands"),
                                     folder / "shapes.gl", folder / "picture.gl"}) {
        SCOPED_TRACE(scene);
        const ProgramResult exported = run_program("twinlight", {"export", scene, "--as", "c"});
        ASSERT_EQ(exported.status, 0) << exported.err;
        write_file_atomically(folder / "scene.c", exported.out);
        const ProgramResult compiled =
            run_shell("", "cd " + quoted(folder.str()) + " && " + compiler +
                              " -std=c99 -DglutSwapBuffers=keep_picture scene.c keep.c -o scene -lglut -lGLU -lGL -lm");
        ASSERT_EQ(compiled.status, 0) << compiled.err;
        const ProgramResult drawn =
            run_shell("", "DISPLAY=" + server.display() + " LIBGL_ALWAYS_SOFTWARE=1 " + quoted(folder / "scene"));
        ASSERT_EQ(drawn.status, 0) << drawn.err;
        ASSERT_EQ(drawn.out.size(), std::size_t{kWidth} * kHeight * 3);

        ASSERT_EQ(run_program("twinlight", {"render", scene, "--with", "fixed", "-o", folder / "fixed.png"}).status, 0);
        const Frame frame = make_frame(*load_commands(scene), {});
        const ImageDifference found = difference(picture_of(drawn.out), read_png(folder / "fixed.png"),
                                                 reference::allowed_difference(frame).edge);
        if (is_other) {
            EXPECT_LE(found.interior.max, kOfAnotherRelease);
            EXPECT_LE(found.interior.differing_share(), kBorderlineOfAnotherRelease);
            EXPECT_LE(found.edge.differing_share(), kBorderlineOfAnotherRelease);
            continue;
        }
        // Both libraries come from the same Mesa. But a window counts its rows from the top, so it rounds positions differently.
        constexpr double kBorderline = 0.0001;
        EXPECT_LE(found.interior.max, 1.001 / 255) << "at " << found.interior.worst_x << "," << found.interior.worst_y;
        EXPECT_LE(static_cast<double>(found.interior.differing + found.edge.differing),
                  kBorderline * static_cast<double>(found.interior.pixels + found.edge.pixels));
    }
}

}  // namespace
}  // namespace twinlight::exported_c_test

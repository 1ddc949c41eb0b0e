// twinlight record: compiles, runs and records programs. Needs apitrace, Xvfb and cc with freeglut.
#include "scene/record/record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "../pictures.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"

namespace twinlight::record_test {
namespace {

// Draws nothing in its first two frames, then four triangles, then one in each frame.
constexpr const char* kProgram = R"(
#include <GL/glut.h>
#include <stdio.h>
#include <stdlib.h>
static int frame = 0;
static void display(void) {
    int i, count = frame < 2 ? 0 : frame == 2 ? 4 : 1;
    glClear(GL_COLOR_BUFFER_BIT);
    for (i = 0; i < count; ++i) {
        glBegin(GL_TRIANGLES);
        glColor3f(1, 0.5f, 0); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(0, 1);
        glEnd();
    }
    glutSwapBuffers();
    if (++frame == LAST) exit(0);
    glutPostRedisplay();
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitWindowSize(64, 48);
    glutInitDisplayMode(GLUT_DOUBLE);
    glutCreateWindow(argc > 1 ? argv[1] : "no argument");
    printf("arguments: %d\n", argc - 1);
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
)";

class RecordCommand : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* tool : {"apitrace", "Xvfb", "cc"}) {
            if (run_shell("twinlight", std::string("command -v ") + tool).status != 0)
                GTEST_SKIP() << tool << " is not installed";
        }
        write_file_atomically(in_ / "probe.c", "#include <GL/glut.h>\nint main(void) { return 0; }\n");
        if (run_shell("twinlight",
                      "cc " + quoted(in_ / "probe.c") + " -o " + quoted(in_ / "probe") + " -lglut -lGLU -lGL")
                .status != 0)
            GTEST_SKIP() << "cc finds no freeglut";
    }
    std::string source(const std::string& last) {
        std::string text = kProgram;
        text.replace(text.find("LAST"), 4, last);
        write_file_atomically(in_ / "homework.c", text);
        return in_ / "homework.c";
    }
    // In the folder in_, without a display.
    ProgramResult record(const std::string& arguments) {
        return run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) +
                                          " && env -u DISPLAY LIBGL_ALWAYS_SOFTWARE=1 \"$P\" record " + arguments);
    }

    const TemporaryFolder in_;
};

TEST_F(RecordCommand, CompilesRunsAndNamesAFrame) {
    source("6");
    const ProgramResult result = record("homework.c title --seconds 60");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out,
              "Recording: homework.trace, in a display of its own (Xvfb), until the program ended\n"
              "It has 6 frames, 0 to 5. Frame 2 is worth a look:\n"
              "  twinlight compare homework.trace --frame 2\n");
    EXPECT_NE(result.err.find("with your rights and without a sandbox"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("arguments: 1\n"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("apitrace: "), std::string::npos) << result.err;
    const ProgramResult render = run_program(
        "twinlight", {"render", in_ / "homework.trace", "--frame", "2", "--with", "reference", "-o", in_ / "p.png"});
    EXPECT_EQ(render.status, 0) << render.err;
    const Image image = read_png(in_ / "p.png");
    ASSERT_EQ(image.width, 64);
    EXPECT_EQ(image.at(32, 24)[0], 1.0F);
    EXPECT_EQ(image.at(32, 24)[2], 0.0F);
}

TEST_F(RecordCommand, EndsAProgramThatDoesNotEndAndKeepsTheFirstFrames) {
    source("-1");
    // The first two frames draw nothing, so the third is kept, too.
    const ProgramResult result = record("-o short.trace --seconds 20 --frames 2 homework.c");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("It has 3 frames, 0 to 2. Frame 2 is"), std::string::npos) << result.out;
    const ProgramResult more = record("homework.c --seconds 20 --frames 4");
    EXPECT_EQ(more.status, 0) << more.err;
    EXPECT_NE(more.out.find("It has 4 frames, 0 to 3. Frame 2 is"), std::string::npos) << more.out;
    EXPECT_EQ(more.out.find("until the program ended"), std::string::npos) << more.out;
}

TEST_F(RecordCommand, ShowsTheCompilersErrors) {
    write_file_atomically(in_ / "wrong.c", "int main(void) { return x; }\n");
    const ProgramResult result = record("wrong.c");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("wrong.c:1:25: error: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("wrong.c: it cannot be compiled, see above"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(in_ / "wrong.trace"));
}

// They are in the language of the environment, if the C library has it.
TEST_F(RecordCommand, ReadsTheCompilersMessagesInEnglish) {
    write_file_atomically(
        in_ / "cc", "#!/bin/sh\necho \"lamp.c:1:1: fatal error: $LC_ALL$LANGUAGE.h: No such file\" >&2\nexit 1\n");
    std::filesystem::permissions(in_ / "cc", std::filesystem::perms::owner_all);
    write_file_atomically(in_ / "lamp.c", "");
    const ProgramResult result =
        run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) +
                                   "; LANGUAGE=zh_CN LC_ALL=zh_CN.UTF-8 PATH=\"$PWD:$PATH\" \"$P\" record lamp.c");
    EXPECT_NE(result.err.find("lamp.c: it cannot be compiled, see above; if C.UTF-8.h is in another folder"),
              std::string::npos)
        << result.err;
}

TEST_F(RecordCommand, RefusesWhatItCannotRecord) {
    write_file_atomically(in_ / "scene.gl", "glutSolidCube(1);\n");
    const auto expect_refused = [&](const std::string& arguments, const std::string& expected) {
        const ProgramResult result = record(arguments);
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err << "  expected: " << expected;
    };
    expect_refused("", "PROGRAM is required");
    expect_refused("no-such-program-at-all", "no-such-program-at-all: there is no such program");
    expect_refused("none.c", "none.c: there is no such file");
    expect_refused("./none", "./none: there is no such file");
    expect_refused("scene.gl", "scene.gl: is not a program; give a program, or a file of C, C++ or Python");
    expect_refused("true", "made no GL call that apitrace could record");
    expect_refused("true -o true.png", "the name of a recording must end in .trace");
    expect_refused("true --seconds 0", "--seconds: '0' is not a number from 0.1 to 3600");
    expect_refused("true --api wgl", "'wgl' is not one of egl, glx");
}

TEST_F(RecordCommand, SaysWhichToolIsMissing) {
    std::filesystem::create_symlink("/bin/true", in_ / "program");
    // PATH holds only env and realpath.
    std::filesystem::create_directory(in_ / "bin");
    for (const char* tool : {"apitrace", "env", "sh"}) {
        const std::string place = run_shell("twinlight", std::string("command -v ") + tool).out;
        std::filesystem::create_symlink(place.substr(0, place.size() - 1), in_ / ("bin/" + std::string(tool)));
    }
    EXPECT_NE(record("no-such-program --seconds 1").err.find("no such program"), std::string::npos);
    const auto with_path = [&] {
        return run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) +
                                          "; env -u DISPLAY PATH=" + quoted(in_ / "bin") + " \"$P\" record ./program");
    };
    EXPECT_NE(with_path().err.find("Xvfb: is not installed; running a program where DISPLAY is not set needs it"),
              std::string::npos)
        << with_path().err;
    std::filesystem::remove(in_ / "bin/apitrace");
    EXPECT_NE(with_path().err.find("apitrace: is not installed; recording needs it (apt-get install apitrace)"),
              std::string::npos)
        << with_path().err;
}

TEST_F(RecordCommand, RecordsProgramsThatUseEgl) {
    write_file_atomically(in_ / "pbuffer.c", R"(
#include <EGL/egl.h>
#include <GL/gl.h>
int main(void) {
    const EGLint attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, 64, EGL_HEIGHT, 48, EGL_NONE};
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    EGLConfig config;
    EGLint count;
    int frame;
    if (!eglInitialize(display, 0, 0)) return 77;
    eglBindAPI(EGL_OPENGL_API);
    eglChooseConfig(display, attributes, &config, 1, &count);
    EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, 0, 0));
    for (frame = 0; frame < 3; ++frame) {
        glClear(GL_COLOR_BUFFER_BIT);
        glRectf(-1, -1, 0, 0);
        eglSwapBuffers(display, surface);
    }
    return 0;
}
)");
    if (run_shell("twinlight", "cd " + quoted(in_.str()) + " && cc pbuffer.c -o pbuffer -lEGL -lGL").status != 0)
        GTEST_SKIP() << "cc finds no EGL";
    const ProgramResult result = record("./pbuffer");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("It has 3 frames, 0 to 2. Frame 0 is worth a look"), std::string::npos) << result.out;
}

// A framebuffer object of 256 x 256 pixels, for a texture in a window of 160 x 120. The program's text shows the same.
TEST_F(RecordCommand, RecordsProgramsWithFramebufferObjects) {
    const std::string program = std::filesystem::absolute("tests/traces/monitor.c");
    const ProgramResult result = record("-o monitor.trace " + quoted(program));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("It has 3 frames, 0 to 2. Frame 0 is worth a look"), std::string::npos) << result.out;
    for (const char* frame : {"0", "2"}) {
        const ProgramResult compared =
            run_program("twinlight", {"compare", in_ / "monitor.trace", "--frame", frame, "-o", in_ / "report"});
        EXPECT_EQ(compared.status, 0) << compared.err;
        EXPECT_NE(compared.out.find("frame " + std::string(frame) + ", 160 x 120"), std::string::npos) << compared.out;
        EXPECT_NE(compared.out.find("All three agree"), std::string::npos) << compared.out;
    }
    const ProgramResult of_text = run_program("twinlight", {"compare", program, "-o", in_ / "report"});
    EXPECT_NE(of_text.out.find("All three agree"), std::string::npos) << of_text.out << of_text.err;
}

TEST_F(RecordCommand, FindsTheWindowSystemInTheProgramsLibraries) {
    using trace::WindowSystem;
    const auto found = [&](const std::string& bytes) {
        write_file_atomically(in_ / "program", bytes);
        return trace::window_system_of(in_ / "program");
    };
    EXPECT_EQ(found("..libglut.so.3..libGL.so.1.."), WindowSystem::kGlx);
    EXPECT_EQ(found("..libEGL.so.1..libOpenGL.so.0.."), WindowSystem::kEgl);
    EXPECT_EQ(found("..libEGL.so.1..libGL.so.1.."), WindowSystem::kEgl);
    EXPECT_EQ(found("..libEGL.so.1..libGL.so.1..glXMakeCurrent.."), WindowSystem::kGlx);
    EXPECT_EQ(found("..libEGL.so.1..libglut.so.3.."), WindowSystem::kGlx);
    EXPECT_EQ(found("nothing"), WindowSystem::kGlx);
}

}  // namespace
}  // namespace twinlight::record_test

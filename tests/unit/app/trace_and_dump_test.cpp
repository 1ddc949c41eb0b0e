// A .trace is read as the text that `apitrace dump` prints of it: the same steps, bit by bit, with the same memory and places.
// Needs apitrace, Xvfb and cc with freeglut; for more programs, those of tests/traces/README.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/trace/trace.h"

namespace twinlight::trace_and_dump_test {
namespace {

// A step in full: all digits, and the bytes of its memory.
std::string line_of(const Step& step) {
    const Command& command = step.command;
    std::string line = fmt::format("{} {}", static_cast<int>(step.kind), step.text);
    if (step.kind == Step::Kind::kCommand) {
        line += command.name();
        for (const double argument : command.arguments) line += fmt::format(" {:a}", argument);
        if (command.memory)
            line += " " + std::string(reinterpret_cast<const char*>(command.memory->bytes.data()),
                                      command.memory->bytes.size());
    }
    const Place& place = command.place;
    if (place.calls) return fmt::format("{} at {}:{}:{} {}", line, *place.file, place.line, place.column, *place.calls);
    return fmt::format("{} at {}", line, place.line);
}

std::vector<std::string> lines_of(const Recording& recording) {
    std::vector<std::string> lines = recording.notes();
    recording.for_each([&](const Step& step) {
        lines.push_back(line_of(step));
        return true;
    });
    return lines;
}

class TraceAndDump : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* tool : {"apitrace", "Xvfb", "cc"})
            if (run_shell("", std::string("command -v ") + tool).status != 0)
                GTEST_SKIP() << tool << " is not installed";
    }
    void expect_same(const std::string& trace, std::size_t least_steps) {
        const std::string out = in_ / "dump";
        std::filesystem::remove_all(out);
        std::filesystem::create_directory(out);
        const ProgramResult dumped = run_shell(
            "", "trace=$(realpath " + quoted(trace) + ") && cd " + quoted(out) +
                    " && apitrace dump --color=never --thread-ids=yes --arg-names=no --blobs $trace >dump.txt");
        ASSERT_EQ(dumped.status, 0) << dumped.err;
        const auto native = lines_of(*trace::open_trace(trace)), text = lines_of(*trace::open_dump(out + "/dump.txt"));
        EXPECT_GE(text.size(), least_steps);
        ASSERT_EQ(native.size(), text.size());
        for (std::size_t i = 0; i < text.size(); ++i) ASSERT_EQ(native[i], text[i]) << "step " << i;
    }
    void expect_same_of(const std::string& program, std::size_t least_steps) {
        SCOPED_TRACE(program);
        const ProgramResult recorded =
            run_shell("twinlight",
                      "env -u DISPLAY LIBGL_ALWAYS_SOFTWARE=1 PATH=/usr/bin:\"$PATH\" \"$PROGRAM\" record "
                      "--seconds 2 --frames 20 -o " +
                          quoted(in_ / "a.trace") + " " + program);
        ASSERT_EQ(recorded.status, 0) << recorded.err;
        expect_same(in_ / "a.trace", least_steps);
    }

    const TemporaryFolder in_;
};

TEST_F(TraceAndDump, AreTheSameOfOurPrograms) {
    expect_same_of("tests/recorded/lamp.c", 40);
    expect_same_of("tests/recorded/bodies.cpp", 40);
    expect_same_of("tests/recorded/headers.c", 10);
    expect_same_of("tests/traces/monitor.c", 50);
}

// A file that is not in Snappy's chunks is read by apitrace.
TEST_F(TraceAndDump, AreTheSameOfAFileThatOnlyApitraceReads) {
    expect_same_of("tests/recorded/headers.c", 10);
    const ProgramResult packed =
        run_shell("", "apitrace repack --zlib " + quoted(in_ / "a.trace") + " " + quoted(in_ / "b.trace"));
    if (packed.status != 0) GTEST_SKIP() << "this apitrace cannot repack: " << packed.err;
    EXPECT_NE(read_file(in_ / "b.trace").substr(0, 2), "at");
    EXPECT_EQ(lines_of(*trace::open_trace(in_ / "b.trace")), lines_of(*trace::open_trace(in_ / "a.trace")));
}

TEST_F(TraceAndDump, AreTheSameOfPython) {
    if (run_shell("", "PATH=/usr/bin:\"$PATH\" python3 -c 'import OpenGL.GLUT'").status != 0)
        GTEST_SKIP() << "PyOpenGL is not installed";
    expect_same_of("tests/recorded/lamp.py", 10);
}

// Values of all kinds, and what only some drivers or toolkits call.
TEST_F(TraceAndDump, AreTheSameOfAllKindsOfValues) {
    write_file_atomically(in_ / "values.c", R"(#define GL_GLEXT_PROTOTYPES
#include <GL/glut.h>
#include <GL/glext.h>
#include <math.h>
#include <string.h>
static void display(void) {
    static const float vertices[] = {0, 0, 0, 1, 0, 0, 0.3f, 1e-9f, 1e30f};
    static const unsigned short elements[] = {0, 1, 2, 2};
    static const double plane[] = {1. / 3, -1e-7, 123456789.123456789, 1e100};
    static const unsigned char image[] = "abcdefghijklmnop";
    const int firsts[] = {0, 1}, counts[] = {3, 2};
    unsigned names[3];
    float got[4];
    int i;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushAttrib(GL_LIGHTING_BIT | 0x40000000);
    glPushAttrib(0);
    glClipPlane(GL_CLIP_PLANE0, plane);
    glEnable(0x1234567);
    glHint(0x8B8B, GL_NICEST);
    glBegin(GL_TRIANGLES);
    for (i = 0; i < 2000; ++i) {
        glColor4f(sinf(i), 1.f / (i + 1), expf(i % 80), -expf(-i % 90));
        glNormal3d(sin(i), exp(i % 700), -exp(-i % 700));
        glVertex3f(i * 0.1f, i * 1234.5f, -0.f);
        glVertex2i(i, -i * 1000000);
        glColor3ub(i, 2 * i, 3 * i);
    }
    glVertex3f(INFINITY, -INFINITY, NAN);
    glEnd();
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, vertices);
    glDrawElements(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_SHORT, elements);
    glMultiDrawArrays(GL_TRIANGLES, firsts, counts, 2);
    glGenBuffers(2, names);
    glBindBuffer(GL_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, 0, GL_STATIC_DRAW);
    memcpy(glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY), vertices, sizeof vertices);
    glUnmapBuffer(GL_ARRAY_BUFFER);
    glVertexPointer(3, GL_FLOAT, 0, (void*)4);
    glDrawArrays(GL_POINTS, 0, 2);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glGenTextures(3, names);
    glBindTexture(GL_TEXTURE_2D, names[2]);
    glTexImage2D(GL_TEXTURE_2D, 0, 4, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, 0);
    glGetFloatv(GL_CURRENT_COLOR, got);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, memcpy(names, names, 0));
    glCallLists(4, GL_UNSIGNED_BYTE, image);
    glUseProgram(glCreateProgram());
    glUseProgram(0);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, vertices);
    glDepthMask(GL_FALSE);
    glPopAttrib();
    glutSwapBuffers();
    glutPostRedisplay();
}
int main(int argc, char** argv) {
    glutInit(&argc, argv);
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_MULTISAMPLE);
    glutInitWindowSize(64, 48);
    glutCreateWindow("values");
    glutDisplayFunc(display);
    glutMainLoop();
    return 0;
}
)");
    expect_same_of(quoted(in_ / "values.c"), 10'000);
}

// `name` | package | licence | API | seconds | frames | `command`
TEST_F(TraceAndDump, AreTheSameOfRealPrograms) {
    const std::regex row(R"(\| `([^`]+)` \| \S+ \| \S+ \| (?:gl|egl) \| \d+ \| \d+ \| `(\S+) ?[^`]*` \|)");
    std::istringstream lines(read_file("tests/traces/README.md"));
    int tried = 0;
    for (std::string line; tried < 6 && std::getline(lines, line);) {
        std::smatch field;
        if (!std::regex_match(line, field, row) ||
            run_shell("", "PATH=$PATH:/usr/games:/usr/libexec/xscreensaver command -v " + field[2].str()).status != 0)
            continue;
        SCOPED_TRACE(field[1].str());
        const ProgramResult made =
            run_shell("", "tests/traces/record.sh -o " + quoted(in_ / "out") + " " + field[1].str());
        const std::string trace = in_ / ("out/" + field[1].str() + ".trace");
        ASSERT_TRUE(std::filesystem::exists(trace)) << made.out << made.err;
        expect_same(trace, 50);
        ++tried;
    }
    if (tried == 0) GTEST_SKIP() << "none of the programs of tests/traces/README.md is installed";
}

}  // namespace
}  // namespace twinlight::trace_and_dump_test

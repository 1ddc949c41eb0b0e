// Programs that are run by --run and by record: their warnings have the lines of their own sources. The programs are in
// tests/recorded; a comment `warning: NAME` is at the end of each line that has one. Needs apitrace, Xvfb and cc with
// freeglut, for Python also PyOpenGL, for keys xdotool.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/record/compile.h"
#include "scene/record/keys.h"
#include "scene/record/trace_follower.h"

namespace twinlight::recorded_lines_test {
namespace {

const std::string kFolder = "tests/recorded/";

std::string missing_tool() {
    for (const char* tool : {"apitrace", "Xvfb", "cc", "c++"})
        if (run_shell("twinlight", std::string("command -v ") + tool).status != 0) return tool;
    const TemporaryFolder in;
    write_file_atomically(in / "probe.c", "#include <GL/glut.h>\nint main(void) { return 0; }\n");
    const std::string compile = "cc " + quoted(in / "probe.c") + " -o " + quoted(in / "probe") + " -lglut -lGLU -lGL";
    return run_shell("twinlight", compile).status == 0 ? "" : "freeglut";
}

// Without a display, and with the Python that packages are installed for.
ProgramResult twinlight(const std::string& arguments, const std::string& folder = ".") {
    return run_shell("twinlight", "P=$(realpath \"$PROGRAM\"); cd " + quoted(folder) +
                                      " && env -u DISPLAY LIBGL_ALWAYS_SOFTWARE=1 PATH=/usr/bin:\"$PATH\" \"$P\" " +
                                      arguments);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

using Lines = std::set<std::string>;  // "lamp.c:6 scale-without-normalize"

Lines marked(const std::vector<std::string>& files) {
    Lines lines;
    const std::regex mark("warning: ([a-z-]+)");
    for (const std::string& file : files) {
        std::istringstream in(read_file(kFolder + file));
        int number = 0;
        std::smatch found;
        for (std::string line; std::getline(in, line);) {
            ++number;
            if (std::regex_search(line, found, mark))
                lines.insert(kFolder + file + ":" + std::to_string(number) + " " + found[1].str());
        }
    }
    return lines;
}

Lines warned(const std::string& out) {
    Lines lines;
    const std::regex warning(R"(^(.*:\d+):\d+: warning: .* \[([a-z-]+)\]$)");
    std::istringstream in(out);
    std::smatch found;
    for (std::string line; std::getline(in, line);)
        if (std::regex_search(line, found, warning)) lines.insert(found[1].str() + " " + found[2].str());
    return lines;
}

class RecordedLines : public testing::Test {
  protected:
    void SetUp() override {
        static const std::string missing = missing_tool();
        if (!missing.empty()) GTEST_SKIP() << missing << " is not installed";
    }
    // Warnings of the program are at the marked lines of these files. Returns what it printed.
    ProgramResult expect_marked(const std::string& arguments, const std::vector<std::string>& files) {
        ProgramResult result = twinlight("lint --calls --run " + arguments);
        EXPECT_EQ(warned(result.out), marked(files)) << result.out << result.err;
        EXPECT_EQ(result.status, 1);
        EXPECT_TRUE(std::regex_search(result.err, std::regex("^twinlight: note: (compiles and )?runs "))) << result.err;
        return result;
    }
    void write(const std::string& name, const std::string& text) { write_file_atomically(in_ / name, text); }
    // A program in a folder of its own that calls these statements when it draws.
    void write_program(const std::string& name, const std::string& display, const std::string& before = "") {
        write(name, "#include <GL/glut.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>\n" + before +
                        "\nstatic void display(void) {\n" + display +
                        "\n}\n"
                        "int main(int argc, char** argv) {\n"
                        "    glutInit(&argc, argv);\n"
                        "    glutInitDisplayMode(GLUT_DOUBLE);\n"
                        "    glutInitWindowSize(64, 48);\n"
                        "    glutCreateWindow(\"program\");\n"
                        "    glutDisplayFunc(display);\n"
                        "    glutMainLoop();\n"
                        "    return 0;\n"
                        "}\n");
    }

    const TemporaryFolder in_;
};

TEST_F(RecordedLines, OfC) {
    const ProgramResult result = expect_marked(kFolder + "lamp.c", {"lamp.c"});
    EXPECT_TRUE(has(result.out, "    glutSolidSphere(1, 16, 12); /* warning: scale-without-normalize */\n    ^\n"));
    EXPECT_TRUE(has(result.out, "display > draw_room > draw_lamp\n")) << result.out;
}

TEST_F(RecordedLines, OfCppWithClassesAndTheStandardLibrary) {
    const ProgramResult result = expect_marked(kFolder + "bodies.cpp", {"bodies.cpp"});
    EXPECT_TRUE(has(result.out, "display > Body::draw > Planet::material\n")) << result.out;
}

TEST_F(RecordedLines, OfTwoFilesThatAreGivenOrFoundInTheFolder) {
    expect_marked(kFolder + "room/room.cpp " + kFolder + "room/walls.cpp", {"room/walls.cpp"});
    const ProgramResult found = expect_marked(kFolder + "room/room.cpp", {"room/walls.cpp"});
    EXPECT_TRUE(has(found.err, "compiled with the other files of its folder: tests/recorded/room/walls.cpp"))
        << found.err;
}

TEST_F(RecordedLines, OfAProgramWithHeadersOfOtherSystems) { expect_marked(kFolder + "headers.c", {"headers.c"}); }

TEST_F(RecordedLines, OfANameWithABlank) {
    expect_marked("'" + kFolder + "my lamp.C'", {"my lamp.C"});
    std::filesystem::copy(kFolder + "my lamp.C", in_ / "my lamp.C");
    const ProgramResult result = twinlight("record 'my lamp.C'", in_.str());
    EXPECT_TRUE(has(result.out, "Recording: my lamp.trace, ")) << result.out << result.err;
    EXPECT_TRUE(has(result.out, "twinlight compare 'my lamp.trace'\n")) << result.out;
}

TEST_F(RecordedLines, OfPython) {
    if (run_shell("", "/usr/bin/python3 -c 'import OpenGL.GLUT'").status != 0) GTEST_SKIP() << "there is no PyOpenGL";
    const ProgramResult result = expect_marked(kFolder + "lamp.py", {"lamp.py"});
    EXPECT_TRUE(has(result.out, "  calls: main > display > draw_lamp\n")) << result.out;
    expect_marked("-- python3 " + kFolder + "lamp.py", {"lamp.py"});
}

TEST_F(RecordedLines, OfAPictureAfterKeys) {
    if (run_shell("", "command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is not installed";
    expect_marked("--keys 'zs<Left>' " + kFolder + "keys.c", {"keys.c"});
}

TEST_F(RecordedLines, AreInComparisonsExplanationsAndJson) {
    const std::string program = kFolder + "lamp.c";
    const ProgramResult compared = twinlight("compare --run " + program + " -o " + quoted(in_ / "report"));
    EXPECT_EQ(compared.status, 0) << compared.err;
    EXPECT_TRUE(has(compared.err, program + ":6:5: warning: ")) << compared.err;
    EXPECT_TRUE(has(compared.err, "'twinlight lint --run " + program + "' shows how to fix it")) << compared.err;
    const ProgramResult explained = twinlight("explain --run " + program + " --pixel 32,24 --calls");
    EXPECT_TRUE(has(explained.out, program + ":6:5 (display > draw_room > draw_lamp): front face"))
        << explained.out << explained.err;
    const ProgramResult json = twinlight("lint --json --run " + program);
    EXPECT_TRUE(has(json.out, "\"file\": \"" + program + "\"")) << json.out;
    EXPECT_TRUE(has(json.out, "\"line\": 6")) << json.out;
}

// apitrace trim would leave out the stacks.
TEST_F(RecordedLines, AreInARecordingThatIsCut) {
    write_program("endless.c",
                  "    glClear(GL_COLOR_BUFFER_BIT); glLoadIdentity(); glScalef(2, 2, 2);\n"
                  "    glutSolidSphere(0.3, 9, 9);\n"
                  "    glutSwapBuffers(); glutPostRedisplay();",
                  "static void nothing(void) { glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); }\n#define glClear(x) "
                  "(glClear(x), nothing())");
    const ProgramResult result = twinlight("record --seconds 20 --frames 3 endless.c", in_.str());
    EXPECT_TRUE(has(result.out, "It has 3 frames, 0 to 2. ")) << result.out << result.err;
    EXPECT_FALSE(has(result.out, "until the program ended")) << result.out;
    const ProgramResult linted = twinlight("lint endless.trace --frame 2", in_.str());
    EXPECT_TRUE(has(linted.out, "endless.c:9:5: warning: ")) << linted.out << linted.err;
}

TEST_F(RecordedLines, AreSilencedByComments) {
    std::string text = read_file(kFolder + "lamp.c");
    const std::string mark = "/* warning: scale-without-normalize */";
    text.replace(text.find(mark), mark.size(), "// twinlight: allow(scale-without-normalize)");
    write("quiet.c", text);
    const ProgramResult result = twinlight("lint --run quiet.c", in_.str());
    EXPECT_EQ(result.status, 0) << result.out << result.err;
    EXPECT_EQ(result.out, "");
}

TEST_F(RecordedLines, AreOfWhatAPictureLeavesForTheNext) {
    const std::string lit = "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);\n";
    write_program("twice.c",
                  lit +
                      "glutSolidSphere(0.7, 20, 20);\nglDisable(GL_LIGHTING);\nglRectf(0.8, 0.8, 1, 1);\n"
                      "glutSwapBuffers();\nglutPostRedisplay();",
                  "static void first(void) { glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST); }\n"
                  "#define glutMainLoop() (first(), glutMainLoop())");
    const ProgramResult result = twinlight("lint --run twice.c", in_.str());
    EXPECT_TRUE(has(result.out, "twice.c:10:1: warning: this glDisable(GL_LIGHTING) still holds when the next picture"))
        << result.out << result.err;
    const ProgramResult first = twinlight("lint --run twice.c --frame 0", in_.str());
    EXPECT_EQ(first.out, "") << first.err;
}

TEST_F(RecordedLines, CanBeMendedInACopy) {
    const std::string fix = " --fix scale-without-normalize -o ";
    const auto expect_corrected = [&](const std::string& program, const std::string& rule, const std::string& copy) {
        const ProgramResult corrected =
            twinlight("lint --run " + kFolder + program + " --fix " + rule + " -o " + quoted(in_ / copy));
        EXPECT_EQ(corrected.status, 0) << corrected.err;
        const ProgramResult again = twinlight("lint --run " + copy, in_.str());
        EXPECT_EQ(again.status, 0) << again.out << again.err;
    };
    expect_corrected("lamp.c", "scale-without-normalize", "copy.c");
    expect_corrected("bodies.cpp", "shininess-without-specular", "copy.cpp");
    const ProgramResult same = twinlight("lint --run copy.c" + fix + "./copy.c", in_.str());
    EXPECT_EQ(same.status, 2);
    EXPECT_TRUE(has(same.err, "--fix: this scene has no warning")) << same.err;
    std::filesystem::copy(kFolder + "lamp.c", in_ / "lamp.c");
    EXPECT_TRUE(has(twinlight("lint --run lamp.c" + fix + "./lamp.c", in_.str()).err,
                    "-o ./lamp.c: this is the program's source, which --fix leaves as it is"));
    if (run_shell("", "/usr/bin/python3 -c 'import OpenGL.GLUT'").status != 0) return;
    EXPECT_TRUE(has(twinlight("lint --run " + kFolder + "lamp.py" + fix + "-").err,
                    "'scale-without-normalize' needs your own change at tests/recorded/lamp.py:10:5: glEnable("));
}

// ---- What goes wrong ----

TEST_F(RecordedLines, ShowTheLineOfACrash) {
    const ProgramResult result = twinlight("lint --run " + kFolder + "crash.cpp");
    EXPECT_EQ(result.status, 2);
    const std::regex message(
        R"(crash\.cpp: it ended after \d\.\d s by signal 11 \(.*\), at tests/recorded/crash\.cpp:6 \(.*display > draw_crash\), before it drew anything)");
    EXPECT_TRUE(std::regex_search(result.err, message)) << result.err;
}

TEST_F(RecordedLines, ShowTheProgramsLastWords) {
    write("words.c", "#include <stdio.h>\nint main(void) { fprintf(stderr, \"no cube.obj\\n\"); return 3; }\n");
    const ProgramResult result = twinlight("record words.c", in_.str());
    EXPECT_EQ(result.status, 2);
    EXPECT_TRUE(std::regex_search(
        result.err,
        std::regex(
            R"(words\.c: made no GL call that apitrace could record; it ended after \d\.\d s with status 3; its last message: no cube\.obj\n)")))
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(in_ / "words.trace"));
}

TEST_F(RecordedLines, NeedAllFilesOfAProject) {
    const auto expect_refused = [&](const std::string& arguments, const std::string& message) {
        const ProgramResult result = twinlight("record " + arguments, in_.str());
        EXPECT_EQ(result.status, 2);
        EXPECT_TRUE(has(result.err, message)) << result.err;
    };
    write("two.cpp", "void load_all(int);\nint main() { load_all(1); }\n");
    expect_refused(
        "two.cpp",
        "two.cpp: it calls load_all, which is in no file given here; it needs its project's other files: compile "
        "it as usual and run 'twinlight record ./program'");
    write("empty.c", "int x;\n");
    expect_refused("empty.c", "empty.c: it has no main(); give the file that has it, too");
    write("gl.c", "void glutNoSuch(void);\nint main(void) { glutNoSuch(); return 0; }\n");
    expect_refused("gl.c", "gl.c: glutNoSuch is not in freeglut, GLU and GL; -lNAME adds a library");
    write("header.c", "#include <glm/none.hpp>\n");
    expect_refused("header.c", "if glm/none.hpp is in another folder, -IDIR names it");
    expect_refused("none.py", "none.py: there is no such file");
}

TEST_F(RecordedLines, TakeOptionsForTheCompiler) {
    std::filesystem::create_directory(in_ / "headers");
    write("headers/own.h", "#define SIZE 0.5\n");
    write_program(
        "options.c",
        "    glClear(GL_COLOR_BUFFER_BIT); glutSolidCube(SIZE * WIDE); glutSwapBuffers(); exit((int)cbrt(0));",
        "#include <math.h>\n#include <own.h>");
    const ProgramResult result = twinlight("record -Iheaders -DWIDE=2 -lm options.c", in_.str());
    EXPECT_EQ(result.status, 0) << result.err;
}

// A program that draws only when it runs for the second time.
TEST_F(RecordedLines, OfAProgramThatDrawsLater) {
    write_program("late.c",
                  "    if (access(\"ran\", F_OK) != 0) { fclose(fopen(\"ran\", \"w\")); return; }\n"
                  "    glClear(GL_COLOR_BUFFER_BIT); glutSolidCube(0.5); glutSwapBuffers(); exit(0);");
    const ProgramResult result = twinlight("record late.c", in_.str());
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(has(result.err, "late.c drew nothing; runs it again, for 8 s\n")) << result.err;
}

TEST_F(RecordedLines, WarnIfCallsAreMissing) {
    write_program("bare.c", "    glRectf(-1, -1, 0, 0); glutSwapBuffers(); exit(0);");
    const ProgramResult result = twinlight("record bare.c", in_.str());
    EXPECT_TRUE(has(result.err, "twinlight: warning: bare.c draws, but without any call such as glClear, "))
        << result.err;
    const ProgramResult usual = twinlight("record " + quoted(std::filesystem::absolute(kFolder + "lamp.c")), in_.str());
    EXPECT_FALSE(has(usual.err, "warning: ")) << usual.err;
}

// `apitrace trace` ended before the program had written what was recorded.
TEST_F(RecordedLines, AreNotLostWhenTheTimeIsOver) {
    write_program("still.c", "    glClear(GL_COLOR_BUFFER_BIT); glutSolidCube(0.5); glutSwapBuffers();");
    ASSERT_EQ(run_shell("", "cd " + quoted(in_.str()) + " && cc still.c -o still -lglut -lGLU -lGL").status, 0);
    for (int i = 0; i < 6; ++i) {
        const ProgramResult result = twinlight("record --seconds 0.5 ./still", in_.str());
        EXPECT_TRUE(has(result.out, "It has one frame.")) << result.err;
    }
}

TEST_F(RecordedLines, AreOnlyOfWhatRunIsGivenFor) {
    const auto expect_refused = [](const std::string& arguments, const std::string& message) {
        const ProgramResult result = twinlight(arguments);
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_TRUE(has(result.err, message)) << result.err;
    };
    expect_refused("compare report lab", "unexpected argument 'lab'");
    expect_refused("compare report --keys x", "--seconds, --frames, --keys, --api, -l, -I, -D and -L need --run");
    expect_refused("explain --run none.c", "none.c: there is no such file");
    expect_refused("record --keys '<Left' " + kFolder + "keys.c", "--keys: < starts the name of a key");
    EXPECT_FALSE(has(twinlight("lint " + kFolder + "bodies.cpp").err, "runs"));
}

TEST(Keys, HaveTheNamesOfX) {
    EXPECT_EQ(trace::keys_of("aZ9 +;[~<Left><F1>\n"),
              (std::vector<std::string>{"a", "Z", "9", "space", "plus", "semicolon", "bracketleft", "asciitilde",
                                        "Left", "F1", "Return"}));
    for (const char* text : {"<", "<>", "a<b", "\x01", "\xC3\xA4"})
        EXPECT_THROW(trace::keys_of(text), SceneError) << text;
}

TEST(TraceFollower, CopiesAFileThatItCannotRead) {
    const TemporaryFolder in;
    const std::string damaged(
        "at\x05\0\0\0\x03\x08"
        "abc",
        11),
        foreign(
            "\x1f\x8b"
            "123456");
    for (const std::string& bytes : {damaged, foreign}) {
        write_file_atomically(in / "a.trace", bytes);
        trace::TraceFollower follower(in / "a.trace");
        follower.read_on();
        EXPECT_NE(follower.failure(), "");
        follower.copy_frames(1, in / "b.trace");
        EXPECT_EQ(read_file(in / "b.trace"), bytes);
    }
}

TEST(Sources, AreKnownByTheirExtensionsInAnyCase) {
    for (const char* name : {"a.c", "a.C", "a.cc", "a.cpp", "b/a.CPP", "a b.cxx"})
        EXPECT_TRUE(trace::is_source(name)) << name;
    for (const char* name : {"a.h", "a", "a.gl", "c", ".c.o"}) EXPECT_FALSE(trace::is_source(name)) << name;
    EXPECT_TRUE(trace::is_python("lamp.PY"));
}

}  // namespace
}  // namespace twinlight::recorded_lines_test

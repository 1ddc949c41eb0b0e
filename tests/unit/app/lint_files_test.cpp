// twinlight lint of several files and of folders.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/lint/lint.h"

namespace twinlight::lint_files_test {
namespace {

constexpr const char* kCpp = "#include <iostream>\nint main() { std::cout << 1; }\n";

std::string program(const std::string& display) {
    return "#include <GL/glut.h>\n#include \"lamp.h\"\nvoid display(void) { " + display +
           " glutSolidSphere(0.3, 20, 20); glutSwapBuffers(); }\n"
           "int main(int argc, char** argv) {\n"
           "    glutInit(&argc, argv);\n"
           "    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB);\n"
           "    glutCreateWindow(\"program\");\n"
           "    glutDisplayFunc(display);\n"
           "    glutMainLoop();\n"
           "}\n";
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

class LintFiles : public testing::Test {
  protected:
    // A class of three: one answer is right, one has a mistake in its header, one is C++.
    LintFiles() {
        for (const char* folder : {"ann", "bob", ".git"}) std::filesystem::create_directory(in_ / folder);
        write("ann/right.gl", lint::corrected_scene(*lint::find_rule("light-black")));
        write("ann/notes.txt", "no scene");
        write("bob/lamp.c", program("glClear(GL_COLOR_BUFFER_BIT); lamp();"));
        write("bob/lamp.h", "void lamp(void) {\n  glEnable(GL_LIGHTING); glEnable(GL_LIGHT1);\n}\n");
        write("bob/part.c", "#include \"lamp.h\"\nint part(void) { return 3; }\n");
        write("cy.cpp", kCpp);
        write(".git/hidden.gl", "glNothing();");
    }
    void write(const std::string& name, const std::string& text) { write_file_atomically(in_ / name, text); }
    ProgramResult lint(const std::string& arguments) {
        return run_shell("twinlight",
                         "P=$(realpath \"$PROGRAM\"); cd " + quoted(in_.str()) + " && \"$P\" lint " + arguments);
    }

    const TemporaryFolder in_;
};

// README promises four.
TEST(LintHomework, HasTheFourMistakesOfReadme) {
    const ProgramResult result = run_program("twinlight", {"lint", "docs/homework.c"});
    EXPECT_EQ(result.status, 1) << result.err;
    std::vector<std::string> rules;
    for (const std::string& line : lines_of(result.out))
        if (line.ends_with(']')) rules.push_back(line.substr(line.rfind('[')));
    EXPECT_EQ(rules, (std::vector<std::string>{"[light-before-camera]", "[specular-without-shininess]",
                                               "[color-ignored]", "[scale-without-normalize]"}))
        << result.out;
}

// Each has its line, so it was found to have a main().
TEST_F(LintFiles, MayHaveAnyBlanksAfterMain) {
    const std::string more = " { return 0; }\n";
    std::filesystem::create_directory(in_ / "dot");
    write("dot/long.cpp", kCpp + std::string("int other();\n"));
    write("dot/lines.cpp", "#include <iostream>\nint main\n\t(void)" + more);
    write("dot/blanks.cpp", "#include <iostream>\nint main" + std::string(1'000'000, ' ') + "()" + more);
    write("dot/domain.cpp", "#include <iostream>\nint domain()" + more);
    const ProgramResult result = lint("dot");
    EXPECT_EQ(result.status, 2) << result.err;
    std::vector<std::string> files;
    for (const std::string& line : lines_of(result.out))
        if (line.starts_with("dot/")) files.push_back(line.substr(4, line.find(".cpp") - 4));
    EXPECT_EQ(files, (std::vector<std::string>{"blanks", "lines", "long"})) << result.out;
}

TEST_F(LintFiles, OfAFolderHaveALineEach) {
    const ProgramResult result = lint(".");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "");
    const std::vector<std::string> lines = lines_of(result.out);
    ASSERT_EQ(lines.size(), 7U) << result.out;
    EXPECT_EQ(lines[0], "./ann/right.gl  no warnings");
    EXPECT_EQ(lines[1], "./bob/lamp.c    1 warning: light-black");
    EXPECT_EQ(lines[2], "./cy.cpp        not read: it is C++; run it: twinlight lint --run ./cy.cpp");
    EXPECT_EQ(lines[4], "3 files: 1 without warnings, 1 with warnings, 1 not read");
}

TEST_F(LintFiles, DecideTheExitStatusTogether) {
    EXPECT_EQ(lint("ann").status, 0);
    EXPECT_EQ(lint("ann bob").status, 1);
    EXPECT_EQ(lint("ann bob/lamp.c").status, 1);
    EXPECT_EQ(lint("ann missing.gl bob").status, 2);
    EXPECT_EQ(lint("report lab").status, 0);
}

TEST_F(LintFiles, ThatCannotBeReadAreLinesWithTheReason) {
    write("bad.gl", "glClear(GL_COLOR_BUFFER_BIT);\nglFoo();\n");
    const std::vector<std::string> lines = lines_of(lint("missing.gl bad.gl bob/lamp.c").out);
    ASSERT_GE(lines.size(), 3U);
    EXPECT_EQ(lines[0], "missing.gl  not read: No such file or directory");
    EXPECT_TRUE(lines[1].starts_with("bad.gl      not read: line 2: unknown command 'glFoo'")) << lines[1];
    EXPECT_EQ(lines[2], "bob/lamp.c  1 warning: light-black");
}

TEST_F(LintFiles, MakeATableWithARowForEachWarningAndForEachFileWithoutAny) {
    const ProgramResult result = lint("--csv .");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out,
              "file,result,rule,source,line,count,message,fix\n"
              "./ann/right.gl,no warnings,,,,,,\n"
              "./bob/lamp.c,warning,light-black,./bob/lamp.h,2,1,GL_LIGHT1 is on but black: only GL_LIGHT0 starts "
              "with a colour,\"glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});\"\n"
              "./cy.cpp,not read,,,,,it is C++; run it: twinlight lint --run ./cy.cpp,\n");
    EXPECT_EQ(lines_of(lint("--csv ann/right.gl").out)[1], "ann/right.gl,no warnings,,,,,,");
}

TEST_F(LintFiles, NamesAreNoFormulasInATable) {
    write("=1+1,\"2\".gl", lint::corrected_scene(*lint::find_rule("light-black")));
    EXPECT_EQ(lines_of(lint("--csv '=1+1,\"2\".gl' ann").out)[1], "\"'=1+1,\"\"2\"\".gl\",no warnings,,,,,,");
}

TEST_F(LintFiles, MakeAListInJson) {
    const Json json = Json::parse(lint("--json .").out);
    ASSERT_EQ(json["files"].size(), 3U);
    EXPECT_EQ(json["files"][0]["file"], "./ann/right.gl");
    EXPECT_EQ(json["files"][0]["scene"], "right.gl");
    EXPECT_TRUE(json["files"][0]["warnings"].empty());
    EXPECT_EQ(json["files"][1]["warnings"][0]["file"], "./bob/lamp.h");
    EXPECT_EQ(json["files"][1]["warnings"][0]["line"], 2);
    EXPECT_EQ(json["files"][2]["error"], "it is C++; run it: twinlight lint --run ./cy.cpp");
}

TEST_F(LintFiles, WarningsOfAnIncludedFileNameItsPath) {
    EXPECT_TRUE(lint("bob/lamp.c").out.starts_with("bob/lamp.h:2:26: warning: ")) << lint("bob/lamp.c").out;
    EXPECT_EQ(Json::parse(lint("--json bob/lamp.c").out)["warnings"][0]["file"], "bob/lamp.h");
}

TEST_F(LintFiles, OfCppAreNeverCalledC) {
    for (const char* name : {"x.cpp", "x.cc", "x.cxx", "x.C", "x.c++", "x.CPP"}) {
        for (const char* text : {"int main(void) { glFoo(); }\n", kCpp}) {
            write(name, text);
            const std::string message = lint(name).err;
            EXPECT_NE(message.find("C++"), std::string::npos) << message;
            EXPECT_EQ(message.find("a C program"), std::string::npos) << message;
        }
    }
    write("x.c", kCpp);
    EXPECT_NE(lint("x.c").err.find("x.c: this C++ program does not call glutMainLoop, so it cannot be read; "),
              std::string::npos);
    write("x.c", "#include <GLFW/glfw3.h>\n#define N 3\nint\nmain(void) { glfwSwapBuffers(0); }\n");
    EXPECT_NE(lint("x.c").err.find("x.c: this C program does not call glutMainLoop, so it cannot be read; "),
              std::string::npos);
    write("y.c", "int main(void) { glFoo(); }\n");
    EXPECT_NE(lint("y.c").err.find("this is a C program; "), std::string::npos);
}

TEST_F(LintFiles, OfAFolderRunOneAfterTheOther) {
    for (const char* tool : {"apitrace", "Xvfb", "cc", "c++"})
        if (run_shell("twinlight", std::string("command -v ") + tool).status != 0)
            GTEST_SKIP() << tool << " is not installed";
    const ProgramResult result = lint("--run --frames 2 .");
    EXPECT_EQ(result.status, 2);
    const std::vector<std::string> lines = lines_of(result.out);
    ASSERT_GE(lines.size(), 2U);
    EXPECT_EQ(lines[0], "./bob/lamp.c  1 warning: light-black") << result.err;
    EXPECT_TRUE(lines[1].starts_with("./cy.cpp      not read: made no GL call")) << lines[1];
    EXPECT_TRUE(result.err.starts_with("twinlight: note: compiles and runs 2 programs of ., with your rights"))
        << result.err;
}

}  // namespace
}  // namespace twinlight::lint_files_test

// What file names, full disks and large scenes must not do: control the terminal, leave half of a result, fill the memory.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "../run_program.h"
#include "../sanitized.h"
#include "base/image/file.h"
#include "base/text/json.h"

namespace twinlight::untrusted_test {
namespace {

const std::string kSphere = "glClear(GL_COLOR_BUFFER_BIT); glutSolidSphere(1, 8, 8);\n";

bool has_control_characters(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c < 0x20 && c != '\n') || c == 0x7f) return true;
        if (c == 0xc2 && i + 1 < text.size() && (static_cast<unsigned char>(text[i + 1]) & 0xe0) == 0x80) return true;
    }
    return false;
}

TEST(UntrustedNames, DoNotReachTheTerminalRaw) {
    const TemporaryFolder folder;
    const std::string odd =
        "a\x1b[31m\x7f\nb\xc2\x9b"
        "c";
    const std::string scene = folder / (odd + ".gl"), report = folder / (odd + "-report");
    // glDrawPixels: a note names the place; GL_LIGHT1: a warning of the linter does.
    write_file_atomically(
        scene,
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT1);\n" + kSphere +
            "glDrawPixels(1, 1, GL_COLOR_INDEX, GL_INT, (GLint[]){0});\nGLint v[4]; glGetIntegerv(GL_VIEWPORT, v);\n");
    const std::vector<std::vector<std::string>> commands = {
        {"compare", scene, "--size", "16x16", "-o", report},
        {"render", scene, "--with", "reference", "--size", "16x16", "-o", folder / (odd + ".png")},
        {"render", scene, "--with", "reference", "--size", "16x16"},
        {"explain", scene, "--size", "16x16"},
        {"explain", scene, "--size", "16x16", "--pixel", "8,8"},
        {"explain", scene, "--vertex", "1,1"},
        {"export", scene, "--as", "c"},
        {"export", scene, "--as", "scene"},
        {"export", scene, "--as", "glsl"},
        {"export", scene, "--as", "glsl", "-o", report},
        {"lint", scene},
        {"lint", scene, "--json"},
        {"study", scene, "--quick", "--size", "8x8", "--seconds", "0", "-o", folder / (odd + "-study")},
        {"study", scene, "--resume", "-o", folder / odd},
        {"check", scene},
        {"fuzz", "--count", "1", "-o", folder / ("no\x1b[1m" + std::string("/\n\x01"))},
        {"compare", folder / (odd + "missing.gl")},
        {odd},
    };
    for (const std::vector<std::string>& command : commands) {
        const ProgramResult result = run_shell("twinlight", [&] {
            std::string line = "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(folder.str()) + "; \"$PROGRAM\"";
            for (const std::string& word : command) line += " " + quoted(word);
            return line;
        }());
        EXPECT_FALSE(has_control_characters(result.out)) << command[0] << ": " << quoted(result.out);
        EXPECT_FALSE(has_control_characters(result.err)) << command[0] << ": " << quoted(result.err);
        const bool is_quiet = command[0] == "export" && command.back() == report;
        EXPECT_EQ(result.out + result.err == "", is_quiet) << command[0];
    }
}

TEST(UntrustedNumbers, AreRefused) {
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"render", "report", "--with", "shaders", "--budget", "nan"},
                                               {"study", "report", "--seconds", "nan"},
                                               {"fuzz", "--seed", "-1"},
                                               {"fuzz", "--seed", "99999999999999999999999"},
                                               {"fuzz", "--seed", ""},
                                               {"compare", "report", "--memory", "nan"}}) {
        const ProgramResult result = run_program("twinlight", command);
        EXPECT_EQ(result.status, 2) << command[1] << command[2];
        EXPECT_NE(result.err.find("number from"), std::string::npos) << result.err;
    }
    EXPECT_EQ(run_program("twinlight", {"fuzz", "--seed", "18446744073709551615", "--count", "1"}).status, 0);
}

// ---- Special files ----

TEST(SpecialFiles, AreNotWaitedFor) {
    const TemporaryFolder folder;
    const std::string in_folder = "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(folder.str()) + "; ";
    ASSERT_EQ(run_shell("", "mkfifo " + quoted(folder / "pipe.gl") + " " + quoted(folder / "pipe.trace")).status, 0);
    write_file_atomically(folder / "texture.gl", "#pragma twinlight texture(\"pipe.gl\")\nglutSolidSphere(1, 8, 8);\n");
    write_file_atomically(folder / "mesh.gl", "#pragma twinlight mesh(\"pipe.gl\")\n");
    const std::string refused = ": this is a named pipe, not a file; give a file, or - for standard input\n";
    for (const auto& [command, error] :
         std::vector<std::pair<std::string, std::string>>{{"render pipe.gl --with reference", refused},
                                                          {"render pipe.trace --with reference", refused},
                                                          {"compare pipe.gl", refused},
                                                          {"explain pipe.gl", refused},
                                                          {"export pipe.gl --as c", refused},
                                                          {"lint pipe.gl", refused},
                                                          {"study pipe.gl --quick", refused},
                                                          {"study --merge pipe.gl pipe.gl", refused},
                                                          {"check ./pipe.gl", refused},
                                                          {"lesson overlay --check pipe.gl", refused},
                                                          {"lint texture.gl", "this is not a file"},
                                                          {"lint mesh.gl", "this is not a file"}}) {
        const ProgramResult result = run_shell("twinlight", in_folder + "timeout 20 \"$PROGRAM\" " + command);
        EXPECT_EQ(result.status, 2) << command;
        EXPECT_NE((result.out + result.err).find(error), std::string::npos)
            << command << ": " << result.out << result.err;
    }
    // What the shell opens for the program stays a scene.
    write_file_atomically(folder / "sphere.gl", kSphere);
    for (const char* line :
         {"cat sphere.gl | \"$PROGRAM\" explain /dev/stdin", "\"$PROGRAM\" explain - <sphere.gl",
          "cat sphere.gl | \"$PROGRAM\" explain /dev/fd/0", "cat sphere.gl >pipe.gl & \"$PROGRAM\" explain - <pipe.gl"})
        EXPECT_EQ(run_shell("twinlight", in_folder + line).status, 0) << line;
}

// ---- Folders ----

TEST(Folders, HoldAllCasesOrNone) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const ProgramResult whole = run_program("twinlight", {"check", "--write-cases", out});
    ASSERT_EQ(whole.status, 0) << whole.err;
    const std::size_t programs = std::distance(std::filesystem::directory_iterator(out + "/cases"), {});
    ASSERT_GT(programs, 300u);
    // No file can be larger than a kilobyte, as on a disk that is full: the first programs do not stay alone.
    const std::string full = folder / "full";
    const ProgramResult result = run_shell(
        "twinlight", "trap '' XFSZ; ulimit -f 1; \"$PROGRAM\" check --write-cases " + quoted(full) + " >/dev/null");
    EXPECT_EQ(result.status, 2);
    EXPECT_FALSE(std::filesystem::exists(full));
}

TEST(Folders, KeepNoPicturesAndPlotsOfAnEarlierStudy) {
    const TemporaryFolder folder;
    const std::string sphere = folder / "sphere.gl", square = folder / "square.gl", out = folder / "study";
    write_file_atomically(sphere, kSphere);
    write_file_atomically(square,
                          "glClear(GL_COLOR_BUFFER_BIT); glRectf(-1, -1, 1, 1);\n");  // fewer choices: no slices
    const auto files = [&] {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(out))
            if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(out));
        std::ranges::sort(names);
        return names;
    };
    const auto study = [&](const std::string& scene) {
        return run_program("twinlight", {"study", scene, "--quick", "--size", "8x8", "--seconds", "0", "-o", out});
    };
    ASSERT_EQ(study(square).status, 0);
    const std::vector<std::string> few = files();
    ASSERT_EQ(study(sphere).status, 0);
    EXPECT_NE(files(), few);
    write_file_atomically(out + "/pictures/mine.png", "mine");
    ASSERT_EQ(study(square).status, 0);
    std::vector<std::string> expected = few;
    expected.emplace_back("pictures/mine.png");  // what the study did not write stays
    std::ranges::sort(expected);
    EXPECT_EQ(files(), expected);
}

TEST(Folders, AreTriedBeforeALongFuzzing) {
    const TemporaryFolder folder;
    write_file_atomically(folder / "file", "");
    const std::string under_file = folder / "file/failures";
    const ProgramResult result = run_program("twinlight", {"fuzz", "--count", "2147483647", "-o", under_file});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(run_program("twinlight", {"fuzz", "--count", "1", "-o", folder / "a/b"}).status, 0);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});  // nothing was found, so nothing is left
}

TEST(Files, OfOneResultAreNeverOldAndNew) {
    const TemporaryFolder folder;
    const std::string picture = folder / "a.png", page = folder / "index.html";
    write_files_atomically({{picture, "old"}, {page, "old"}});
    write_files_atomically({{picture, "new"}, {page, "new"}});
    EXPECT_EQ(read_file(picture) + read_file(page), "newnew");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "index.html"}));
    // Where one cannot be written, the old ones stay.
    EXPECT_THROW(write_files_atomically({{picture, "newer"}, {folder / "none/index.html", "newer"}}), FileError);
    EXPECT_EQ(read_file(picture), "new");
}

// ---- Memory ----

TEST(MemoryLimit, IsOneClearLine) {
    const TemporaryFolder folder;
    const std::string scene = folder / "sphere.gl";
    write_file_atomically(scene, "glClear(GL_COLOR_BUFFER_BIT);\nglutSolidSphere(1, 550, 550);\n");
    const auto render = [&](const std::string& memory, const std::string& size) {
        return run_program("twinlight", {"render", scene, "--with", "reference", "--size", size, "--memory", memory,
                                         "-o", folder / "x.png"});
    };
    const ProgramResult small = render("0.1", "16x16");
    EXPECT_EQ(small.status, 2);
    EXPECT_EQ(small.err.find(
                  "/sphere.gl:2:1: error: this picture needs more than 0.1 GB of memory; draw fewer vertices, or run "
                  "twinlight with a larger --memory (GL_OUT_OF_MEMORY)\n") == std::string::npos,
              false)
        << small.err;
    EXPECT_EQ(render("1", "16x16").status, 0);
    const ProgramResult large = render("1", "8192x8192");
    EXPECT_EQ(large.status, 2);
    EXPECT_NE(
        large.err.find("the scene and its pictures of 8192 x 8192 need 4.5 GB of memory, but 1 are allowed; try --size "
                       "3011x3011 or --memory 4.5\n"),
        std::string::npos)
        << large.err;
}

// The word after this one.
std::string word_after(const std::string& text, const std::string& name) {
    const std::size_t at = text.find(name + " ");
    if (at == std::string::npos) return "";
    const std::size_t begin = at + name.size() + 1;
    return text.substr(begin, text.find_first_of(" \n", begin) - begin);
}

TEST(MemoryLimit, SaysWhatFits) {
    const TemporaryFolder folder;
    const std::string plain = folder / "sphere.gl", accumulated = folder / "accumulated.gl";
    write_file_atomically(plain, kSphere);
    write_file_atomically(accumulated, kSphere + "glAccum(GL_LOAD, 1); glAccum(GL_RETURN, 1);\n");
    for (const std::string& scene : {plain, accumulated}) {
        const auto render = [&](const std::string& size, const std::string& memory) {
            return run_program("twinlight", {"render", scene, "--with", "reference", "--size", size, "--memory", memory,
                                             "-o", folder / "x.png"});
        };
        const ProgramResult refused = render("900x600", "0.03");
        EXPECT_EQ(refused.status, 2);
        const std::string size = word_after(refused.err, "--size"), memory = word_after(refused.err, "--memory");
        EXPECT_EQ(render("900x600", memory).status, 0) << refused.err;
        EXPECT_EQ(render(size, "0.03").status, 0) << refused.err;
    }
    // Without the option, its default counts.
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"study", plain, "--size", "8192x8192", "-o", folder / "study"},
             {"study", plain, "--size", "1000x1000", "--coverage", "16", "-o", folder / "study"}}) {
        const ProgramResult result = run_program("twinlight", command);
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find("but 2 are allowed; try --size "), std::string::npos) << result.err;
        EXPECT_EQ(result.err.find("--memory"), std::string::npos) << result.err;
    }
    const ProgramResult window = run_program("twinlight-demo", {"--size", "8192x8192"});
    EXPECT_EQ(
        window.err,
        "twinlight-demo: pictures of 8192 x 8192 need 4.1 GB of memory, but 2 are allowed; try --size 5773x5773\n");
}

// The size of a recording's picture comes from its viewports, which may be anything.
TEST(MemoryLimit, HoldsForTheSizeOfARecording) {
    const TemporaryFolder folder;
    const std::string dump = folder / "dump.txt";
    write_file_atomically(
        dump,
        "0 glViewport(x = 0, y = 0, width = 8000, height = 8000)\n1 glRectf(x1 = -1, y1 = -1, x2 = 1, "
        "y2 = 1)\n2 glXSwapBuffers(dpy = 0x1, drawable = 2)\n");
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"render", dump, "--with", "reference", "-o", folder / "x.png"},
                                               {"render", dump, "--with", "fixed", "-o", folder / "x.png"},
                                               {"compare", dump, "-o", folder / "report"},
                                               {"explain", dump, "--pixel", "1,1"},
                                               {"export", dump, "--as", "html", "-o", folder / "x.html"}}) {
        const ProgramResult result = run_program("twinlight", command);
        EXPECT_EQ(result.status, 2) << command[0];
        EXPECT_NE(result.err.find("pictures of 8000 x 8000 need "), std::string::npos) << result.err;
        EXPECT_EQ(word_after(result.err, "--size") == "", command[0] == "export") << result.err;
    }
    EXPECT_EQ(run_program("twinlight", {"explain", dump}).status, 0);  // draws no picture
}

// A loop is counted before it runs, which would take seconds.
TEST(MemoryLimit, HoldsForALoopOfAProgram) {
    const TemporaryFolder folder;
    const std::string program = folder / "points.c";
    const auto lint = [&](const std::string& loop) {
        write_file_atomically(program,
                              "void display(void) {\nglClear(GL_COLOR_BUFFER_BIT); glBegin(GL_POINTS);\n" + loop +
                                  "\nglEnd();\n}\nint main(int argc, char **argv) { glutInit(&argc, argv); "
                                  "glutCreateWindow(\"w\"); glutDisplayFunc(display); glutMainLoop(); return 0; }\n");
        return run_program("twinlight", {"lint", program, "--size", "16x16", "--memory", "0.01"});
    };
    for (const char* loop :
         {"for (int i = 0; i < 10000; i++) glVertex2f(0.001 * i, 0);",
          "int i; for (i = 1; i <= 5000; ++i) { glVertex2f(0.001 * i, 0); glVertex2f(0, 0.1); }",
          "for (int i = 0; i < 1000; i++) for (int j = 0; j < 10; j++) glVertex2f(0.001 * i, 0.1 * j);",
          "for (int i = 0; i < 1000; i++) { for (int j = 1; j < 10; j++) glVertex2f(0.001 * i, 0.1 * j); "
          "glVertex2f(0.001 * i, 0); }"}) {
        const ProgramResult result = lint(loop);
        EXPECT_EQ(result.status, 2) << loop;
        EXPECT_NE(result.err.find("points.c:3:"), std::string::npos) << result.err;
        EXPECT_NE(
            result.err.find(": error: this loop sends 10000 vertices, which need more memory than is allowed; draw "
                            "fewer vertices, or run twinlight with a larger --memory\n"),
            std::string::npos)
            << result.err;
    }
    // Loops that end earlier, or that send fewer vertices than rounds, run.
    for (const char* loop :
         {"for (int i = 0; i < 100000; i++) { if (i == 9) break; glVertex2f(0.001 * i, 0); }",
          "for (int i = 0; i < 100000; i++) { glVertex2f(0.001 * i, 0); i = i + 50000; }",
          "for (int i = 0; i < 100000; i++) if (i < 9) glVertex2f(0.001 * i, 0);",
          "for (int i = 0; i < 10000; i++) for (int j = 0; j < 10; j++) { glVertex2f(0.1 * j, 0); i += 9999; }",
          "for (int i = 0; i < 5; i++) glVertex2f(0.001 * i, 0);"}) {
        const ProgramResult result = lint(loop);
        EXPECT_EQ(result.status, 0) << loop << result.err << result.out;
    }
}

// The peak stays below what the limit counts, so the limit holds for the process. (Sanitizers need memory of their own.)
TEST(MemoryLimit, CountsWhatIsBuilt) {
    if (kSanitized) GTEST_SKIP() << "sanitizers change how much memory is needed";
    const TemporaryFolder folder;
    const std::string scene = folder / "sponge.gl";
    write_file_atomically(scene, "GLdouble at[] = {0, 0, 0};\nglutSolidSierpinskiSponge(7, at, 1);\n");
    const auto run = [&](const std::string& memory) {
        return run_shell("twinlight", "ulimit -v 1500000; \"$PROGRAM\" render " + quoted(scene) +
                                          " --with reference --size 16x16 --memory " + memory + " -o " +
                                          quoted(folder / "x.png"))
            .status;
    };
    EXPECT_EQ(run("0.05"), 2);
    EXPECT_EQ(run("0.5"), 0);
}

// The largest memory of a process, in bytes. Without the driver's cache of shaders each run compiles them.
double peak_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), build_folder() + "/twinlight");
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
        ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        ::raise(SIGSTOP);
        ::execv(words.front(), words.data());
        ::_exit(127);
    }
    // It stops where it ends, and the kernel's peak is read there. getrusage() would also count the memory that this test had at the
    // fork.
    int status = 0;
    ::waitpid(child, &status, 0);
    ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACEEXIT | PTRACE_O_EXITKILL);
    const std::string file = "/proc/" + std::to_string(child) + "/status", label = "VmHWM:";
    double kilobytes = 0;
    ::ptrace(PTRACE_CONT, child, nullptr, nullptr);
    while (::waitpid(child, &status, 0) == child && WIFSTOPPED(status)) {
        const int signal = WSTOPSIG(status);
        if (status >> 8 == (SIGTRAP | (PTRACE_EVENT_EXIT << 8))) {
            std::ifstream lines(file);
            for (std::string line; std::getline(lines, line);)
                if (line.starts_with(label)) kilobytes = std::stod(line.substr(label.size()));
        }
        ::ptrace(PTRACE_CONT, child, nullptr, signal == SIGTRAP ? 0L : static_cast<long>(signal));
    }
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) < 2) << arguments[1];
    EXPECT_GT(kilobytes, 0) << arguments[1];
    return 1024 * kilobytes;
}

// A recording of one glBegin with this many vertices.
std::string dump_of(const std::string& mode, const std::string& polygon_mode, int vertices) {
    std::string text = "0 glViewport(x = 0, y = 0, width = 64, height = 64)\n1 glEnable(cap = GL_LIGHTING)\n";
    text += "2 glPolygonMode(face = GL_FRONT_AND_BACK, mode = " + polygon_mode + ")\n";
    text += "3 glBegin(mode = " + mode + ")\n";
    for (int i = 0; i < vertices; ++i)
        text += std::to_string(4 + i) + " glVertex2f(x = " + std::to_string(1.8 * i / vertices - 0.9) +
                (i % 2 == 0 ? ", y = 0.5)\n" : ", y = -0.5)\n");
    const int end = 4 + vertices;
    return text + std::to_string(end) + " glEnd()\n" + std::to_string(end + 1) +
           " glXSwapBuffers(dpy = 0x1, drawable = 2)\n";
}

// A picture that is allowed as much memory as its comparison was seen to need is refused. What a scene needs is twice what its second
// half adds: both runs have the same driver's code, and reuse the memory in which it was compiled.
TEST(MemoryLimit, CountsAtLeastWhatAComparisonUses) {
    if (kSanitized) GTEST_SKIP() << "sanitizers change how much memory is needed";
    const TemporaryFolder folder;
    const auto compare = [&](const std::string& file, const std::string& memory) {
        return std::vector<std::string>{"compare",  file,   "--size", "64x64",
                                        "--memory", memory, "-o",     folder / "report"};
    };
    const std::string half = folder / "half.txt", whole = folder / "whole.txt";
    for (const auto& [mode, polygon_mode] : std::vector<std::pair<std::string, std::string>>{
             {"GL_TRIANGLE_STRIP", "GL_FILL"}, {"GL_TRIANGLE_STRIP", "GL_LINE"}, {"GL_POINTS", "GL_FILL"}}) {
        write_file_atomically(half, dump_of(mode, polygon_mode, 20'000));
        write_file_atomically(whole, dump_of(mode, polygon_mode, 40'000));
        const double used = 2 * (peak_of(compare(whole, "2")) - peak_of(compare(half, "2")));
        EXPECT_GT(used, 8e6) << mode;
        const ProgramResult refused = run_program("twinlight", compare(whole, std::to_string(used / 1e9)));
        EXPECT_EQ(refused.status, 2) << mode << " " << polygon_mode << ": " << used / 40'000 << " bytes a vertex";
        EXPECT_NE(refused.err.find("--memory"), std::string::npos) << refused.err;
    }
    // A shape sends each vertex twice. What it is said to need does not hang on the picture's size. Here few triangles cover a pixel's
    // centre; at 1000 x 1000 a vertex needs 930 bytes.
    const std::string small = folder / "small.gl", sphere = folder / "sphere.gl";
    write_file_atomically(small, "glutSolidSphere(1, 283, 283);");
    write_file_atomically(sphere, "glutSolidSphere(1, 400, 400);");
    const double used = 2 * (peak_of(compare(sphere, "2")) - peak_of(compare(small, "2")));
    EXPECT_GT(used, 30e6);
    EXPECT_EQ(run_program("twinlight", compare(sphere, std::to_string(used / 1e9))).status, 2);
    const double enough = 2 * 160'000 * 930.0;
    EXPECT_EQ(run_program("twinlight", compare(sphere, std::to_string(enough / 1e9))).status, 0)
        << used / 160'000 << " bytes a vertex";
}

// The same for the pixels: of each renderer, with accumulation and copies, and of several steps on one page.
TEST(MemoryLimit, CountsAtLeastWhatPixelsUse) {
    if (kSanitized) GTEST_SKIP() << "sanitizers change how much memory is needed";
    const TemporaryFolder folder;
    const std::string quads =
        "glClear(GL_COLOR_BUFFER_BIT); glBegin(GL_QUADS); glVertex3f(-0.9, -0.9, 0); glVertex3f(0.9, -0.9, 0.3);\n"
        "glVertex3f(0.9, 0.9, 0); glVertex3f(-0.9, 0.9, 0.3); glEnd();\n";
    const std::string plain = folder / "plain.gl", most = folder / "most.gl";
    write_file_atomically(plain, quads);
    write_file_atomically(most,
                          quads +
                              "glAccum(GL_LOAD, 0.5); glClear(GL_COLOR_BUFFER_BIT); glAccum(GL_ACCUM, 0.5);\n"
                              "glAccum(GL_RETURN, 1); glRasterPos2f(0, 0); glCopyPixels(0, 0, 64, 64, GL_COLOR);\n");
    struct Row {
        std::vector<std::string> command;
        double slack;  // at most this many times what is used is enough
    };
    for (const auto& [command, slack] :
         std::vector<Row>{{{"render", plain, "--with", "reference", "-o", folder / "x.png"}, 1.6},
                          {{"render", most, "--with", "reference", "-o", folder / "x.png"}, 3.5},
                          {{"render", most, "--with", "shaders", "-o", folder / "x.png"}, 3.5},
                          {{"explain", most, "--pixel", "20,20"}, 3},
                          {{"compare", most, "-o", folder / "report"}, 1.6},
                          {{"compare", "terms", "-o", folder / "report"}, 2}}) {
        const auto with = [&, &given = command](const std::string& size, double gigabytes) {
            std::vector<std::string> words = given;
            words.insert(words.end(), {"--size", size, "--memory", std::to_string(gigabytes)});
            return words;
        };
        const std::string line = command[0] + " " + command[1] + " " + command[3];
        // A comparison takes seconds, and needs enough memory with fewer pixels.
        const bool is_slow = command[0] == "compare";
        const std::string size = is_slow ? "480x400" : "800x600", eighth = is_slow ? "200x120" : "300x200";
        const double pixels = is_slow ? 480 * 400 : 800 * 600;
        const double used = (peak_of(with(size, 2)) - peak_of(with(eighth, 2))) * 8 / 7;
        const ProgramResult refused = run_program("twinlight", with(size, used / 1e9));
        EXPECT_EQ(refused.status, 2) << line << ": " << used / pixels << " bytes a pixel";
        EXPECT_NE(refused.err.find((is_slow ? "pictures of 480 x 400 need " : "pictures of 800 x 600 need ")),
                  std::string::npos)
            << refused.err;
        EXPECT_LT(run_program("twinlight", with(size, slack * used / 1e9)).status, 2)
            << line << ": " << used / pixels << " bytes a pixel";
    }
}

}  // namespace
}  // namespace twinlight::untrusted_test

// Every command ends with its own status, whatever its standard input, output and error are: closed, full, or a pipe whose other end is
// closed. Only a result that standard output cannot take is an error.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "../run_program.h"
#include "base/image/file.h"

namespace twinlight::streams_test {
namespace {

enum class State { kUsual, kClosed, kFull, kBroken };
constexpr std::array<const char*, 3> kStreams = {"input", "output", "error"};

// A pipe's end, whose other end is closed.
int broken_pipe(int stream) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return -1;
    const bool reads = stream == STDIN_FILENO;
    ::close(ends.at(reads ? 1 : 0));
    return ends.at(reads ? 0 : 1);
}

// Runs a program with one stream in this state. Standard error goes into a file.
ProgramResult run(std::vector<std::string> words, int stream, State state, const std::string& file_of_errors) {
    words.front() = build_folder() + "/" + words.front();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const int full = ::open("/dev/full", O_RDWR | O_CLOEXEC), null = ::open("/dev/null", O_RDWR | O_CLOEXEC),
              errors = ::open(file_of_errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600),
              broken = broken_pipe(stream);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(null, STDIN_FILENO);
        ::dup2(null, STDOUT_FILENO);
        ::dup2(errors, STDERR_FILENO);
        switch (state) {
            case State::kUsual: break;
            case State::kClosed: ::close(stream); break;
            case State::kFull: ::dup2(full, stream); break;
            case State::kBroken: ::dup2(broken, stream); break;
        }
        ::execv(arguments.front(), arguments.data());
        ::_exit(127);
    }
    for (const int file : {full, null, errors, broken}) ::close(file);
    int status = 0;
    ::waitpid(child, &status, 0);
    ProgramResult result;
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    result.err = read_file(file_of_errors);
    take_gl(result);
    return result;
}

TEST(Streams, InAnyStateLeaveEveryCommandItsStatus) {
    const TemporaryFolder folder;
    const std::string scene = folder / "warned.gl", errors = folder / "errors";
    write_file_atomically(scene,
                          "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glBegin(GL_TRIANGLES); glNormal3f(0, 0, 0.5);\n"
                          "glVertex3f(0, 0, 0); glVertex3f(1, 0, 0); glVertex3f(0, 1, 0); glEnd();\n");
    struct Row {
        std::vector<std::string> words;
        int status;
        bool has_result = true;  // on standard output
    };
    const std::vector<Row> rows = {
        {{"twinlight", "--version"}, 0},
        {{"twinlight"}, 2, false},
        {{"twinlight", "scenes"}, 0},
        {{"twinlight", "explain", scene, "--pixel", "1,1", "--size", "8x6"}, 0},
        {{"twinlight", "export", scene, "--as", "glsl"}, 0},
        {{"twinlight", "export", scene, "--as", "glsl", "-o", folder / "shaders"}, 0, false},
        {{"twinlight", "render", scene, "--with", "fixed", "--size", "8x6", "-o", folder / "a.png"}, 0, false},
        {{"twinlight", "render", scene, "--with", "reference", "--size", "8x6", "-o", "-"}, 0},
        {{"twinlight", "compare", scene, "--size", "8x6", "-o", folder / "report"}, 0},
        {{"twinlight", "study", scene, "--quick", "--seconds", "0", "--size", "4x4", "-o", folder / "study"}, 0},
        {{"twinlight", "fuzz", "--count", "1", "-o", folder / "fuzz"}, 0},
        {{"twinlight", "check", "light-none"}, 0},
        {{"twinlight", "lint", scene}, 1},
        {{"twinlight", "lint", "no-such-file"}, 2, false},
        {{"twinlight", "lesson"}, 0},
        {{"twinlight", "record", "no-such-program"}, 2, false},
        {{"twinlight-demo", "--version"}, 0},
        {{"twinlight-demo", "no-such-file"}, 2, false},
    };
    for (const Row& row : rows) {
        std::string command;
        for (const std::string& word : row.words) command += word + " ";
        const ProgramResult usual = run(row.words, STDIN_FILENO, State::kUsual, errors);
        EXPECT_EQ(usual.status, row.status) << command << usual.err;
        for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
            for (const State state : {State::kClosed, State::kFull, State::kBroken}) {
                const ProgramResult result = run(row.words, stream, state, errors);
                const std::string what = command + "with standard " + kStreams.at(static_cast<std::size_t>(stream)) +
                                         " in state " + std::to_string(static_cast<int>(state)) + ": " + result.err;
                const bool is_lost = stream == STDOUT_FILENO && row.has_result;
                EXPECT_EQ(result.status, is_lost ? 2 : row.status) << what;
                const char* reason = state == State::kClosed ? "Bad file descriptor"
                                     : state == State::kFull ? "No space left on device"
                                                             : "Broken pipe";
                if (is_lost) {
                    EXPECT_EQ(result.err, "twinlight" + std::string(row.words[0] == "twinlight" ? "" : "-demo") +
                                              ": standard output: " + reason + "\n")
                        << what;
                }
            }
        }
    }
    // "/dev/full" gives zeros to read without end.
    const std::vector<std::string> piped = {"twinlight", "lint", "-"};
    EXPECT_EQ(run(piped, STDIN_FILENO, State::kClosed, errors).err, "twinlight: standard input: Bad file descriptor\n");
    EXPECT_EQ(run(piped, STDIN_FILENO, State::kClosed, errors).status, 2);
    EXPECT_EQ(run(piped, STDIN_FILENO, State::kFull, errors).status, 2);
    EXPECT_EQ(run(piped, STDIN_FILENO, State::kBroken, errors).status, 2);
}

// A file must not get the number of a closed stream: the warnings would be written into it.
TEST(Streams, ThatAreClosedAreNoFiles) {
    if (!can_trace()) GTEST_SKIP() << kCannotTrace;
    const TemporaryFolder folder;
    const ProgramResult result = run_shell(
        "twinlight", "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(folder.str()) +
                         "; strace -o log -e trace=openat,fcntl \"$PROGRAM\" scenes 0<&- 1>&- 2>&-; echo $? >status");
    EXPECT_EQ(read_file(folder / "status"), "2\n");
    const std::string log = read_file(folder / "log");
    for (const char* opened : {"O_WRONLY) = 0\n", "O_RDONLY) = 1\n", "O_RDONLY) = 2\n"})
        EXPECT_NE(log.find("\"/dev/null\", " + std::string(opened)), std::string::npos) << opened << log;
}

}  // namespace
}  // namespace twinlight::streams_test

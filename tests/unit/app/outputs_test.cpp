// What every command of twinlight writes, on a disk that is full and when it is interrupted.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "../effort.h"
#include "../pictures.h"
#include "../run_program.h"
#include "../sanitized.h"
#include "base/image/descriptor.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"

namespace twinlight::outputs_test {
namespace {

namespace fs = std::filesystem;

// A departure that the driver is known for, looked for: each is written as it is found.
const std::string kFuzz = "fuzz --seed 1 --count 400 --lift 'lights after glPopAttrib of GL_ENABLE_BIT' -o ";

void expect_whole(const fs::path& file, const std::string& where) {
    const std::string kind = file.extension(), bytes = read_file(file);
    EXPECT_NE(kind, ".part") << where << ": " << file;
    if (kind == ".png") {
        EXPECT_NO_THROW(decode_png(bytes)) << where << ": " << file;
    }
    if (kind == ".json") {
        EXPECT_TRUE(nlohmann::json::accept(bytes)) << where << ": " << file;
    }
    if (kind == ".html" || kind == ".svg") {
        EXPECT_NE(bytes.find("</" + kind.substr(1)), bytes.npos) << where << ": " << file;
    }
    if (kind == ".csv" || kind == ".gl" || kind == ".c") {
        EXPECT_TRUE(bytes.ends_with('\n')) << where << ": " << file;
    }
}

class Outputs : public testing::Test {
  protected:
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.str()))
            if (entry.is_regular_file()) found.push_back(entry.path());
        return found;
    }
    std::string in_folder(const std::string& name) const { return quoted(folder_ / name); }

    const TemporaryFolder folder_;
};

TEST_F(Outputs, OfEveryCommandThatDoNotFitAreTold) {
    for (const std::string& arguments :
         std::vector<std::string>{"--help",
                                  "--version",
                                  "render --help",
                                  "scenes",
                                  "explain report",
                                  "explain report --json",
                                  "explain report --pixel 320,240",
                                  "export report --as c",
                                  "export report --as glsl",
                                  "render report --with reference --size 8x6 -o -",
                                  "compare report --size 8x6 -o " + in_folder("report"),
                                  "compare report --size 8x6 --json -o " + in_folder("report"),
                                  "study report --quick --seconds 0.01 --size 8x6 -o " + in_folder("study"),
                                  "study report --quick --seconds 0.01 --size 8x6 --json -o " + in_folder("study"),
                                  "fuzz --count 1 -o " + in_folder("fuzz"),
                                  "fuzz --count 1 --json -o " + in_folder("fuzz"),
                                  "check light-none rescale-1e7",
                                  "check light-none --json",
                                  "check rescale-1e7 --html " + in_folder("page"),
                                  "check rescale-1e7 --write-cases " + in_folder("cases"),
                                  "check rescale-1e7 --write-reports " + in_folder("bugs"),
                                  "check rescale-1e7 --write-reports " + in_folder("bugs")}) {
        const ProgramResult result = run_shell("twinlight", "\"$PROGRAM\" " + arguments + " >/dev/full");
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(result.err, "twinlight: standard output: No space left on device\n") << arguments;
    }
}

TEST_F(Outputs, LeaveNoFileWhereTheDiskIsFull) {
    for (const std::string& arguments : std::vector<std::string>{
             "render report --with reference --size 64x48 -o " + in_folder("p.png"),
             "compare report --size 8x6 -o " + in_folder("report"),
             "study report --quick --seconds 0.01 --size 8x6 -o " + in_folder("study"), kFuzz + in_folder("fuzz"),
             "check rescale-1e7 --html " + in_folder("page"), "check rescale-1e7 --write-cases " + in_folder("cases"),
             "export report --as glsl -o " + in_folder("shaders"), "export report --as wgsl -o " + in_folder("wgsl"),
             "lint --rules -o " + in_folder("rules")}) {
        // No file may be longer than 512 bytes. A signal says so, too, which must not end the program.
        const ProgramResult result = run_shell("twinlight", "ulimit -f 1; \"$PROGRAM\" " + arguments);
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(": File too large"), std::string::npos) << arguments << ": " << result.err;
        EXPECT_EQ(folder_.names(), std::vector<std::string>{}) << arguments;  // nor an empty folder
    }
}

// One picture fits, the page does not.
TEST_F(Outputs, OfSeveralFilesAreWholeOrNotThere) {
    const ProgramResult rules =
        run_shell("twinlight", "ulimit -f 16; \"$PROGRAM\" lint --rules -o " + in_folder("rules"));
    EXPECT_EQ(rules.status, 2);
    EXPECT_NE(rules.err.find("lint.md: File too large\n"), std::string::npos) << rules.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{});
    write_file_atomically(folder_ / "file", "");
    const ProgramResult cases =
        run_shell("twinlight", "ulimit -f 16; \"$PROGRAM\" check rescale-1e7 --write-cases " + in_folder("cases"));
    EXPECT_EQ(cases.status, 2);
    EXPECT_NE(cases.err.find("hard_case.c: File too large\n"), std::string::npos) << cases.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"file"});
}

TEST_F(Outputs, AreWholeOrNotThereAfterAnInterruption) {
    const std::vector<std::string> commands = {
        "render report --with reference --size 320x240 -o " + in_folder("p.png"),
        "compare report --size 160x120 -o " + in_folder("report"),
        "study report --quick --seconds 0.1 --size 16x12 -o " + in_folder("study"),
        kFuzz + in_folder("fuzz"),
        "check --html " + in_folder("page"),
        "check --write-cases " + in_folder("cases")};
    int interrupted = 0;
    for (const std::string& arguments : commands) {
        for (const char* signal : {"INT", "TERM", "HUP"}) {
            for (const char* delay : {"0.02", "0.1", "0.3"}) {
                const ProgramResult result = run_shell("twinlight", std::string("timeout -s ") + signal + " " + delay +
                                                                        " \"$PROGRAM\" " + arguments + " >/dev/null");
                interrupted += result.status == 124 ? 1 : 0;
            }
            for (const fs::path& file : files()) {
                expect_whole(file, arguments);
            }
        }
    }
    EXPECT_GT(interrupted, 10);
}

// ---- Killed ----

// A command that writes something, and the file that it gets its name last: as long as that exists, the result is whole.
struct Writer {
    const char *arguments, *output, *last;
};
constexpr Writer kWriters[] = {
    {"render small.gl --with reference --size 8x6 -o", "picture.png", "picture.png"},
    {"compare small.gl --size 8x6 -o", "report", "report/index.html"},
    {"lint small.gl --fix normal-length -o", "fixed.gl", "fixed.gl"},
    {"export small.gl --as glsl -o", "shaders", "shaders/README.md"},
    {"export small.gl --as html -o", "page.html", "page.html"},
    {"export small.gl --as wgsl -o", "wgsl", "wgsl/README.md"},
    {"lesson overlay -o", "start.gl", "start.gl"},
    {"check rescale-1e7 --html", "cases", "cases/index.html"},
    {"check rescale-1e7 --write-reports", "bugs", "bugs/rescale-1e7.md"},
    {"check rescale-1e7 --write-cases", "cases", "cases/window_win32.c"},
    {"study small.gl --quick --size 4x4 --seconds 0 -o", "study", "study/index.html"},
    {"lint --rules -o", "rules", "rules/lint.md"},
};

// Kills a writer at the nth of each system call that could leave something behind, where there is nothing yet and where there is an
// older result. Afterwards each file is whole; if the last one is there, all are; and nothing else is left.
TEST(KilledWriters, LeaveAWholeResultOrNone) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer makes system calls of its own";
    if (!can_trace()) GTEST_SKIP() << kCannotTrace;
    const TemporaryFolder folder;
    if (const Descriptor nameless(::open(folder.str().c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600));
        !nameless.valid())
        GTEST_SKIP() << "the file system has no files without names";
    write_file_atomically(folder / "small.gl",
                          "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glBegin(GL_TRIANGLES); glNormal3f(0, 0, 0.5);\n"
                          "glVertex3f(0, 0, 0); glVertex3f(1, 0, 0); glVertex3f(0, 1, 0); glEnd();\n");
    const std::string before = "PROGRAM=$(realpath \"$PROGRAM\"); cd " + quoted(folder.str()) + "; mkdir -p out; ";
    const fs::path out = folder / "out";
    const auto names = [&] {
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(out))
            if (entry.is_regular_file()) found.push_back(entry.path().lexically_relative(out).string());
        std::ranges::sort(found);
        return found;
    };
    int killed = 0;
    const std::size_t writers = tries_all() ? std::size(kWriters) : 4;
    for (const Writer& writer : std::span(kWriters).first(writers)) {
        const std::string command =
            std::string("\"$PROGRAM\" ") + writer.arguments + " out/" + writer.output + " >/dev/null 2>&1";
        const auto run = [&](const std::string& tracer) {
            return run_shell("twinlight", before + tracer + command).status;
        };
        fs::remove_all(out);
        ASSERT_LT(run(""), 2) << command;
        const std::vector<std::string> whole = names();
        ASSERT_TRUE(std::ranges::find(whole, writer.last) != whole.end()) << command;
        for (const bool is_old_there : {false, true}) {
            for (const std::string call : {"write", "linkat", "rename", "unlink", "mkdir"}) {
                // Until it makes no more such calls. A few of many are enough: they are of one loop.
                for (int n = 1, step = 1; n < 1000; n += step) {
                    if (!is_old_there) fs::remove_all(out);
                    const std::string where = fmt::format("{}, killed at {} {}, {}", command, call, n,
                                                          is_old_there ? "over an old result" : "the first time");
                    const bool is_killed =
                        run(fmt::format("strace -f -o /dev/null -e trace={0} -e inject={0}:signal=KILL:when={1} ", call,
                                        n)) == 128 + SIGKILL;
                    std::vector<std::string> left = names();
                    // No system call replaces a file with one that has no name.
                    const bool may_leave_part = is_old_there && call == "rename" && whole.size() == 1;
                    if (may_leave_part && is_killed) {
                        EXPECT_EQ(std::erase(left, whole.front() + ".part"), 1u) << where;
                    }
                    EXPECT_TRUE(std::ranges::includes(whole, left)) << where << ": " << testing::PrintToString(left);
                    for (const std::string& name : left) expect_whole(out / name, where);
                    const bool is_whole = std::ranges::find(left, writer.last) != left.end();
                    if (is_whole) {
                        EXPECT_EQ(left, whole) << where;
                    }
                    if (is_old_there) {
                        EXPECT_TRUE(is_whole || whole.size() > 1) << where;
                        run("");
                        EXPECT_EQ(names(), whole) << where;
                    }
                    if (!is_killed) break;
                    ++killed;
                    if (!tries_all() && n == 2) break;
                    if (n == 8) step = 7;
                }
            }
        }
    }
    EXPECT_GT(killed, 20);
}

}  // namespace
}  // namespace twinlight::outputs_test

// The recordings of real programs: each is complete and matches README.md's table; and record.sh makes such recordings
// and reports errors.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "base/image/file.h"

namespace twinlight::recordings_test {
namespace {

constexpr const char* kFolder = "tests/traces";
constexpr std::uintmax_t kLargestRecording = 256 << 10, kLargestTogether = 3 << 19;  // 1.5 MiB

struct Row {
    std::string name, package, licence;
    int frames = 0;
};

// | `name` | package | licence | API | seconds | frames | `command` |
std::vector<Row> table() {
    const std::regex pattern(R"(\| `([^`]+)` \| (\S+) \| (\S+) \| (?:gl|egl) \| \d+ \| (\d+) \| `[^`]+` \|)");
    std::vector<Row> rows;
    std::istringstream lines(read_file(std::string(kFolder) + "/README.md"));
    for (std::string line; std::getline(lines, line);) {
        std::smatch field;
        if (std::regex_match(line, field, pattern)) rows.push_back({field[1], field[2], field[3], std::stoi(field[4])});
    }
    return rows;
}

std::vector<Row> kept_rows() {
    std::vector<Row> rows;
    for (const Row& row : table()) {
        if (std::filesystem::is_directory(std::string(kFolder) + "/" + row.name)) rows.push_back(row);
    }
    return rows;
}

int count(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern, std::regex::multiline);
    return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

constexpr const char* kEndOfFrame = R"(^\d+ (glX|egl)SwapBuffers\()";

TEST(Recordings, AreOfEightProgramsBesideGlxgears) {
    std::set<std::string> names;
    for (const Row& row : kept_rows()) names.insert(row.name);
    EXPECT_EQ(names.count("glxgears"), 1u);
    EXPECT_GE(names.size(), 1u + 8u);
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        if (!entry.is_directory()) continue;
        EXPECT_EQ(names.count(entry.path().filename()), 1u) << entry.path() << " has no row in README.md's table";
    }
}

TEST(Recordings, HoldLitFramesAsManyAsTheTableSays) {
    for (const Row& row : kept_rows()) {
        SCOPED_TRACE(row.name);
        const std::string dump = read_file(std::string(kFolder) + "/" + row.name + "/dump.txt");
        EXPECT_EQ(count(dump, kEndOfFrame), row.frames);
        EXPECT_GE(count(dump, R"(^\d+ glEnable\(cap = GL_LIGHTING\)$)"), 1);
        EXPECT_GE(count(dump, R"(^\d+ glEnable\(cap = GL_LIGHT[0-7]\)$)"), 1);
        // Nothing follows the last frame.
        EXPECT_EQ(dump.substr(dump.size() - 2), "\n\n");
    }
}

TEST(Recordings, HaveTheBlobsThatTheyNameAndNoOthers) {
    for (const Row& row : kept_rows()) {
        SCOPED_TRACE(row.name);
        const std::filesystem::path folder = std::filesystem::path(kFolder) / row.name;
        const std::string dump = read_file((folder / "dump.txt").string());
        const std::regex blob(R"re(blob\("([^"]+)"\))re");
        std::set<std::string> named = {"dump.txt"}, there;
        for (std::sregex_iterator i(dump.begin(), dump.end(), blob), end; i != end; ++i) named.insert((*i)[1]);
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            there.insert(entry.path().filename());
            EXPECT_GT(entry.file_size(), 0u) << entry.path();
        }
        EXPECT_EQ(there, named);
        EXPECT_EQ(count(dump, R"(blob\(\d)"), 0) << "only the size of a blob was kept; dump with --blobs";
    }
}

TEST(Recordings, AreSmall) {
    std::uintmax_t together = 0;
    for (const Row& row : kept_rows()) {
        std::uintmax_t size = 0;
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(kFolder) / row.name)) {
            size += entry.file_size();
        }
        EXPECT_LE(size, kLargestRecording) << row.name;
        together += size;
    }
    EXPECT_LE(together, kLargestTogether);
}

// ---- record.sh ----

bool installed(const std::string& program) { return run_shell("", "command -v " + program).status == 0; }

// record.sh next to a table written by the test.
class Record : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* tool : {"apitrace", "Xvfb"}) {
            if (!installed(tool)) GTEST_SKIP() << tool << " is not installed";
        }
        std::filesystem::copy_file(std::string(kFolder) + "/record.sh", folder_ / "record.sh");
    }

    ProgramResult record(const std::string& row, const std::string& arguments = "") {
        write_file_atomically(folder_ / "README.md", row + "\n");
        return run_shell("", quoted(folder_ / "record.sh") + " -o " + quoted(folder_ / "out") + " " + arguments);
    }

    TemporaryFolder folder_;
};

TEST_F(Record, KeepsTheFirstFramesOfGlxgears) {
    if (!installed("glxgears")) GTEST_SKIP() << "glxgears is not installed; it is in Debian's package mesa-utils";
    const ProgramResult result =
        record("| `gears` | mesa-utils | MIT | gl | 3 | 3 | `glxgears -geometry 200x100` |", "gears");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("gears: 3 frames, "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("1 recorded, 0 failed, 0 skipped"), std::string::npos) << result.out;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out/gears.trace"));
    const std::string dump = read_file(folder_ / "out/gears/dump.txt");
    EXPECT_EQ(count(dump, kEndOfFrame), 3);
    EXPECT_EQ(count(dump, R"(^\d+ glNewList\()"), 3);  // before the first frame: one for each gear
    EXPECT_EQ(count(dump, R"(^\d+ glCallList\()"), 3 * 3);
    EXPECT_EQ(count(dump, R"(^\d+ glViewport\(x = 0, y = 0, width = 200, height = 100\)$)"), 1);
}

TEST_F(Record, SkipsWhatIsNotInstalledAndNamesItsPackage) {
    const ProgramResult result = record("| `ghost` | ghost-package | MIT | gl | 1 | 1 | `no-such-program -x` |");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("ghost: skipped: not installed; it is in Debian's package ghost-package"),
              std::string::npos)
        << result.out;
}

TEST_F(Record, SaysWhyAProgramCouldNotBeRecorded) {
    const ProgramResult result = record("| `mute` | coreutils | GPL-3+ | gl | 1 | 1 | `true` |");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.out.find("mute: failed: no trace came of it; its last words: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("0 recorded, 1 failed, 0 skipped"), std::string::npos) << result.out;
}

TEST_F(Record, RefusesANameThatTheTableLacks) {
    const ProgramResult result = record("| `mute` | coreutils | GPL-3+ | gl | 1 | 1 | `true` |", "gaers");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("record.sh: no program 'gaers' in "), std::string::npos) << result.err;
}

}  // namespace
}  // namespace twinlight::recordings_test

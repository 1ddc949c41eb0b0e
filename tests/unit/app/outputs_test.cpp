// What every command of twinlight writes, on a disk that is full and when it is interrupted.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../pictures.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"

namespace twinlight::outputs_test {
namespace {

namespace fs = std::filesystem;

// A departure that the driver is known for, looked for: each is written as it is found.
const std::string kFuzz = "fuzz --seed 1 --count 400 --lift 'lights after glPopAttrib of GL_ENABLE_BIT' -o ";

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
    for (const std::string& arguments : std::vector<std::string>{
             "--help", "--version", "render --help", "scenes", "explain report", "explain report --json",
             "explain report --pixel 320,240", "export report --as c", "export report --as glsl",
             "render report --with reference --size 8x6 -o -", "compare report --size 8x6 -o " + in_folder("report"),
             "compare report --size 8x6 --json -o " + in_folder("report"),
             "study report --quick --seconds 0.01 --size 8x6 -o " + in_folder("study"),
             "study report --quick --seconds 0.01 --size 8x6 --json -o " + in_folder("study"),
             "fuzz --count 1 -o " + in_folder("fuzz"), "fuzz --count 1 --json -o " + in_folder("fuzz"),
             "check light-none rescale-1e7", "check light-none --json",
             "check rescale-1e7 --html " + in_folder("page") + " --write-reproducers " + in_folder("faults")}) {
        const ProgramResult result = run_shell("twinlight", "\"$PROGRAM\" " + arguments + " >/dev/full");
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(result.err, "twinlight: standard output: No space left on device\n") << arguments;
    }
}

TEST_F(Outputs, LeaveNoFileWhereTheDiskIsFull) {
    for (const std::string& arguments :
         std::vector<std::string>{"render report --with reference --size 64x48 -o " + in_folder("p.png"),
                                  "compare report --size 8x6 -o " + in_folder("report"),
                                  "study report --quick --seconds 0.01 --size 8x6 -o " + in_folder("study"),
                                  kFuzz + in_folder("fuzz"), "check rescale-1e7 --html " + in_folder("page"),
                                  "check rescale-1e7 --write-reproducers " + in_folder("faults")}) {
        // No file may be longer than 512 bytes.
        const ProgramResult result = run_shell("twinlight", "trap '' XFSZ; ulimit -f 1; \"$PROGRAM\" " + arguments);
        EXPECT_EQ(result.status, 2) << arguments;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(": File too large"), std::string::npos) << arguments << ": " << result.err;
        EXPECT_TRUE(files().empty()) << arguments << ": " << files().front();
    }
}

TEST_F(Outputs, AreWholeOrNotThereAfterAnInterruption) {
    const std::vector<std::string> commands = {
        "render report --with reference --size 320x240 -o " + in_folder("p.png"),
        "compare report --size 160x120 -o " + in_folder("report"),
        "study report --quick --seconds 0.1 --size 16x12 -o " + in_folder("study"), kFuzz + in_folder("fuzz"),
        "check --html " + in_folder("page") + " --write-reproducers " + in_folder("faults")};
    int interrupted = 0;
    for (const std::string& arguments : commands) {
        for (const char* signal : {"INT", "TERM", "HUP"}) {
            for (const char* delay : {"0.02", "0.1", "0.3"}) {
                const ProgramResult result = run_shell("twinlight", std::string("timeout -s ") + signal + " " + delay +
                                                                        " \"$PROGRAM\" " + arguments + " >/dev/null");
                interrupted += result.status == 124 ? 1 : 0;
            }
            for (const fs::path& file : files()) {
                const std::string kind = file.extension(), bytes = read_file(file);
                EXPECT_NE(kind, ".part") << file;
                if (kind == ".png") {
                    EXPECT_NO_THROW(decode_png(bytes)) << file;
                }
                if (kind == ".json") {
                    EXPECT_TRUE(nlohmann::json::accept(bytes)) << file;
                }
                if (kind == ".html" || kind == ".svg") {
                    EXPECT_NE(bytes.find("</" + kind.substr(1)), bytes.npos) << file;
                }
                if (kind == ".csv" || kind == ".gl" || kind == ".c") {
                    EXPECT_TRUE(bytes.ends_with('\n')) << file;
                }
            }
        }
    }
    EXPECT_GT(interrupted, 10);
}

}  // namespace
}  // namespace twinlight::outputs_test

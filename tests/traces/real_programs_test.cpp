// Frames of real programs, three ways. The recordings of this folder are read from their dumps; glxgears is recorded
// again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../unit/compare_three_ways.h"
#include "../unit/run_program.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/compare/comparison.h"
#include "judge/report/words.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"

namespace twinlight::real_programs_test {

namespace {

constexpr const char* kFolder = "tests/traces";

// Features of the programs that not every renderer supports.
const std::map<std::string, std::set<std::string>>& expected_unsupported() {
    static const std::map<std::string, std::set<std::string>> table = {};
    return table;
}

std::vector<std::string> recordings() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        if (entry.is_directory()) names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::size_t pixels_drawn(const Image& image) {
    return static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(), [](const Rgba& pixel) {
        return pixel[0] > 0 || pixel[1] > 0 || pixel[2] > 0;
    }));
}

class RealPrograms : public testing::TestWithParam<std::string> {};

TEST_P(RealPrograms, LookAlikeThreeWays) {
    const auto recording = load_recording(fmt::format("{}/{}/dump.txt", kFolder, GetParam()));
    const RecordedFrame recorded = make_recorded_frame(recording, {});
    EXPECT_EQ(recorded.error_count, 0u) << (recorded.first_error ? recorded.first_error->message : "");

    const compare::Comparison comparison = compare_three_ways(recorded.scene);
    std::set<std::string> unsupported;
    for (const Unsupported& item : comparison.unsupported) unsupported.insert(item.name);
    const auto expected = expected_unsupported().find(GetParam());
    EXPECT_EQ(unsupported, expected == expected_unsupported().end() ? std::set<std::string>() : expected->second);
    const auto unchecked = {"blinkbox", "stonerview",
                            "sundancer2"};  // OpenGL leaves much of these open (docs/real-programs.md)
    const bool is_unchecked = std::ranges::find(unchecked, GetParam()) != unchecked.end();
    EXPECT_EQ(comparison.verdict(), !unsupported.empty() ? compare::Verdict::kPartial
                                    : is_unchecked       ? compare::Verdict::kUnjudged
                                                         : compare::Verdict::kWithin);
    std::string told;
    for (const std::string& sentence : report::answer(comparison).sentences()) told += sentence + "\n";
    SCOPED_TRACE(told);
    for (const compare::Pair& pair : comparison.pairs) {
        EXPECT_NE(pair.verdict, compare::Verdict::kBeyond) << report::name_of(comparison, pair);
        // A picture without interior pixels would always pass.
        EXPECT_GT(pair.difference.interior.pixels, pair.difference.edge.pixels);
    }
    for (const compare::Render& render : comparison.renders) {
        EXPECT_GT(pixels_drawn(render.image), render.image.pixels.size() / 200) << render.name << " is almost black";
    }
}

INSTANTIATE_TEST_SUITE_P(OfDebian, RealPrograms, testing::ValuesIn(recordings()),
                         [](const testing::TestParamInfo<std::string>& program) { return program.param; });

// The same commands as a user: apitrace trace glxgears; twinlight compare glxgears.trace.
TEST(RealProgram, GlxgearsRecordedNowIsAsGlSaysInEveryRenderer) {
    for (const char* tool : {"apitrace", "Xvfb", "glxgears"}) {
        if (run_shell("", std::string("command -v ") + tool).status != 0) GTEST_SKIP() << tool << " is not installed";
    }
    const TemporaryFolder folder;
    std::filesystem::copy_file(std::string(kFolder) + "/record.sh", folder / "record.sh");
    write_file_atomically(folder / "README.md",
                          "| `gears` | mesa-utils | MIT | gl | 3 | 2 | `glxgears -geometry 300x300` |\n");
    const ProgramResult recorded =
        run_shell("", quoted(folder / "record.sh") + " -o " + quoted(folder / "out") + " gears");
    ASSERT_EQ(recorded.status, 0) << recorded.err;

    const ProgramResult result = run_program(
        "twinlight", {"compare", folder / "out/gears.trace", "--json", "-o", folder / "report", "--frame", "1"});
    EXPECT_EQ(result.status, 0) << result.err;
    const nlohmann::json comparison = nlohmann::json::parse(result.out);
    EXPECT_EQ(comparison["verdict"], "within");
    EXPECT_EQ(comparison["unsupported"].size(), 0u);
    EXPECT_EQ(comparison["size"], nlohmann::json({300, 300}));
    int pairs = 0;
    for (const nlohmann::json& pair : comparison["pairs"]) {
        const std::string both = pair["a"].get<std::string>() + pair["b"].get<std::string>();
        if (both.find("phong") != std::string::npos) continue;
        ++pairs;
        EXPECT_LE(pair["interior"]["max"].get<double>(), 1 / 255.0) << both;
        EXPECT_GT(pair["interior"]["pixels"].get<int>(), 60'000);
    }
    EXPECT_EQ(pairs, 3);
}

}  // namespace

}  // namespace twinlight::real_programs_test

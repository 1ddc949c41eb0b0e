// Every command with every built-in scene, step, lesson and recording: it gives a result, or says in one line why it cannot.
// `make test` tries a sample, and ALL_CASES all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "../effort.h"
#include "../run_program.h"
#include "../sanitized.h"
#include "judge/lesson/lesson.h"
#include "scene/scenes/load.h"

namespace twinlight::all_pairs_test {
namespace {

using Arguments = std::vector<std::string>;

struct Way {
    Arguments command;  // SCENE goes after it
    bool takes_size = true, writes = false;
    bool may_disagree = false;      // status 1: the renderers differ, or the scene has warnings
    bool is_slow = false;           // a second or more
    std::string_view may_refuse{};  // what the one line of a refusal has
};

// The fixed function lights no pixels.
bool is_of_vertices(std::string_view with, std::string_view shading) {
    return with == "fixed" && (shading == "phong" || shading == "exact");
}

const std::vector<Way>& ways() {
    static const std::vector<Way> all = [] {
        std::vector<Way> list = {
            {.command = {"compare"}, .writes = true, .may_disagree = true},
            {.command = {"compare", "--shading", "exact"}, .writes = true, .may_disagree = true},
            {.command = {"compare", "--precise"}, .writes = true, .may_disagree = true},
            {.command = {"explain"}},
            {.command = {"explain", "--all", "--json"}},
            {.command = {"explain", "--pixel", "20,20"}},
            {.command = {"lint"}, .may_disagree = true},
            {.command = {"study", "--quick", "--seconds", "0.1"}, .writes = true, .is_slow = true},
            {.command = {"export", "--as", "c"}, .takes_size = false},
            {.command = {"export", "--as", "scene"}, .takes_size = false},
            {.command = {"export", "--as", "glsl"}, .takes_size = false},
            {.command = {"export", "--as", "glsl", "--for-this-picture"}, .takes_size = false},
            {.command = {"export", "--as", "glsl"},
             .takes_size = false,
             .writes = true,
             .may_refuse = "shaders to keep"},
            {.command = {"export", "--as", "html"},
             .takes_size = false,
             .writes = true,
             .may_refuse = "shaders to keep"},
            {.command = {"export", "--as", "wgsl"},
             .takes_size = false,
             .writes = true,
             .may_refuse = "cannot draw this scene"},
            {.command = {"export", "--as", "vulkan"},
             .takes_size = false,
             .writes = true,
             .may_refuse = "cannot draw this scene"},
        };
        for (const char* with : {"fixed", "shaders", "reference"})
            for (const char* shading : {"flat", "gouraud", "phong", "exact"})
                list.push_back({.command = {"render", "--with", with, "--shading", shading},
                                .writes = true,
                                .may_refuse = is_of_vertices(with, shading) ? "the fixed function " : ""});
        for (const char* option : {"--baked", "--precise"})
            list.push_back({.command = {"render", "--with", "shaders", option}, .writes = true});
        for (const char* with : {"fixed", "reference"})
            list.push_back({.command = {"render", "--with", with, "--scrubbed"}, .writes = true});
        return list;
    }();
    return all;
}

// SCENE and its options.
std::vector<Arguments> scenes(const TemporaryFolder& folder) {
    std::vector<Arguments> all;
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        const std::size_t steps = read_built_in(file).steps.size();
        if (steps == 0) all.push_back({name});
        for (std::size_t step = 1; step <= steps; ++step) all.push_back({name, "--step", std::to_string(step)});
    }
    for (const EmbeddedFile& file : kLessonFiles) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        for (const bool changed : {false, true}) {
            const std::string scene = folder / (name + (changed ? "-changed.gl" : ".gl"));
            Arguments lesson = {"lesson", name, "-o", scene};
            if (changed) lesson.emplace_back("--changed");
            EXPECT_EQ(run_program("twinlight", lesson).status, 0) << name;
            all.push_back({scene});
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator("tests/traces"))
        if (entry.is_directory()) all.push_back({entry.path() / "dump.txt"});
    for (const auto& entry : std::filesystem::directory_iterator("tests/homework"))
        if (entry.path().extension() == ".c") all.push_back({entry.path()});
    std::ranges::sort(all);
    return all;
}

TEST(AllPairs, OfCommandsAndScenesGiveAResult) {
    if (kSanitized && !tries_all()) GTEST_SKIP() << "the sample is tried without sanitizers";
    const TemporaryFolder folder, out;
    const std::vector<Arguments> inputs = scenes(folder);
    // A sample: each way meets other scenes, a slow one only one of them.
    constexpr std::size_t kStride = 67, kShift = 7;
    std::size_t tried = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t w = 0; w < ways().size(); ++w) {
            const Arguments& scene = inputs[i];
            const Way& way = ways()[w];
            const bool is_in_sample = (i + kShift * w) % (way.is_slow ? inputs.size() : kStride) == 0;
            if (!is_in_sample && !tries_all()) continue;
            ++tried;
            Arguments arguments = way.command;
            arguments.insert(arguments.end(), scene.begin(), scene.end());
            if (way.takes_size) arguments.insert(arguments.end(), {"--size", "40x40"});
            const std::string result = out / "result";
            if (way.writes) arguments.insert(arguments.end(), {"-o", result});
            const ProgramResult run = run_program("twinlight", arguments);
            const std::string line = fmt::format("twinlight {}", fmt::join(arguments, " "));
            const bool is_refused = run.status == 2 && !way.may_refuse.empty();
            if (is_refused) {
                EXPECT_NE(run.err.find(way.may_refuse), std::string::npos) << line << "\n" << run.err;
            } else {
                EXPECT_TRUE(run.status == 0 || (run.status == 1 && way.may_disagree))
                    << line << "\nended with " << run.status << "\n"
                    << run.err;
                EXPECT_TRUE(std::filesystem::exists(result) || !way.writes) << line;
            }
            std::filesystem::remove_all(result);
            EXPECT_TRUE(out.names().empty()) << line << " left " << out.names().front();
        }
    EXPECT_GT(tried, 30u);
}

}  // namespace
}  // namespace twinlight::all_pairs_test

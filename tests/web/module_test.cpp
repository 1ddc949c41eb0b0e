// The page's WebAssembly, in Node: it reads scenes and draws the reference's pictures as the native code does, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "../unit/run_program.h"
#include "app/web/page_scene.h"
#include "base/image/file.h"
#include "base/text/json.h"
#include "judge/check/case.h"
#include "scene/scenes/load.h"

namespace twinlight::web::module_test {

namespace {

using Json = nlohmann::json;

constexpr const char* kPage = "build/web/page";

struct Job {
    std::string name, text, step;
    int width = 0, height = 0;
};

struct JobLook {
    const char* name;
    std::optional<Shading> shading;
    bool as_floats = false;

    reference::Options options() const {
        reference::Options options;
        options.shading = shading;
        if (as_floats) {
            options.arithmetic.number = Number::kFloat;
            options.lecture_variants = false;
        }
        return options;
    }
};
constexpr JobLook kLooks[] = {
    {"scene", {}}, {"scene", {}, true}, {"phong", Shading::kPhong}, {"exact", Shading::kExact}};

std::vector<Job> all_jobs() {
    constexpr int kWidth = 120, kHeight = 90;
    std::vector<Job> jobs;
    for (const EmbeddedFile& file : kSceneFiles) {
        const CommandList list = read_built_in(file);
        for (std::size_t step = 1; step <= std::max<std::size_t>(list.steps.size(), 1); ++step)
            jobs.push_back({list.name, std::string(file.text), std::to_string(step), kWidth, kHeight});
        if (list.steps.empty()) jobs.back().step.clear();
    }
    for (const EmbeddedFile& file : kCaseFiles)
        jobs.push_back({std::string(file.name.substr(0, file.name.rfind('.'))), std::string(file.text), "",
                        check::kSide, check::kSide});
    return jobs;
}

// The first byte that differs, in words; empty if none does.
std::string first_difference(std::string_view a, std::string_view b, int width) {
    const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (at == a.end()) return "";
    const auto byte = at - a.begin(), pixel = byte / 4;
    return "pixel " + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + ", channel " +
           std::to_string(byte % 4) + ": native " + std::to_string(static_cast<unsigned char>(*at)) + ", WebAssembly " +
           std::to_string(static_cast<unsigned char>(*other));
}

TEST(WebModule, DrawsAsTheNativeReference) {
    if (!std::filesystem::exists(std::string(kPage) + "/module.wasm"))
        GTEST_SKIP() << "the page is not built: make web (Debian's packages emscripten and node-acorn)";
    const std::vector<Job> jobs = all_jobs();
    Json list = Json::array(), looks = Json::array();
    for (const JobLook& look : kLooks) looks.push_back({{"shading", look.name}, {"asFloats", look.as_floats}});
    for (const Job& job : jobs)
        list.push_back({{"name", job.name},
                        {"text", job.text},
                        {"step", job.step},
                        {"width", job.width},
                        {"height", job.height},
                        {"looks", looks}});
    const TemporaryFolder folder;
    write_file_atomically(folder / "jobs.json", list.dump());
    // Both draw at the same time.
    std::future<ProgramResult> node = std::async(std::launch::async, [&] {
        return run_shell("", "node tests/web/pictures.mjs " + quoted(kPage) + " " + quoted(folder / "jobs.json") + " " +
                                 quoted(folder.str()));
    });
    struct Native {
        Json answer;
        int width = 0;
        std::vector<std::string> pictures{};  // as kLooks
    };
    std::vector<Native> natives;
    PageScene scene;
    for (const Job& job : jobs) {
        natives.push_back({Json::parse(scene.open(job.text, job.name, job.step, {job.width, job.height}))});
        if (!scene.is_open()) continue;
        const Frame& frame = scene.scene().frame;
        natives.back().width = frame.width;
        for (const JobLook& look : kLooks) {
            const auto pixels = scene.reference(look.options(), 0, frame.height);
            natives.back().pictures.emplace_back(pixels.begin(), pixels.end());
        }
    }
    const ProgramResult run = node.get();
    ASSERT_EQ(run.status, 0) << run.err;

    const Json answers = Json::parse(read_file(folder / "answers.json", 64u << 20));
    const std::string pictures = read_file(folder / "pictures", std::size_t{1} << 30);
    EXPECT_GT(jobs.size(), 280u);
    ASSERT_EQ(answers.size(), jobs.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        SCOPED_TRACE(jobs[i].name + " " + jobs[i].step);
        EXPECT_EQ(answers[i], natives[i].answer);
        for (std::size_t look = 0; look < natives[i].pictures.size(); ++look) {
            const std::string& native = natives[i].pictures[look];
            ASSERT_LE(next + native.size(), pictures.size());
            EXPECT_EQ(
                first_difference(native, std::string_view(pictures).substr(next, native.size()), natives[i].width), "")
                << kLooks[look].name << (kLooks[look].as_floats ? " in floats" : "");
            next += native.size();
        }
    }
    EXPECT_EQ(next, pictures.size());
}

}  // namespace

}  // namespace twinlight::web::module_test

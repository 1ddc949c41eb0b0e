// Every built-in scene, and every step of one: its renderers agree. The scenes with a folder in golden/scenes also have golden
// pictures.
//
// The golden pictures change only by `make golden CASE=NAME`; look at them before they are committed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "../unit/compare_three_ways.h"
#include "golden_picture.h"
#include "judge/compare/allowances.h"
#include "judge/compare/comparison.h"
#include "judge/lesson/lesson.h"
#include "judge/report/report.h"
#include "render/context/driver_name.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::scenes_test {

namespace {

constexpr int kWidth = 640, kHeight = 480;

bool has_golden_pictures(const std::string& name) { return std::filesystem::exists("golden/scenes/" + name); }

std::vector<std::string> golden_names() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) {
        names.emplace_back(file.name.substr(0, file.name.rfind(".gl")));
        if (!has_golden_pictures(names.back())) names.pop_back();
    }
    return names;
}

CommandList commands_of(const std::string& name, const std::string& step = {}) {
    return read_built_in(*std::ranges::find(kSceneFiles, name + ".gl", &EmbeddedFile::name), {.step = step});
}

Scene scene_of(const std::string& name, const std::string& step = {}, int width = kWidth, int height = kHeight) {
    const auto scene = std::make_shared<const CommandList>(commands_of(name, step));
    return make_scene(scene, {.width = width, .height = height});
}

compare::Comparison comparison_of(const std::string& name, Shading per_pixel = Shading::kPhong) {
    return compare_three_ways(scene_of(name), per_pixel);
}

class GoldenScenes : public testing::TestWithParam<std::string> {};

void expect_agreement(const compare::Comparison& comparison) {
    for (const compare::Pair& pair : comparison.pairs) {
        const RegionDifference& interior = pair.difference.interior;
        EXPECT_NE(pair.verdict, compare::Verdict::kBeyond)
            << fmt::format("{} ~ {}: {} of {} interior pixels differ, by {}/255 at most, at {},{}",
                           comparison.a(pair).name, comparison.b(pair).name, interior.differing, interior.pixels,
                           interior.max * 255, interior.worst_x, interior.worst_y);
    }
}

// The golden pictures are llvmpipe's of Mesa 22.3. One of another driver or release, and a golden one, are a pair of two drivers.
AllowedDifference allowed_of(const compare::Render& render, const compare::Comparison& comparison) {
    const Driver driver = parse_driver_name(comparison.driver);
    const bool is_of_golden_driver = driver.name == "llvmpipe" && driver.has_version("Mesa 22.3");
    if (render.path == Path::kReference || is_of_golden_driver) return comparison.allowed;
    const std::string reference = render.name.ends_with("-phong") ? "reference-phong" : "reference";
    return compare::allowed_of_drivers(comparison.allowed,
                                       *std::ranges::find(comparison.renders, reference, &compare::Render::name));
}

TEST_P(GoldenScenes, AgreeThreeWaysAndWithTheGoldenPictures) {
    const std::string& name = GetParam();
    const compare::Comparison comparison = comparison_of(name);
    EXPECT_TRUE(comparison.unsupported.empty());
    expect_agreement(comparison);
    for (const compare::Render& render : comparison.renders)
        expect_golden(name, "scenes/" + name, report::picture_file(render), render.image,
                      allowed_of(render, comparison));
}

// Of the reference alone: nothing is left to a driver.
TEST_P(GoldenScenes, HaveTheGoldenPictureOfTheirExactSurfaces) {
    const Image image = reference::render(scene_of(GetParam()).frame, {{.shading = Shading::kExact}});
    expect_golden(GetParam(), "scenes/" + GetParam(), "reference-exact.png", image, nothing_is_allowed(image));
}

// By shaders, to what two renderers are held to.
TEST_P(GoldenScenes, AgreeInTheirExactSurfaces) { expect_agreement(comparison_of(GetParam(), Shading::kExact)); }

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenScenes, testing::ValuesIn(golden_names()),
                         [](const testing::TestParamInfo<std::string>& scene) { return scene.param; });

// ---- Scenes without golden pictures, and all steps but the first of those with them ----

struct SceneStep {
    std::string scene;
    std::size_t step = 0;  // 0: a scene without steps
};

std::vector<SceneStep> steps_without_golden_pictures() {
    std::vector<SceneStep> steps;
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind(".gl")));
        const std::size_t count = read_built_in(file).steps.size();
        const bool has_golden = has_golden_pictures(name);
        if (count == 0 && !has_golden) steps.push_back({name});
        for (std::size_t step = has_golden ? 2 : 1; step <= count; ++step) steps.push_back({name, step});
    }
    return steps;
}

class SceneSteps : public testing::TestWithParam<SceneStep> {};

TEST_P(SceneSteps, AgreeThreeWays) {
    const auto& [name, step] = GetParam();
    const Scene scene = scene_of(name, step == 0 ? "" : std::to_string(step), 320, 240);
    const compare::Comparison comparison = compare_three_ways(scene);
    EXPECT_TRUE(comparison.unsupported.empty());
    expect_agreement(comparison);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneSteps, testing::ValuesIn(steps_without_golden_pictures()),
                         [](const testing::TestParamInfo<SceneStep>& step) {
                             std::string name = fmt::format("{}_{}", step.param.scene, step.param.step);
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

// The scene that a lesson starts from, and the one of its prediction.
TEST(LessonScenes, AgreeThreeWays) {
    for (const std::string_view name : lesson::names()) {
        const lesson::Lesson lesson = lesson::load_lesson(name, lesson::Language::kEnglish);
        for (const std::string& text : {lesson.scene, lesson.changed}) {
            SCOPED_TRACE(fmt::format("{}, {}", name, text == lesson.scene ? "start" : "changed"));
            const compare::Comparison comparison =
                compare_three_ways(make_scene(lesson::commands_of(lesson, text), {.width = 320, .height = 240}));
            EXPECT_TRUE(comparison.unsupported.empty());
            expect_agreement(comparison);
        }
    }
}

}  // namespace

}  // namespace twinlight::scenes_test

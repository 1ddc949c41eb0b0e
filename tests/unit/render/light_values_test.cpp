// A program and its Draw meet in one list: each uniform that the text declares has a value, whatever is drawn and planned, and no
// other uniform has one.
#include "render/programmable/numbers/light_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "../effort.h"
#include "judge/fuzz/random_states.h"
#include "judge/study/lighting_change.h"
#include "render/programmable/numbers/precise.h"
#include "render/programmable/numbers/program_uniforms.h"
#include "render/programmable/numbers/surface_values.h"
#include "render/programmable/text/bake.h"
#include "scene/frame/frame.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::programmable::light_values_test {
namespace {

// The plans that some command makes, with all combinations of what they leave out.
std::vector<PlanOptions> plan_options() {
    std::vector<PlanOptions> all;
    for (const bool any_pose : {false, true})
        for (const bool variants : {false, true})
            for (const bool folds : {false, true})
                for (const auto shading : {std::optional<Shading>(), std::optional(Shading::kPhong)}) {
                    PlanOptions options;
                    options.for_any_pose = any_pose;
                    options.lecture_variants = variants;
                    options.fold_spectra = folds;
                    options.shading = shading;
                    options.budget = any_pose ? 0 : options.budget;
                    all.push_back(options);
                }
    return all;
}

// The names that the lists give to a program. Samplers have no numbers.
std::set<std::string> listed_names(const Code& code) {
    const EffectSet& effects = code.effects;
    std::set<std::string> names;
    const auto add_all = [&](const UniformList& list, const std::string& suffix) {
        for_each_uniform([&](auto value) {
            if (list.contains(value)) names.insert(name_of(value, suffix));
        });
        names.erase(name_of(TextureValue::kSampler, suffix));
    };
    add_all(uniform_list(effects, code.form), "");
    for (const UnitEffects& unit : effects.units) add_all(uniform_list(unit, code.form), std::to_string(unit.number));
    for (int i = 0; i < effects.clip_plane_count; ++i) names.insert(clip_plane_name(i));
    if (!effects.lighting) return names;

    values_of_model(effects).for_each(
        [&](ModelValue value) { names.insert(std::string(declaration_of(value, effects).name)); });
    std::vector<std::string> faces = {"front"};
    if (effects.two_side) faces.emplace_back("back");
    for (const std::string& face : faces) {
        const FaceEffects& varying = face == "back" ? effects.back : effects.front;
        values_of_face(effects, varying).for_each([&](FaceValue value) {
            names.insert(name_of(face, value, effects));
        });
        sampled_colors(effects).for_each([&](LightValue color) { names.insert(name_of_face_samples(face, color)); });
    }
    for (std::size_t i = 0; i < effects.lights.size(); ++i) {
        sampled_colors(effects).for_each([&](LightValue color) { names.insert(name_of_light_samples(i, color)); });
        if (loop_length(effects, code.form, i) > 0) names.insert(name_of_count(i));
        values_of_light(effects, code.form, i).for_each([&](LightValue value) {
            const LightUniform uniform = declaration_of(value, effects, code.form, i);
            if (!is_color(value)) names.insert(name_of(i, uniform));
            for (const std::string& face : faces)
                if (is_color(value) && effects.spectral_groups == 0) names.insert(name_of(i, uniform, face));
        });
    }
    return names;
}

class Checker {
  public:
    // The uniforms that the program's text declares and that have no value are added to `missing`, values that are not listed to
    // `unlisted`.
    void check(const Code& code, const Uniforms& numbers, const std::string& where) {
        const auto [declared, is_new] = declared_.try_emplace({code.effects, code.form});
        if (is_new) declared->second = uniform_names(assemble(code.effects, code.form));
        for (const std::string& name_and_length : declared->second) {
            const std::string name = name_and_length.substr(0, name_and_length.find('['));  // of an array
            if (!is_sampler(name) && !numbers.contains(name)) missing_.insert(name + " of " + where);
        }
        const std::set<std::string> listed = listed_names(code);
        for (const std::string& name : listed)
            if (!numbers.contains(name)) missing_.insert(name + " of the list of " + where);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!listed.contains(std::string(numbers[i].name)))
                unlisted_.insert(fmt::format("{} of {}", numbers[i].name, where));
        met_names_.insert(listed.begin(), listed.end());
        for (std::size_t i = 0; i < code.effects.lights.size(); ++i)
            values_of_light(code.effects, code.form, i).for_each([&](LightValue value) { ++met_[value]; });
    }

    void check(const Draw& draw, bool begins_shape, const std::string& where) {
        for (const PlanOptions& options : plan_options()) {
            const Plan plan = plan_effects(draw, options);
            const DrawProgram program = draw_program(draw, plan, false);
            check(program.code, program.numbers, where);
            if (!draw.has_exact_surfaces() || !begins_shape) continue;
            PlanOptions exact = options;
            exact.shading = Shading::kExact;
            for (const SurfaceProgram& surface : surface_programs(draw, exact))
                for (const Uniforms& numbers_of_pass : surface.passes)
                    check(surface.code, numbers_of_pass, where + ", exact");
        }
        const Options precise = precise_options({});
        const DrawProgram program = draw_program(draw, plan_effects(draw, precise), true);
        check(program.code, program.numbers, where + ", precise");
    }

    void check(const Frame& frame, const std::string& where) {
        const Draw* before = nullptr;
        for (const auto& item : frame.items) {
            const Draw* draw = std::get_if<Draw>(&item);
            if (draw) check(*draw, !before || !are_one_shape(*before, *draw), where);
            before = draw;
        }
    }

    const std::set<std::string>& missing() const { return missing_; }
    const std::set<std::string>& unlisted() const { return unlisted_; }
    const std::map<LightValue, int>& met() const { return met_; }
    const std::set<std::string>& met_names() const { return met_names_; }
    std::size_t programs() const { return declared_.size(); }

  private:
    static bool is_sampler(const std::string& name) {
        std::string_view base = name;
        while (!base.empty() && base.back() >= '0' && base.back() <= '9') base.remove_suffix(1);
        return base == "u_texture" || base == "u_framebuffer";
    }
    std::map<std::pair<EffectSet, Form>, std::set<std::string, std::less<>>> declared_;
    std::set<std::string> missing_, unlisted_, met_names_;
    std::map<LightValue, int> met_;
};

// Samplers have no numbers, and planes in eye coordinates are only in shaders to keep.
template <class Value>
bool has_numbers(Value value) {
    if constexpr (std::is_same_v<Value, TextureValue>)
        return value != TextureValue::kSampler && !name_of(value).ends_with("_eye");
    else
        return true;
}

// Some program needs each value of the enum.
template <class Value>
void expect_all_are_met(const Checker& checker) {
    for_each_uniform([&](auto value) {
        if constexpr (std::is_same_v<decltype(value), Value>) {
            const std::string name = name_of(value);
            const bool is_met = checker.met_names().contains(name) || checker.met_names().contains(name + "0");
            EXPECT_TRUE(is_met || !has_numbers(value)) << "no program here needs " << name;
        }
    });
}

constexpr StateOptions kSmall = {.width = 64, .height = 64};

std::string listed(const std::set<std::string>& names) { return fmt::format("{}", fmt::join(names, "\n")); }

TEST(LightValues, AreGivenToEveryProgramOfScenesAndRecordings) {
    Checker checker;
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::size_t steps = std::max<std::size_t>(1, read_built_in(file).steps.size());
        for (std::size_t step = 1; step <= steps; ++step) {
            const Frame frame =
                make_frame(read_built_in(file, {.step = steps > 1 ? std::to_string(step) : ""}), kSmall);
            for (const study::LightingChangeRow& change : study::lighting_changes())
                if (study::matters(frame, change.value))
                    checker.check(study::with_lighting_change(frame, change.value),
                                  fmt::format("{}, step {}, {}", file.name, step, change.words));
        }
    }
    FrameChoice small;
    small.width = small.height = 64;
    int recordings = 0;
    for (const auto& folder : std::filesystem::directory_iterator("tests/traces")) {
        if (!folder.is_directory() || !is_tried(recordings++)) continue;
        const RecordedFrame recorded = make_recorded_frame(load_recording(folder.path() / "dump.txt"), small);
        checker.check(recorded.scene.frame, folder.path().filename());
    }
    EXPECT_TRUE(checker.missing().empty()) << listed(checker.missing());
    EXPECT_TRUE(checker.unlisted().empty()) << listed(checker.unlisted());
    EXPECT_GT(checker.programs(), 500u);
    expect_all_are_met<SurfaceValue>(checker);
}

TEST(LightValues, AreGivenToEveryProgramOfRandomStates) {
    Checker checker;
    const int count = rounds(400);
    for (int i = 0; i < count; ++i) {
        const fuzz::Seed seed{.structure = static_cast<std::uint64_t>(i), .values = 1};
        for (const auto& [name, make] : {std::pair("lighting", &fuzz::lighting_state),
                                         {"extreme", &fuzz::extreme_state},
                                         {"fragment", &fuzz::fragment_state}})
            checker.check(make_frame(make(seed), kSmall), fmt::format("{} state {}", name, i));
    }
    EXPECT_TRUE(checker.missing().empty()) << listed(checker.missing());
    EXPECT_TRUE(checker.unlisted().empty()) << listed(checker.unlisted());
    for (std::size_t i = 0; i < kLightValueCount; ++i) {
        const auto value = static_cast<LightValue>(i);
        if (value == LightValue::kCosOuter || value == LightValue::kConeSlope) continue;  // only pragmas make these
        EXPECT_TRUE(checker.met().contains(value)) << "no random state needs light value " << i;
    }
    expect_all_are_met<DrawValue>(checker);
    expect_all_are_met<TextureValue>(checker);
}

}  // namespace
}  // namespace twinlight::programmable::light_values_test

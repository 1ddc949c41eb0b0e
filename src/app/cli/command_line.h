// Shared by the subcommands: their declarations, common options, loading a scene.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/memory.h"
#include "app/program.h"
#include "base/image/image.h"
#include "render/look.h"
#include "scene/command/command.h"
#include "scene/frame/scene.h"
#include "scene/state/state.h"

namespace twinlight::cli {

struct Subcommand {
    CLI::App* app;
    std::function<int()> run;  // returns the exit status
};

// The program: carries out a command line and returns the exit status.
int run(int argc, char** argv);

// Each has a file of its own.
Subcommand add_render(CLI::App& app);
Subcommand add_compare(CLI::App& app);
Subcommand add_explain(CLI::App& app);
Subcommand add_export(CLI::App& app);
Subcommand add_record(CLI::App& app);
Subcommand add_scenes(CLI::App& app);
Subcommand add_study(CLI::App& app);
Subcommand add_fuzz(CLI::App& app);
Subcommand add_check(CLI::App& app);
Subcommand add_lint(CLI::App& app);
Subcommand add_lesson(CLI::App& app);

// Accepts the keys of a map.
template <class Map>
CLI::Validator one_of(const Map& map) {
    std::string names;
    for (const auto& [name, value] : map) names += (names.empty() ? "" : ", ") + name;
    const auto check = [&map, names](const std::string& text) {
        return map.contains(text) ? "" : "'" + text + "' is not one of " + names;
    };
    return CLI::Validator(check, "");
}

CLI::Option* add_scene_argument(CLI::App& app, std::string& scene);
void add_shading_option(CLI::App& app, std::optional<Shading>& shading);
void add_variants_option(CLI::App& app, bool& variants);

// For PlanOptions::budget.
void add_budget_option(CLI::App& app, double& budget);

// For programmable::Options::precise.
void add_precise_flag(CLI::App& app, bool& precise);

// Which picture of a recorded program.
struct RecordedPart {
    std::optional<int> frame{}, context{};  // counted from 0
    // Whether the caller itself chooses the frame of a program that is read; otherwise it is refused.
    bool chooses_of_program = false;
    bool is_of_several = false;  // the first frame of --frames, which may draw nothing
};
// --frame and --context.
void add_recorded_options(CLI::App& app, RecordedPart& part);

// --calls: the chain of calls to each place of a recorded program.
void add_calls_flag(CLI::App& app, bool& calls);

// --gl: which GL draws (choose_gl()). Commands that draw have it.
void add_gl_option(CLI::App& app);
// Says on standard error which GL draws, and the file that it was loaded from. Does so once, and only for commands that have --gl. To be
// called before the first line of standard error and before drawing. Returns driver_name(), which is empty without --gl. Throws
// std::runtime_error if there is no GL.
const std::string& name_gl();

// For MemoryBudget::bytes.
void add_memory_option(CLI::App& app, MemoryBudget& memory);

// The step of a scene with steps; see ReadOptions::step.
void add_step_option(CLI::App& app, std::string& step, const std::string& default_step = "the first");

// Loads a scene, or a frame of a recorded program. Throws UsageError or SceneError if drawing it needs more memory than
// is allowed. Notes about a recording (cut short, GL errors) go to standard error.
Scene load_scene(const std::string& name, std::optional<Size> size, const RecordedPart& part = {},
                 const std::string& step = {}, const MemoryBudget& memory = {});

// All steps of a scene with steps, without `step`; otherwise what load_scene() loads.
std::vector<Scene> load_steps(const std::string& name, std::optional<Size> size, const RecordedPart& part,
                              const std::string& step, const MemoryBudget& memory = {});

// The default of -o: "lab-report" for the scene lab or dir/lab.gl with the suffix "-report", in the working folder.
std::string name_after_scene(const std::string& scene, std::string_view suffix);

// Whether standard output may be coloured: it is a terminal, and NO_COLOR (no-color.org) is not set.
bool result_in_color();

}  // namespace twinlight::cli

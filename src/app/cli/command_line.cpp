#include "app/cli/command_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>

#include "app/cli/progress.h"
#include "base/image/file.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/recorded_frame.h"
#include "scene/state/state.h"

namespace twinlight::cli {

namespace {

const std::map<std::string, Shading> kAllShadings = [] {
    std::map<std::string, Shading> named;
    for (const ShadingName& name : kShadings) named.emplace(name.key, name.value);
    return named;
}();

}  // namespace

CLI::Option* add_scene_argument(CLI::App& app, std::string& scene) {
    return app
        .add_option("SCENE", scene,
                    "a built-in scene, a .gl file, an apitrace .trace file or its text dump, or - for standard input")
        ->required()
        ->type_name("")
        ->check(not_empty());
}

void add_shading_option(CLI::App& app, std::optional<Shading>& shading) {
    app.add_option_function<std::string>(
           "--shading", [&shading](const std::string& name) { shading = kAllShadings.at(name); },
           "shading model (default: the scene's glShadeModel); exact draws curved shapes from their equations, by "
           "casting rays")
        ->type_name("flat|gouraud|phong|exact")
        ->check(one_of(kAllShadings));
}

void add_precise_flag(CLI::App& app, bool& precise) {
    app.add_flag(
        "--precise", precise,
        "applies only to shaders: compute vertex lighting in the same order as Mesa's fixed function and skip no "
        "light; on llvmpipe the colours are then equal bit for bit, except where its fixed function has a known bug");
}

void add_budget_option(CLI::App& app, double& budget) {
    app.add_option("--budget", budget,
                   "how much the shaders may change a colour channel (0 to 1) by skipping faint lights; 0: not at all")
        ->type_name("B")
        ->check(number_from(0.0, 1.0))
        ->default_str("0.5/255");
}

void add_frame_option(CLI::App& app, std::optional<int>& frame) {
    app.add_option_function<int>(
           "--frame", [&frame](int number) { frame = number; },
           "frame of a recorded program, counted from 0 (default: the first that draws something)")
        ->type_name("N")
        ->check(number_from(0, std::numeric_limits<int>::max()));
}

void add_step_option(CLI::App& app, std::string& step, const std::string& default_step) {
    app.add_option("--step", step,
                   "step of a scene with steps: its number, from 1, or its title (default: " + default_step + ")")
        ->type_name("N")
        ->check(not_empty());
}

namespace {

// Reading up to a late frame may take long, so this shows its progress.
Scene load_recorded_frame(const std::shared_ptr<const Recording>& recording, std::optional<Size> size,
                          std::optional<int> number) {
    FrameChoice choice{.number = number};
    if (size) {
        choice.width = size->width;
        choice.height = size->height;
    }
    ProgressBar bar;
    choice.progress = [&](int frames, std::size_t commands) {
        bar.show(fmt::format("reading {}: {} frames, {:.1f} million commands", recording->name, frames,
                             static_cast<double>(commands) / 1e6));
    };
    RecordedFrame recorded = make_recorded_frame(recording, choice);
    bar.wipe();
    for (const std::string& note : recorded.notes) {
        fmt::print(stderr, "twinlight: note: {}: {}\n", recording->name, one_line(note));
    }
    if (recorded.first_error) {
        const GlError& first = *recorded.first_error;
        fmt::print(
            stderr,
            "twinlight: note: up to this frame, {} of the program's commands {} a GL error; the first: {}: {} ({})\n",
            recorded.error_count, recorded.error_count == 1 ? "causes" : "cause", first.place.str(),
            one_line(first.message), enum_name(first.code));
    }
    return std::move(recorded.scene);
}

Scene scene_of(std::shared_ptr<const Recording> commands, std::optional<Size> size) {
    const auto [width, height] = size.value_or(Size{});
    Frame made = make_frame(*commands->command_list(), {.width = width, .height = height});
    return {std::move(commands), std::move(made)};
}

}  // namespace

Scene load_scene(const std::string& name, std::optional<Size> size, std::optional<int> frame, const std::string& step) {
    std::shared_ptr<const Recording> recording;
    try {
        recording =
            load_recording(name, size ? std::optional(WindowSize{size->width, size->height}) : std::nullopt, step);
    } catch (const SceneError& error) {
        throw with_gl_errors(error, {});
    }
    const CommandList* commands = recording->command_list();
    if (!commands) return load_recorded_frame(recording, size, frame);
    if (frame) {
        throw UsageError(fmt::format("--frame applies only to recorded programs; '{}' is a scene", name));
    }
    if (!size && commands->window) size = Size{commands->window->width, commands->window->height};
    return scene_of(std::move(recording), size);
}

std::vector<Scene> load_steps(const std::string& name, std::optional<Size> size, std::optional<int> frame,
                              const std::string& step) {
    std::vector<Scene> scenes;
    scenes.push_back(load_scene(name, size, frame, step));
    const CommandList* first = scenes.front().recording->command_list();
    if (!first || !step.empty()) return scenes;
    for (std::size_t i = 2; i <= first->steps.size(); ++i)
        scenes.push_back(scene_of(load_step(name, *first, std::to_string(i)), size));
    return scenes;
}

std::string name_after_scene(const std::string& scene, std::string_view suffix) {
    std::string stem = scene == "-" ? "stdin" : std::filesystem::path(scene).stem().string();
    if (stem.empty()) stem = "scene";
    return stem + std::string(suffix);
}

bool result_in_color() {
    const char* no_color = std::getenv("NO_COLOR");
    return ::isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

}  // namespace twinlight::cli

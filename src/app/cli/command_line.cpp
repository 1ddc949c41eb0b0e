#include "app/cli/command_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/cli/progress.h"
#include "base/image/contrast.h"
#include "base/image/file.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/frame/picture_memory.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
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

void add_variants_option(CLI::App& app, bool& variants) {
    app.add_flag(
        "--variants", variants,
        "follow the variants of the lecture that the scene's pragmas choose (reflection, smooth cones, samples of "
        "light), which OpenGL lacks; phong and exact shading always do");
}

void add_precise_flag(CLI::App& app, bool& precise) {
    app.add_flag(
        "--precise", precise,
        "applies only to shaders: compute vertex lighting in the same order as the fixed function of Mesa 22.3 and "
        "skip "
        "no light; on llvmpipe of that release the colours are then equal bit for bit, except where its fixed function "
        "has a known bug; on later releases the last digit of a few colours differs");
}

void add_budget_option(CLI::App& app, double& budget) {
    app.add_option("--budget", budget,
                   "how much the shaders may change a colour channel (0 to 1) by skipping faint lights; 0: not at all")
        ->type_name("B")
        ->check(number_from(0.0, 1.0))
        ->default_str("0.5/255");
}

void add_recorded_options(CLI::App& app, RecordedPart& part) {
    app.add_option_function<int>(
           "--frame", [&part](int number) { part.frame = number; },
           "frame of a recorded program, counted from 0 (default: the first that draws something)")
        ->type_name("N")
        ->check(number_from(0, std::numeric_limits<int>::max()));
    app.add_option_function<int>(
           "--context", [&part](int number) { part.context = number; },
           "GL context of a recorded program with several, counted from 0 (default: the one that draws most)")
        ->type_name("N")
        ->check(number_from(0, std::numeric_limits<int>::max()));
}

void add_calls_flag(CLI::App& app, bool& calls) {
    app.add_flag("--calls", calls,
                 "also show the functions of a recorded program that led to each place: main > display > draw_lamp");
}

void add_step_option(CLI::App& app, std::string& step, const std::string& default_step) {
    app.add_option("--step", step,
                   "step of a scene with steps: its number, from 1, or its title (default: " + default_step + ")")
        ->type_name("N")
        ->check(not_empty());
}

namespace {

bool& is_to_name_gl() {
    static bool is_to = false;
    return is_to;
}

}  // namespace

void add_gl_option(CLI::App& app) {
    app.add_option_function<std::string>(
           "--gl", [](const std::string& name) { choose_gl(name); },
           "which OpenGL draws: OSMesa, EGL's first driver, or that of a file: a libOSMesa, libEGL or libGL (default: "
           "the environment variable TWINLIGHT_GL, or else OSMesa, or EGL's software driver)")
        ->type_name("osmesa|egl|FILE")
        ->check(not_empty());
    app.parse_complete_callback([] { is_to_name_gl() = true; });
}

const std::string& name_gl() {
    static std::string driver;
    if (!is_to_name_gl()) return driver;
    is_to_name_gl() = false;
    const std::unique_ptr<OffscreenContext> context = make_offscreen_context(1, 1);
    driver = driver_name();
    print_message("twinlight: OpenGL is {} ({})\n", one_line(driver), one_line(gl_library()));
    return driver;
}

void add_memory_option(CLI::App& app, MemoryBudget& memory) {
    app.add_option_function<double>(
           "--memory", [&memory](double gigabytes) { memory.bytes = static_cast<std::size_t>(gigabytes * 1e9); },
           "how much memory a picture may need, in GB")
        ->type_name("G")
        ->check(number_from(0.001, 1000.0))
        ->default_str("2");
}

namespace {

void check_fits(const MemoryBudget& memory, const Frame& frame) {
    check_fits(memory, frame.width, frame.height, bytes_of_pictures(frame, memory.bytes_of_pixel),
               bytes_of_scene(frame));
}

constexpr std::uint64_t kMostLookedAt = std::uint64_t{1} << 22;  // pixels

// color_contrast() of the driver's picture; nullopt if it is too large to draw it only for this, or if there is no driver.
std::optional<float> contrast(const Scene& scene, const MemoryBudget& memory) {
    constexpr std::size_t kBytesOfPixel = 40;
    const Frame& frame = scene.frame;
    if (pixels_of(frame.width, frame.height) > kMostLookedAt ||
        bytes_of_pictures(frame, kBytesOfPixel) + bytes_of_scene(frame) > memory.bytes)
        return std::nullopt;
    Image image;
    try {
        name_gl();
        const std::unique_ptr<OffscreenContext> context = make_offscreen_context(frame.width, frame.height);
        image = fixed::render(scene);
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
    return color_contrast(image);
}

void print_note(const Recording& recording, std::string_view note) {
    print_message("twinlight: note: {}: {}\n", recording.name, one_line(note));
}

// Reading up to a late frame may take long, so this shows its progress.
Scene load_recorded_frame(const std::shared_ptr<const Recording>& recording, std::optional<Size> size,
                          const RecordedPart& part, const MemoryBudget& memory) {
    FrameChoice choice{.number = part.frame, .may_be_empty = part.is_of_several, .memory = memory.bytes};
    if (size) {
        choice.width = size->width;
        choice.height = size->height;
    }
    const auto print = [&](const std::string& note) {
        name_gl();
        print_note(*recording, note);
    };
    std::vector<std::string> notes = recording->notes();
    std::ranges::for_each(notes, print);
    ProgressBar bar;
    choice.progress = [&](int frames, std::size_t commands) {
        bar.show(fmt::format("reading {}: {} frames, {:.1f} million commands", recording->name, frames,
                             static_cast<double>(commands) / 1e6));
    };
    RecordedFrame recorded =
        frame_to_see(recording, choice, [&](const Scene& scene) { return contrast(scene, memory); });
    bar.wipe();
    check_fits(memory, recorded.scene.frame);
    std::ranges::for_each(recorded.notes, print);
    std::ranges::move(recorded.notes, std::back_inserter(notes));
    if (recorded.first_error) {
        notes.push_back(note_of_errors(recorded));
        name_gl();
        print_message("twinlight: note: {}\n", notes.back());
    }
    recorded.scene.notes = std::move(notes);
    return std::move(recorded.scene);
}

Scene scene_of(std::shared_ptr<const Recording> commands, std::optional<Size> size, const MemoryBudget& memory) {
    const WindowSize of_scene = commands->command_list()->window.value_or(WindowSize{});
    const auto [width, height] = size.value_or(Size{of_scene.width, of_scene.height});
    Scene made =
        make_scene({commands, commands->command_list()}, {.width = width, .height = height, .memory = memory.bytes});
    check_fits(memory, made.frame);
    made.notes = made.recording->notes();
    for (const std::string& note : made.notes) print_note(*commands, note);
    return made;
}

}  // namespace

Scene load_scene(const std::string& name, std::optional<Size> size, const RecordedPart& part, const std::string& step,
                 const MemoryBudget& memory) {
    std::shared_ptr<const Recording> recording;
    try {
        recording = load_recording(
            name, size ? std::optional(WindowSize{size->width, size->height}) : std::nullopt, step, part.context,
            [&](Enum mode, std::size_t vertices) { return bytes_of_vertices({}, mode, vertices) <= memory.bytes; });
    } catch (const SceneError& error) {
        throw with_gl_errors(error, {});
    }
    const CommandList* commands = recording->command_list();
    if (!commands) return load_recorded_frame(recording, size, part, memory);
    const bool is_refused = part.frame && !(part.chooses_of_program && commands->is_program);
    if (is_refused || part.context) {
        throw UsageError(fmt::format("{} applies only to recorded programs; '{}' is a scene",
                                     part.is_of_several ? "--frames"
                                     : part.frame       ? "--frame"
                                                        : "--context",
                                     name));
    }
    return scene_of(std::move(recording), size, memory);
}

std::vector<Scene> load_steps(const std::string& name, std::optional<Size> size, const RecordedPart& part,
                              const std::string& step, const MemoryBudget& memory) {
    std::vector<Scene> scenes;
    scenes.push_back(load_scene(name, size, part, step, memory));
    const CommandList* first = scenes.front().recording->command_list();
    if (!first || !step.empty() || first->steps.size() < 2) return scenes;
    MemoryBudget of_all = memory;
    of_all.bytes_of_pixel += (first->steps.size() - 1) * memory.bytes_of_step_pixel;
    check_fits(of_all, scenes.front().frame);
    for (std::size_t i = 2; i <= first->steps.size(); ++i)
        scenes.push_back(scene_of(load_step(name, *first, std::to_string(i)), size, of_all));
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

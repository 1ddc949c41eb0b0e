// twinlight record: runs a program and records what it draws, as a scene for the other commands.
#include "scene/trace/record.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "app/cli/command_line.h"
#include "app/cli/interrupt.h"
#include "scene/command/text.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::cli {

namespace {

struct RecordArguments {
    std::vector<std::string> command;
    std::string output;
    double seconds = trace::RecordOptions{}.seconds;
    int frames = trace::RecordOptions{}.frames;
    std::optional<trace::WindowSystem> window_system;
};

const std::map<std::string, trace::WindowSystem> kWindowSystems = {
    {"glx", trace::WindowSystem::kGlx},
    {"egl", trace::WindowSystem::kEgl},
};

std::string advice(const std::string& file, const trace::BusiestFrame& frame) {
    if (!frame.has_swaps) return fmt::format("It never swaps buffers. Its picture: twinlight compare {}\n", file);
    if (frame.frames == 1) return fmt::format("It has one frame. To see it: twinlight compare {}\n", file);
    return fmt::format(
        "It has {} frames, 0 to {}. Frame {} is worth a look:\n"
        "  twinlight compare {} --frame {}\n",
        frame.frames, frame.frames - 1, frame.number, file, frame.number);
}

struct RecordingMade {
    trace::Recorded recorded;
    std::optional<trace::BusiestFrame> frame;
};

RecordingMade record_once(const RecordArguments& arguments, std::optional<trace::WindowSystem> window_system) {
    RecordingMade made{.recorded = trace::record({.command = arguments.command,
                                                  .trace = arguments.output,
                                                  .seconds = arguments.seconds,
                                                  .frames = arguments.frames,
                                                  .window_system = window_system,
                                                  .stop_early = [] { return Interrupt::came(); }}),
                       .frame = std::nullopt};
    write_message(made.recorded.output);
    made.frame = trace::busiest_frame(arguments.output);
    return made;
}

// The frame that draws the most; if that one cannot be drawn, the first that can. Throws SceneError if no frame can.
trace::BusiestFrame frame_that_draws(const std::string& file, const std::optional<trace::BusiestFrame>& busiest) {
    const std::shared_ptr<const Recording> recording = load_recording(file);
    trace::BusiestFrame frame = busiest.value_or(trace::BusiestFrame{});
    try {
        if (busiest) make_recorded_frame(recording, {.number = frame.number});
        if (busiest) return frame;
    } catch (const SceneError&) {  // for example, shaders draw it
    }
    try {
        frame.number = make_recorded_frame(recording, {}).number;
    } catch (const SceneError& error) {
        throw SceneError(fmt::format("recorded, but {}; try a larger --seconds or --frames", one_line(error.what())));
    }
    return frame;
}

int run_record(RecordArguments arguments) {
    const std::string given = arguments.command.front();
    if (arguments.output.empty()) arguments.output = name_after_scene(given, ".trace");
    if (std::filesystem::path(arguments.output).extension() != ".trace")
        throw UsageError(fmt::format("-o {}: the name of a recording must end in .trace", arguments.output));
    std::optional<trace::TemporaryFolder> folder;
    if (trace::is_source(given)) {
        folder.emplace();
        const std::string program = folder->path() + "/" + std::filesystem::path(given).stem().string();
        trace::compile_source(given, program);
        arguments.command.front() = program;
    } else {
        arguments.command.front() = trace::find_program(given);
    }
    print_message("twinlight: note: runs {} for {:g} s, with your rights and without a sandbox; Ctrl-C stops it\n",
                  one_line(given), arguments.seconds);
    const Interrupt interrupt;
    RecordingMade made = record_once(arguments, arguments.window_system);
    // Some programs name both window systems.
    const bool again = !arguments.window_system && !(made.frame && made.frame->has_swaps) && !Interrupt::came() &&
                       made.recorded.window_system == trace::WindowSystem::kGlx &&
                       trace::names_egl(arguments.command.front());
    if (again) {
        print_message("twinlight: note: GLX shows no frames; runs {} again with --api egl\n", one_line(given));
        made = record_once(arguments, trace::WindowSystem::kEgl);
    }
    const trace::Recorded& recorded = made.recorded;
    const trace::BusiestFrame frame = frame_that_draws(arguments.output, made.frame);
    if (!recorded.not_trimmed.empty())
        print_message("twinlight: note: {}; keeps the whole recording, whose end may be damaged\n",
                      one_line(recorded.not_trimmed));
    const std::string file = one_line(arguments.output);
    for (const std::string& note : frame.notes) print_message("twinlight: note: {}: {}\n", file, one_line(note));
    write_result(fmt::format("Recording: {}{}{}\n{}", file,
                             recorded.has_own_display ? ", in a display of its own (Xvfb)" : "",
                             recorded.ended_itself ? ", until the program ended" : "", advice(file, frame)));
    return kFine;
}

}  // namespace

Subcommand add_record(CLI::App& app) {
    const auto arguments = std::make_shared<RecordArguments>();
    CLI::App* record = app.add_subcommand("record", "Run a program and record what it draws, as a .trace file");
    record
        ->add_option(
            "PROGRAM", arguments->command,
            "a program and its arguments, or a C or C++ file, which is compiled first (freeglut, GLU); write -- "
            "before it if its arguments start with -")
        ->required()
        ->type_name("[ARGUMENTS...]")
        ->check(not_empty());
    record->add_option("-o", arguments->output, "the .trace file (default: the program's name and .trace)")
        ->type_name("FILE")
        ->check(not_empty());
    record->add_option("--seconds", arguments->seconds, "end the program after this time")
        ->type_name("S")
        ->check(number_from(0.1, 3600.0))
        ->default_str(fmt::format("{:g}", arguments->seconds));
    record->add_option("--frames", arguments->frames, "keep only so many frames, from the first on")
        ->type_name("N")
        ->check(number_from(1, 1'000'000))
        ->default_str(std::to_string(arguments->frames));
    record
        ->add_option_function<std::string>(
            "--api", [arguments](const std::string& name) { arguments->window_system = kWindowSystems.at(name); },
            "how the program opens its window (default: by its libraries)")
        ->type_name("glx|egl")
        ->check(one_of(kWindowSystems));
    record->footer(
        "This runs the program with all your rights; it is not a sandbox. Do not run programs that you do not trust.\n"
        "Needs apitrace, and Xvfb where DISPLAY is not set. The program's output goes to standard error.\n"
        "Exit status: 0 success, 2 bad input or usage.");
    return {record, [arguments] { return run_record(*arguments); }};
}

}  // namespace twinlight::cli

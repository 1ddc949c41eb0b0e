#include "app/cli/run_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/cli/interrupt.h"
#include "base/text/translation.h"
#include "scene/command/text.h"
#include "scene/record/compile.h"
#include "scene/record/keys.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/scenes/load.h"
#include "scene/trace/process.h"

namespace twinlight::cli {

namespace {

// If a program draws nothing, it runs again for so long, unless --seconds is given.
constexpr double kLonger[] = {8, 20};

const std::map<std::string, trace::WindowSystem> kWindowSystems = {
    {"glx", trace::WindowSystem::kGlx},
    {"egl", trace::WindowSystem::kEgl},
};

trace::Recorded record_once(const RunArguments& run, const std::vector<std::string>& command, const std::string& file,
                            double seconds, std::optional<trace::WindowSystem> window_system) {
    trace::Recorded recorded = trace::record({.command = command,
                                              .trace = file,
                                              .seconds = seconds,
                                              .frames = run.frames,
                                              .keys = trace::keys_of(run.keys),
                                              .window_system = window_system,
                                              .stop_early = [] { return Interrupt::came(); }});
    write_message(recorded.output);
    return recorded;
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
        throw SceneError(tr("recorded, but {}; try a larger --seconds or --frames, or --keys", one_line(error.what())));
    }
    return frame;
}

// The words of the command that are compiled: the sources before its arguments.
std::vector<std::string> sources_of(const std::vector<std::string>& command) {
    const auto end = std::ranges::find_if_not(command, trace::is_source);
    return {command.begin(), end};
}

void add_options(std::vector<std::string>& to, const char* name, const std::vector<std::string>& values) {
    for (const std::string& value : values) to.push_back(name + value);
}

// The program and its arguments, with the sources compiled into the folder.
std::vector<std::string> program_of(const RunArguments& run, const std::string& folder) {
    std::vector<std::string> command = run.command;
    const std::vector<std::string> sources = sources_of(command);
    const std::string given = one_line(command.front());
    std::error_code ignored;
    for (const std::string& file : trace::is_python(command.front()) ? std::vector{command.front()} : sources)
        if (!std::filesystem::is_regular_file(file, ignored)) throw SceneError(tr("{}: there is no such file", file));
    if (trace::is_python(command.front())) command.insert(command.begin(), "python3");
    if (sources.empty()) command.front() = trace::find_program(command.front());
    // Before all else: people may not expect that this runs.
    print_message("twinlight: note: {} {} for {:g} s, with your rights and without a sandbox; Ctrl-C stops it\n",
                  sources.empty() ? "runs" : "compiles and runs", given,
                  run.seconds.value_or(trace::RecordOptions{}.seconds));
    if (sources.empty()) return command;
    const std::string program = folder + "/" + std::filesystem::path(sources.front()).stem().string();
    trace::Build build{.sources = sources};
    add_options(build.options, "-I", run.headers);
    add_options(build.options, "-D", run.macros);
    add_options(build.options, "-L", run.library_folders);
    add_options(build.options, "-l", run.libraries);
    const trace::Compiled compiled = trace::compile(build, program);
    if (!compiled.failure.empty()) {
        write_message(compiled.messages);
        throw SceneError(compiled.failure);
    }
    if (!compiled.others.empty())
        print_message("twinlight: note: compiled with the other files of its folder: {}\n",
                      one_line(fmt::format("{}", fmt::join(compiled.others, ", "))));
    command.erase(command.begin(), command.begin() + static_cast<std::ptrdiff_t>(sources.size()));
    command.insert(command.begin(), program);
    return command;
}

[[noreturn]] void fail_without_calls(const std::string& given, const trace::Recorded& recorded) {
    const std::string words = trace::last_line(recorded.output);
    std::string text = tr("{}: made no GL call that apitrace could record", given);
    if (!recorded.ended.empty()) text += tr("; it {}", recorded.ended);
    if (!words.empty()) text += tr("; its last message: {}", one_line(words));
    const std::string python = trace::in_path("python3");
    if (words.find("No module named 'OpenGL'") != words.npos)
        text += tr("; {} needs PyOpenGL: apt-get install python3-opengl, or pip install PyOpenGL", python);
    const char* const other = recorded.window_system == trace::WindowSystem::kEgl ? "glx" : "egl";
    if (!recorded.has_failed) text += tr("; --api {} records the other window system", other);
    throw SceneError(text);
}

}  // namespace

RecordingMade record_program(const RunArguments& run, const std::string& file) {
    const std::string given = one_line(run.command.front());
    const double seconds = run.seconds.value_or(trace::RecordOptions{}.seconds);
    const trace::TemporaryFolder folder;
    const std::vector<std::string> command = program_of(run, folder.path());
    const Interrupt interrupt;
    RecordingMade made;
    trace::Recorded& recorded = made.recorded;
    std::optional<trace::BusiestFrame> busiest;
    const auto record_for = [&](double limit, std::optional<trace::WindowSystem> window_system) {
        recorded = record_once(run, command, file, limit, window_system);
        busiest = recorded.has_calls ? trace::busiest_frame(file) : std::nullopt;
    };
    record_for(seconds, run.window_system);
    // Some programs name both window systems.
    if (!run.window_system && !(busiest && busiest->has_swaps) && !Interrupt::came() && !recorded.has_failed &&
        recorded.window_system == trace::WindowSystem::kGlx && trace::names_egl(command.front())) {
        print_message("twinlight: note: GLX shows no frames; runs {} again with --api egl\n", given);
        record_for(seconds, trace::WindowSystem::kEgl);
    }
    // What was recorded can be seen only when a megabyte is full, or the program has ended.
    for (double longer : kLonger) {
        if (run.seconds || recorded.has_drawn || !recorded.ended.empty() || Interrupt::came()) break;
        print_message("twinlight: note: {} drew nothing; runs it again, for {:g} s\n", given, longer);
        record_for(longer, recorded.window_system);
    }
    if (!recorded.has_calls) fail_without_calls(given, recorded);
    if (recorded.has_failed && !busiest && !recorded.has_drawn)
        throw SceneError(tr("{}: it {}, before it drew anything", given, one_line(recorded.ended)));
    if (busiest && !busiest->has_setup)
        print_message(
            "twinlight: warning: {} draws, but without any call such as glClear, glMatrixMode and glEnable; apitrace "
            "has "
            "missed calls, so this is not the program's picture\n",
            given);
    made.frame = frame_that_draws(file, busiest);
    // Keys change the picture, so the last one shows what they do.
    if (!run.keys.empty() && busiest && made.frame.number == busiest->number) made.frame.number = busiest->frames - 1;
    if (recorded.has_failed) print_message("twinlight: note: {} {}\n", given, one_line(recorded.ended));
    if (!recorded.not_cut.empty())
        print_message("twinlight: note: {}; keeps the whole recording, whose end may be damaged\n",
                      one_line(recorded.not_cut));
    return made;
}

void add_run_options(CLI::App& app, RunArguments& run) {
    app.add_option_function<double>(
           "--seconds", [&run](double seconds) { run.seconds = seconds; },
           "end the program after this time (default: 3; if it draws nothing, 8 and 20)")
        ->type_name("S")
        ->check(number_from(0.1, 3600.0));
    app.add_option("--frames", run.frames, "end the program after this many frames, but not before one that draws")
        ->type_name("N")
        ->check(number_from(1, 1'000'000))
        ->default_str(std::to_string(run.frames));
    app.add_option("--keys", run.keys,
                   "send these keys to the program's window, in a display of its own; <Left>, <F1>, <Escape> name keys")
        ->type_name("TEXT")
        ->check(not_empty());
    app.add_option_function<std::string>(
           "--api", [&run](const std::string& name) { run.window_system = kWindowSystems.at(name); },
           "how the program opens its window (default: found from its libraries)")
        ->type_name("glx|egl")
        ->check(one_of(kWindowSystems));
    const auto add = [&](const char* name, std::vector<std::string>& values, const char* type, const char* what) {
        app.add_option(name, values, what)->type_name(type)->allow_extra_args(false)->check(not_empty());
    };
    add("-l", run.libraries, "NAME", "for the compiler: link this library; freeglut, GLU and GL are always linked");
    add("-I", run.headers, "DIR", "for the compiler: look for headers in this folder");
    add("-D", run.macros, "NAME", "for the compiler: define this macro");
    add("-L", run.library_folders, "DIR", "for the compiler: look for libraries in this folder");
}

void add_run_flag(CLI::App& app, RunInstead& run) {
    run.name_of_command = app.get_name();
    app.add_flag(
        "--run", run.is_on,
        "SCENE is a program, or its source in C, C++ or Python: run it, and take the frame that draws the most; "
        "its other files and arguments follow. It runs with all your rights");
    app.add_option("ARGUMENTS", run.arguments.command,
                   "with --run: other sources, or arguments of the program; write -- before it if some start with -")
        ->type_name("");
    add_run_options(app, run.arguments);
}

std::string recorded_first(RunInstead& run, const std::string& scene, RecordedPart& part) {
    if (!run.is_on) {
        const RunArguments& given = run.arguments;
        if (!given.command.empty())
            throw UsageError(fmt::format("unexpected argument '{}'; see 'twinlight {} --help'", given.command.front(),
                                         run.name_of_command));
        if (given.seconds || !given.keys.empty() || given.frames != RunArguments{}.frames || given.window_system ||
            !given.libraries.empty() || !given.headers.empty() || !given.macros.empty() ||
            !given.library_folders.empty())
            throw UsageError("--seconds, --frames, --keys, --api, -l, -I, -D and -L need --run");
        return scene;
    }
    RunArguments arguments = run.arguments;
    arguments.command.insert(arguments.command.begin(), scene);
    run.folder.emplace();
    const std::string file = run.folder->path() + "/" + name_after_scene(scene, ".trace");
    const RecordingMade made = record_program(arguments, file);
    if (!part.frame && !part.context && made.frame.has_swaps) part.frame = made.frame.number;
    return file;
}

std::string words_of_scene(const RunInstead& run, const std::string& scene) {
    if (!run.is_on) return shell_word(scene);
    std::string words = "--run " + shell_word(scene);
    for (const std::string& word : run.arguments.command) words += " " + shell_word(word);
    return words;
}

std::string shell_word(const std::string& word) {
    const auto is_plain = [](unsigned char c) {
        return c >= 0x80 || std::isalnum(c) != 0 ||
               std::string_view("_./+-=:,@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
    return text + "'";
}

}  // namespace twinlight::cli

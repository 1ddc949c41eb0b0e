// twinlight record: runs a program and records what it draws, as a scene for the other commands.
#include <fmt/format.h>

#include <filesystem>

#include "app/cli/command_line.h"
#include "app/cli/run_program.h"
#include "app/session/language.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

struct RecordArguments {
    RunArguments run;
    std::string output;
    lesson::Language language = lesson::Language::kEnglish;  // of errors
};

std::string advice(const std::string& file, const trace::BusiestFrame& frame) {
    if (!frame.has_swaps) return fmt::format("It never swaps buffers. Its picture: twinlight compare {}\n", file);
    if (frame.frames == 1) return fmt::format("It has one frame. To see it: twinlight compare {}\n", file);
    return fmt::format(
        "It has {} frames, 0 to {}. Frame {} is worth a look:\n"
        "  twinlight compare {} --frame {}\n",
        frame.frames, frame.frames - 1, frame.number, file, frame.number);
}

int run_record(RecordArguments arguments) {
    session::set_language(arguments.language);
    if (arguments.output.empty()) {
        // python3 lamp.py makes lamp.trace, too.
        const std::vector<std::string>& command = arguments.run.command;
        const bool is_python =
            command.size() > 1 && command.front().starts_with("python") && command[1].ends_with(".py");
        arguments.output = name_after_scene(command[is_python ? 1 : 0], ".trace");
    }
    if (std::filesystem::path(arguments.output).extension() != ".trace")
        throw UsageError(fmt::format("-o {}: the name of a recording must end in .trace", arguments.output));
    const auto [recorded, frame] = record_program(arguments.run, arguments.output);
    const std::string file = one_line(arguments.output);
    for (const std::string& note : frame.notes) print_message("twinlight: note: {}: {}\n", file, one_line(note));
    write_result(
        fmt::format("Recording: {}{}{}\n{}", file, recorded.has_own_display ? ", in a display of its own (Xvfb)" : "",
                    recorded.ended.empty() ? "" : ", until the program ended", advice(shell_word(file), frame)));
    return kFine;
}

}  // namespace

Subcommand add_record(CLI::App& app) {
    const auto arguments = std::make_shared<RecordArguments>();
    CLI::App* record = app.add_subcommand("record", "Run a program and record what it draws, as a .trace file");
    record
        ->add_option("PROGRAM", arguments->run.command,
                     "a program; C or C++ files, which are compiled (freeglut, GLU); or a Python file (PyOpenGL); "
                     "and the program's arguments. Write -- before it if these start with -")
        ->required()
        ->type_name("[ARGUMENTS...]")
        ->check(not_empty());
    record->add_option("-o", arguments->output, "the .trace file (default: the program's name and .trace)")
        ->type_name("FILE")
        ->check(not_empty());
    add_run_options(*record, arguments->run);
    add_language_option(*record, arguments->language, "language of errors: English or Chinese (default: English)");
    record->footer(
        "This runs the program with all your rights; it is not a sandbox. Do not run programs that you do not trust.\n"
        "A recording has the call stacks, so the other commands name the lines of the program's own source, if it was\n"
        "compiled with -g, as sources given here are.\n"
        "  twinlight record lamp.cpp room.cpp -lGLEW\n"
        "  twinlight record --keys 'wwd<Left>' ./lamp\n"
        "  twinlight record lamp.py\n"
        "Needs apitrace, Xvfb where DISPLAY is not set, and xdotool for --keys. The program's output goes to standard\n"
        "error.\n"
        "Exit status: 0 success, 2 bad input or usage.");
    return {record, [arguments] { return run_record(*arguments); }};
}

}  // namespace twinlight::cli

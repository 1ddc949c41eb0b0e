// twinlight lint: warns about mistakes in a scene's lighting that GL accepts without an error.
#include "judge/lint/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "app/cli/lint_files.h"
#include "app/cli/lint_notes.h"
#include "app/cli/run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/lint/tried.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/record/compile.h"
#include "scene/recorded/recorded_frame.h"
#include "scene/state/state.h"

namespace twinlight::cli {

namespace {

struct LintArguments {
    std::string scene, fix, output;
    std::optional<Size> size;
    RecordedPart part;
    RunInstead run;
    std::string step;
    MemoryBudget memory;  // draws nothing
    bool json = false, csv = false, rules = false, calls = false;

    LintForm form() const { return json ? LintForm::kJson : csv ? LintForm::kCsv : LintForm::kText; }
};

constexpr int kPictureWidth = 160, kPictureHeight = 120;

std::string picture_of(const std::string& text, const std::string& name) {
    const auto list = std::make_shared<CommandList>(read_scene(text, name, name));
    const Scene scene = make_scene(list, {.width = kPictureWidth, .height = kPictureHeight});
    return encode_png(reference::render(lint::shown_frame(scene), {}));
}

// lint.md, and lint/NAME-wrong.png and lint/NAME-right.png for each rule.
void write_rules(const std::string& folder) {
    const std::filesystem::path root = folder;
    try_folder(folder);
    std::vector<std::pair<std::string, std::string>> contents;  // path, bytes
    for (const lint::Rule& rule : lint::rules()) {
        const std::string name(rule.name);
        contents.emplace_back((root / "lint" / (name + "-wrong.png")).string(),
                              picture_of(lint::wrong_scene(rule), name));
        contents.emplace_back((root / "lint" / (name + "-right.png")).string(),
                              picture_of(lint::corrected_scene(rule), name));
    }
    contents.emplace_back((root / "lint.md").string(), lint::markdown());
    std::vector<FileToWrite> files;
    for (const auto& [path, bytes] : contents) files.push_back({path, bytes});
    write_files_atomically(files, {}, MissingFolders::kMade);
}

// C++ has no arrays such as (GLfloat[]){1, 1, 1, 1} in calls.
std::string in_cpp(const std::string& call) {
    constexpr std::string_view kCast = "(GLfloat[])";
    const std::size_t cast = call.rfind(kCast), array = cast + kCast.size(), end = call.find('}', cast);
    if (cast == call.npos || end == call.npos) return call;
    return fmt::format("{{ const GLfloat values[] = {}; {}values{} }}", call.substr(array, end + 1 - array),
                       call.substr(0, cast), call.substr(end + 1));
}

// Whether its edits are in one file of C or C++, which is not the file to write.
bool can_be_edited(const lint::Warning& warning, const std::string& output) {
    const auto is_in_file = [&](const Place& place) { return place.file == warning.place.file && place.column > 0; };
    if (warning.place.calls) {
        std::error_code ignored;
        if (trace::is_python(*warning.place.file)) return false;
        if (std::filesystem::equivalent(*warning.place.file, output, ignored))
            throw UsageError(fmt::format("-o {}: this is the program's source, which --fix leaves as it is", output));
    }
    return std::ranges::all_of(warning.edits, [&](const lint::Edit& edit) {
        return is_in_file(edit.place) && (edit.moved == Place{} || is_in_file(edit.moved));
    });
}

int write_corrected(const LintArguments& arguments, const Scene& scene, const std::vector<lint::Warning>& warnings) {
    const lint::Rule* rule = lint::find_rule(arguments.fix);
    if (!rule) {
        std::vector<std::string_view> names;
        for (const lint::Rule& known : lint::rules()) names.push_back(known.name);
        const auto near = nearest(arguments.fix, names);
        throw UsageError(fmt::format(
            "--fix: there is no rule '{}'; {}", arguments.fix,
            near ? fmt::format("did you mean '{}'?", *near) : "the name is in brackets at the end of a warning"));
    }
    const auto found =
        std::ranges::find_if(warnings, [&](const lint::Warning& warning) { return warning.rule == rule; });
    if (found == warnings.end()) throw UsageError(fmt::format("--fix: this scene has no warning '{}'", arguments.fix));
    if (found->edits.empty())
        throw UsageError(fmt::format("--fix: '{}' needs your own change: {}", arguments.fix, found->fix));
    const auto text = scene.recording->text_of(found->place);
    if (!text || !can_be_edited(*found, arguments.output))
        throw UsageError(
            fmt::format("--fix: '{}' needs your own change at {}: {}", arguments.fix, found->place.str(), found->fix));
    const auto others = std::ranges::count_if(
        warnings, [&](const lint::Warning& warning) { return warning.rule == rule && warning.place == found->place; });
    if (found->count + others > 2 &&
        std::ranges::any_of(found->edits, [](const lint::Edit& edit) { return edit.removes; }))
        throw UsageError(
            fmt::format("--fix: '{}' is in {} places; fix them yourself: {}", arguments.fix, found->count, found->fix));
    lint::Warning warning = *found;
    if (warning.place.calls && !warning.place.file->ends_with(".c"))
        for (lint::Edit& edit : warning.edits) edit.insert = in_cpp(edit.insert);
    write_output(arguments.output, lint::corrected(*text, warning));
    return kFine;
}

// The scenes, files and folders of the command line. With --run, only the first word is one, unless it is a folder.
std::vector<std::string> inputs_of(const LintArguments& arguments) {
    const std::vector<std::string>& others = arguments.run.arguments.command;
    std::vector<std::string> inputs = {arguments.scene};
    if (!arguments.run.is_on) inputs.insert(inputs.end(), others.begin(), others.end());
    if (arguments.run.is_on && is_folder(arguments.scene) && !others.empty())
        throw UsageError(fmt::format("--run {}: nothing can follow a folder of programs", arguments.scene));
    return inputs;
}

// The later pictures of a whole program, or of a recorded one.
std::vector<lint::LaterScene> later_of(const Scene& scene) {
    if (scene.recording->command_list()) return lint::later_scenes(scene);
    std::vector<lint::LaterScene> later;
    for (RecordedFrame& frame : later_frames(scene)) {
        const bool is_next = later.empty();
        later.push_back(
            {std::move(frame.scene),
             is_next ? fmt::format("from frame {} on", frame.number) : fmt::format("in frame {}", frame.number),
             is_next});
    }
    return later;
}

// Frame 0 or 1 of a program that is read.
Scene frame_of_program(const std::string& input, const Scene& scene, int frame) {
    if (frame == 0) return scene;
    std::vector<lint::LaterScene> later = lint::later_scenes(scene);
    if (frame > 1 || later.empty())
        throw UsageError(
            fmt::format("--frame {}: of a program that is read, not recorded, there {}; to record it: "
                        "twinlight lint --run {}",
                        frame, later.empty() ? "is only frame 0" : "are frames 0 and 1", shell_word(input)));
    return later.front().scene;
}

// The scene that the user named, and its warnings.
struct Linted {
    Scene scene;
    std::vector<lint::Warning> warnings;
};

Linted linted(const LintArguments& arguments, RunInstead& run, const std::string& input) {
    RecordedPart part = arguments.part;
    const std::string file = recorded_first(run, input, part);
    part.frame = arguments.part.frame;  // several are looked at, from the first that draws on
    part.chooses_of_program = true;
    Linted result{load_scene(file, arguments.size, part, arguments.step, arguments.memory), {}};
    if (part.frame && result.scene.recording->command_list())
        result.scene = frame_of_program(input, result.scene, *part.frame);
    std::vector<lint::LaterScene> later;
    if (!arguments.part.frame) later = later_of(result.scene);
    result.warnings = lint::lint(result.scene, later);
    lint::try_fixes(result.scene, later, result.warnings);
    return result;
}

int lint_many(const LintArguments& arguments, const std::vector<std::string>& inputs) {
    if (!arguments.fix.empty()) throw UsageError("--fix takes one SCENE, and no folder");
    if (arguments.calls) throw UsageError("--calls takes one SCENE, and no folder; --json names the calls of many");
    const bool is_run = arguments.run.is_on;
    const Programs programs = is_run ? Programs::kAreRun : Programs::kAreRead;
    const std::vector<std::string> files = files_to_lint(inputs, programs);
    if (is_run)
        print_message("twinlight: note: compiles and runs {} program{} of {}, with your rights and without a sandbox\n",
                      files.size(), files.size() == 1 ? "" : "s", one_line(arguments.scene));
    const auto lint_one = [&](const std::string& file) {
        RunInstead run{.is_on = is_run, .name_of_command = arguments.run.name_of_command};
        run.arguments = arguments.run.arguments;
        run.arguments.command.clear();
        Linted one = linted(arguments, run, file);
        return LintedFile{.file = file, .scene = is_run ? file : one.scene.name(), .warnings = std::move(one.warnings)};
    };
    return lint_files(files, arguments.form(), programs, lint_one);
}

int run_lint(LintArguments& arguments) {
    if (arguments.rules) {
        if (!arguments.scene.empty()) throw UsageError("--rules takes no SCENE");
        if (arguments.output.empty())
            write_result(lint::markdown());
        else
            write_rules(arguments.output);
        return kFine;
    }
    if (arguments.scene.empty()) throw UsageError("SCENE is required; see 'twinlight lint --help'");
    if (arguments.fix.empty() != arguments.output.empty())
        throw UsageError("--fix NAME and -o FILE belong together; give both or neither");
    if (arguments.json && arguments.csv) throw UsageError("choose --json or --csv");
    const std::vector<std::string> inputs = inputs_of(arguments);
    if (inputs.size() > 1 || is_folder(arguments.scene)) return lint_many(arguments, inputs);
    const auto [scene, warnings] = linted(arguments, arguments.run, arguments.scene);
    if (!arguments.fix.empty()) return write_corrected(arguments, scene, warnings);
    if (arguments.csv) {
        write_result(csv_of({{.file = arguments.scene, .scene = scene.name(), .warnings = warnings}}));
    } else if (arguments.json) {
        write_result(lint::json_text(scene.name(), warnings));
    } else {
        std::string text;
        for (const lint::Warning& warning : warnings) {
            const auto source = scene.recording->text_of(warning.place);
            text += lint::full_text(warning, source ? std::string_view(*source) : "", arguments.calls);
        }
        write_result(text);
    }
    return warnings.empty() ? kFine : kDifferent;
}

}  // namespace

void print_lint_notes(const std::vector<lint::Warning>& warnings, const std::string& scene) {
    if (warnings.empty()) return;
    for (const lint::Warning& warning : warnings) print_message("{}\n", one_line(lint::headline(warning)));
    print_message("twinlight: note: 'twinlight lint {}' shows how to fix {}\n", one_line(scene),
                  warnings.size() == 1 ? "it" : "them");
}

Subcommand add_lint(CLI::App& app) {
    const auto arguments = std::make_shared<LintArguments>();
    CLI::App* lint = app.add_subcommand(
        "lint", "Find mistakes in the lighting of scenes and programs that GL accepts without an error");
    add_scene_argument(*lint, arguments->scene)
        ->required(false)
        ->description(
            "a built-in scene, a .gl file, a program in C (.c), an apitrace .trace file or its text dump, a folder of "
            "these, or - for standard input");
    add_size_option(*lint, arguments->size);
    add_recorded_options(*lint, arguments->part);
    add_run_flag(*lint, arguments->run);
    lint->get_option("--run")->description(
        "SCENE is a program, or its source in C, C++ or Python: run it; its "
        "other files and arguments follow. Or it is a folder of such programs. They run with all your rights");
    lint->get_option("ARGUMENTS")
        ->description(
            "more scenes and folders: prints one line for each file; with --run: other sources, or arguments of the "
            "program; write -- before it if some start with -");
    add_step_option(*lint, arguments->step);
    add_memory_option(*lint, arguments->memory);
    add_calls_flag(*lint, arguments->calls);
    lint->add_flag("--json", arguments->json,
                   "print one JSON object instead of the text; for several files: {\"files\": [...]}");
    lint->add_flag("--csv", arguments->csv,
                   "print a table for spreadsheets: one row for each warning, and for each file without any");
    lint->add_option("--fix", arguments->fix,
                     "write the scene, or the source of a recorded program, with the first warning of this name "
                     "corrected; needs -o")
        ->type_name("NAME")
        ->check(not_empty());
    lint->add_flag("--rules", arguments->rules,
                   "print the list of rules (docs/lint.md); with -o DIR, write it there with its pictures");
    lint->add_option("-o", arguments->output, "output file of --fix, or - for standard output; folder of --rules")
        ->type_name("FILE")
        ->check(not_empty());
    lint->footer(
        "It looks at several pictures of a program: the first, the second, one after a second and one after a key; of\n"
        "a recording, at the first that draws, the next and a later one. --frame N: only that one (for a program that\n"
        "is read, 0 or 1).\n"
        "A comment in the scene silences a warning: // twinlight: allow(NAME), at the end of a line for that line, or\n"
        "on a line of its own for the whole scene.\n"
        "  twinlight lint homework.c           a whole program, read without a compiler\n"
        "  twinlight lint program.trace        a recording\n"
        "  twinlight lint --run lamp.cpp       any other program: compiles, runs and records it\n"
        "  twinlight lint --csv homework/      all scenes, C programs and recordings in a folder\n"
        "Exit status: 0 no warnings, 1 some warnings, 2 a file that could not be read, or bad usage.");
    return {lint, [arguments] { return run_lint(*arguments); }};
}

}  // namespace twinlight::cli

// Runs a program, or compiles source and runs that, and records what it draws: for `record` and for --run.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "scene/record/record.h"
#include "scene/trace/temporary_folder.h"

namespace twinlight::cli {

struct RunArguments {
    std::vector<std::string> command;  // a program or sources, and arguments
    std::optional<double> seconds{};
    int frames = trace::RecordOptions{}.frames;
    std::optional<trace::WindowSystem> window_system{};
    std::string keys;
    std::vector<std::string> libraries{}, library_folders{}, headers{}, macros{};  // for the compiler
};

// --seconds, --frames, --api, --keys and the compiler's options.
void add_run_options(CLI::App& app, RunArguments& run);

struct RecordingMade {
    trace::Recorded recorded;
    trace::BusiestFrame frame;  // one that is worth a look
};
// Compiles and runs it, and writes the .trace file. Notes, and what the program prints, go to standard error. Throws
// SceneError if nothing was drawn.
RecordingMade record_program(const RunArguments& run, const std::string& file);

// --run: the scene on the command line is a program, which is recorded first.
struct RunInstead {
    bool is_on = false;
    std::string name_of_command{};
    RunArguments arguments{};  // `command` lacks its first word
    std::optional<trace::TemporaryFolder> folder{};
};
// Also takes what may follow the scene then.
void add_run_flag(CLI::App& app, RunInstead& run);
// The scene to load. With --run, records the program, and chooses the frame unless `part` does.
std::string recorded_first(RunInstead& run, const std::string& scene, RecordedPart& part);
// "solar.cpp", or "--run solar.cpp": the words of the command line that choose the scene, for advice.
std::string words_of_scene(const RunInstead& run, const std::string& scene);

// As a shell takes it: in quotes if it has blanks.
std::string shell_word(const std::string& word);

}  // namespace twinlight::cli

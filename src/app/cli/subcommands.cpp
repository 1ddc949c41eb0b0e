// The list of the subcommands.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "app/cli/command_line.h"
#include "scene/command/names.h"
#include "scene/scenes/load.h"

namespace twinlight::cli {

namespace {

// "render, compare or explain"
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += i == 0 ? "" : i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

// CLI11 would report an unknown subcommand as an unexpected argument, and accept a missing one.
void check_subcommand(int argc, char** argv, const std::vector<std::string>& names) {
    if (argc < 2) throw UsageError("a command is missing: " + listed(names) + "; see 'twinlight --help'");
    const std::string name = argv[1];
    if (name.starts_with('-')) {
        if (name == "-h" || name == "--help" || name == "--version") return;
        throw UsageError("give a command before '" + name + "': " + listed(names) + "; see 'twinlight --help'");
    }
    if (std::ranges::find(names, name) != names.end()) return;
    if (name == "help")
        throw UsageError("there is no command 'help'; 'twinlight --help' and 'twinlight COMMAND --help' print help");
    std::error_code ignored;
    const bool is_scene =
        std::ranges::any_of(kSceneFiles, [&](const EmbeddedFile& file) { return file.name == name + ".gl"; }) ||
        std::filesystem::is_regular_file(name, ignored);
    if (is_scene)
        throw UsageError(
            fmt::format("a command is missing before the scene '{}'; try 'twinlight compare {}'", name, name));
    const auto near = nearest(name, {names.begin(), names.end()});
    throw UsageError(
        fmt::format("there is no command '{}'; {}", name,
                    near ? fmt::format("did you mean '{}'?", *near) : "the commands are " + listed(names)));
}

}  // namespace

int run(int argc, char** argv) {
    CLI::App app(
        "Draws OpenGL lighting three ways - with the driver's fixed function, with generated shaders, and with a\n"
        "double-precision reference - and shows where the pictures differ.",
        "twinlight");
    app.require_subcommand(1);
    app.set_help_flag("-h,--help", "Print this help and exit");
    add_version_flag(app, "twinlight");

    const std::array subcommands = {add_render(app), add_compare(app), add_explain(app), add_export(app),
                                    add_record(app), add_scenes(app),  add_study(app),   add_fuzz(app),
                                    add_check(app),  add_lint(app),    add_lesson(app)};
    std::vector<std::string> names;
    for (const Subcommand& subcommand : subcommands) {
        names.push_back(subcommand.app->get_name());
        add_version_flag(*subcommand.app, "twinlight");
        if (subcommand.app->get_footer().empty())
            subcommand.app->footer("Exit status: 0 success, 2 bad input or usage.");
    }
    app.footer(
        "'twinlight COMMAND --help' shows the options of a command.\n"
        "Exit status: 0 success, 1 a difference that is larger than allowed (lint: warnings; lesson: wrong answers), 2 "
        "bad input or usage.");
    check_subcommand(argc, argv, names);
    if (!parse_command_line(app, argc, argv)) return kFine;
    return std::ranges::find(subcommands, app.get_subcommands().front(), &Subcommand::app)->run();
}

}  // namespace twinlight::cli

// twinlight export: a scene as a program.
#include <functional>
#include <map>

#include "app/cli/command_line.h"
#include "command/text.h"

namespace twinlight::cli {

namespace {

struct Arguments {
    std::string scene;
    std::string form;
};

const std::map<std::string, std::function<std::string(const Frame&)>> kForms = {
    {"c", [](const Frame& frame) { return print_c_program(*frame.commands); }},
};

int run(const Arguments& arguments) {
    // The whole scene is run first: what has an error is not exported.
    write_result(kForms.at(arguments.form)(load_frame(arguments.scene, {})));
    return kFine;
}

}  // namespace

Subcommand add_export(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* exporting =
        app.add_subcommand("export", "Print a scene as a C program that draws it with freeglut");
    add_scene_argument(*exporting, arguments->scene);
    exporting->add_option("--as", arguments->form, "the form")
        ->required()
        ->type_name("c")
        ->check(one_of(kForms));
    return {exporting, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli

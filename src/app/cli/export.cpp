// twinlight export: a scene as a program, in C or in GLSL.
#include <fmt/format.h>

#include <functional>
#include <map>

#include "app/cli/command_line.h"
#include "render/programmable/programmable.h"
#include "scene/command/text.h"
#include "scene/shape/written_out.h"

namespace twinlight::cli {

namespace {

struct ExportArguments {
    std::string scene;
    std::string form;
    std::optional<Shading> shading;
    std::optional<int> frame;
    bool precise = false;
};

// What a C compiler still takes in one function.
constexpr std::size_t kMostExported = 1'000'000;

// The commands that lead to the picture.
CommandList commands_of(const Scene& scene) {
    CommandList commands(scene.name(), {});
    scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) commands.commands.push_back(step.command);
        if (commands.commands.size() <= kMostExported) return true;
        throw SceneError(
            fmt::format("{}: more than {} commands lead to this picture, too many to be printed; choose an "
                        "earlier --frame",
                        scene.name(), kMostExported));
    });
    return commands;
}

using Export = std::function<std::string(const Scene&, const programmable::Options&)>;
const std::map<std::string, Export> kForms = {
    {"c",
     [](const Scene& scene, const auto&) { return print_c_program(with_pragmas_written_out(commands_of(scene))); }},
    {"glsl", [](const Scene& scene, const auto& options) { return programmable::shader_source(scene.frame, options); }},
    {"scene", [](const Scene& scene, const auto&) { return print_scene(commands_of(scene)); }},
};

int run_export(const ExportArguments& arguments) {
    if (arguments.form != "glsl" && arguments.shading) {
        throw UsageError("--shading is for --as glsl; a program shades as its glShadeModel says");
    }
    if (arguments.form != "glsl" && arguments.precise)
        throw UsageError("--precise is of the shaders; use it with --as glsl");
    // The whole scene is run first: what has an error is not exported.
    const Scene scene = load_scene(arguments.scene, {}, arguments.frame);
    programmable::Options options{{{.shading = arguments.shading}}};
    options.precise = arguments.precise;
    write_result(kForms.at(arguments.form)(scene, options));
    return kFine;
}

}  // namespace

Subcommand add_export(CLI::App& app) {
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App* exporting = app.add_subcommand(
        "export", "Print a scene as a freeglut program in C, the shaders that draw it, or its commands as a scene");
    add_scene_argument(*exporting, arguments->scene);
    exporting->add_option("--as", arguments->form, "the form")
        ->required()
        ->type_name("c|glsl|scene")
        ->check(one_of(kForms));
    add_shading_option(*exporting, arguments->shading);
    add_frame_option(*exporting, arguments->frame);
    add_precise_flag(*exporting, arguments->precise);
    return {exporting, [arguments] { return run_export(*arguments); }};
}

}  // namespace twinlight::cli

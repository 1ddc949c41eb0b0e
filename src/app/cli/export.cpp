// twinlight export: prints a scene as a C program, as GLSL, or as a scene file.
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

// C compilers fail on functions that are much larger.
constexpr std::size_t kMostExported = 1'000'000;

// All commands up to the frame.
CommandList commands_of(const Scene& scene) {
    CommandList commands(scene.name(), {});
    scene.recording->for_each([&](const Step& step) {
        if (step.kind == Step::Kind::kCommand) commands.commands.push_back(step.command);
        if (commands.commands.size() <= kMostExported) return true;
        throw SceneError(
            fmt::format("{}: this frame needs more than {} commands, too many to print; choose an earlier --frame",
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
        throw UsageError("--shading applies only to --as glsl; the other formats keep the scene's glShadeModel");
    }
    if (arguments.form != "glsl" && arguments.precise)
        throw UsageError("--precise applies only to shaders; use it with --as glsl");
    // Loading runs the whole scene, so that a scene with an error is not exported.
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
        "export", "Print a scene as a C program (freeglut), as the GLSL shaders that draw it, or as a scene file");
    add_scene_argument(*exporting, arguments->scene);
    exporting->add_option("--as", arguments->form, "output format")
        ->required()
        ->type_name("c|glsl|scene")
        ->check(one_of(kForms));
    add_shading_option(*exporting, arguments->shading);
    add_frame_option(*exporting, arguments->frame);
    add_precise_flag(*exporting, arguments->precise);
    return {exporting, [arguments] { return run_export(*arguments); }};
}

}  // namespace twinlight::cli

// twinlight export: a scene as a program, in C or in GLSL.
#include <functional>
#include <map>

#include "app/cli/command_line.h"
#include "command/text.h"
#include "programmable/programmable.h"
#include "shape/primitives.h"

namespace twinlight::cli {

namespace {

struct Arguments {
    std::string scene;
    std::string form;
    std::optional<Shading> shading;
};

const std::map<std::string, std::function<std::string(const Frame&, const RenderOptions&)>> kForms = {
    {"c", [](const Frame& frame,
             const RenderOptions&) { return print_c_program(with_shapes_as_primitives(*frame.commands)); }},
    {"glsl", programmable::shader_source},
};

int run(const Arguments& arguments) {
    if (arguments.form == "c" && arguments.shading) {
        throw UsageError("--shading is for --as glsl; a C program shades as its glShadeModel says");
    }
    // The whole scene is run first: what has an error is not exported.
    const Frame frame = load_frame(arguments.scene, {});
    write_result(kForms.at(arguments.form)(frame, {.shading = arguments.shading, .lecture_variants = true}));
    return kFine;
}

}  // namespace

Subcommand add_export(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* exporting =
        app.add_subcommand("export", "Print a scene as a freeglut program in C, or the shaders that draw it");
    add_scene_argument(*exporting, arguments->scene);
    exporting->add_option("--as", arguments->form, "the form")->required()->type_name("c|glsl")->check(one_of(kForms));
    add_shading_option(*exporting, arguments->shading);
    return {exporting, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli

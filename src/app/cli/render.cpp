// twinlight render: draws a scene with one renderer into a PNG.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <map>

#include "app/cli/command_line.h"
#include "app/cli/lint_notes.h"
#include "app/cli/renderers.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/report/words.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/replay.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

struct RenderArguments {
    std::string scene;
    std::string renderer = "fixed";
    std::optional<Shading> shading;
    std::optional<Size> size;
    RecordedPart part;
    std::string step;
    MemoryBudget memory{.bytes_of_pixel = 60};
    bool variants = false, scrubbed = false, baked = false, precise = false;
    double budget = PlanOptions{}.budget;
    std::string output;
};

const std::map<std::string, Path> kRenderers = {
    {"fixed", Path::kFixed},
    {"shaders", Path::kProgrammable},
    {"reference", Path::kReference},
};

// Commands that the renderer cannot draw.
void warn_unsupported(const Frame& frame, Path path) {
    for (const Unsupported& item : frame.unsupported)
        if (lacks(path, item))
            print_message("twinlight: note: {}\n", one_line(report::sentence_of(item, std::array{path})));
}

Image drawn(const RenderArguments& arguments, const Scene& scene, const RendererSet& renderers) {
    const PlanOptions plan{look_of(arguments.shading, arguments.variants), arguments.budget};
    switch (kRenderers.at(arguments.renderer)) {
        case Path::kFixed:
            return arguments.scrubbed ? fixed::render_scrubbed(scene, arguments.shading, arguments.budget)
                                      : renderers.functions().fixed(scene, {arguments.shading});
        case Path::kProgrammable:
            return renderers.functions().programmable(
                scene.frame,
                {plan, arguments.baked ? programmable::Tier::kBaked : programmable::Tier::kUniform, arguments.precise});
        case Path::kReference:
            return renderers.functions().reference(arguments.scrubbed ? scrubbed_frame(scene.frame, plan) : scene.frame,
                                                   reference::Options{plan});
    }
    return {};
}

// -o writes a PNG whatever the name is, so it refuses the names of other formats.
void check_is_png(const std::string& file) {
    const std::string extension = extension_of(file);
    for (std::string_view other :
         {".jpg", ".jpeg", ".gif", ".bmp", ".ppm", ".tif", ".tiff", ".webp", ".svg", ".pdf", ".tga"}) {
        if (extension != other) continue;
        throw UsageError(fmt::format("-o {}: render writes only PNG files; use -o {}", file,
                                     std::filesystem::path(file).replace_extension(".png").string()));
    }
}

int run_render(RenderArguments arguments) {
    const bool names_file = !arguments.output.empty();
    if (!names_file) arguments.output = name_after_scene(arguments.scene, ".png");
    check_is_png(arguments.output);
    if (arguments.renderer == "fixed" && arguments.shading == Shading::kPhong) {
        throw UsageError("the fixed function has no phong shading; use --with shaders or --with reference");
    }
    if (arguments.renderer == "fixed" && arguments.shading == Shading::kExact) {
        throw UsageError("the fixed function cannot draw exact surfaces; use --with shaders or --with reference");
    }
    if (arguments.variants && (arguments.renderer == "fixed" || arguments.precise)) {
        throw UsageError(
            "--variants: the fixed function, and shaders that follow it (--precise), have only OpenGL's own model; "
            "leave it out");
    }
    if (arguments.scrubbed && arguments.renderer == "shaders") {
        throw UsageError(
            "--scrubbed applies only to --with fixed and --with reference; shaders never use more state than they "
            "need");
    }
    if (arguments.scrubbed && arguments.shading == Shading::kExact) {
        throw UsageError("--scrubbed works on meshes, not on exact surfaces; use either --scrubbed or --shading exact");
    }
    if (arguments.baked && arguments.renderer != "shaders") {
        throw UsageError("--baked applies only to shaders; use it with --with shaders");
    }
    if (arguments.precise && arguments.renderer != "shaders") {
        throw UsageError("--precise applies only to shaders; use it with --with shaders");
    }
    const bool to_stdout = arguments.output == "-";
    if (to_stdout && ::isatty(STDOUT_FILENO) != 0) {
        throw UsageError("-o - would write a PNG to the terminal; redirect standard output or give a file name");
    }
    const Scene scene = load_scene(arguments.scene, arguments.size, arguments.part, arguments.step, arguments.memory);
    name_gl();
    const RendererSet renderers(scene.frame.width, scene.frame.height);
    const std::string png = encode_png(drawn(arguments, scene, renderers));
    const std::vector<compare::Query> queries = compare::queries_of(scene, renderers.functions().answers);
    const std::vector<lint::Warning> warnings = lint::lint(scene);
    if (to_stdout) {
        write_result(png);
    } else {
        write_file_atomically(arguments.output, png);
        if (!names_file) write_result(fmt::format("Picture: {}\n", one_line(arguments.output)));
    }
    for (const compare::Query& query : queries) print_message("{}\n", one_line(compare::sentence_of(query)));
    warn_unsupported(scene.frame, kRenderers.at(arguments.renderer));
    print_lint_notes(warnings, arguments.scene);
    return kFine;
}

}  // namespace

Subcommand add_render(CLI::App& app) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* render = app.add_subcommand("render", "Draw a scene with one renderer and write a PNG");
    add_scene_argument(*render, arguments->scene);
    render
        ->add_option("--with", arguments->renderer,
                     "the driver's fixed function (default), generated shaders, or the double-precision reference")
        ->type_name("fixed|shaders|reference")
        ->check(one_of(kRenderers));
    add_shading_option(*render, arguments->shading);
    add_variants_option(*render, arguments->variants);
    add_size_option(*render, arguments->size);
    add_recorded_options(*render, arguments->part);
    add_step_option(*render, arguments->step);
    add_memory_option(*render, arguments->memory);
    add_gl_option(*render);
    add_budget_option(*render, arguments->budget);
    render->add_flag("--scrubbed", arguments->scrubbed,
                     "with fixed or reference: drop lights and other lighting state that a draw does not need");
    render->add_flag("--baked", arguments->baked,
                     "with shaders: write the scene's numbers into the shaders as constants, instead of uniforms");
    add_precise_flag(*render, arguments->precise);
    render
        ->add_option("-o", arguments->output,
                     "output PNG file, or - for standard output (default: the scene's name and .png)")
        ->type_name("FILE")
        ->check(not_empty());
    return {render, [arguments] { return run_render(*arguments); }};
}

}  // namespace twinlight::cli

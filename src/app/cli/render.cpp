// twinlight render: one scene by one renderer, as a PNG.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "app/cli/command_line.h"
#include "app/cli/renderers.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/report/words.h"
#include "render/effect/scrubbed_state.h"
#include "render/fixed/fixed.h"
#include "render/reference/reference.h"

namespace twinlight::cli {

namespace {

struct Arguments {
    std::string scene;
    std::string renderer;
    std::optional<Shading> shading;
    std::optional<Size> size;
    std::optional<int> frame;
    bool scrubbed = false, baked = false, precise = false;
    double budget = RenderOptions{}.budget;
    std::string output;
};

const std::map<std::string, compare::RenderFunction compare::Renderers::*> kRenderers = {
    {"fixed", &compare::Renderers::fixed},
    {"programmable", &compare::Renderers::programmable},
    {"reference", &compare::Renderers::reference},
};

const std::map<std::string, compare::RenderFunction> kScrubbed = {
    {"fixed", fixed::render_scrubbed},
    {"reference",
     [](const Frame& frame, const RenderOptions& options) {
         return reference::render(scrubbed_frame(frame, options), options);
     }},
};

// A picture is never silently partial.
void tell_unsupported(const Frame& frame, const std::string& renderer) {
    for (Unsupported item : frame.unsupported) {
        if (std::ranges::find(item.renderers, renderer) == item.renderers.end()) continue;
        item.renderers = {renderer};
        fmt::print(stderr, "twinlight: note: {}\n", report::sentence_of(item));
    }
}

int run(const Arguments& arguments) {
    if (arguments.renderer == "fixed" && arguments.shading == Shading::kPhong) {
        throw UsageError(
            "the fixed function cannot shade by phong; use --with programmable or "
            "--with reference");
    }
    if (arguments.renderer == "fixed" && arguments.shading == Shading::kExact) {
        throw UsageError(
            "the fixed function draws meshes, no surfaces by their equations; use --with programmable or "
            "--with reference");
    }
    if (arguments.scrubbed && arguments.renderer == "programmable") {
        throw UsageError(
            "shaders are always made for what each draw calls for; use --scrubbed with fixed or reference");
    }
    if (arguments.scrubbed && arguments.shading == Shading::kExact) {
        throw UsageError(
            "what a draw calls for is planned of its mesh, not of its exact surface; leave one of both out");
    }
    if (arguments.baked && arguments.renderer != "programmable") {
        throw UsageError("--baked is of the shaders; use it with --with programmable");
    }
    if (arguments.precise && arguments.renderer != "programmable") {
        throw UsageError("--precise is of the shaders; use it with --with programmable");
    }
    const bool to_stdout = arguments.output == "-";
    if (to_stdout && ::isatty(STDOUT_FILENO) != 0) {
        throw UsageError("-o - would write a PNG's bytes to the terminal; redirect it or name a file");
    }
    const Frame frame = load_frame(arguments.scene, arguments.size, arguments.frame);
    const RendererSet renderers(frame.width, frame.height);
    const compare::RenderFunction render = arguments.scrubbed
                                               ? kScrubbed.at(arguments.renderer)
                                               : renderers.functions().*kRenderers.at(arguments.renderer);
    const RenderOptions options{.shading = arguments.shading,
                                .lecture_variants = true,
                                .budget = arguments.budget,
                                .tier = arguments.baked ? Tier::kBaked : Tier::kUniform,
                                .precise = arguments.precise};
    const std::string png = encode_png(render(frame, options));
    if (to_stdout) {
        write_result(png);
    } else {
        write_file_atomically(arguments.output, png);
    }
    tell_unsupported(frame, arguments.renderer);
    return kFine;
}

}  // namespace

Subcommand add_render(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* render = app.add_subcommand("render", "Draw a scene with one renderer, as a PNG");
    add_scene_argument(*render, arguments->scene);
    render->add_option("--with", arguments->renderer, "the driver's own lighting, generated shaders, or the reference")
        ->required()
        ->type_name("fixed|programmable|reference")
        ->check(one_of(kRenderers));
    add_shading_option(*render, arguments->shading);
    add_size_option(*render, arguments->size);
    add_frame_option(*render, arguments->frame);
    add_budget_option(*render, arguments->budget);
    render->add_flag("--scrubbed", arguments->scrubbed,
                     "fixed, reference: no more of the state than each draw calls for, instead of all of it");
    render->add_flag("--baked", arguments->baked,
                     "programmable: the scene's numbers as constants of the shaders, instead of uniforms");
    add_precise_flag(*render, arguments->precise);
    render->add_option("-o", arguments->output, "the picture, or - for standard output")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    return {render, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli

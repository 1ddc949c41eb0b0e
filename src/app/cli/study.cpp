// twinlight study: what accuracy costs in time.
#include "study/study.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/cli/command_line.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/renderers.h"
#include "app/cli/samples.h"
#include "context/gl.h"
#include "fixed/prepared_frame.h"
#include "image/file.h"
#include "reference/reference.h"
#include "state/state.h"
#include "study/tessellation.h"

namespace twinlight::cli {

namespace {

constexpr Size kSize{320, 240}, kQuickSize{240, 180};
constexpr double kSeconds = 60, kQuickSeconds = 5;

struct Arguments {
    std::string scene;
    std::optional<Size> size;
    std::string folder;
    std::optional<double> seconds;
    bool quick = false, json = false;
};

// Draws into the context that is current.
study::Renderers study_renderers(int width, int height, programmable::Renderer& shaders) {
    study::Renderers renderers;
    const auto prepared = [width, height](const std::function<void()>& draw) {
        const auto finish = [draw] {
            draw();
            glFinish();
        };
        return study::Prepared{finish, [finish, width, height] {
                                   finish();
                                   return read_pixels(width, height);
                               }};
    };
    renderers.fixed = [prepared](const Frame& frame, const RenderOptions& options) {
        const auto kept = std::make_shared<const Frame>(frame);
        const auto ready = std::make_shared<fixed::PreparedFrame>(*kept, options, fixed::Scrub::kNothing);
        return prepared([kept, ready] { ready->draw(); });
    };
    renderers.programmable = [prepared, &shaders](const Frame& frame, const RenderOptions& options) {
        const auto ready = std::make_shared<programmable::PreparedFrame>(frame, options);
        return prepared([ready, &shaders] { shaders.draw(*ready); });
    };
    renderers.reference = [](const Frame& frame, const RenderOptions& options) {
        const auto ready = std::make_shared<const Frame>(frame);
        return study::Prepared{[ready, options] { reference::render(*ready, options); },
                               [ready, options] { return reference::render(*ready, options); }};
    };
    renderers.seen = reference::seen_shapes;
    return renderers;
}

std::string summary(const study::Study& study, const std::string& folder) {
    std::string text = fmt::format("{}, {} x {}, {}: {} choices, {} rounds\n\n{:<56} {:>10} {:>10} {:>8}\n",
                                   study.scene, study.width, study.height, study.driver, study.points.size(),
                                   study.rounds, "no other is both faster and more accurate", "time", "rms", "max");
    std::vector<const study::Point*> front;
    for (const study::Point& point : study.points)
        if (point.on_front) front.push_back(&point);
    std::ranges::sort(front, {}, [](const study::Point* point) { return point->median_seconds(); });
    for (const study::Point* point : front)
        text += fmt::format("{:<56} {:>7.3g} ms {:>10.2e} {:>8.3f}\n", point->choice.words(),
                            1000 * point->median_seconds(), point->whole.rms, point->whole.max);
    text += "\n";
    for (const std::string& sentence : study.findings) text += sentence + "\n";
    if (study.spectral) text += "\n" + study::spectral_text(*study.spectral);
    return text + "Report: " + (std::filesystem::path(folder) / "index.html").string() + "\n";
}

int run(const Arguments& arguments) {
    const Size size = arguments.size.value_or(arguments.quick ? kQuickSize : kSize);
    const Frame frame = load_frame(arguments.scene, size);
    const auto* scene = dynamic_cast<const CommandList*>(frame.commands.get());
    const bool has_slices = scene && study::has_slices(*scene);
    const auto frame_of = [&](int slices) {
        if (slices == 0) return frame;
        return make_frame(std::make_shared<const CommandList>(study::with_slices(*scene, slices)),
                          {.width = frame.width, .height = frame.height});
    };
    // Before the work, not after it.
    const std::filesystem::path folder(arguments.folder);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(arguments.folder + ": " + error.message());
    const auto context = make_offscreen_context(frame.width, frame.height);
    programmable::Renderer shaders({.programs = 1024});  // all of them stay ready
    const Interrupt interrupt;
    ProgressBar bar;
    study::Study result = study::run(frame_of, has_slices, study_renderers(frame.width, frame.height, shaders),
                                     {.extent = arguments.quick ? study::Extent::kQuick : study::Extent::kFull,
                                      .seconds = arguments.seconds.value_or(arguments.quick ? kQuickSeconds : kSeconds),
                                      .progress = [&](int done, int total, const std::string& next) {
                                          bar.show(done, total, next);
                                          return !Interrupt::came();
                                      }});
    bar.wipe();
    result.spectral = study_samples(frame, arguments.quick);
    result.scene = frame.commands->name;
    result.driver = driver_name();
    const std::string json = study::study_json(result), csv = study::study_csv(result), svg = study::study_svg(result),
                      page = study::study_page(result);
    const std::string samples_svg = result.spectral ? study::spectral_svg(*result.spectral) : "";
    std::vector<FileToWrite> files = {{(folder / "study.json").string(), json},
                                      {(folder / "study.csv").string(), csv},
                                      {(folder / "study.svg").string(), svg},
                                      {(folder / "index.html").string(), page}};
    if (result.spectral) files.push_back({(folder / "spectral.svg").string(), samples_svg});
    write_files_atomically(files);
    write_result(arguments.json ? json : summary(result, arguments.folder));
    return kFine;
}

}  // namespace

Subcommand add_study(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* study = app.add_subcommand("study", "Show what accuracy costs in time");
    add_scene_argument(*study, arguments->scene);
    study
        ->add_option("-o", arguments->folder,
                     "where study.json, study.csv, study.svg and index.html go; made if it is not there")
        ->required()
        ->type_name("DIR")
        ->check(not_empty());
    add_size_option(*study, arguments->size);
    study
        ->add_option_function<double>(
            "--seconds", [arguments](double seconds) { arguments->seconds = seconds; },
            "how long to take times; each choice is timed three times at least")
        ->type_name("S")
        ->default_str("60, or 5 with --quick")
        ->check(CLI::Range(0.0, 86400.0));
    study->add_flag("--quick", arguments->quick, "fewer meshes, a smaller picture, less time");
    study->add_flag("--json", arguments->json, "print study.json's object instead of the table");
    study->footer(
        "Truth is the reference with exact surfaces. Of a scene with #pragma twinlight spectrum(n) the samples are "
        "studied\n"
        "too: in study.json, the page and spectral.svg. Ctrl-C ends the timing; what was measured is written.\n"
        "Exit status: 0 fine, 2 bad input or use.");
    return {study, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli

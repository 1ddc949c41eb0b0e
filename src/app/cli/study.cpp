// twinlight study: measures how much time accuracy costs.
#include "judge/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/cli/command_line.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/study_samples.h"
#include "app/study_renderers.h"
#include "base/image/file.h"
#include "base/text/input_text.h"
#include "judge/study/scene_of_choice.h"
#include "render/context/driver_name.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::cli {

namespace {

constexpr Size kSize{320, 240}, kQuickSize{240, 180};
constexpr double kSeconds = 60, kQuickSeconds = 2;

struct StudyArguments {
    std::string scene;
    std::string step;
    std::optional<Size> size;
    std::string folder;
    std::vector<std::string> merge;
    std::optional<double> seconds;
    std::optional<int> coverage;
    bool quick = false, resume = false, json = false;
};

// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo): distinguishes scenes, but does not protect against forgery.
// Reads in pieces, because a recording may be larger than memory.
std::string fingerprint(std::istream& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    std::array<char, 1 << 16> piece{};
    do {
        bytes.read(piece.data(), piece.size());
        for (const char c : std::string_view(piece.data(), static_cast<std::size_t>(bytes.gcount())))
            hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3;
    } while (bytes);
    return fmt::format("{:016x}", hash);
}

std::string summary(const study::Study& study, const std::string& folder) {
    constexpr std::size_t kRms = 0;  // of kMeasures
    std::string text =
        fmt::format("{}, {} x {}: {} choices\n", study.scene, study.width, study.height, study.points.size());
    for (std::size_t series = 0; series < study.series.size(); ++series) {
        const study::Series& one = study.series[series];
        text += fmt::format("\n{}, {} cores, {}; {} rounds\n{:<64} {:>10} {:>10} {:>8}\n", one.machine.processor,
                            one.machine.cores, one.driver, one.rounds,
                            "best choices (none is both faster and more accurate)", "time", "rms", "max");
        std::vector<const study::Point*> front;
        for (const study::Point& point : study.points)
            if (point.series == series && point.on_front[kRms]) front.push_back(&point);
        std::ranges::sort(front, {}, [](const study::Point* point) { return point->median_seconds(); });
        for (const study::Point* point : front)
            text += fmt::format("{:<64} {:>7.3g} ms {:>10.2e} {:>8.3f}\n", point->choice.words(),
                                1000 * point->median_seconds(), point->errors.whole.rms, point->errors.whole.max);
        text += "\n";
        for (const std::string& sentence : one.findings) text += sentence + "\n";
        if (one.spectral) text += "\n" + study::spectral_text(*one.spectral);
    }
    return text + "\nReport: " + one_line((std::filesystem::path(folder) / "index.html").string()) + "\n";
}

int write(const StudyArguments& arguments, const study::Study& study) {
    study::write_study(study, arguments.folder);
    write_result(arguments.json ? study_json(study) : summary(study, arguments.folder));
    return kFine;
}

int merge(const StudyArguments& arguments) {
    if (arguments.merge.size() < 2) throw UsageError("--merge needs at least two study.json files");
    std::vector<study::NamedStudy> studies;
    for (const std::string& file : arguments.merge) studies.push_back({file, study::load_study(file)});
    return write(arguments, study::merged(std::move(studies)));
}

// Loads the study that --resume continues; its settings are the defaults of this one.
std::optional<study::Study> earlier_study(StudyArguments& arguments) {
    if (!arguments.resume) return {};
    const std::string file = (std::filesystem::path(arguments.folder) / "study.json").string();
    study::Study study = study::load_study(file);
    if (study.series.size() != 1)
        throw UsageError(file + " holds several merged studies; --resume continues only a single one");
    const bool was_quick = study.extent == study::Extent::kQuick;
    if (arguments.quick && !was_quick) throw UsageError(file + " was made without --quick; leave --quick out");
    arguments.quick = was_quick;
    if (!arguments.size) arguments.size = Size{study.width, study.height};
    if (!arguments.coverage) arguments.coverage = study.coverage;
    return study;
}

void check_resumable(const study::Study& earlier, const study::Study& now) {
    std::string difference = difference_of(now, earlier);
    if (difference.empty() && earlier.series[0].machine != now.series[0].machine)
        difference = "of another machine, " + earlier.series[0].machine.processor;
    if (difference.empty() && earlier.series[0].driver != now.series[0].driver)
        difference = "of another driver, " + earlier.series[0].driver;
    if (!difference.empty())
        throw UsageError(
            fmt::format("cannot resume: the study in this folder is {}; leave --resume out to start again, or use "
                        "another folder and --merge",
                        one_line(difference)));
}

int run_study(StudyArguments arguments) {
    if (arguments.scene.empty() && arguments.merge.empty())
        throw UsageError("SCENE is missing; give a scene, or --merge and study.json files");
    if (arguments.folder.empty()) arguments.folder = name_after_scene(arguments.scene, "-study");
    if (!arguments.merge.empty()) return merge(arguments);
    const std::optional<study::Study> earlier = earlier_study(arguments);
    const Size size = arguments.size.value_or(arguments.quick ? kQuickSize : kSize);
    // Measured. Each choice is drawn with so many samples of a pixel.
    const auto samples = static_cast<std::size_t>(arguments.coverage.value_or(1));
    const MemoryBudget memory{
        .bytes_of_pixel = (arguments.quick ? 500 : 800) + (samples > 1 ? 40 * samples * samples : 0),
        .has_option = false};
    const Scene scene = load_scene(arguments.scene, size, {}, arguments.step, memory);
    const Frame& frame = scene.frame;
    const CommandList* commands = scene.recording->command_list();
    const bool has_slices = commands && study::has_slices(*commands);
    const auto frame_of = [&](int slices) {
        if (slices == 0) return frame;
        return make_frame(study::with_slices(*commands, slices), {.width = frame.width, .height = frame.height});
    };
    // Before the work, so that a bad folder is reported at once.
    try_folder(arguments.folder);
    name_gl();
    StudyRenderers renderers(frame.width, frame.height);

    study::Study about;  // known before measuring
    about.scene = scene.title();
    if (commands) {
        InputText text(print_scene(*commands));
        about.fingerprint = fingerprint(text);
    } else {
        std::ifstream file(arguments.scene, std::ios::binary);
        if (!file) throw FileError(arguments.scene + ": cannot be read twice; save it to a file first");
        about.fingerprint = fingerprint(file);
        if (file.bad()) throw FileError(arguments.scene + ": read error");
    }
    about.width = frame.width;
    about.height = frame.height;
    about.coverage = arguments.coverage.value_or(1);
    about.series.push_back({.name = current_driver().renderer,
                            .machine = this_machine(),
                            .driver = driver_name(),
                            .library = gl_library(),
                            .rounds = 0,
                            .findings = {}});
    if (earlier) check_resumable(*earlier, about);

    const Interrupt interrupt;
    ProgressBar bar;
    std::map<std::string, int> failures;  // by reason
    study::Study result =
        study::run(frame_of, has_slices, renderers.functions(),
                   {.extent = arguments.quick ? study::Extent::kQuick : study::Extent::kFull,
                    .coverage = about.coverage,
                    .seconds = arguments.seconds.value_or(arguments.quick ? kQuickSeconds : kSeconds),
                    .earlier = earlier ? &*earlier : nullptr,
                    .failed = [&](const study::Choice&, const std::string& reason) { ++failures[reason]; },
                    .progress =
                        [&](const study::Progress& progress) {
                            bar.show(progress.done, progress.total, progress.next, progress.seconds_left);
                            return !Interrupt::came();
                        }});
    bar.wipe();
    for (const auto& [reason, count] : failures)
        print_message("twinlight: {} choice{} left out: {}\n", count, count == 1 ? " is" : "s are", one_line(reason));
    result.scene = about.scene;
    result.fingerprint = about.fingerprint;
    study::Series& series = result.series[0];
    series.name = about.series[0].name;
    series.machine = about.series[0].machine;
    series.driver = about.series[0].driver;
    series.library = about.series[0].library;
    series.spectral = study_samples(frame, arguments.quick);
    return write(arguments, result);
}

}  // namespace

Subcommand add_study(CLI::App& app) {
    const auto arguments = std::make_shared<StudyArguments>();
    CLI::App* study = app.add_subcommand("study", "Measure how much time accuracy costs");
    add_scene_argument(*study, arguments->scene)->required(false);
    study
        ->add_option("-o", arguments->folder,
                     "folder for index.html, study.json, study.csv, plots (.svg) and pictures/; created if it does not "
                     "exist (default: the scene's name and -study)")
        ->type_name("DIR")
        ->check(not_empty());
    add_step_option(*study, arguments->step);
    add_size_option(*study, arguments->size, "320x240, or 240x180 with --quick");
    study
        ->add_option_function<double>(
            "--seconds", [arguments](double seconds) { arguments->seconds = seconds; },
            "time for the measurements, which repeat at least three times (default: 60, or 2 with --quick)")
        ->type_name("S")
        ->check(number_from(0.0, 86400.0));
    study
        ->add_option_function<int>(
            "--coverage", [arguments](int samples) { arguments->coverage = samples; },
            "study antialiasing too: the exact picture has NxN samples per pixel (N is 1, 2, 4, 8 or 16)")
        ->type_name("N")
        ->default_str("1")
        ->check(CLI::IsMember({1, 2, 4, 8, 16}).description(""));
    study->add_flag("--quick", arguments->quick, "fewer choices and a smaller picture: about ten seconds");
    study->add_flag("--resume", arguments->resume, "continue the study in DIR with the same settings");
    study->add_option("--merge", arguments->merge, "combine studies of one scene from several machines; takes no SCENE")
        ->type_name("A.json B.json");
    add_gl_option(*study);
    study->add_flag("--json", arguments->json, "print study.json instead of the table");
    study->footer(
        "Draws the scene in many ways (renderer, shading, mesh, lighting), and measures the time of each and its "
        "error:\n"
        "the difference from the exact picture, which the reference draws from the equations of curved shapes.\n"
        "For a scene with #pragma twinlight spectrum(n), the number of wavelengths is studied too (spectral.svg).\n"
        "Ctrl-C stops the study and keeps all measurements; --resume continues it.\n"
        "Exit status: 0 success, 2 bad input or usage.");
    return {study, [arguments] { return run_study(*arguments); }};
}

}  // namespace twinlight::cli

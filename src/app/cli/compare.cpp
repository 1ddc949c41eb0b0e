// twinlight compare: draws a scene with all renderers and reports where they differ.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <map>

#include "app/cli/command_line.h"
#include "app/cli/lint_notes.h"
#include "app/cli/progress.h"
#include "app/cli/renderers.h"
#include "app/cli/run_program.h"
#include "base/image/contrast.h"
#include "base/image/file.h"
#include "base/threads/async.h"
#include "judge/report/report.h"
#include "judge/report/words.h"
#include "render/context/driver_name.h"
#include "render/programmable/joined_draws.h"
#include "scene/command/text.h"

namespace twinlight::cli {

namespace {

struct CompareArguments {
    std::string scene;
    std::optional<Size> size;
    RecordedPart part;
    RunInstead run;
    std::string step;
    MemoryBudget memory{.bytes_of_pixel = 450, .bytes_of_step_pixel = 170};
    std::string folder;
    double budget = PlanOptions{}.budget;
    bool precise = false, json = false;
    Shading per_pixel = Shading::kPhong;
};

const std::map<std::string, Shading> kPixelShadings = {{"phong", Shading::kPhong}, {"exact", Shading::kExact}};

std::string colored(const std::string& text, compare::Verdict verdict) {
    if (!result_in_color()) return text;
    switch (verdict) {
        case compare::Verdict::kWithin: return "\x1b[32m" + text + "\x1b[0m";
        case compare::Verdict::kBeyond: return "\x1b[1;31m" + text + "\x1b[0m";
        case compare::Verdict::kUnjudged:
        case compare::Verdict::kPartial: return "\x1b[33m" + text + "\x1b[0m";
        case compare::Verdict::kInformative: return text;
    }
    return text;
}

std::string line(std::string_view name, std::string_view part, const RegionDifference& region) {
    const bool any = region.differing > 0;
    return fmt::format("{:<20}  {:<15}  {:>9}  {:>8}  {:>7}  {:>7}  {:>9}", name, part,
                       report::grouped(region.differing), report::share_of(region), report::in_255ths(region.max),
                       any ? fmt::format("{:.1e}", region.rms) : "0",
                       any ? fmt::format("{},{}", region.worst_x, region.worst_y) : "-");
}

std::string judged_lines(const compare::Judged& judged) {
    std::string text = fmt::format("{} pixels are away from edges, and held to their allowed difference.\n",
                                   report::grouped(judged.to_allowed));
    if (judged.to_one_of > 0)
        text += fmt::format(
            "{} are at edges, and held to one of several colours: in the median {:.0f} with ranges up to {} wide, in "
            "95% at most {:.0f} and {}.\n",
            report::grouped(judged.to_one_of), judged.colors.median, report::in_255ths(judged.width.median),
            judged.colors.most, report::in_255ths(judged.width.most));
    if (judged.not_judged > 0)
        text += fmt::format("{} are at edges where OpenGL leaves the colour open, and not checked.\n",
                            report::grouped(judged.not_judged));
    return text;
}

// Two lines for each pair: pixels away from edges, and edge pixels. A third line if a part of the difference is allowed: the rest.
std::string table(const compare::Comparison& comparison) {
    std::string text = fmt::format("{:<20}  {:<15}  {:>9}  {:>8}  {:>7}  {:>7}  {:>9}  {}\n", "pair", "pixels",
                                   "differing", "share", "max", "rms", "worst x,y", "verdict");
    for (const compare::Pair& pair : comparison.pairs) {
        text += line(comparison.a(pair).name, "away from edges", pair.difference.interior) + "  " +
                colored(report::words_of(pair.verdict), pair.verdict) + "\n";
        text += line("~ " + comparison.b(pair).name, "at edges", pair.difference.edge) + "\n";
        if (report::has_allowed_difference(pair))
            text += line("", "not allowed", pair.difference.beyond_allowed) + "\n";
    }
    return text + judged_lines(comparison.pairs.front().judged);
}

// What some renderer does not draw, and what queries returned.
std::string notes(const compare::Comparison& comparison, const std::string& indent = "") {
    std::string text;
    for (const Unsupported& item : comparison.unsupported) text += indent + one_line(report::sentence_of(item)) + "\n";
    for (const compare::Query& query : comparison.queries)
        text += indent + one_line(compare::sentence_of(query)) + "\n";
    return text;
}

std::string report_line(const std::string& folder) {
    return "Report: " + one_line((std::filesystem::path(folder) / "index.html").string()) + "\n";
}

std::string summary(const compare::Comparison& comparison, const std::string& folder) {
    std::string text =
        fmt::format("{}, {} x {}, {}\n\n", comparison.scene, comparison.width, comparison.height, comparison.driver);
    for (const std::string& sentence : report::answer(comparison).sentences()) text += sentence + "\n";
    text += notes(comparison) + "\n" + table(comparison) + "\nTime:";
    for (const compare::Render& render : comparison.renders) {
        text += fmt::format("{} {} {:.1f} ms", text.back() == ':' ? "" : ",", render.name, render.ms);
    }
    return text + "\n" + report_line(folder);
}

struct Compared {
    compare::Comparison comparison;
    std::vector<lint::Warning> warnings;
};

Compared compared(const Scene& scene, const CompareArguments& arguments, ProgressBar& bar) {
    name_gl();
    static const DrawingPrecision precision = measure_drawing_precision();
    const RendererSet set(scene.frame.width, scene.frame.height);
    compare::Renderers renderers = set.functions();
    renderers.precision = precision;
    // Beside the drawing; get() runs it where there is no room for a thread, or where both together may need more memory than was
    // counted.
    constexpr std::size_t kFewVertices = 30'000;
    const bool has_few = programmable::count_vertices(scene.frame.draws()) <= kFewVertices;
    std::future<std::vector<lint::Warning>> warnings =
        std::async(has_few ? kThreadIfPossible : std::launch::deferred, [&scene] { return lint::lint(scene); });
    Compared result;
    result.comparison = compare::compare_scene(
        scene,
        {.driver = driver_name(),
         .library = gl_library(),
         .budget = arguments.budget,
         .precise = arguments.precise,
         .per_pixel = arguments.per_pixel,
         .progress = [&](int done, int total, std::string_view next) { bar.show(done, total, next); }},
        renderers);
    result.warnings = warnings.get();
    for (const lint::Warning& warning : result.warnings)
        result.comparison.warnings.push_back(
            {.line = lint::headline(warning), .why = std::string(warning.rule->why), .fix = warning.fix});
    return result;
}

// The first sentence of each step.
std::string summary(const std::vector<report::ComparedStep>& steps, const std::string& folder) {
    const compare::Comparison& first = steps.front().comparison;
    std::string text = fmt::format("{}, {} steps, {} x {}, {}\n\n", first.scene, steps.size(), first.width,
                                   first.height, first.driver);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const compare::Comparison& comparison = steps[i].comparison;
        text += fmt::format("{}. {}\n   {}\n", i + 1, steps[i].title,
                            colored(report::answer(comparison).headline, comparison.verdict()));
        text += notes(comparison, "   ");
    }
    return text + "\nThe numbers of one step: --step N\n" + report_line(folder);
}

// The pictures of all steps of a scene, on one page.
int compare_steps(const std::vector<Scene>& scenes, const CompareArguments& arguments) {
    std::vector<report::ComparedStep> steps;
    std::vector<lint::Warning> warnings;
    {
        ProgressBar bar;
        for (const Scene& scene : scenes) {
            const CommandList& commands = *scene.recording->command_list();
            Compared step = compared(scene, arguments, bar);
            steps.push_back({commands.steps[commands.step - 1], std::move(step.comparison)});
            steps.back().comparison.scene = scene.name();
            // A warning about a line of every step shows once.
            for (lint::Warning& warning : step.warnings)
                if (std::ranges::none_of(warnings, [&](const lint::Warning& known) {
                        return lint::headline(known) == lint::headline(warning);
                    }))
                    warnings.push_back(std::move(warning));
        }
    }
    const std::string text = arguments.json ? report::steps_json(steps) : summary(steps, arguments.folder);
    report::write_report(steps, arguments.folder);
    write_result(text);
    print_lint_notes(warnings, words_of_scene(arguments.run, arguments.scene));
    return report::verdict_of(steps) == compare::Verdict::kBeyond ? kDifferent : kFine;
}

int run_compare(CompareArguments& arguments) {
    if (arguments.folder.empty()) arguments.folder = name_after_scene(arguments.scene, "-report");
    const bool has_frame = arguments.part.frame.has_value();
    const std::string file = recorded_first(arguments.run, arguments.scene, arguments.part);
    const std::vector<Scene> scenes =
        load_steps(file, arguments.size, arguments.part, arguments.step, arguments.memory);
    try_folder(arguments.folder);  // before the work: a bad folder fails at once
    if (scenes.size() > 1) return compare_steps(scenes, arguments);
    Compared result;
    {
        ProgressBar bar;
        result = compared(scenes.front(), arguments, bar);
    }
    const compare::Comparison& comparison = result.comparison;
    const std::string text =
        arguments.json ? report::comparison_json(comparison) : summary(comparison, arguments.folder);
    report::write_report(comparison, arguments.folder);
    write_result(text);
    print_lint_notes(result.warnings, words_of_scene(arguments.run, arguments.scene));
    // load_scene() looks at the frame that it chooses itself.
    if (has_frame && color_contrast(comparison.renders.front().image) == 0)
        print_message("twinlight: note: the picture of frame {} is of one colour; --frame chooses another\n",
                      *arguments.part.frame);
    return comparison.within_tolerance() ? kFine : kDifferent;
}

}  // namespace

Subcommand add_compare(CLI::App& app) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* compare = app.add_subcommand("compare", "Draw a scene with all renderers and report where they differ");
    add_scene_argument(*compare, arguments->scene);
    compare
        ->add_option("-o", arguments->folder,
                     "folder for the report; created if it does not exist (default: the scene's name and -report)")
        ->type_name("DIR")
        ->check(not_empty());
    add_size_option(*compare, arguments->size);
    add_recorded_options(*compare, arguments->part);
    add_run_flag(*compare, arguments->run);
    add_step_option(*compare, arguments->step, "all, on one page");
    add_memory_option(*compare, arguments->memory);
    add_gl_option(*compare);
    add_budget_option(*compare, arguments->budget);
    add_precise_flag(*compare, arguments->precise);
    compare
        ->add_option_function<std::string>(
            "--shading", [arguments](const std::string& name) { arguments->per_pixel = kPixelShadings.at(name); },
            "for the pictures that are lit at every pixel; exact draws curved shapes from their equations")
        ->type_name("phong|exact")
        ->check(one_of(kPixelShadings))
        ->default_str("phong");
    compare->add_flag("--json", arguments->json, "print comparison.json instead of the table");
    compare->footer(
        "Exit status: 0 the renderers agree, perhaps only in what all of them draw; 1 they differ more than allowed;\n"
        "2 bad input or usage.");
    return {compare, [arguments] { return run_compare(*arguments); }};
}

}  // namespace twinlight::cli

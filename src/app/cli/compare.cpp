// twinlight compare: one scene by all renderers, and how they differ.
#include <fmt/format.h>

#include <filesystem>

#include "app/cli/command_line.h"
#include "app/cli/progress.h"
#include "app/cli/renderers.h"
#include "report/comparison.h"
#include "report/words.h"

namespace twinlight::cli {

namespace {

struct Arguments {
    std::string scene;
    Size size;
    std::string folder;
    bool json = false;
};

using Row = std::vector<std::string>;

Row row_of(const report::Comparison& comparison, const report::Pair& pair) {
    Row row = {report::name_of(comparison, pair)};
    for (const RegionDifference& region : {pair.difference.interior, pair.difference.edge}) {
        row.push_back(report::grouped(region.differing));
        row.push_back(report::share_of(region));
        row.push_back(report::codes_of(region.max));
        row.push_back(region.rms == 0 ? "0" : fmt::format("{:.1e}", region.rms));
        row.push_back(region.differing == 0 ? "-" : fmt::format("{},{}", region.worst_x, region.worst_y));
    }
    row.push_back(report::word_of(pair.verdict));
    return row;
}

std::string colored(const std::string& text, report::Verdict verdict) {
    if (!result_in_color()) return text;
    switch (verdict) {
        case report::Verdict::kWithin: return "\x1b[32m" + text + "\x1b[0m";
        case report::Verdict::kBeyond: return "\x1b[1;31m" + text + "\x1b[0m";
        case report::Verdict::kInformative: return text;
    }
    return text;
}

// The pairs as columns: the first and the last to the left, the numbers to the right.
std::string table(const report::Comparison& comparison) {
    std::vector<Row> rows = {{"pair", "differ", "share", "max", "rms", "worst at", "differ", "share", "max",
                              "rms", "worst at", "verdict"}};
    for (const report::Pair& pair : comparison.pairs) rows.push_back(row_of(comparison, pair));
    const std::size_t last = rows[0].size() - 1;
    std::vector<std::size_t> widths(last);
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < last; ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    // Two blanks between columns, four before each of the two groups.
    const auto gap = [](std::size_t column) { return column == 1 || column == 6 ? 4U : 2U; };
    const auto group_width = [&](std::size_t first) {
        std::size_t width = 0;
        for (std::size_t c = first; c < first + 5; ++c) width += widths[c] + (c == first ? 0 : gap(c));
        return width;
    };
    const ImageDifference& any = comparison.pairs.front().difference;  // all pairs share one mask
    std::string text = fmt::format("{:{}}    {:<{}}    edges, {} pixels\n", "", widths[0],
                                   fmt::format("interior, {} pixels", report::grouped(any.interior.pixels)),
                                   group_width(1), report::grouped(any.edge.pixels));
    for (std::size_t r = 0; r < rows.size(); ++r) {
        text += fmt::format("{:<{}}", rows[r][0], widths[0]);
        for (std::size_t c = 1; c < last; ++c) text += fmt::format("{:>{}}", rows[r][c], widths[c] + gap(c));
        text +=
            "  " + (r == 0 ? rows[r][last] : colored(rows[r][last], comparison.pairs[r - 1].verdict)) + "\n";
    }
    return text;
}

std::string summary(const report::Comparison& comparison, const std::string& folder) {
    std::string text = fmt::format("{}, {} x {}, {}\n\n", comparison.scene, comparison.width,
                                   comparison.height, comparison.driver);
    text += table(comparison) + "\ntime:";
    for (const report::Render& render : comparison.renders) {
        text += fmt::format("{} {} {:.1f} ms", text.back() == ':' ? "" : ",", render.name, render.ms);
    }
    text += "\n\n";
    for (const std::string& sentence : report::verdict_sentences(comparison)) text += sentence + "\n";
    for (const Unsupported& item : comparison.unsupported) text += report::sentence_of(item) + "\n";
    return text + "Report: " + (std::filesystem::path(folder) / "index.html").string() + "\n";
}

int run(const Arguments& arguments) {
    const Frame frame = load_frame(arguments.scene, arguments.size);
    report::Comparison comparison;
    {
        ProgressBar bar;
        const RendererSet renderers(frame.width, frame.height);
        comparison = report::compare_scene(
            frame, frame.commands->name, driver_name(), renderers.functions(),
            [&](int done, int total, std::string_view next) { bar.show(done, total, next); });
    }
    report::write_report(comparison, arguments.folder);
    write_result(arguments.json ? report::comparison_json(comparison)
                                : summary(comparison, arguments.folder));
    return comparison.within_tolerance() ? kFine : kDifferent;
}

}  // namespace

Subcommand add_compare(CLI::App& app) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* compare =
        app.add_subcommand("compare", "Draw a scene with all renderers and report how they differ");
    add_scene_argument(*compare, arguments->scene);
    compare->add_option("-o", arguments->folder, "the report's folder, made if it is not there")
        ->required()
        ->type_name("DIR");
    add_size_option(*compare, arguments->size);
    compare->add_flag("--json", arguments->json, "print comparison.json's object instead of the table");
    compare->footer("Exit status: 0 within the tolerance, 1 beyond it, 2 bad input or use.");
    return {compare, [arguments] { return run(*arguments); }};
}

}  // namespace twinlight::cli

// index.html: src/judge/report/pages/study.html, filled in. Its script reads one JSON object: that of study.json, with
// pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text/page.h"
#include "judge/report/html.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace {

using Json = nlohmann::ordered_json;
using report::escaped;

// The axes on which the choices of this study differ.
std::vector<const Axis*> axes_of(const Study& study) {
    std::vector<const Axis*> result;
    for (const Axis& axis : axes()) {
        std::set<std::string> keys;
        for (const Point& point : study.points) keys.insert(axis.value(point.choice).key);
        if (keys.size() > 1) result.push_back(&axis);
    }
    return result;
}

std::string page_data(const Study& study) {
    Json data = Json::parse(study_json(study));
    data["axes"] = Json::array();
    for (const Axis* axis : axes_of(study)) data["axes"].push_back({{"name", axis->name}, {"words", axis->words}});
    data["measures"] = Json::array();
    for (const Measure& measure : kMeasures)
        data["measures"].push_back({{"name", measure.name}, {"words", measure.axis}, {"unit", measure.unit}});
    data["truth"] = report::data_uri(study.truth_png);
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        const Point& point = study.points[i];
        Json& json = data["points"][i];
        json["seconds"].erase("samples");
        for (const Axis& axis : axes()) json["values"][axis.name] = axis.value(point.choice).words;
        if (point.picture_png.empty()) continue;
        json["picture"] = report::data_uri(point.picture_png);
        json["difference"] = report::data_uri(point.difference_png);
    }
    // The text goes into <script>, which only a "<" could end.
    std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace), safe;
    for (const char c : text) safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

std::string head_row(const Study& study) {
    std::string html;
    const auto add = [&](std::string_view words) { html += fmt::format("<th scope=\"col\">{}</th>", escaped(words)); };
    add("choice");
    if (study.series.size() > 1) add("machine");
    add("time, ms");
    add("middle half");
    for (const Measure& measure : kMeasures) add(measure.axis);
    add("PSNR, dB");
    add("rms inside shapes");
    add("rms at outlines");
    add("front");
    return html;
}

std::string row(const Study& study, const Point& point, std::size_t number) {
    const auto [q1, q3] = point.quartiles_seconds();
    std::string html =
        fmt::format("<tr data-point=\"{}\"><th scope=\"row\">{}</th>", number, escaped(point.choice.words()));
    const auto add = [&](const std::string& words) { html += "<td>" + escaped(words) + "</td>"; };
    if (study.series.size() > 1) add(study.series[point.series].name);
    add(fmt::format("{:.3g}", 1000 * point.median_seconds()));
    add(fmt::format("{:.3g} to {:.3g}", 1000 * q1, 1000 * q3));
    const Errors& errors = point.errors;
    for (const Measure& measure : kMeasures) add(fmt::format("{:.3g}", errors.whole.*measure.value));
    add(errors.whole.rms > 0 ? fmt::format("{:.1f}", errors.whole.psnr_db()) : "");
    add(fmt::format("{:.3g}", errors.interior.rms));
    add(fmt::format("{:.3g}", errors.silhouette.rms));
    std::string fronts;
    for (std::size_t m = 0; m < kMeasureCount; ++m)
        if (point.on_front[m]) fronts += (fronts.empty() ? "" : ", ") + std::string(kMeasures[m].unit);
    add(fronts);
    return html + "</tr>\n";
}

std::string words_of(const Point& point) {
    return fmt::format("{} ({:.3g} ms)", escaped(point.choice.words()), 1000 * point.median_seconds());
}

std::string errors_of(const Error& error) { return fmt::format("rms {:.2g}, largest {:.2g}", error.rms, error.max); }

// Which choices are right, compared with the exact picture.
std::string answers(const Study& study, std::size_t series) {
    std::vector<const Point*> points = timed_points(study, series);
    if (points.empty()) return "";
    std::ranges::stable_sort(points, {}, [](const Point* point) { return point->median_seconds(); });
    const auto is_right = [](const Point* point) { return point->errors.whole.max <= kCode * (1 + 1e-6); };
    const auto first_right = std::ranges::find_if(points, is_right);
    const Point& fastest = *points.front();
    // The reference draws the exact picture itself, so it is no answer.
    const auto error_on_driver = [](const Point* point) {
        return point->choice.method == Method::kReference ? HUGE_VAL : point->errors.whole.rms;
    };
    const Point& most_accurate = **std::ranges::min_element(points, {}, error_on_driver);
    const std::string right =
        first_right == points.end()
            ? "No choice is within 1/255 of the exact picture at every pixel."
            : fmt::format(
                  "{} of {} choices are within 1/255 of the exact picture at every pixel; the fastest of them is {}.",
                  std::ranges::count_if(points, is_right), points.size(), words_of(**first_right));
    const std::string where = fmt::format(
        "The fastest choice of all, {}, has an rms error of {:.2g} inside shapes and of {:.2g} at outlines.",
        words_of(fastest), fastest.errors.interior.rms, fastest.errors.silhouette.rms);
    const std::string how_much =
        fmt::format("Over all pixels, its error is: {}. The most accurate choice on the driver, {}: {}.",
                    errors_of(fastest.errors.whole), words_of(most_accurate), errors_of(most_accurate.errors.whole));
    return fmt::format("<div class=\"verdict {}\">\n<p class=\"headline\">{}</p>\n<p>{}</p>\n<p>{}</p>\n</div>\n",
                       first_right == points.end() ? "partial" : "within", right, where, how_much);
}

std::string findings(const Study& study) {
    std::string html;
    for (std::size_t i = 0; i < study.series.size(); ++i) {
        const Series& series = study.series[i];
        if (study.series.size() > 1) html += fmt::format("<h3>{}</h3>\n", escaped(series.name));
        html += answers(study, i) + "<details><summary>The fastest choice for each error</summary>\n<ul>\n";
        for (const std::string& sentence : series.findings) html += "<li>" + escaped(sentence) + "</li>\n";
        html += "</ul></details>\n";
    }
    return html;
}

std::string machines(const Study& study) {
    std::string html;
    for (const Series& series : study.series) {
        if (study.series.size() > 1) html += fmt::format("<h3>{}</h3>\n", escaped(series.name));
        html += "<dl class=\"facts\">\n";
        const auto add = [&](const char* name, const std::string& words) {
            html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, escaped(words));
        };
        const Machine& machine = series.machine;
        add("Driver", series.driver);
        add("Processor",
            fmt::format("{}, {} {}", machine.processor, machine.cores, machine.cores == 1 ? "core" : "cores"));
        add("System", machine.system);
        add("Rounds", std::to_string(series.rounds));
        html += "</dl>\n";
    }
    return html;
}

std::string samples(const Study& study) {
    std::string html;
    for (const Series& series : study.series)
        if (series.spectral) html += spectral_section(*series.spectral, study.series.size() > 1 ? series.name : "");
    return html;
}

}  // namespace

std::string study_page(const Study& study) {
    using report::page_file;
    std::string rows;
    for (std::size_t i = 0; i < study.points.size(); ++i)
        if (study.points[i].is_timed()) rows += row(study, study.points[i], i);
    const std::string style = std::string(page_file("page.css")) + std::string(page_file("study.css"));
    return filled(page_file("study.html"),
                  {{"head", report::page_head(study.scene + ": what accuracy costs in time", style)},
                   {"scene", escaped(study.scene)},
                   {"size", fmt::format("{} &times; {}", study.width, study.height)},
                   {"machines", machines(study)},
                   {"findings", findings(study)},
                   {"plot", study_svg(study)},
                   {"columns", head_row(study)},
                   {"time_column", study.series.size() > 1 ? "2" : "1"},
                   {"rows", rows},
                   {"spectral", samples(study)},
                   {"data", page_data(study)},
                   {"chart", std::string(page_file("chart.js"))},
                   {"script", std::string(page_file("study.js"))}});
}

}  // namespace twinlight::study

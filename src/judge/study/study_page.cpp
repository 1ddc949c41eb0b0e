// index.html: src/judge/report/pages/study.html, filled in. Its script reads one JSON object: that of study.json, with
// pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text/json.h"
#include "base/text/page.h"
#include "judge/report/html.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace {

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
    Json data = parsed_json(study_json(study));
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
    std::string text = dumped(data), safe;
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

// Three sentences for each machine.
std::string findings(const Study& study) {
    std::string html;
    for (std::size_t i = 0; i < study.series.size(); ++i) {
        if (study.series.size() > 1) html += fmt::format("<h3>{}</h3>\n", escaped(study.series[i].name));
        html += "<ul class=\"findings\">\n";
        for (const std::string& sentence : headlines(study, i)) html += "<li>" + escaped(sentence) + "</li>\n";
        html += "</ul>\n";
    }
    return html;
}

// The fastest choice for each error, folded.
std::string recommendations(const Study& study) {
    std::string html;
    for (const Series& series : study.series) {
        html += fmt::format("<details>\n<summary>The fastest choice for each error{}</summary>\n<ul>\n",
                            study.series.size() > 1 ? ": " + escaped(series.name) : "");
        for (const std::string& sentence : series.findings) html += "<li>" + escaped(sentence) + "</li>\n";
        html += "</ul>\n</details>\n";
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
    std::size_t count = 0;
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        if (!study.points[i].is_timed()) continue;
        rows += row(study, study.points[i], i);
        ++count;
    }
    const std::string style = std::string(page_file("page.css")) + std::string(page_file("study.css"));
    return filled(page_file("study.html"),
                  {{"head", report::page_head(study.scene + ": what accuracy costs in time", style)},
                   {"scene", escaped(study.scene)},
                   {"size", fmt::format("{} &times; {}", study.width, study.height)},
                   {"machines", machines(study)},
                   {"findings", findings(study)},
                   {"recommendations", recommendations(study)},
                   {"plot", study_svg(study)},
                   {"columns", head_row(study)},
                   {"time_column", study.series.size() > 1 ? "2" : "1"},
                   {"rows", rows},
                   {"count", std::to_string(count)},
                   {"spectral", samples(study)},
                   {"data", page_data(study)},
                   {"chart", std::string(page_file("chart.js"))},
                   {"script", std::string(page_file("study.js"))}});
}

}  // namespace twinlight::study

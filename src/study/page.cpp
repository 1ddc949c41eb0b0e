// index.html: src/report/pages/study.html, filled.
#include <fmt/format.h>

#include "image/png.h"
#include "report/html.h"
#include "study/study.h"

namespace twinlight::study {

namespace {

std::string row(const Point& point, std::size_t number) {
    const auto [q1, q3] = point.quartiles_seconds();
    const std::string psnr = point.whole.rms > 0 ? fmt::format("{:.1f}", point.whole.psnr_db()) : "";
    return fmt::format(
        "<tr data-point=\"{}\" data-picture=\"{}\" data-difference=\"{}\" data-factor=\"{}\">"
        "<th scope=\"row\">{}</th><td>{:.3g}</td><td>{:.3g} to {:.3g}</td><td>{:.3g}</td><td>{:.3g}</td><td>{}</td>"
        "<td>{:.3g}</td><td>{:.3g}</td><td>{}</td></tr>\n",
        number, report::data_uri(encode_png(point.picture)), report::data_uri(encode_png(point.difference)),
        point.difference_factor, report::escaped(point.choice.words()), 1000 * point.median_seconds(), 1000 * q1,
        1000 * q3, point.whole.rms, point.whole.max, psnr, point.interior.rms, point.silhouette.rms,
        point.on_front ? "yes" : "");
}

}  // namespace

std::string study_page(const Study& study) {
    std::string rows, findings;
    for (std::size_t i = 0; i < study.points.size(); ++i)
        if (!study.points[i].seconds.empty()) rows += row(study.points[i], i);
    for (const std::string& sentence : study.findings) findings += "<li>" + report::escaped(sentence) + "</li>\n";
    return report::filled(report::page_file("study.html"),
                          {{"scene", report::escaped(study.scene)},
                           {"driver", report::escaped(study.driver)},
                           {"size", fmt::format("{} &times; {}", study.width, study.height)},
                           {"rounds", std::to_string(study.rounds)},
                           {"findings", findings},
                           {"plot", study_svg(study)},
                           {"truth", report::data_uri(encode_png(study.truth))},
                           {"rows", rows},
                           {"spectral", study.spectral ? spectral_section(*study.spectral) : ""},
                           {"style", std::string(report::page_file("page.css"))},
                           {"script", std::string(report::page_file("study.js"))}});
}

}  // namespace twinlight::study

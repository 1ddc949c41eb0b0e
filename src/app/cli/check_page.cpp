#include "app/cli/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/image/png.h"
#include "judge/report/html.h"

namespace twinlight::cli {

namespace {

using namespace check;
using report::escaped;

constexpr const char* kStyle = R"(
body { font: 15px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
section { border-top: 1px solid #8886; padding: .4rem 0; }
h3 { font: 600 1rem ui-monospace, monospace; margin: .4rem 0; }
p, ul, figure { margin: .2rem 0; }
pre { overflow-x: auto; padding: .5rem; background: #8882; }
img { width: 128px; height: 128px; image-rendering: pixelated; }
figure { display: inline-block; margin-right: 1rem; }
.verdict { display: inline-block; padding: 0 .5em; border-radius: .3em; margin-right: .5em; background: #8883; }
.departs { background: #e8a3; outline: 1px solid #c80; }
.NEW, .VANISHED { background: #d33; color: #fff; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; line-height: 1.1em; text-align: center; vertical-align: -.2em; margin-right: .4em; border: 1px solid #8888; }
)";

std::string swatch(const std::optional<Seen>& seen) {
    if (!seen || !std::holds_alternative<glm::dvec4>(*seen)) return "";
    const auto& color = std::get<glm::dvec4>(*seen);
    if (std::isnan(color.r + color.g + color.b)) return "<span class=\"swatch\">?</span>";
    const auto code = [&](int i) { return channel_code(static_cast<float>(std::clamp(color[i], 0.0, 1.0))); };
    return fmt::format("<span class=\"swatch\" style=\"background: rgb({}, {}, {})\"></span>", code(0), code(1),
                       code(2));
}

// Squares of two greys where nothing is drawn: no colour that is drawn looks like that.
Image with_ground(Image image) {
    const int square = std::max(1, image.width / 8);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Rgba& pixel = image.at(x, y);
            const float grey = (x / square + y / square) % 2 == 0 ? 0.35F : 0.65F;
            if (pixel == Rgba{0, 0, 0, 0}) pixel = {grey, grey, grey, 1};
        }
    return image;
}

std::string section_of(const Case& of, const Result& result) {
    std::string html = fmt::format("<section id=\"{0}\"><h3>{0}</h3>\n<p>", escaped(of.name));
    for (std::size_t path = 0; path < kPaths; ++path)
        html += fmt::format(R"(<span class="verdict {0}">{1}: {0}</span>)", word_of(result.outcomes.at(path)),
                            kPathNames.at(path));
    html += fmt::format("</p>\n<p><b>{}</b>: {}.</p>\n<p>{}</p>\n<p>Derived: {}</p>\n<ul>", escaped(of.what),
                        escaped(of.why), escaped(of.text), escaped(of.derived));
    for (const Expectation& expected : of.expectations)
        html +=
            fmt::format("<li>{}{}: {}{}</li>\n", swatch(expected.value), expected.spot.str(), text_of(expected.value),
                        expected.other == expected.value ? "" : " or " + text_of(expected.other));
    for (const Finding& finding : result.findings)
        html += fmt::format("<li>{}{}</li>\n", swatch(finding.value), escaped(finding_text(of, finding)));
    if (!result.error.empty()) html += "<li>refused: " + escaped(result.error) + "</li>\n";
    html += "</ul>\n";
    if (of.tolerance) html += fmt::format("<p>Tolerance: {}, {}</p>\n", *of.tolerance, escaped(of.tolerance_causes));
    for (const auto& [name, image] : result.pictures)
        html += fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                            escaped(name), report::data_uri(encode_png(with_ground(image))));
    return html + "<details><summary>the scene</summary><pre>" + escaped(of.scene_text) +
           "</pre></details></section>\n";
}

// Cases whose names begin with the same word are about the same.
std::string group_of(const Case& of) { return of.name.substr(0, of.name.find('-')); }

}  // namespace

std::string check_page(const std::string& driver, const std::vector<Case>& cases, const std::vector<Result>& results) {
    std::map<std::string, std::string> groups;
    for (std::size_t i = 0; i < cases.size(); ++i) groups[group_of(cases[i])] += section_of(cases[i], results[i]);
    std::string html = report::page_head("twinlight check", kStyle) + "<body>\n<h1>Hard cases</h1>\n<p>" +
                       escaped(driver) + "</p>\n<p>";
    for (const auto& [name, sections] : groups) html += fmt::format("<a href=\"#of-{0}\">{0}</a> ", escaped(name));
    html += fmt::format(
        "</p>\n<p>Pictures of cases about vertices have {0} by {0} pixels, those about pixels {1} by {1}; chequered is "
        "where nothing is drawn.</p>\n",
        kVertexSide, kSide);
    for (const auto& [name, sections] : groups)
        html += fmt::format("<h2 id=\"of-{0}\">{0}</h2>\n{1}", escaped(name), sections);
    return html + "</body>\n</html>\n";
}

}  // namespace twinlight::cli

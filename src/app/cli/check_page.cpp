#include "app/cli/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/image/png.h"
#include "judge/report/html.h"

namespace twinlight::cli {

namespace {

using namespace check;
using report::escaped;

// After page.css, which the comparison's page has too.
constexpr const char* kStyle = R"(
section { border-top: 1px solid var(--line); }
summary code { font: 600 .9375rem ui-monospace, monospace; }
.case { margin: 0 0 1rem 1.25rem; }
.case figure { display: inline-block; margin: .25rem 1rem .25rem 0; }
.case figure img { width: 128px; height: 128px; image-rendering: pixelated; }
.outcome { display: inline-block; padding: 0 .5em; border-radius: .3em; margin-left: .5em;
    font-size: .8125rem; background: #8883; }
.outcome.known-bug { background: #e8a3; outline: 1px solid #c80; }
.outcome.new-bug, .outcome.fixed-bug { background: #d33; color: #fff; }
.totals { display: flex; flex-wrap: wrap; gap: .5rem; margin: 1rem 0; }
.totals button { padding: .5rem .9rem; border: 1px solid var(--line); border-radius: .3rem; background: var(--raised);
    color: var(--ink); font: inherit; font-size: .875rem; text-align: left; cursor: pointer; }
.totals button b { display: block; font-size: 1.5rem; line-height: 1.2; }
.totals button.unexpected b { color: var(--bad); }
.totals button[aria-pressed=true] { border-color: var(--accent); box-shadow: inset 0 0 0 1px var(--accent); }
.search input { font: inherit; padding: .25rem .5rem; width: 16rem; max-width: 100%; }
.swatch { display: inline-block; width: 1.1em; height: 1.1em; line-height: 1.1em; text-align: center;
    vertical-align: -.2em; margin-right: .4em; border: 1px solid #8888; }
)";

// A link to a case opens it. The totals and the search box choose which cases are shown; a total that is pressed shows
// only its group.
constexpr const char* kScript = R"(
document.documentElement.classList.add("with-script");
const buttons = [...document.querySelectorAll(".totals button")];
const search = document.querySelector(".search input");
function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const pressed = buttons.filter((button) => button.getAttribute("aria-pressed") === "true");
    let shown = 0;
    for (const group of document.querySelectorAll(".group")) {
        const isChosen = pressed.length === 0 || pressed.some((button) => button.dataset.group === group.dataset.group);
        let inGroup = 0;
        for (const section of group.querySelectorAll("section")) {
            const text = section.querySelector("summary").textContent.toLowerCase();
            section.hidden = !isChosen || !words.every((word) => text.includes(word));
            inGroup += !section.hidden;
        }
        group.hidden = inGroup === 0;
        shown += inGroup;
    }
    document.querySelector(".search output").textContent = shown === 1 ? "1 case" : shown + " cases";
}
for (const button of buttons) {
    button.addEventListener("click", () => {
        button.setAttribute("aria-pressed", button.getAttribute("aria-pressed") !== "true");
        filter();
    });
}
search.addEventListener("input", filter);
filter();
function openTarget() {
    const section = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (section && section.hidden) {
        for (const button of buttons) button.setAttribute("aria-pressed", "false");
        search.value = "";
        filter();
    }
    const details = section && section.querySelector("details");
    if (details) details.open = true;
    if (section) section.scrollIntoView();
}
addEventListener("hashchange", openTarget);
openTarget();
)";

constexpr const char* kTerms = R"(<details><summary>What the words mean</summary>
<dl class="hint terms">
<dt>fixed</dt><dd>The driver&rsquo;s own fixed function, which runs the scene&rsquo;s commands.</dd>
<dt>shaders</dt><dd>Twinlight&rsquo;s shaders, on the same driver.</dd>
<dt>reference</dt><dd>Twinlight&rsquo;s software renderer, which uses no driver.</dd>
<dt>pass</dt><dd>The expected result.</dd>
<dt>known bug</dt><dd>A wrong result that the case lists for this driver.</dd>
<dt>our choice</dt><dd>The specification is silent: shaders and reference give the result that we
chose, the driver gives another one.</dd>
<dt>new bug</dt><dd>A wrong result that is not listed: unexpected.</dd>
<dt>fixed bug</dt><dd>The expected result where a known bug is listed: unexpected.</dd>
<dt>not tested</dt><dd>The case needs a feature that GL&rsquo;s fixed function lacks, or the driver may crash.</dd>
</dl></details>
<details><summary>What the symbols mean</summary>
<p class="hint">They are those of the OpenGL 2.1 specification, whose section numbers are given with each case. V is the
vertex, n its normal, P the light. VP is the unit vector from the vertex to the light, PV the opposite one, VPe the
unit vector to the viewer; h is the half vector between VP and VPe. k_0, k_1 and k_2 are the constant, linear and
quadratic attenuation, d is the distance to the light, att_i the attenuation factor. s is the direction of a
spotlight, c its cutoff, spot_i its factor. f_i is 1 where n . VP is above 0, and 0 elsewhere: it removes highlights
on the side away from the light. M is the modelview matrix. A denormal float is smaller than 1.2e-38 and has fewer
digits; a driver may round it to 0.</p></details>
)";

std::string swatch(const std::optional<Seen>& seen) {
    if (!seen || !std::holds_alternative<glm::dvec4>(*seen)) return "";
    const auto& color = std::get<glm::dvec4>(*seen);
    if (std::isnan(color.r + color.g + color.b)) return "<span class=\"swatch\">?</span>";
    const auto code = [&](int i) { return channel_code(static_cast<float>(std::clamp(color[i], 0.0, 1.0))); };
    return fmt::format("<span class=\"swatch\" style=\"background: rgb({}, {}, {})\"></span>", code(0), code(1),
                       code(2));
}

// A grey chequerboard where nothing is drawn: no case draws one.
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

// "known bug" as a class of the style.
std::string style_class(Outcome outcome) {
    std::string name(word_of(outcome));
    std::ranges::replace(name, ' ', '-');
    return name;
}

// For each renderer that does not pass.
std::string badges(const Result& result) {
    std::string html;
    for (std::size_t path = 0; path < kPaths; ++path) {
        const Outcome outcome = result.outcomes.at(path);
        if (outcome == Outcome::kPass) continue;
        html += fmt::format(R"( <span class="outcome {}">{}: {}</span>)", style_class(outcome), kPathNames.at(path),
                            word_of(outcome));
    }
    return html;
}

// The largest difference of a channel; infinite where a value is not finite. None for errors and missing values.
std::optional<double> difference_of(const Finding& finding) {
    if (!finding.value || !std::holds_alternative<glm::dvec4>(*finding.value)) return {};
    const auto& value = std::get<glm::dvec4>(*finding.value);
    const auto& expected = std::get<glm::dvec4>(finding.expected);
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
        const double difference = std::abs(value[i] - expected[i]);
        largest = std::isfinite(difference) ? std::max(largest, difference) : HUGE_VAL;
    }
    return largest;
}

std::string line_of(const Case& hard_case, const Finding& finding) {
    std::string text = escaped(finding_text(hard_case, finding));
    const std::optional<double> difference = difference_of(finding);
    if (difference && finding.outcome != Outcome::kFixedBug)
        text += std::isfinite(*difference) ? fmt::format("; off by {:.2g}", *difference) : "; not finite";
    return fmt::format("<li>{}<b>{}</b>: {}</li>\n", swatch(finding.value), word_of(finding.outcome), text);
}

std::string section_of(const Case& hard_case, const Result& result) {
    std::string html = fmt::format(
        "<section id=\"{0}\"><details{1}><summary><code>{0}</code> {2}{3}</summary>\n<div class=\"case\">\n",
        escaped(hard_case.name), result.fails() ? " open" : "", escaped(hard_case.what), badges(result));
    if (!result.error.empty()) html += "<p><b>Rejected:</b> " + escaped(result.error) + "</p>\n";
    if (!result.findings.empty()) {
        html += "<ul>\n";
        for (const Finding& finding : result.findings) html += line_of(hard_case, finding);
        html += "</ul>\n";
    }
    html += "<p><b>Expected:</b></p>\n<ul>\n";
    for (const Expectation& expected : hard_case.expectations)
        html +=
            fmt::format("<li>{}{}: {}{}</li>\n", swatch(expected.value), expected.spot.str(), text_of(expected.value),
                        expected.other == expected.value ? "" : " or " + text_of(expected.other));
    html += fmt::format(
        "</ul>\n<p><b>Why it is hard:</b> {}.</p>\n<p><b>What the specification says:</b> {}.</p>\n"
        "<p><b>How the expected values follow:</b> {}.</p>\n",
        escaped(hard_case.why), escaped(hard_case.text), escaped(hard_case.derived));
    if (hard_case.tolerance)
        html += fmt::format("<p><b>Tolerance:</b> {}: {}.</p>\n", *hard_case.tolerance,
                            escaped(hard_case.tolerance_causes));
    for (const auto& [name, image] : result.pictures)
        html += fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                            escaped(name), report::data_uri(encode_png(with_ground(image))));
    return html + "<details><summary>The scene</summary><pre>" + escaped(hard_case.scene_text) +
           "</pre></details>\n</div></details></section>\n";
}

struct Group {
    std::string title;
    std::string words;  // below its total
    std::vector<std::size_t> cases{};
};

// Each case once: unexpected results first, then by the result of the driver's fixed function.
std::vector<Group> grouped(const std::vector<Result>& results) {
    std::vector<Group> groups = {{"Unexpected results", "unexpected"},
                                 {"Known bugs of this driver", "known bugs of the driver"},
                                 {"Our choice, where the specification is silent", "our choice"},
                                 {"Passed", "passed"},
                                 {"Not tested on the driver: GL lacks these features, or it may crash", "not tested"}};
    const auto place_of = [](const Result& result) -> std::size_t {
        if (result.fails()) return 0;
        switch (result.outcomes[0]) {
            case Outcome::kNewBug:
            case Outcome::kFixedBug: return 0;
            case Outcome::kKnownBug: return 1;
            case Outcome::kOurChoice: return 2;
            case Outcome::kPass: return 3;
            case Outcome::kNotTested: return 4;
        }
        return 0;
    };
    for (std::size_t i = 0; i < results.size(); ++i) groups[place_of(results[i])].cases.push_back(i);
    return groups;
}

std::string counted(std::size_t count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

// The largest error of the driver's fixed function, and how often its result is not finite; empty where it has no
// errors.
std::string error_of_driver(const std::vector<Case>& cases, const std::vector<Result>& results) {
    double largest = 0;
    std::size_t worst = 0, not_finite = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        bool is_finite = true;
        for (const Finding& finding : results[i].findings) {
            if (finding.path != Path::kFixed || finding.outcome == Outcome::kOurChoice) continue;
            const double difference = difference_of(finding).value_or(0);
            is_finite = is_finite && std::isfinite(difference);
            if (!std::isfinite(difference) || difference <= largest) continue;
            largest = difference;
            worst = i;
        }
        not_finite += !is_finite;
    }
    std::string html;
    if (largest > 0)
        html = fmt::format(
            "The driver&rsquo;s largest error is {0:.2g} (1 is full brightness), in <a href=\"#{1}\">{1}</a>. ",
            largest, escaped(cases[worst].name));
    if (not_finite > 0)
        html += fmt::format("Its result is NaN or infinite in {}. ", counted(not_finite, "case", "cases"));
    return html;
}

// Whether anything is unexpected, and how large the errors are.
std::string verdict(const std::string& driver, const std::vector<Case>& cases, const std::vector<Result>& results,
                    const std::vector<Group>& groups) {
    const std::size_t unexpected = groups[0].cases.size(), bugs = groups[1].cases.size();
    const bool is_expected = unexpected == 0;
    const std::string all = counted(cases.size(), "case", "cases");
    const std::string headline =
        is_expected
            ? fmt::format("Nothing unexpected: {} of {} pass, {} this driver&rsquo;s known bugs.",
                          groups[3].cases.size(), all, bugs == 0 ? "and none shows" : fmt::format("{} show", bugs))
            : fmt::format("Unexpected results in {} of {}.", unexpected, all);
    double from_long_double = 0;
    for (const Result& result : results) from_long_double = std::max(from_long_double, result.from_long_double);
    const std::string unmeasured = compare::unmeasured_words(parse_driver_name(driver));
    return fmt::format(
        "<div class=\"verdict {}\">\n<p class=\"headline\">{}</p>\n<p>{}The shaders are at most {:.1e} away from the "
        "reference.{}</p>\n</div>\n",
        is_expected ? "within" : "beyond", headline, error_of_driver(cases, results), from_long_double,
        unmeasured.empty() ? "" : " " + escaped(unmeasured));
}

// The number of cases in each group; its button shows only that group.
std::string totals(const std::vector<Group>& groups) {
    std::string html = "<div class=\"totals\" role=\"group\" aria-label=\"Show only some results\">\n";
    for (std::size_t i = 0; i < groups.size(); ++i)
        html += fmt::format("<button type=\"button\" data-group=\"{}\" aria-pressed=\"false\"{}><b>{}</b>{}</button>\n",
                            i, i == 0 && !groups[i].cases.empty() ? " class=\"unexpected\"" : "",
                            groups[i].cases.size(), groups[i].words);
    return html + "</div>\n";
}

}  // namespace

std::string check_page(const std::string& driver, const std::vector<Case>& cases, const std::vector<Result>& results) {
    const std::vector<Group> groups = grouped(results);
    std::string html = report::page_head("twinlight check", std::string(report::page_file("page.css")) + kStyle);
    html +=
        "<body>\n<header>\n<p class=\"product\">Twinlight &middot; hard cases</p>\n<h1>Hard cases of lighting</h1>\n";
    html += verdict(driver, cases, results, groups) + totals(groups);
    html += fmt::format(
        "<p class=\"hint\">A hard case is a small scene whose right colours are known. Open a case to see its results, "
        "pictures and commands. Click a total to see only its cases.</p>\n"
        "<p class=\"search scripted\"><label>Search <input type=\"search\" placeholder=\"spot, GL_NORMALIZE "
        "...\"></label> <output></output></p>\n</header>\n<main>\n");
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].cases.empty()) continue;
        html += fmt::format("<div class=\"group\" data-group=\"{}\">\n<h2>{}: {}</h2>\n", i, groups[i].title,
                            counted(groups[i].cases.size(), "case", "cases"));
        for (const std::size_t one : groups[i].cases) html += section_of(cases[one], results[one]);
        html += "</div>\n";
    }
    html += fmt::format("<h2>About this page</h2>\n{}<dl class=\"facts\"><div><dt>Driver</dt><dd>{}</dd></div></dl>\n",
                        kTerms, escaped(driver));
    return html + fmt::format(
                      "<p class=\"hint\">The pictures have {0} by {0} pixels where a case tests vertices, and {1} by "
                      "{1} where it tests pixels. A grey chequerboard means that nothing is "
                      "drawn.</p>\n</main>\n<script>{2}</script>\n</body>\n</html>\n",
                      kVertexSide, kSide, kScript);
}

}  // namespace twinlight::cli

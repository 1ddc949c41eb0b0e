// The report's page: pages/page.html with its {{places}} filled.
//
// Tables and pictures are plain HTML, so that the page reads without its script too; the script adds the wipe
// and the magnifier to what stands there.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "judge/report/html.h"
#include "judge/report/report.h"
#include "judge/report/words.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Render;

namespace {

std::string image(const Comparison& comparison, std::string_view png, std::string_view attributes) {
    return fmt::format(R"(<img {} width="{}" height="{}" src="{}">)", attributes, comparison.width, comparison.height,
                       data_uri(png));
}

// A picture with its name below; `name` is also what the script's lists call it.
std::string figure(const Comparison& comparison, std::string_view png, const std::string& name, std::string_view kind,
                   std::string_view remark, std::string_view meaning) {
    return fmt::format("<figure>{}<figcaption>{} <span>{}</span><small>{}</small></figcaption></figure>\n",
                       image(comparison, png, fmt::format(R"(alt="{0}" data-name="{0}" data-kind="{1}")", name, kind)),
                       name, remark, meaning);
}

std::string cells(const RegionDifference& region) {
    const std::string worst =
        region.differing == 0
            ? "&ndash;"
            : fmt::format(R"(<button type="button" class="place" data-x="{0}" data-y="{1}">{0}, {1}</button>)",
                          region.worst_x, region.worst_y);
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>", grouped(region.differing),
                       share_of(region), codes_of(region.max),
                       region.rms == 0 ? "0" : fmt::format("{:.2e}", region.rms), worst);
}

std::string pair_rows(const Comparison& comparison) {
    std::string rows;
    for (const Pair& pair : comparison.pairs) {
        rows += fmt::format("<tr><th scope=\"row\">{0}<br>~ {1}</th><td class=\"verdict {2}\">{2}</td>{3}{4}</tr>\n",
                            comparison.a(pair).name, comparison.b(pair).name, word_of(pair.verdict),
                            cells(pair.difference.interior), cells(pair.difference.edge));
        if (!has_allowed_difference(pair)) continue;
        rows +=
            fmt::format("<tr><th scope=\"row\">beyond what is allowed</th><td></td>{}<td colspan=\"5\"></td></tr>\n",
                        cells(pair.difference.beyond_allowed));
    }
    return rows;
}

std::string verdict(const Comparison& comparison) {
    const std::vector<std::string> sentences = verdict_sentences(comparison);
    std::string html = "<p>" + escaped(sentences.front()) + "</p>";
    if (sentences.size() == 1) return html;
    html += "\n<ul>";
    for (std::size_t i = 1; i < sentences.size(); ++i) html += "<li>" + escaped(sentences[i]) + "</li>";
    return html + "</ul>";
}

std::string unsupported(const Comparison& comparison) {
    if (comparison.unsupported.empty()) return "<p>Every command of the scene is done by every renderer.</p>";
    std::string html = "<p>These pictures are not the whole scene:</p>\n<ul>";
    for (const Unsupported& item : comparison.unsupported) html += "<li>" + escaped(sentence_of(item)) + "</li>\n";
    return html + "</ul>";
}

std::string plan_rows(const Plan& plan) {
    std::string rows;
    const auto add = [&](std::string_view state, std::string_view what, std::string_view why) {
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"{}\">{}</td><td>{}</td></tr>\n", escaped(what),
                            state == "in" ? "within" : "informative", state, escaped(why));
    };
    for (const ExplainedLights& lights : explain_lights(plan)) add(lights.in ? "in" : "out", lights.names, lights.why);
    for (const LeftOut& left_out : plan.left_out) add("out", left_out.what, left_out.why);
    return rows;
}

// A section that opens for each picture that is drawn from plans. Of very many different plans the first are shown.
std::string plans(const Comparison& comparison) {
    constexpr std::size_t kShown = 100;
    std::string html;
    for (const Render& render : comparison.renders) {
        if (render.plan.empty()) continue;
        html += fmt::format("<details>\n<summary>{}: off by {}{}</summary>\n", render.name,
                            error_bound(render.plan) > 0 ? "at most " : "", in_codes(error_bound(render.plan)));
        for (std::size_t i = 0; i < std::min(render.plan.size(), kShown); ++i) {
            const ExplainedDraw& draw = render.plan[i];
            html += fmt::format(
                "<h3>{}</h3>\n<pre>{}</pre>\n<div class=\"scroll\"><table class=\"plan\"><tbody>\n{}"
                "</tbody></table></div>\n",
                escaped(name_of(draw)), escaped(describe(draw.plan.effects)), plan_rows(draw.plan));
        }
        if (render.plan.size() > kShown)
            html += fmt::format("<p>And {} plans more.</p>\n", render.plan.size() - kShown);
        html += "</details>\n";
    }
    return html.empty() ? "<p>Nothing is drawn from a plan.</p>" : html;
}

}  // namespace

std::string comparison_page(const Comparison& comparison, const EncodedPictures& pictures) {
    std::string renders, differences;
    for (std::size_t i = 0; i < comparison.renders.size(); ++i) {
        const Render& render = comparison.renders[i];
        renders += figure(comparison, pictures.renders[i], render.name, "render", fmt::format("{:.1f} ms", render.ms),
                          escaped(render.meaning));
    }
    for (std::size_t i = 0; i < comparison.pairs.size(); ++i) {
        const Pair& pair = comparison.pairs[i];
        differences += figure(comparison, pictures.differences[i], name_of(comparison, pair), "difference",
                              fmt::format("&times; {}", pair.factor), "");
    }
    return filled(
        page_file("page.html"),
        {{"head", page_head(comparison.scene + ": three renderers compared", std::string(page_file("page.css")))},
         {"scene", escaped(comparison.scene)},
         {"driver", escaped(comparison.driver)},
         {"size", fmt::format("{} &times; {}", comparison.width, comparison.height)},
         {"state", word_of(comparison.verdict())},
         {"verdict", verdict(comparison)},
         {"renders", renders},
         {"differences", differences},
         {"edges", image(comparison, pictures.edges, R"(id="edges" alt="" hidden)")},
         {"pair_rows", pair_rows(comparison)},
         {"interior_pixels", grouped(comparison.pairs.front().difference.interior.pixels)},
         {"edge_pixels", grouped(comparison.pairs.front().difference.edge.pixels)},
         {"tolerance", words_of(comparison.tolerance)},
         {"unsupported", unsupported(comparison)},
         {"plans", plans(comparison)},
         {"script", std::string(page_file("page.js"))}});
}

}  // namespace twinlight::report

// The report's page: pages/page.html, and pages/comparison.html for each comparison, with each {{name}} filled in.
//
// Tables and pictures are plain HTML, so that the page is readable without its script, which adds the wipe and the magnifiers,
// and shows one step of the scene at a time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text/page.h"
#include "judge/report/html.h"
#include "judge/report/report.h"
#include "judge/report/words.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Render;
using compare::Verdict;

namespace {

std::string image(const Comparison& comparison, std::string_view png, std::string_view attributes) {
    return fmt::format(R"(<img {} width="{}" height="{}" src="{}">)", attributes, comparison.width, comparison.height,
                       data_uri(png));
}

// The scene's labels, to lie over a picture of any size.
std::string labels(const Comparison& comparison) {
    if (comparison.labels.empty()) return "";
    constexpr double kSize = 17, kWidthOfACharacter = 0.6 * kSize;  // at most, so that no text leaves the picture
    std::string texts;
    for (const SceneLabel& label : comparison.labels) {
        const auto [x, y] = pixel_of(comparison, label);
        const double half =
            std::min(kWidthOfACharacter * static_cast<double>(label.text.size()), 1.0 * comparison.width) / 2;
        texts += fmt::format(R"(<text x="{:.0f}" y="{}">{}</text>)", std::clamp(1.0 * x, half, comparison.width - half),
                             std::clamp(1.0 * y, kSize / 2, comparison.height - kSize / 2), escaped(label.text));
    }
    return fmt::format(
        R"(<svg viewBox="0 0 {} {}" style="position:absolute;inset:0;width:100%;height:100%;pointer-events:none;)"
        R"(font:bold {}px sans-serif;fill:#fff;stroke:#000c;stroke-width:4px;paint-order:stroke;text-anchor:middle;)"
        R"(dominant-baseline:central">{}</svg>)",
        comparison.width, comparison.height, kSize, texts);
}

// A picture with its name below it, which the script's lists use too.
std::string figure(const Comparison& comparison, std::string_view png, const std::string& name, std::string_view kind,
                   std::string_view remark, std::string_view meaning) {
    return fmt::format(
        "<figure><div style=\"position:relative\">{}{}</div><figcaption>{} <span>{}</span><small>{}</small>"
        "</figcaption></figure>\n",
        image(comparison, png, fmt::format(R"(alt="{0}" data-name="{0}" data-kind="{1}")", name, kind)),
        labels(comparison), name, remark, meaning);
}

std::string cells(const RegionDifference& region) {
    const std::string worst =
        region.differing == 0
            ? "&ndash;"
            : fmt::format(R"(<button type="button" class="place" data-x="{0}" data-y="{1}">{0}, {1}</button>)",
                          region.worst_x, region.worst_y);
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>", grouped(region.differing),
                       share_of(region), in_255ths(region.max),
                       region.rms == 0 ? "0" : fmt::format("{:.2e}", region.rms), worst);
}

std::string pair_rows(const Comparison& comparison) {
    std::string rows;
    for (const Pair& pair : comparison.pairs) {
        rows += fmt::format("<tr><th scope=\"row\">{}<br>~ {}</th><td class=\"verdict {}\">{}</td>{}{}</tr>\n",
                            comparison.a(pair).name, comparison.b(pair).name, word_of(pair.verdict),
                            words_of(pair.verdict), cells(pair.difference.interior), cells(pair.difference.edge));
        if (!has_allowed_difference(pair)) continue;
        rows += fmt::format("<tr><th scope=\"row\">not allowed</th><td></td>{}<td colspan=\"5\"></td></tr>\n",
                            cells(pair.difference.beyond_allowed));
    }
    return rows;
}

// The headline, where pictures differ, and the details folded.
std::string verdict(const Comparison& comparison) {
    const Answer answers = answer(comparison);
    std::string html = fmt::format("<p class=\"headline\">{}</p>\n", escaped(answers.headline));
    if (!answers.where.empty()) html += fmt::format("<p>{}</p>\n", escaped(answers.where));
    if (answers.details.empty()) return html;
    html += "<details><summary>Details</summary>\n<ul>";
    for (const std::string& sentence : answers.details) html += "<li>" + escaped(sentence) + "</li>";
    return html + "</ul></details>\n";
}

// ---- The pairs that the page offers side by side ----

struct ShownPair {
    std::string left, right;  // names of pictures
    std::string words;        // of the button
    std::string says;         // sentences below the buttons, when the pair is shown
};

std::string differing_pixels(const RegionDifference& region) {
    if (region.differing == 0) return "away from edges, no pixel differs";
    return fmt::format("{} of {} pixels away from edges differ, by up to {}", grouped(region.differing),
                       grouped(region.pixels), in_255ths(region.max));
}

// Fixed function beside lighting at every pixel: what a shader adds.
ShownPair taught(const Comparison& comparison, const Pair& pair) {
    const RegionDifference& region = pair.difference.interior;
    const bool is_exact = comparison.b(pair).name.ends_with("-exact");
    const std::string result =
        region.differing == 0
            ? "In this scene they show the same."
            : fmt::format("They are meant to differ: in this scene by up to {}.", in_255ths(region.max));
    return {comparison.a(pair).name, comparison.b(pair).name,
            is_exact ? "Triangles, exact surfaces" : "Lit vertices, lit pixels",
            fmt::format("Left: the fixed function lights only the vertices. Right: shaders {}. {}",
                        is_exact ? "draw curved shapes exactly and light every pixel" : "light every pixel", result)};
}

// Two renderers of one model.
ShownPair compared(const Comparison& comparison, const Pair& pair, const char* words) {
    return {comparison.a(pair).name, comparison.b(pair).name, words,
            fmt::format("Both light only the vertices{}: {}.",
                        pair.verdict == Verdict::kPartial ? ", and one of them lacks a part of the scene"
                                                          : ", and should agree",
                        differing_pixels(pair.difference.interior))};
}

// The first is shown when the page opens.
std::vector<ShownPair> shown_pairs(const Comparison& comparison) {
    std::vector<ShownPair> shown;
    for (const Pair& pair : comparison.pairs)
        if (pair.verdict == Verdict::kInformative) shown.push_back(taught(comparison, pair));
    for (const Pair& pair : comparison.pairs) {
        const Render &a = comparison.a(pair), &b = comparison.b(pair);
        if (a.path != Path::kFixed || pair.verdict == Verdict::kInformative) continue;
        const bool is_shaders = b.path == Path::kProgrammable;
        shown.push_back(
            compared(comparison, pair, is_shaders ? "Fixed function, shaders" : "Fixed function, reference"));
        if (!is_shaders)
            shown.push_back({a.name, name_of(comparison, pair), "Their difference",
                             fmt::format("Right: how much the fixed function differs from the reference, multiplied by "
                                         "{}. Grey means equal; brighter means a larger difference.",
                                         pair.factor)});
    }
    return shown;
}

std::string buttons(const std::vector<ShownPair>& pairs) {
    std::string html;
    for (const ShownPair& pair : pairs)
        html += fmt::format("<button type=\"button\" data-left=\"{}\" data-right=\"{}\" data-says=\"{}\">{}</button>\n",
                            escaped(pair.left), escaped(pair.right), escaped(pair.says), escaped(pair.words));
    return html;
}

// The pixel that the page selects first: where lighting every pixel changes most; else the middle of the picture.
std::array<int, 2> first_pixel(const Comparison& comparison) {
    for (const Pair& pair : comparison.pairs) {
        const RegionDifference& region = pair.difference.interior;
        if (pair.verdict == Verdict::kInformative && region.differing > 0) return {region.worst_x, region.worst_y};
    }
    return {comparison.width / 2, comparison.height / 2};
}

std::string unsupported(const Comparison& comparison) {
    if (comparison.unsupported.empty()) return "<p>Every renderer draws every command of the scene.</p>";
    std::string html = "<p>Some pictures do not show the whole scene:</p>\n<ul>";
    for (const Unsupported& item : comparison.unsupported) html += "<li>" + escaped(sentence_of(item)) + "</li>\n";
    return html + "</ul>";
}

std::string warnings(const Comparison& comparison) {
    if (comparison.warnings.empty()) return "";
    std::string html = "<section>\n<h2>Possible mistakes in the scene</h2>\n<ul>\n";
    for (const compare::SceneWarning& warning : comparison.warnings)
        html += fmt::format("<li><code>{}</code><br>{}<br>To fix it: <code>{}</code></li>\n", escaped(warning.line),
                            escaped(warning.why), escaped(warning.fix));
    return html + "</ul>\n</section>\n";
}

// All of them in the order of their bits, for the page's script.
std::string words_of_whys() {
    std::string words;
    for (int bit = 0; bit < kWhys; ++bit)
        words += fmt::format("{}{}", bit == 0 ? "" : "|", words_of(static_cast<Why>(bit)));
    return words;
}

std::string notes(const Comparison& comparison) {
    if (comparison.notes.empty()) return "";
    std::string html = "<section>\n<h2>About this recording</h2>\n<ul>\n";
    for (const std::string& note : comparison.notes) html += "<li>" + escaped(note) + "</li>\n";
    return html + "</ul>\n</section>\n";
}

// What the scene's queries return; "" if it has none.
std::string queries(const Comparison& comparison) {
    if (comparison.queries.empty()) return "";
    std::string rows;
    for (const compare::Query& query : comparison.queries) {
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td><code>{}</code></td><td class=\"{}\">{}</td><td>{}</td></tr>\n",
            escaped(query.place.str()), escaped(query.call), query.agree ? "" : "beyond", escaped(query.state),
            escaped(query.driver));
    }
    return fmt::format(
        "<details open>\n<summary>What the scene&rsquo;s queries return</summary>\n<div class=\"scroll\"><table "
        "class=\"plan\">\n<thead><tr><th scope=\"col\">Place</th><th scope=\"col\">Query</th><th "
        "scope=\"col\">Twinlight</th><th scope=\"col\">Driver</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n"
        "</details>\n",
        rows);
}

std::string plan_rows(const Plan& plan) {
    std::string rows;
    const auto add = [&](std::string_view state, std::string_view what, std::string_view why) {
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"{}\">{}</td><td>{}</td></tr>\n", escaped(what),
                            state == "used" ? "within" : "informative", state, escaped(why));
    };
    for (const ExplainedLights& lights : explain_lights(plan))
        add(lights.in ? "used" : "skipped", lights.names, lights.why);
    for (const LeftOut& left_out : plan.left_out) add("skipped", left_out.what, left_out.why);
    return rows;
}

// A folded section for each picture that is drawn from plans, with the first kShown plans.
std::string plans(const Comparison& comparison) {
    constexpr std::size_t kShown = 100;
    std::string html;
    for (const Render& render : comparison.renders) {
        if (render.plan.empty()) continue;
        const double error = error_bound(render.plan);
        html += fmt::format("<details>\n<summary>{}: skipping effects changes {}</summary>\n", render.name,
                            error > 0 ? "a channel by at most " + in_codes(error) : "no pixel");
        for (std::size_t i = 0; i < std::min(render.plan.size(), kShown); ++i) {
            const ExplainedDraw& draw = render.plan[i];
            html += fmt::format(
                "<h3>{}</h3>\n<pre>{}</pre>\n<div class=\"scroll\"><table class=\"plan\"><tbody>\n{}"
                "</tbody></table></div>\n",
                escaped(name_of(draw)), escaped(describe(draw.plan.effects)), plan_rows(draw.plan));
        }
        if (render.plan.size() > kShown)
            html += fmt::format("<p>{} more are not shown.</p>\n", render.plan.size() - kShown);
        html += "</details>\n";
    }
    return html.empty() ? "<p>The shaders of these pictures skip nothing.</p>" : html;
}

std::string article(const Compared& compared, std::size_t number) {
    const Comparison& comparison = compared.comparison;
    const EncodedPictures& pictures = compared.pictures;
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
    const auto [x, y] = first_pixel(comparison);
    return filled(
        page_file("comparison.html"),
        {{"number", std::to_string(number)},
         {"x", std::to_string(x)},
         {"y", std::to_string(y)},
         {"title", compared.title.empty() ? "" : fmt::format("<h2>{}. {}</h2>\n", number, escaped(compared.title))},
         {"driver", escaped(comparison.driver)},
         {"size", fmt::format("{} &times; {}", comparison.width, comparison.height)},
         {"state", word_of(comparison.verdict())},
         {"verdict", verdict(comparison)},
         {"shown_pairs", buttons(shown_pairs(comparison))},
         {"labels", labels(comparison)},
         {"labels_switch", comparison.labels.empty() ? ""
                                                     : "<label class=\"check\"><input class=\"show-labels\" "
                                                       "type=\"checkbox\" checked> Labels</label>\n"},
         {"warnings", warnings(comparison)},
         {"notes", notes(comparison)},
         {"renders", renders},
         {"differences", differences},
         {"edges", image(comparison, pictures.edges, R"(class="edges" alt="" hidden)")},
         {"why", image(comparison, pictures.why,
                       fmt::format(R"(class="why" alt="" data-words="{}" hidden)", escaped(words_of_whys())))},
         {"pair_rows", pair_rows(comparison)},
         {"interior_pixels", grouped(comparison.pairs.front().difference.interior.pixels)},
         {"edge_pixels", grouped(comparison.pairs.front().difference.edge.pixels)},
         {"tolerance", words_of(comparison.tolerance)},
         {"open_if_unsupported", comparison.unsupported.empty() ? "" : " open"},
         {"unsupported", unsupported(comparison)},
         {"queries", queries(comparison)},
         {"plans", plans(comparison)}});
}

// A link to each step, with its largest difference; the script adds thumbnails.
std::string steps(const std::vector<Compared>& comparisons) {
    if (comparisons.size() == 1) return "";
    std::string html = "<nav class=\"steps\" aria-label=\"Steps of the scene\">\n";
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        const Comparison& comparison = comparisons[i].comparison;
        html += fmt::format("<a href=\"#step={0}\">{0}. {1}<span class=\"{2}\">largest difference {3}</span></a>\n",
                            i + 1, escaped(comparisons[i].title), word_of(comparison.verdict()),
                            in_255ths(largest_difference(comparison)));
    }
    return html + "</nav>\n";
}

}  // namespace

std::string comparison_page(const std::vector<Compared>& comparisons) {
    std::string articles;
    for (std::size_t i = 0; i < comparisons.size(); ++i) articles += article(comparisons[i], i + 1);
    const std::string& scene = comparisons.front().comparison.scene;
    return filled(page_file("page.html"),
                  {{"head", page_head(scene + ": three renderers compared", std::string(page_file("page.css")))},
                   {"scene", escaped(scene)},
                   {"steps", steps(comparisons)},
                   {"comparisons", articles},
                   {"script", std::string(page_file("page.js"))}});
}

}  // namespace twinlight::report

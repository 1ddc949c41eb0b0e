// comparison.json
#include "base/text/json.h"

#include "judge/report/report.h"
#include "judge/report/words.h"

namespace twinlight::report {

using compare::Comparison;
using compare::Pair;
using compare::Render;
using compare::Verdict;

namespace {

Json json_of(const RegionDifference& region) {
    return {{"pixels", region.pixels},
            {"differing", region.differing},
            {"max", region.max},
            {"rms", region.rms},
            {"worst", {region.worst_x, region.worst_y}}};
}

Json json_of(const compare::Judged& judged) {
    return {{"to_allowed_difference", judged.to_allowed},
            {"to_one_of_several_colors", judged.to_one_of},
            {"not_checked", judged.not_judged},
            {"drawn", judged.drawn},
            {"drawn_not_checked", judged.drawn_not_judged},
            {"drawn_widely_checked", judged.drawn_widely},
            {"undefined", judged.undefined},
            {"colors", {{"median", judged.colors.median}, {"95%", judged.colors.most}}},
            {"width", {{"median", judged.width.median}, {"95%", judged.width.most}}}};
}

Json json_of(const Comparison& comparison, const Pair& pair) {
    Json json = {{"a", comparison.a(pair).name},
                 {"b", comparison.b(pair).name},
                 {"interior", json_of(pair.difference.interior)},
                 {"beyond_slack", json_of(pair.difference.beyond_allowed)},
                 {"edge", json_of(pair.difference.edge)},
                 {"checked", json_of(pair.judged)},
                 {"verdict", word_of(pair.verdict)}};
    if (pair.verdict != Verdict::kInformative) {
        json["tolerance"] = {{"max", comparison.tolerance.max},
                             {"differing_share", comparison.tolerance.differing_share}};
    }
    json["file"] = difference_file(comparison, pair);
    json["factor"] = pair.factor;
    return json;
}

Json json_of(const Comparison& comparison) {
    Json json = {{"scene", comparison.scene},
                 {"driver", comparison.driver},
                 {"library", comparison.library},
                 {"size", {comparison.width, comparison.height}}};
    json["verdict"] = word_of(comparison.verdict());
    json["renders"] = Json::array();
    for (const Render& render : comparison.renders) {
        json["renders"].push_back({{"name", render.name}, {"file", picture_file(render)}, {"ms", render.ms}});
        if (!render.plan.empty()) json["renders"].back()["error_bound"] = error_bound(render.plan);
    }
    json["pairs"] = Json::array();
    for (const Pair& pair : comparison.pairs) json["pairs"].push_back(json_of(comparison, pair));
    json["driver_precision"] = {{"position", comparison.precision.position},
                                {"conversion", comparison.precision.conversion},
                                {"approximates_rho", comparison.precision.approximates_rho}};
    json["is_listed_driver"] = comparison.is_listed_driver;
    json["undefined"] = comparison.undefined;
    json["proved_causes"] = comparison.proved_causes;
    json["known_departures"] = comparison.known_departures;
    json["unsupported"] = Json::array();
    for (const Unsupported& unsupported : comparison.unsupported) {
        json["unsupported"].push_back({{"name", unsupported.name},
                                       {"count", unsupported.count},
                                       {"place", unsupported.first.str()},
                                       {"renderers", names_of(unsupported)}});
    }
    json["labels"] = Json::array();
    for (const SceneLabel& label : comparison.labels) {
        const auto [x, y] = pixel_of(comparison, label);
        json["labels"].push_back({{"text", label.text}, {"at", {x, y}}});
    }
    json["queries"] = Json::array();
    for (const compare::Query& query : comparison.queries) {
        json["queries"].push_back({{"place", query.place.str()},
                                   {"call", query.call},
                                   {"twinlight", query.state},
                                   {"driver", query.driver},
                                   {"agree", query.agree}});
    }
    json["warnings"] = Json::array();
    for (const compare::SceneWarning& warning : comparison.warnings) json["warnings"].push_back(warning.line);
    json["notes"] = comparison.notes;
    return json;
}

// A scene's name may hold any bytes; JSON is UTF-8.
}  // namespace

std::string comparison_json(const Comparison& comparison) { return dumped_lines(json_of(comparison)); }

compare::Verdict verdict_of(const std::vector<ComparedStep>& steps) {
    Verdict worst = Verdict::kWithin;
    for (const ComparedStep& step : steps) {
        worst = std::max(worst, step.comparison.verdict());
    }
    return worst;
}

std::string steps_json(const std::vector<ComparedStep>& steps) {
    const Comparison& first = steps.front().comparison;
    Json json = {{"scene", first.scene},
                 {"driver", first.driver},
                 {"library", first.library},
                 {"size", {first.width, first.height}},
                 {"verdict", word_of(verdict_of(steps))},
                 {"steps", Json::array()}};
    for (std::size_t i = 0; i < steps.size(); ++i)
        json["steps"].push_back({{"number", i + 1},
                                 {"title", steps[i].title},
                                 {"folder", step_folder(i)},
                                 {"comparison", json_of(steps[i].comparison)}});
    return dumped_lines(json);
}

}  // namespace twinlight::report

// study.json and study.csv.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/study.h"

namespace twinlight::study {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Error& error) {
    Json json = {{"pixels", error.pixels}, {"max", error.max}, {"rms", error.rms}};
    json["psnr_db"] = error.rms > 0 ? Json(error.psnr_db()) : Json(nullptr);
    return json;
}

const char* name_of(Tier tier) { return tier == Tier::kBaked ? "baked" : "uniform"; }

Json json_of(const Point& point) {
    const Choice& choice = point.choice;
    const auto [q1, q3] = point.quartiles_seconds();
    Json json = {{"key", choice.key()},
                 {"words", choice.words()},
                 {"renderer", choice.renderer},
                 {"shading", study::name_of(choice.shading)}};
    json["tier"] = choice.renderer == "programmable" ? Json(name_of(choice.tier)) : Json(nullptr);
    json["slices"] = choice.slices > 0 ? Json(choice.slices) : Json(nullptr);
    json["budget"] = choice.budget;
    json["seconds"] = {{"median", point.median_seconds()}, {"q1", q1}, {"q3", q3}, {"samples", point.seconds.size()}};
    json["error"] = {{"whole", json_of(point.whole)},
                     {"interior", json_of(point.interior)},
                     {"silhouette", json_of(point.silhouette)}};
    json["on_front"] = point.on_front;
    return json;
}

}  // namespace

std::string study_json(const Study& study) {
    Json json = {{"scene", study.scene},   {"driver", study.driver},  {"size", {study.width, study.height}},
                 {"rounds", study.rounds}, {"points", Json::array()}, {"findings", study.findings}};
    for (const Point& point : study.points) json["points"].push_back(json_of(point));
    if (study.spectral) json["spectral"] = Json::parse(spectral_json(*study.spectral));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string study_csv(const Study& study) {
    std::string text =
        "key,renderer,shading,slices,budget,seconds_median,seconds_q1,seconds_q3,rms,max,interior_rms,interior_max,"
        "silhouette_rms,silhouette_max,on_front\n";
    for (const Point& point : study.points) {
        const Choice& choice = point.choice;
        const auto [q1, q3] = point.quartiles_seconds();
        text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n",
                            choice.key(), choice.renderer, study::name_of(choice.shading), choice.slices, choice.budget,
                            point.median_seconds(), q1, q3, point.whole.rms, point.whole.max, point.interior.rms,
                            point.interior.max, point.silhouette.rms, point.silhouette.max, point.on_front ? 1 : 0);
    }
    return text;
}

}  // namespace twinlight::study

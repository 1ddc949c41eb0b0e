// study.json and study.csv.
#include <fmt/format.h>

#include "base/text/json.h"
#include "judge/study/study.h"

namespace twinlight::study {

namespace {

Json json_of(const Error& error) {
    Json json = {{"pixels", error.pixels}};
    for (const Measure& measure : kMeasures) json[measure.name] = error.*measure.value;
    json["psnr_db"] = error.rms > 0 ? Json(error.psnr_db()) : Json(nullptr);
    return json;
}

Json json_of(const Series& series) {
    Json json = {
        {"name", series.name},
        {"machine",
         {{"processor", series.machine.processor}, {"cores", series.machine.cores}, {"system", series.machine.system}}},
        {"driver", series.driver},
        {"library", series.library},
        {"rounds", series.rounds},
        {"findings", series.findings}};
    if (series.spectral) json["spectral"] = parsed_json(spectral_json(*series.spectral));
    return json;
}

Json value_of(const Axis& axis, const Choice& choice) {
    const std::string key = axis.value(choice).key;
    if (axis.is_number) return key.empty() ? Json(nullptr) : parsed_json(key);
    return key;
}

Json json_of(const Study& study, const Point& point) {
    const Choice& choice = point.choice;
    Json json = {{"series", point.series}, {"key", choice.key()}, {"words", choice.words()}};
    for (const Axis& axis : axes()) json["axes"][axis.name] = value_of(axis, choice);
    const auto [q1, q3] = point.quartiles_seconds();
    json["seconds"] = {{"median", nullptr}, {"q1", nullptr}, {"q3", nullptr}, {"samples", point.seconds}};
    if (point.is_timed()) json["seconds"].update({{"median", point.median_seconds()}, {"q1", q1}, {"q3", q3}});
    for (const Region& region : kRegions) json["error"][region.name] = json_of(point.errors.*region.errors);
    json["front"] = Json::array();
    for (std::size_t m = 0; m < kMeasureCount; ++m)
        if (point.on_front[m]) json["front"].push_back(kMeasures[m].name);
    const bool has_picture = !point.picture_png.empty();
    json["picture"] = has_picture ? Json(picture_file(study, point)) : Json(nullptr);
    json["difference"] = has_picture ? Json(difference_file(study, point)) : Json(nullptr);
    json["difference_factor"] = point.difference_factor;
    return json;
}

std::string number(const Study& study, std::size_t series) {
    return study.series.size() > 1 ? std::to_string(series + 1) + "-" : "";
}

std::string picture_name(const Study& study, const Point& point, const char* what) {
    return "pictures/" + number(study, point.series) + point.choice.key() + what + ".png";
}

}  // namespace

std::string picture_file(const Study& study, const Point& point) { return picture_name(study, point, ""); }
std::string difference_file(const Study& study, const Point& point) {
    return picture_name(study, point, "-difference");
}

std::string spectral_file(const Study& study, std::size_t series) { return number(study, series) + "spectral.svg"; }

std::string sampled_picture_file(const Study& study, std::size_t series, int samples) {
    return fmt::format("pictures/{}samples-{}.png", number(study, series), samples);
}

std::string study_json(const Study& study) {
    Json json = {{"format", kFormat},
                 {"version", kFormatVersion},
                 {"scene", study.scene},
                 {"fingerprint", study.fingerprint},
                 {"size", {study.width, study.height}},
                 {"extent", name_of(study.extent)},
                 {"coverage", study.coverage},
                 {"series", Json::array()},
                 {"points", Json::array()}};
    for (const Series& series : study.series) json["series"].push_back(json_of(series));
    for (const Point& point : study.points) json["points"].push_back(json_of(study, point));
    return dumped_lines(json);
}

std::string study_csv(const Study& study) {
    std::string text = "series,key";
    for (const Axis& axis : axes()) text += std::string(",") + axis.name;
    text += ",seconds_median,seconds_q1,seconds_q3,rounds";
    for (const Region& region : kRegions)
        for (const Measure& measure : kMeasures) text += fmt::format(",{}_{}", region.name, measure.name);
    for (const Measure& measure : kMeasures) text += fmt::format(",front_{}", measure.name);
    text += "\n";
    for (const Point& point : study.points) {
        text += fmt::format("{},{}", point.series, point.choice.key());
        for (const Axis& axis : axes()) text += "," + axis.value(point.choice).key;
        const auto [q1, q3] = point.quartiles_seconds();
        text += point.is_timed() ? fmt::format(",{:.6g},{:.6g},{:.6g}", point.median_seconds(), q1, q3) : ",,,";
        text += fmt::format(",{}", point.seconds.size());
        for (const Region& region : kRegions)
            for (const Measure& measure : kMeasures)
                text += fmt::format(",{:.6g}", point.errors.*region.errors.*measure.value);
        for (const bool on_front : point.on_front) text += on_front ? ",1" : ",0";
        text += "\n";
    }
    return text;
}

}  // namespace twinlight::study

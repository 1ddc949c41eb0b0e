#include "app/web/page_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/session/probe.h"
#include "app/session/probe_arrows.h"
#include "base/text/json.h"

namespace twinlight::web {

namespace {

Json rows_json(const std::vector<session::SumRow>& rows) {
    Json json = Json::array();
    for (const session::SumRow& row : rows)
        json.push_back({{"sign", row.sign},
                        {"what", row.what},
                        {"how", row.how},
                        {"color", {row.color.x, row.color.y, row.color.z}},
                        {"is_result", row.is_result}});
    return json;
}

const char* word_of(session::ProbeArrow::Kind kind) {
    using Kind = session::ProbeArrow::Kind;
    switch (kind) {
        case Kind::kNormal: return "normal";
        case Kind::kViewer: return "viewer";
        case Kind::kLight: return "light";
        case Kind::kHighlight: return "highlight";
    }
    return "";
}

Json arrows_json(const session::ProbeArrows& arrows) {
    Json json = Json::array();
    const auto from = arrows.place_of(arrows.place_eye);
    for (const session::ProbeArrow& arrow : arrows.arrows)
        if (const auto to = arrows.place_of(arrows.tip_eye(arrow)); from && to)
            json.push_back({{"kind", word_of(arrow.kind)},
                            {"name", arrow.name},
                            {"from", {from->x, from->y}},
                            {"to", {to->x, to->y}}});
    return json;
}

}  // namespace

std::string probed(const Scene& scene, const Look& look, int x, int y) {
    Json json = {{"heading", ""}, {"rows", Json::array()}, {"mean", Json::array()}, {"arrows", Json::array()}};
    const session::ProbeAnswer answer = session::answer_probe(scene, look, {.x = x, .y = y});
    const auto fragments = session::fragments_of(scene, answer);
    if (fragments.empty()) return dumped(json);
    const std::size_t fragment = session::main_fragment(fragments);
    const auto points = session::points_of(scene, answer, fragment);
    if (!fragments[fragment].is_lit || points.empty()) return dumped(json);
    const session::ProbePoint& point = *std::ranges::max_element(points, {}, &session::ProbePoint::weight);
    json["heading"] = fmt::format("The equation at {}: {}", point.name, fragments[fragment].name);
    json["rows"] = rows_json(session::sum_rows(point.derivation, {}));
    json["mean"] = rows_json(session::mean_rows(points));
    json["arrows"] = arrows_json(session::arrows_of(point.derivation, {}, 0));
    return dumped(json);
}

}  // namespace twinlight::web

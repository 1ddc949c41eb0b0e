#include "app/session/accuracy.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/translation.h"

namespace twinlight::session {
namespace {

constexpr int kSlices[] = {8, 12, 16, 24, 32, 48, 64, 96, 128};

const char* words_of(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return "Flat";
        case Shading::kGouraud: return "Gouraud";
        case Shading::kPhong: return "Phong";
        case Shading::kExact: return "Exact surfaces";
    }
    return "";
}

std::string in_codes(double error) { return fmt::format("{:.2g}/255", 255 * error); }
std::string in_ms(double ms) { return fmt::format("{:.2f} ms", ms); }

// The row of a shading with the fewest slices that is accurate enough; null if no row is.
const AccuracyRow* cheapest(const std::vector<AccuracyRow>& rows, const std::string& shading) {
    const AccuracyRow* best = nullptr;
    for (const AccuracyRow& row : rows)
        if (row.shading == shading && row.is_enough && (!best || row.slices < best->slices)) best = &row;
    return best;
}

// "Gouraud needs 48 slices (2.10 ms)."
std::string demand(const std::vector<AccuracyRow>& rows, const std::string& shading) {
    const AccuracyRow* best = cheapest(rows, shading);
    if (best && best->slices > 0) return tr("{} needs {} slices ({}).", tr(shading), best->slices, in_ms(best->ms));
    if (best) return tr("{} is enough ({}).", tr(shading), in_ms(best->ms));
    const AccuracyRow* nearest = nullptr;
    for (const AccuracyRow& row : rows)
        if (row.shading == shading && (!nearest || row.error < nearest->error)) nearest = &row;
    if (!nearest) return "";
    return nearest->slices > 0
               ? tr("{} is not accurate enough: with {} slices its error is {}.", tr(shading), nearest->slices,
                    in_codes(nearest->error))
               : tr("{} is not accurate enough: its error is {}.", tr(shading), in_codes(nearest->error));
}

}  // namespace

std::vector<study::Choice> accuracy_choices(const Frame& frame, bool has_slices) {
    std::vector<study::Choice> choices;
    for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
        if (!has_slices) choices.push_back({.shading = shading});
        for (const int slices : kSlices)
            if (has_slices) choices.push_back({.shading = shading, .slices = slices});
    }
    if (std::ranges::any_of(frame.draws(), &Draw::has_exact_surfaces)) choices.push_back({.shading = Shading::kExact});
    return choices;
}

std::vector<AccuracyRow> accuracy_rows(const study::Study& study, double target) {
    std::vector<AccuracyRow> rows;
    for (const study::Point& point : study.points) {
        if (!point.is_timed()) continue;
        const double error = point.errors.whole.rms;
        rows.push_back({words_of(point.choice.shading), point.choice.slices, error, 1000 * point.median_seconds(),
                        error <= target});
    }
    return rows;
}

std::string accuracy_sentence(const std::vector<AccuracyRow>& rows, double target) {
    if (rows.empty()) return "";
    std::string text = tr("For an error of at most {}:", in_codes(target));
    std::vector<const AccuracyRow*> meshes;
    for (const char* shading : {"Gouraud", "Phong"}) {
        const std::string sentence = demand(rows, shading);
        if (!sentence.empty()) text += tr(" ") + sentence;
        if (const AccuracyRow* best = cheapest(rows, shading)) meshes.push_back(best);
    }
    const auto exact = std::ranges::find(rows, "Exact surfaces", &AccuracyRow::shading);
    if (exact == rows.end()) return text;
    if (!exact->is_enough)
        return text + tr(" Exact surfaces are not accurate enough: their error is {}.", in_codes(exact->error));
    const auto faster = std::ranges::count_if(meshes, [&](const AccuracyRow* row) { return exact->ms < row->ms; });
    const std::string ms = in_ms(exact->ms);
    if (meshes.empty()) return text + tr(" Exact surfaces take {}.", ms);
    if (faster == static_cast<std::ptrdiff_t>(meshes.size()))
        return text + (meshes.size() == 1 ? tr(" Exact surfaces take {}, which is faster.", ms)
                                          : tr(" Exact surfaces take {}, which is faster than both.", ms));
    return text + (faster > 0 ? tr(" Exact surfaces take {}, which is between the two.", ms)
                              : tr(" Exact surfaces take {}, which is slower.", ms));
}

}  // namespace twinlight::session

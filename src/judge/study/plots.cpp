// study.svg: error against time on logarithmic axes, with a dot for each choice and a line for the front.
// shading.svg, outlines.svg, changes.svg: one finding each, from the points of the first machine.
// spectral.svg: Delta E for each light against the number of samples, and against their time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <iterator>

#include "judge/study/plot.h"
#include "judge/study/study.h"
#include "render/context/driver_name.h"
#include "render/look.h"

namespace twinlight::study {

namespace {

// ---- A study ----

// A colour for each method, or with several machines for each machine. The mark shows the shading.
constexpr Method kColoredMethods[] = {Method::kFixed, Method::kUniforms, Method::kConstants, Method::kReference,
                                      Method::kPrecise};

std::size_t color_number(const Study& study, const Point& point) {
    if (study.series.size() > 1) return point.series;
    return static_cast<std::size_t>(std::ranges::find(kColoredMethods, point.choice.method) -
                                    std::begin(kColoredMethods));
}

Mark mark_of(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return Mark::kSquare;
        case Shading::kGouraud: return Mark::kTriangle;
        case Shading::kPhong: return Mark::kCircle;
        case Shading::kExact: return Mark::kDiamond;
    }
    return {};
}

std::vector<PlotSeries> legend_of(const Study& study) {
    std::vector<PlotSeries> rows;
    const auto add_color = [&](const std::string& words) {
        rows.push_back({.mark = Mark::kSquare, .color = plot_color(rows.size()), .words = words});
    };
    if (study.series.size() > 1)
        for (const Series& series : study.series) add_color(series.name);
    else
        for (const Method method : kColoredMethods) add_color(axes()[0].value({.method = method}).words);
    rows.emplace_back();
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud, Shading::kPhong, Shading::kExact})
        rows.push_back({.mark = mark_of(shading), .color = "#444", .words = name_of(shading)});
    rows.emplace_back();
    rows.push_back({.mark = Mark::kCircle, .color = "#444", .filled = false, .words = "drawn in an unusual way"});
    rows.push_back({.line = Line::kDashed, .words = "nothing is both faster"});
    rows.push_back({.words = "and more accurate"});
    return rows;
}

glm::dvec2 value_of(const Point* point) { return {1000 * point->median_seconds(), point->errors.whole.rms}; }

}  // namespace

std::string study_svg(const Study& study) {
    constexpr std::size_t kRms = 0;  // of kMeasures
    std::vector<const Point*> points;
    for (const Point& point : study.points)
        if (point.is_timed() && point.errors.whole.rms > 0) points.push_back(&point);
    std::ranges::stable_sort(points, {}, [](const Point* point) { return value_of(point).x; });

    std::vector<PlotSeries> fronts(study.series.size(), {.line = Line::kDashed}), dots;
    glm::dvec2 least(1), most(1);
    for (const Point* point : points) {
        const Choice& choice = point->choice;
        const glm::dvec2 value = value_of(point);
        least = point == points.front() ? value : glm::min(least, value);
        most = point == points.front() ? value : glm::max(most, value);
        if (point->on_front[kRms]) fronts[point->series].values.push_back(value);
        const Choice plain{.method = choice.method, .shading = choice.shading, .slices = choice.slices};
        dots.push_back({.values = {value},
                        .mark = mark_of(choice.shading),
                        .color = plot_color(color_number(study, *point)),
                        .filled = choice == plain,
                        .words = fmt::format("{}: {:.3g} ms, rms {:.3g}", choice.words(), value.x, value.y)});
    }
    fronts.insert(fronts.end(), dots.begin(), dots.end());
    const std::string where = study.series.size() == 1 ? parse_driver_name(study.series[0].driver).renderer
                                                       : fmt::format("{} drivers", study.series.size());
    return plot_svg(fmt::format("{}: {} ({} x {}, {})", study.scene,
                                points.empty() ? "nothing was timed" : "what accuracy costs in time", study.width,
                                study.height, where),
                    {580, 448},
                    {{.x = decades(least.x, most.x, "time of a frame, ms"),
                      .y = decades(least.y, most.y, "rms error of a channel, 0 to 1"),
                      .series = fronts}},
                    legend_of(study));
}

// ---- One finding each ----

namespace {

constexpr glm::dvec2 kPanel = {420, 300};
constexpr Shading kMeshShadings[] = {Shading::kFlat, Shading::kGouraud, Shading::kPhong};

// The points of the first machine that shaders with uniforms drew in the usual way, from few slices to many.
std::vector<const Point*> usual_points(const Study& study, Shading shading) {
    std::vector<const Point*> points;
    for (const Point* point : timed_points(study, 0)) {
        const Choice usual{.method = Method::kUniforms, .shading = shading, .slices = point->choice.slices};
        if (point->choice == usual) points.push_back(point);
    }
    std::ranges::stable_sort(points, {}, [](const Point* point) { return point->choice.slices; });
    return points;
}

// Errors of 0 have no place on a logarithmic axis.
template <class Value>
PlotSeries curve(const std::vector<const Point*>& points, const PlotSeries& look, const Value& value) {
    PlotSeries result = look;
    for (const Point* point : points)
        if (const glm::dvec2 at = value(*point); at.y > 0) result.values.push_back(at);
    return result;
}

// A panel around all values; empty if there are fewer than two.
std::string plot_of(std::string_view title, PlotAxis x, const char* y_words, const std::vector<PlotSeries>& series) {
    std::vector<double> ys;
    for (const PlotSeries& one : series)
        for (const glm::dvec2& at : one.values) ys.push_back(at.y);
    if (ys.size() < 2) return "";
    const auto [low, high] = std::ranges::minmax(ys);
    std::vector<PlotSeries> legend = series;
    for (PlotSeries& row : legend) row.values.clear();
    return plot_svg(title, kPanel, {{.x = std::move(x), .y = decades(low, high, y_words), .series = series}}, legend);
}

}  // namespace

std::string shading_svg(const Study& study) {
    std::vector<PlotSeries> series;
    std::vector<double> times;
    const auto add = [&](Shading shading, Line line) {
        const auto points = usual_points(study, shading);
        for (const Point* point : points) times.push_back(1000 * point->median_seconds());
        series.push_back(curve(
            points,
            {.mark = mark_of(shading),
             .line = line,
             .color = plot_color(series.size()),
             .words = line == Line::kNone ? "exact surfaces" : name_of(shading)},
            [](const Point& point) { return glm::dvec2(1000 * point.median_seconds(), point.errors.whole.delta_e); }));
    };
    for (const Shading shading : kMeshShadings) add(shading, Line::kSolid);
    add(Shading::kExact, Line::kNone);
    if (times.size() < 2) return "";
    const auto [shortest, longest] = std::ranges::minmax(times);
    return plot_of("Shading by triangles, from few slices to many, and exact surfaces",
                   decades(shortest, longest, "time of a frame, ms"), "mean Delta E 2000", series);
}

std::string outlines_svg(const Study& study) {
    std::vector<PlotSeries> series;
    std::vector<double> slices;
    const auto add = [&](const std::vector<const Point*>& points, const Region& region, const char* words,
                         const PlotSeries& look) {
        series.push_back(curve(points, look, [&](const Point& point) {
            return glm::dvec2(point.choice.slices, (point.errors.*region.errors).rms);
        }));
        series.back().words = words;
    };
    const auto phong = usual_points(study, Shading::kPhong), gouraud = usual_points(study, Shading::kGouraud);
    for (const Point* point : phong)
        if (point->choice.slices > 0) slices.push_back(point->choice.slices);
    if (slices.size() < 2) return "";
    const auto& [whole, interior, silhouette] = kRegions;
    add(phong, silhouette, "at outlines, phong", {.mark = Mark::kSquare, .line = Line::kSolid, .color = plot_color(0)});
    add(gouraud, interior, "inside shapes, gouraud",
        {.mark = Mark::kTriangle, .line = Line::kSolid, .color = plot_color(1)});
    add(phong, interior, "inside shapes, phong", {.mark = Mark::kCircle, .line = Line::kSolid, .color = plot_color(4)});
    for (const Point* point : usual_points(study, Shading::kExact)) {
        const double rms = point->errors.whole.rms;
        if (rms > 0)
            series.push_back({.values = {{slices.front(), rms}, {slices.back(), rms}},
                              .line = Line::kDashed,
                              .words = "exact surfaces"});
    }
    return plot_of("Error inside shapes and at their outlines",
                   {.low = slices.front(), .high = slices.back(), .ticks = slices, .words = "slices of a round shape"},
                   "rms error, 0 to 1", series);
}

std::string changes_svg(const Study& study) {
    std::vector<Bar> bars;
    const auto points = timed_points(study, 0);
    const auto changed = [](const Point* point) {
        return point->choice.lighting_change != LightingChange::kWhole && point->choice.shading == Shading::kPhong;
    };
    const auto first = std::ranges::find_if(points, changed);
    if (first == points.end()) return "";
    for (const Point* point : points) {
        Choice usual = point->choice;
        usual.lighting_change = (*first)->choice.lighting_change;
        if (usual != (*first)->choice) continue;
        const auto& row =
            *std::ranges::find(lighting_changes(), point->choice.lighting_change, &LightingChangeRow::value);
        const bool is_whole = point->choice.lighting_change == LightingChange::kWhole;
        bars.push_back({is_whole ? "all of the lighting" : row.words, point->errors.whole.rms});
    }
    std::ranges::stable_sort(bars, std::greater{}, &Bar::value);
    return bars_svg(
        fmt::format("rms error, phong{}, with one change of the lighting",
                    (*first)->choice.slices > 0 ? fmt::format(" with {} slices", (*first)->choice.slices) : ""),
        bars);
}

// ---- Samples of the spectrum ----

namespace {

constexpr double kLowest = 0.01;  // Delta E; the lower end of the axis

// The time of a picture with this many samples at every pixel, relative to red, green and blue; 0 if it was not
// measured.
double cost_of(const SpectralStudy& study, int samples) {
    const auto time_of = [&](int count) {
        const auto found = std::ranges::find(study.pictures, count, &SampledPicture::samples);
        return found == study.pictures.end() ? 0 : median(found->reference_seconds);
    };
    return time_of(0) > 0 ? time_of(samples) / time_of(0) : 0;
}

}  // namespace

std::string spectral_svg(const SpectralStudy& study) {
    double longest = 2;
    for (const SampledPicture& picture : study.pictures) longest = std::max(longest, cost_of(study, picture.samples));
    std::vector<double> costs;
    for (double tick = 1; tick <= longest; tick *= 2) costs.push_back(tick);
    const PlotAxis delta_e{.low = kLowest, .high = 10, .ticks = {kLowest, 0.1, 1, 10}};
    Panel by_samples{.x = {.low = 3,
                           .high = 81,
                           .ticks = {3, 5, 9, 16, 31, 81},
                           .words = "samples (dashed: only red, green and blue)"},
                     .y = delta_e};
    Panel by_cost{.x = {.low = 1,
                        .high = longest,
                        .ticks = costs,
                        .words = "time of the reference, relative to red, green and blue"},
                  .y = delta_e};
    std::vector<PlotSeries> legend;
    for (const std::string& light : lights_of(study)) {
        const char* color = plot_color(legend.size());
        const PlotSeries curve{.mark = Mark::kCircle, .line = Line::kSolid, .color = color, .words = light};
        PlotSeries of_samples = curve, of_costs = curve;
        double three = 0;
        for (const PatchError& e : study.patches) {
            if (e.light != light) continue;
            if (e.samples == 0)
                three = e.mean;
            else
                of_samples.values.emplace_back(e.samples, e.mean);
            if (const double cost = cost_of(study, e.samples); cost > 0) of_costs.values.emplace_back(cost, e.mean);
        }
        by_samples.series.push_back(of_samples);
        by_cost.series.push_back(of_costs);
        const bool is_exact = three < kLowest;
        if (!is_exact)
            by_samples.series.push_back({.values = {{3, three}, {81, three}}, .line = Line::kDashed, .color = color});
        legend.push_back({.mark = Mark::kSquare, .color = color, .words = light + (is_exact ? " (exact)" : "")});
    }
    return plot_svg("Mean Delta E 2000 of the ColorChecker; the lowest line is 0.01 or less", {380, 300},
                    {by_samples, by_cost}, legend);
}

}  // namespace twinlight::study

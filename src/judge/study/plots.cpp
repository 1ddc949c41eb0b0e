// study.svg: error against time on logarithmic axes, with a dot for each choice and a line for the front.
// spectral.svg: Delta E for each light against the number of samples, and against their time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <iterator>

#include "judge/report/html.h"
#include "judge/study/study.h"
#include "render/context/driver_name.h"
#include "render/look.h"

namespace twinlight::study {

namespace {

// ---- Any plot ----

enum class Mark : std::uint8_t { kNone, kSquare, kTriangle, kCircle, kDiamond };
enum class Line : std::uint8_t { kNone, kSolid, kDashed };

struct PlotSeries {
    std::vector<glm::dvec2> values{};
    Mark mark = Mark::kNone;
    Line line = Line::kNone;
    const char* color = "#000";
    bool filled = true;
    std::string words{};  // the tooltip of its marks; in the legend the text of the row
};

// A logarithmic axis. Values beyond its ends are drawn at the ends.
struct PlotAxis {
    double low, high;
    std::vector<double> ticks{};
    std::string words{};

    // 0 at `low`, 1 at `high`.
    double part(double value) const { return std::log(std::clamp(value, low, high) / low) / std::log(high / low); }
};
struct Panel {
    PlotAxis x, y;
    std::vector<PlotSeries> series{};
};

// Safe for colour blindness (Okabe and Ito, 2008); the list repeats.
const char* plot_color(std::size_t number) {
    constexpr const char* kColors[] = {"#d55e00", "#0072b2", "#56b4e9", "#cc79a7", "#009e73", "#e69f00", "#000000"};
    return kColors[number % std::size(kColors)];
}

// From the power of ten below `low` to the one above `high`, with a tick at each.
PlotAxis decades(double low, double high, std::string words) {
    const double first = std::floor(std::log10(low)), last = std::max(first + 1, std::ceil(std::log10(high)));
    PlotAxis axis{.low = std::pow(10, first), .high = std::pow(10, last), .words = std::move(words)};
    for (double power = first; power <= last; ++power) axis.ticks.push_back(std::pow(10, power));
    return axis;
}

constexpr double kLeft = 80, kTop = 48, kBottom = 64, kRow = 22;  // margins of a panel; height of a legend row

std::string text_at(glm::dvec2 at, std::string_view words, const char* anchor, const char* turn = "") {
    return fmt::format("<text transform=\"translate({:.1f} {:.1f}){}\" text-anchor=\"{}\">{}</text>\n", at.x, at.y,
                       turn, anchor, report::escaped(words));
}

const char* path_of(Mark mark) {
    switch (mark) {
        case Mark::kNone: return "";
        case Mark::kSquare: return "m-4.5 -4.5h9v9h-9z";
        case Mark::kTriangle: return "m0 -6l5.5 9.5h-11z";
        case Mark::kCircle: return "m-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0";
        case Mark::kDiamond: return "m0 -6l6 6l-6 6l-6 -6z";
    }
    return "";
}

std::string line_through(const std::vector<glm::dvec2>& places, Line line, const char* color) {
    std::string path;
    for (const glm::dvec2& at : places) path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
    if (path.empty() || line == Line::kNone) return "";
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"{}/>\n", path, color,
                       line == Line::kDashed ? " stroke-dasharray=\"4 3\"" : "");
}

std::string mark_at(glm::dvec2 at, const PlotSeries& series) {
    if (series.mark == Mark::kNone) return "";
    return fmt::format("<path d=\"M{:.1f} {:.1f}{}\" fill=\"{}\" stroke=\"{}\"/>", at.x, at.y, path_of(series.mark),
                       series.filled ? series.color : "white", series.color);
}

std::string panel_svg(const Panel& panel, glm::dvec2 top_left, glm::dvec2 size) {
    const glm::dvec2 end = top_left + size, middle = top_left + 0.5 * size;
    const auto place = [&](glm::dvec2 value) {
        return top_left + size * glm::dvec2(panel.x.part(value.x), 1 - panel.y.part(value.y));
    };
    std::string svg;
    for (const double tick : panel.x.ticks) {
        const double x = place({tick, panel.y.low}).x;
        svg += line_through({{x, top_left.y}, {x, end.y}}, Line::kSolid, "#ddd");
        svg += text_at({x, end.y + 20}, fmt::format("{:g}", tick), "middle");
    }
    for (const double tick : panel.y.ticks) {
        const double y = place({panel.x.low, tick}).y;
        svg += line_through({{top_left.x, y}, {end.x, y}}, Line::kSolid, "#ddd");
        svg += text_at({top_left.x - 8, y + 4}, fmt::format("{:g}", tick), "end");
    }
    svg += text_at({middle.x, end.y + 44}, panel.x.words, "middle");
    svg += text_at({top_left.x - 58, middle.y}, panel.y.words, "middle", " rotate(-90)");
    for (const PlotSeries& series : panel.series) {
        std::vector<glm::dvec2> places;
        std::ranges::transform(series.values, std::back_inserter(places), place);
        svg += line_through(places, series.line, series.color);
        for (const glm::dvec2& at : places)
            if (series.mark != Mark::kNone)
                svg += fmt::format("<g class=\"dot\"><title>{}</title>{}</g>\n", report::escaped(series.words),
                                   mark_at(at, series));
    }
    return svg;
}

// Panels of `panel_size` pixels side by side, and a legend; a row without words is a gap.
std::string plot_svg(std::string_view title, glm::dvec2 panel_size, const std::vector<Panel>& panels,
                     const std::vector<PlotSeries>& legend) {
    std::string body = text_at({kLeft, 28}, title, "start");
    glm::dvec2 at(kLeft, kTop);
    for (const Panel& panel : panels) {
        body += panel_svg(panel, at, panel_size);
        at.x += panel_size.x + kLeft;
    }
    at += glm::dvec2(-kLeft + 30, 10);
    std::size_t longest = 0;
    for (const PlotSeries& row : legend) {
        body += line_through({at - glm::dvec2(8, 0), at + glm::dvec2(8, 0)}, row.line, row.color) + mark_at(at, row) +
                text_at(at + glm::dvec2(16, 4), row.words, "start");
        at.y += row.words.empty() ? kRow / 2 : kRow;
        longest = std::max(longest, row.words.size());
    }
    constexpr double kLetter = 7.5;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
               "font-family=\"sans-serif\" font-size=\"13\"><rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
               at.x + 30 + kLetter * static_cast<double>(longest), kTop + panel_size.y + kBottom) +
           body + "</svg>\n";
}

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

#include "judge/study/plot.h"

#include <fmt/format.h>

#include <iterator>

#include "judge/report/html.h"

namespace twinlight::study {

const char* plot_color(std::size_t number) {
    constexpr const char* kColors[] = {"#d55e00", "#0072b2", "#56b4e9", "#cc79a7", "#009e73", "#e69f00", "#000000"};
    return kColors[number % std::size(kColors)];
}

PlotAxis decades(double low, double high, std::string words) {
    const double first = std::floor(std::log10(low)), last = std::max(first + 1, std::ceil(std::log10(high)));
    PlotAxis axis{.low = std::pow(10, first), .high = std::pow(10, last), .words = std::move(words)};
    for (double power = first; power <= last; ++power) axis.ticks.push_back(std::pow(10, power));
    return axis;
}

namespace {

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

constexpr double kLetter = 7.5;  // the width of a letter, about

std::string svg_of(const std::string& body, glm::dvec2 size) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"13\"><rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n{2}</svg>\n",
        size.x, size.y, body);
}

}  // namespace

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
    return svg_of(body, {at.x + 30 + kLetter * static_cast<double>(longest), kTop + panel_size.y + kBottom});
}
std::string bars_svg(std::string_view title, const std::vector<Bar>& bars) {
    constexpr double kLength = 420, kThick = 16, kStep = 28;
    std::size_t longest = 0;
    double most = 0;
    for (const Bar& bar : bars) {
        longest = std::max(longest, bar.words.size());
        most = std::max(most, bar.value);
    }
    const double left = 24 + kLetter * static_cast<double>(longest);
    std::string body = text_at({16, 28}, title, "start");
    double y = kTop;
    for (const Bar& bar : bars) {
        const double length = most > 0 ? kLength * bar.value / most : 0;
        body += text_at({left - 8, y + 13}, bar.words, "end");
        body += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", left, y,
                            length, kThick, plot_color(1));
        body += text_at({left + length + 6, y + 13}, fmt::format("{:.2g}", bar.value), "start");
        y += kStep;
    }
    return svg_of(body, {left + kLength + 70, y + 8});
}

}  // namespace twinlight::study

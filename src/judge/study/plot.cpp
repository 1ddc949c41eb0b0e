// study.svg: error against time, both logarithmic; a dot a choice, the front drawn through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "judge/report/html.h"
#include "judge/study/study.h"
#include "render/look.h"

namespace twinlight::study {

namespace {

constexpr double kPlotRight = 660, kHeight = 560;      // right of it stands the legend
constexpr double kLeft = 80, kTop = 48, kBottom = 64;  // margins

// A logarithmic axis over whole powers of ten.
class LogAxis {
  public:
    LogAxis(double low, double high, double from, double to)
        : low_(std::floor(std::log10(low))), high_(std::ceil(std::log10(high))), from_(from), to_(to) {
        if (high_ <= low_) high_ = low_ + 1;
    }
    double at(double value) const { return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_); }
    int low() const { return static_cast<int>(low_); }
    int high() const { return static_cast<int>(high_); }

  private:
    double low_, high_, from_, to_;
};

// Colour-blind safe (Okabe and Ito, 2008): one a renderer, or of several machines one a machine; the shading is the mark.
constexpr const char* kColours[] = {"#d55e00", "#0072b2", "#56b4e9", "#cc79a7", "#009e73", "#e69f00", "#000000"};
constexpr Renderer kRenderers[] = {Renderer::kFixed, Renderer::kUniforms, Renderer::kConstants, Renderer::kReference,
                                   Renderer::kPrecise};

const char* colour_of(std::size_t number) { return kColours[number % std::size(kColours)]; }

std::size_t colour_number(const Study& study, const Point& point) {
    if (study.series.size() > 1) return point.series;
    return static_cast<std::size_t>(std::ranges::find(kRenderers, point.choice.renderer) - std::begin(kRenderers));
}

std::string mark(Shading shading, double x, double y, const char* colour, bool filled) {
    const std::string paint =
        filled ? fmt::format(R"(fill="{0}" stroke="{0}")", colour) : fmt::format(R"(fill="white" stroke="{}")", colour);
    switch (shading) {
        case Shading::kFlat:
            return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="9" height="9" {}/>)", x - 4.5, y - 4.5, paint);
        case Shading::kGouraud: return fmt::format(R"(<path d="M{:.1f} {:.1f}l5.5 9.5h-11z" {}/>)", x, y - 6, paint);
        case Shading::kPhong: return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="5" {}/>)", x, y, paint);
        case Shading::kExact: return fmt::format(R"(<path d="M{:.1f} {:.1f}l6 6l-6 6l-6 -6z" {}/>)", x, y - 6, paint);
    }
    return {};
}

std::string text(double x, double y, std::string_view anchor, std::string_view words) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor, words) + "\n";
}

std::string power_of_ten(int exponent) {
    return fmt::format(R"(10<tspan dy="-5" font-size="10">{}</tspan>)", exponent);
}

std::string grid(const LogAxis& x, const LogAxis& y) {
    std::string svg = R"(<g stroke="#ddd">)";
    for (int e = x.low(); e <= x.high(); ++e)
        svg += fmt::format(R"(<path d="M{:.1f} {:.1f}V{:.1f}"/>)", x.at(std::pow(10, e)), kTop, kHeight - kBottom);
    for (int e = y.low(); e <= y.high(); ++e)
        svg += fmt::format(R"(<path d="M{:.1f} {:.1f}H{:.1f}"/>)", kLeft, y.at(std::pow(10, e)), kPlotRight);
    svg += "</g>\n";
    for (int e = x.low(); e <= x.high(); ++e)
        svg += text(x.at(std::pow(10, e)), kHeight - kBottom + 20, "middle", power_of_ten(e));
    for (int e = y.low(); e <= y.high(); ++e) svg += text(kLeft - 8, y.at(std::pow(10, e)) + 4, "end", power_of_ten(e));
    svg += text((kLeft + kPlotRight) / 2, kHeight - 16, "middle", "time of a frame, ms");
    return svg +
           fmt::format(
               R"svg(<text transform="translate(22 {:.1f}) rotate(-90)" text-anchor="middle">rms error of a channel, 0 to 1</text>)svg",
               (kTop + kHeight - kBottom) / 2) +
           "\n";
}

// What the colours stand for.
std::vector<std::string> colour_words(const Study& study) {
    std::vector<std::string> words;
    if (study.series.size() > 1)
        for (const Series& series : study.series) words.push_back(series.name);
    else
        for (const Renderer renderer : kRenderers) words.push_back(axes()[0].value({.renderer = renderer}).words);
    return words;
}

// With room for the longest line of the legend.
double width_of(const Study& study) {
    constexpr double kLetter = 7, kLeast = 240, kSigns = 60;
    double right = kLeast;
    for (const std::string& words : colour_words(study))
        right = std::max(right, kSigns + kLetter * static_cast<double>(words.size()));
    return kPlotRight + right;
}

std::string legend(const Study& study) {
    std::string svg;
    double y = kTop + 10;
    const double x = kPlotRight + 30;
    const std::vector<std::string> words = colour_words(study);
    for (std::size_t i = 0; i < words.size(); ++i) {
        svg += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="12" height="12" fill="{}"/>)", x - 6, y - 6,
                           colour_of(i));
        svg += text(x + 16, y + 4, "start", report::escaped(words[i]));
        y += 22;
    }
    y += 10;
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud, Shading::kPhong, Shading::kExact}) {
        svg += mark(shading, x, y, "#444", true) + text(x + 16, y + 4, "start", name_of(shading));
        y += 22;
    }
    y += 10;
    svg += mark(Shading::kPhong, x, y, "#444", false) + text(x + 16, y + 4, "start", "with something changed");
    y += 22;
    svg += fmt::format(R"(<path d="M{:.1f} {:.1f}h16" stroke="#000" stroke-dasharray="4 3"/>)", x - 8, y);
    return svg + text(x + 16, y + 4, "start", "no choice is both faster") +
           text(x + 16, y + 20, "start", "and more accurate");
}

}  // namespace

std::string study_svg(const Study& study) {
    constexpr std::size_t kRms = 0;  // of kMeasures
    std::vector<const Point*> points;
    for (const Point& point : study.points)
        if (point.is_timed() && point.errors.whole.rms > 0) points.push_back(&point);
    std::string svg = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" font-family="sans-serif" font-size="13">)",
        width_of(study), kHeight);
    svg += R"(<rect width="100%" height="100%" fill="white"/>)";
    const std::string where =
        study.series.size() == 1 ? short_name(study.series[0].driver) : fmt::format("{} drivers", study.series.size());
    svg += text(kLeft, 28, "start",
                report::escaped(fmt::format("{}: what accuracy costs in time ({} x {}, {})", study.scene, study.width,
                                            study.height, where)));
    if (points.empty()) return svg + text(kPlotRight / 2, kHeight / 2, "middle", "nothing was timed") + "</svg>\n";
    const auto time = [](const Point* point) { return 1000 * point->median_seconds(); };
    const auto [fastest, slowest] = std::ranges::minmax(points, {}, time);
    const auto rms = [](const Point* point) { return point->errors.whole.rms; };
    const auto [best, worst] = std::ranges::minmax(points, {}, rms);
    const LogAxis x(time(fastest), time(slowest), kLeft, kPlotRight), y(rms(best), rms(worst), kHeight - kBottom, kTop);
    svg += grid(x, y) + legend(study);
    std::ranges::stable_sort(points, {}, time);
    for (std::size_t series = 0; series < study.series.size(); ++series) {
        std::string front;
        for (const Point* point : points)
            if (point->series == series && point->on_front[kRms])
                front += fmt::format("{}{:.1f} {:.1f}", front.empty() ? "M" : "L", x.at(time(point)), y.at(rms(point)));
        if (!front.empty())
            svg += fmt::format(R"(<path d="{}" fill="none" stroke="#000" stroke-dasharray="4 3"/>)", front) + "\n";
    }
    for (const Point* point : points) {
        const Choice& choice = point->choice;
        const Choice plain{.renderer = choice.renderer, .shading = choice.shading, .slices = choice.slices};
        svg += fmt::format(R"(<g class="dot"><title>{}: {:.3g} ms, rms {:.3g}</title>{}</g>)", choice.words(),
                           time(point), rms(point),
                           mark(choice.shading, x.at(time(point)), y.at(rms(point)),
                                colour_of(colour_number(study, *point)), choice == plain)) +
               "\n";
    }
    return svg + "</svg>\n";
}

}  // namespace twinlight::study

// spectral.svg: Delta E of each light against the samples, and against what these cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/report/html.h"
#include "judge/study/spectral.h"

namespace twinlight::study {

namespace {

constexpr double kTop = 40, kWidth = 380, kHeight = 300, kLeftPanel = 60, kRightPanel = 500;
constexpr double kLowest = 0.01, kHighest = 10;  // of Delta E
const char* const kColors[] = {"#c2410c", "#a16207", "#475569", "#15803d", "#0369a1", "#7e22ce"};

struct Dot {
    double x = 0, delta_e = 0;
};

// One axis, logarithmic.
struct XAxis {
    double left = 0;  // of the panel
    double lowest = 1, highest = 10;
    double place(double x) const {
        return left + kWidth * std::log(std::clamp(x, lowest, highest) / lowest) / std::log(highest / lowest);
    }
};

double y_of(double delta_e) {
    return kTop + kHeight * std::log(kHighest / std::clamp(delta_e, kLowest, kHighest)) / std::log(kHighest / kLowest);
}

void add_frame(std::string& svg, const XAxis& axis, const std::vector<double>& ticks, const std::string& words) {
    for (const double e : {0.01, 0.1, 1.0, 10.0})
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"#ddd\"/>\n"
            "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
            axis.left, y_of(e), axis.left + kWidth, axis.left - 8, y_of(e) + 4, e);
    for (const double tick : ticks)
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", axis.place(tick),
                           kTop + kHeight + 20, tick);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", axis.left + kWidth / 2,
                       kTop + kHeight + 42, words);
}

void add_line(std::string& svg, const XAxis& axis, const std::vector<Dot>& dots, const char* color) {
    std::string points, circles;
    for (const Dot& dot : dots) {
        points += fmt::format("{:.1f},{:.1f} ", axis.place(dot.x), y_of(dot.delta_e));
        circles += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", axis.place(dot.x),
                               y_of(dot.delta_e), color);
    }
    svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n{}", points, color,
                       circles);
}

// How many times as long as red, green and blue a picture takes that multiplies so many samples at every pixel; 0: not known.
double cost_of(const SpectralStudy& study, int samples) {
    const auto time_of = [&](int count) {
        const auto found = std::ranges::find(study.pictures, count, &SampledPicture::samples);
        return found == study.pictures.end() ? 0 : median(found->reference_seconds);
    };
    return time_of(0) > 0 ? time_of(samples) / time_of(0) : 0;
}

}  // namespace

std::string spectral_svg(const SpectralStudy& study) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 420\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n<rect width=\"1000\" height=\"420\" fill=\"white\"/>\n"
        "<text x=\"{}\" y=\"20\">Mean Delta E 2000 of the ColorChecker; the lowest line is 0.01 or less</text>\n",
        kLeftPanel);
    double longest = 2;
    for (const SampledPicture& picture : study.pictures) longest = std::max(longest, cost_of(study, picture.samples));
    const XAxis samples{.left = kLeftPanel, .lowest = 3, .highest = 81};
    const XAxis costs{.left = kRightPanel, .lowest = 1, .highest = longest};
    add_frame(svg, samples, {3, 5, 9, 16, 31, 81}, "samples (dashed: the product of red, green and blue)");
    std::vector<double> ticks;
    for (double tick = 1; tick <= longest; tick *= 2) ticks.push_back(tick);
    add_frame(svg, costs, ticks, "time of the reference's picture, in that of red, green and blue");

    const std::vector<std::string> lights = lights_of(study);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const char* color = kColors[i % std::size(kColors)];
        std::vector<Dot> by_samples, by_cost;
        double three = 0;
        for (const PatchError& e : study.patches) {
            if (e.light != lights[i]) continue;
            if (e.samples == 0)
                three = e.mean;
            else
                by_samples.push_back({static_cast<double>(e.samples), e.mean});
            if (const double cost = cost_of(study, e.samples); cost > 0) by_cost.push_back({cost, e.mean});
        }
        add_line(svg, samples, by_samples, color);
        add_line(svg, costs, by_cost, color);
        const bool is_exact = three < kLowest;
        if (!is_exact)
            svg += fmt::format(
                "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"{3}\" "
                "stroke-dasharray=\"5 4\"/>\n",
                kLeftPanel, y_of(three), kLeftPanel + kWidth, color);
        const double y = kTop + 12 + 22 * static_cast<double>(i);
        svg += fmt::format(
            "<rect x=\"896\" y=\"{:.0f}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n"
            "<text x=\"914\" y=\"{:.0f}\">{}{}</text>\n",
            y - 11, color, y, report::escaped(lights[i]), is_exact ? " (exact)" : "");
    }
    return svg + "</svg>\n";
}

}  // namespace twinlight::study

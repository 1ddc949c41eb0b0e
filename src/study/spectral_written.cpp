// What is said of samples of the spectrum: sentences, JSON, a plot, tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/spectral.h"

namespace twinlight::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kSeen = 1;  // of Delta E 2000: what can just be seen

const PatchError* find(const SpectralStudy& study, const std::string& light, int samples) {
    const auto found = std::ranges::find_if(
        study.patches, [&](const PatchError& e) { return e.light == light && e.samples == samples; });
    return found == study.patches.end() ? nullptr : &*found;
}

std::vector<std::string> lights_of(const SpectralStudy& study) {
    std::vector<std::string> lights;
    for (const PatchError& e : study.patches)
        if (lights.empty() || lights.back() != e.light) lights.push_back(e.light);
    return lights;
}

std::string listed(const std::vector<std::string>& names) {
    if (names.size() < 2) return names.empty() ? "" : names.front();
    return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

std::string samples_in_words(int samples) {
    return samples == 0 ? "red, green, blue" : fmt::format("{} samples", samples);
}

}  // namespace

std::vector<std::string> spectral_findings(const SpectralStudy& study) {
    std::vector<std::string> sentences, exact, unseen, paying;
    for (const std::string& light : lights_of(study)) {
        const PatchError *three = find(study, light, 0), *nine = find(study, light, 9);
        if (!three || !nine) continue;
        if (three->max < 1e-6)
            exact.push_back(light);
        else if (three->mean < kSeen && nine->mean < kSeen)
            unseen.push_back(light);
        else
            paying.push_back(light);
    }
    if (!exact.empty())
        sentences.push_back(
            fmt::format("Under {} red, green and blue are exact: that is the light in which materials have their "
                        "colours, and one bounce multiplies them by white.",
                        listed(exact)));
    if (!unseen.empty())
        sentences.push_back(fmt::format("Under {} they are off by less than can be seen on average.", listed(unseen)));
    if (!paying.empty()) sentences.push_back(fmt::format("Nine samples pay under {}.", listed(paying)));
    for (const std::string& light : paying) {
        const PatchError *three = find(study, light, 0), *nine = find(study, light, 9);
        sentences.push_back(fmt::format(
            "{}: the product of red, green and blue is off by {:.1f} on average and {:.1f} at worst ({}), of nine "
            "samples by {:.1f} and {:.1f} ({}).",
            light, three->mean, three->max, three->worst, nine->mean, nine->max, nine->worst));
    }
    const auto of = [&](int samples) { return std::ranges::find(study.pictures, samples, &SampledPicture::samples); };
    if (of(0) != study.pictures.end() && of(9) != study.pictures.end() && of(81) != study.pictures.end() &&
        !of(0)->reference_seconds.empty() && !of(81)->reference_seconds.empty()) {
        const double three = median(of(0)->reference_seconds), shader = median(of(0)->shader_seconds);
        sentences.push_back(fmt::format(
            "Multiplied at every pixel, nine samples take the reference {:.2f} times as long as red, green and blue, "
            "and "
            "81 {:.1f} times; shaders {:.2f} and {:.1f} times. Shaders whose products are made once a Draw take {:.2f} "
            "and "
            "{:.2f} times as long: a scene of one bounce calls for no more.",
            median(of(9)->reference_seconds) / three, median(of(81)->reference_seconds) / three,
            median(of(9)->sampling_shader_seconds) / shader, median(of(81)->sampling_shader_seconds) / shader,
            median(of(9)->shader_seconds) / shader, median(of(81)->shader_seconds) / shader));
    }
    return sentences;
}

std::string spectral_json(const SpectralStudy& study) {
    Json json = {{"patches", Json::array()}, {"pictures", Json::array()}, {"findings", study.findings}};
    for (const PatchError& e : study.patches)
        json["patches"].push_back(
            {{"light", e.light}, {"samples", e.samples}, {"mean", e.mean}, {"max", e.max}, {"worst", e.worst}});
    for (const SampledPicture& p : study.pictures)
        json["pictures"].push_back({{"samples", p.samples},
                                    {"reference_seconds", median(p.reference_seconds)},
                                    {"sampling_shader_seconds", median(p.sampling_shader_seconds)},
                                    {"shader_seconds", median(p.shader_seconds)},
                                    {"mean", p.off.mean},
                                    {"percentile_95", p.off.percentile_95},
                                    {"max", p.off.max}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string spectral_text(const SpectralStudy& study) {
    std::string text = fmt::format("{:<18}", "Delta E 2000");
    const std::vector<std::string> lights = lights_of(study);
    for (const std::string& light : lights) text += fmt::format("{:>14}", light);
    text += "    (mean / max of the 24 patches)\n";
    for (const PatchError& first : study.patches) {
        if (first.light != lights.front()) continue;
        text += fmt::format("{:<18}", samples_in_words(first.samples));
        for (const std::string& light : lights) {
            const PatchError* e = find(study, light, first.samples);
            text += fmt::format("{:>14}", fmt::format("{:.2f} / {:.2f}", e->mean, e->max));
        }
        text += "\n";
    }
    if (!study.pictures.empty())
        text += fmt::format("\n{:<18}{:>15}{:>15}{:>15}{:>8}{:>8}{:>8}\n", "the picture", "reference, ms",
                            "each pixel, ms", "each Draw, ms", "mean", "95 %", "max");
    for (const SampledPicture& p : study.pictures)
        text += fmt::format("{:<18}{:>15.3g}{:>15.3g}{:>15.3g}{:>8.2f}{:>8.2f}{:>8.2f}\n", samples_in_words(p.samples),
                            1000 * median(p.reference_seconds), 1000 * median(p.sampling_shader_seconds),
                            1000 * median(p.shader_seconds), p.off.mean, p.off.percentile_95, p.off.max);
    text += "\n";
    for (const std::string& sentence : study.findings) text += sentence + "\n";
    return text;
}

namespace {

constexpr double kLeft = 60, kTop = 30, kWidth = 560, kHeight = 300;
constexpr double kLowest = 0.01, kHighest = 10;  // of Delta E
constexpr int kFirst = 3, kLast = 81;
const char* const kColors[] = {"#c2410c", "#a16207", "#475569", "#15803d", "#0369a1", "#7e22ce"};

double x_of(int samples) {
    return kLeft + kWidth * std::log(static_cast<double>(samples) / kFirst) / std::log(double{kLast} / kFirst);
}
double y_of(double delta_e) {
    return kTop + kHeight * std::log(kHighest / std::clamp(delta_e, kLowest, kHighest)) / std::log(kHighest / kLowest);
}

}  // namespace

std::string spectral_svg(const SpectralStudy& study) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 760 400\" font-family=\"sans-serif\" "
        "font-size=\"13\">\n"
        "<rect width=\"760\" height=\"400\" fill=\"white\"/>\n"
        "<text x=\"{}\" y=\"18\">Mean Delta E 2000 of the ColorChecker against the samples of the spectrum</text>\n"
        "<text x=\"{}\" y=\"380\" text-anchor=\"middle\">samples (dashed: the product of red, green and blue; lowest "
        "line: 0.01 or less)</text>\n",
        kLeft, kLeft + kWidth / 2);
    const auto line = [&](double x1, double y1, double x2, double y2, const char* style) {
        svg +=
            fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2, y2, style);
    };
    for (const double e : {0.01, 0.1, 1.0, 10.0}) {
        line(kLeft, y_of(e), kLeft + kWidth, y_of(e), "stroke=\"#ddd\"");
        svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", kLeft - 8, y_of(e) + 4, e);
    }
    for (const int n : {3, 5, 9, 16, 31, 81})
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", x_of(n),
                           kTop + kHeight + 20, n);
    const std::vector<std::string> lights = lights_of(study);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const char* color = kColors[i % std::size(kColors)];
        std::string points, dots;
        for (const PatchError& e : study.patches) {
            if (e.light != lights[i] || e.samples < kFirst) continue;
            points += fmt::format("{:.1f},{:.1f} ", x_of(e.samples), y_of(e.mean));
            dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x_of(e.samples),
                                y_of(e.mean), color);
        }
        svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n{}", points,
                           color, dots);
        const PatchError* three = find(study, lights[i], 0);
        if (three && three->mean >= kLowest)
            line(kLeft, y_of(three->mean), kLeft + kWidth, y_of(three->mean),
                 fmt::format("stroke=\"{}\" stroke-dasharray=\"5 4\"", color).c_str());
        const double y = kTop + 20 + 22 * static_cast<double>(i);
        svg += fmt::format(
            "<rect x=\"640\" y=\"{:.0f}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n<text x=\"658\" "
            "y=\"{:.0f}\">{}{}</text>\n",
            y - 11, color, y, lights[i], three && three->mean < kLowest ? " (exact)" : "");
    }
    return svg + "</svg>\n";
}

}  // namespace twinlight::study

// What is written about samples of the spectrum: sentences, JSON, tables.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text/json.h"
#include "judge/report/html.h"
#include "judge/study/measure.h"
#include "judge/study/spectral.h"
#include "scene/spectrum/samples.h"

namespace twinlight::study {

namespace {

constexpr double kSeen = 1;  // a Delta E 2000 that is just visible

const PatchError* find(const SpectralStudy& study, const std::string& light, int samples) {
    const auto found = std::ranges::find_if(
        study.patches, [&](const PatchError& e) { return e.light == light && e.samples == samples; });
    return found == study.patches.end() ? nullptr : &*found;
}

std::string listed(const std::vector<std::string>& names) {
    if (names.size() < 2) return names.empty() ? "" : names.front();
    return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::string samples_in_words(int samples) {
    return samples == 0 ? "red, green, blue" : fmt::format("{} samples", samples);
}

}  // namespace

std::vector<std::string> lights_of(const SpectralStudy& study) {
    std::vector<std::string> lights;
    for (const PatchError& e : study.patches)
        if (lights.empty() || lights.back() != e.light) lights.push_back(e.light);
    return lights;
}

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
        sentences.push_back(fmt::format(
            "Under {}, red, green and blue are exact: materials are given their colours under this light, and one "
            "reflection multiplies them by white.",
            listed(exact)));
    if (!unseen.empty())
        sentences.push_back(fmt::format("Under {}, their average error is too small to see.", listed(unseen)));
    if (!paying.empty())
        sentences.push_back(fmt::format("Nine samples are worth their time under {}.", listed(paying)));
    for (const std::string& light : paying) {
        const PatchError *three = find(study, light, 0), *nine = find(study, light, 9);
        sentences.push_back(
            fmt::format("{}: the Delta E of red, green and blue is {:.1f} on average and {:.1f} at worst ({}), that of "
                        "nine samples {:.1f} and "
                        "{:.1f} ({}).",
                        light, three->mean, three->max, three->worst, nine->mean, nine->max, nine->worst));
    }
    const auto of = [&](int samples) { return std::ranges::find(study.pictures, samples, &SampledPicture::samples); };
    const auto is_timed = [&](int samples) {
        const auto found = of(samples);
        return found != study.pictures.end() && !found->reference_seconds.empty() &&
               !found->sampling_shader_seconds.empty() && !found->shader_seconds.empty();
    };
    if (is_timed(0) && is_timed(9) && is_timed(81)) {
        const double three = median(of(0)->reference_seconds), shader = median(of(0)->shader_seconds);
        sentences.push_back(fmt::format(
            "Compared with red, green and blue, the reference takes {:.2f} times as long with nine samples, and {:.1f} "
            "times with "
            "81. Shaders that use the samples at every pixel take {:.2f} and {:.1f} times as long, shaders that "
            "multiply lights and "
            "materials once per draw {:.2f} and {:.2f} times. For one reflection once per draw is enough.",
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
    return dumped_lines(json);
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
        text += fmt::format("\n{:<18}{:>15}{:>15}{:>15}{:>8}{:>8}{:>8}\n", "picture", "reference, ms", "per pixel, ms",
                            "per draw, ms", "mean", "95 %", "max");
    for (const SampledPicture& p : study.pictures)
        text += fmt::format("{:<18}{:>15.3g}{:>15.3g}{:>15.3g}{:>8.2f}{:>8.2f}{:>8.2f}\n", samples_in_words(p.samples),
                            1000 * median(p.reference_seconds), 1000 * median(p.sampling_shader_seconds),
                            1000 * median(p.shader_seconds), p.off.mean, p.off.percentile_95, p.off.max);
    text += "\n";
    for (const std::string& sentence : study.findings) text += sentence + "\n";
    return text;
}

namespace {

// The scene with red, green and blue, with nine samples, and with all.
std::string pictures_side_by_side(const SpectralStudy& study) {
    std::string html;
    for (const int samples : {0, 9, SpectralSamples::kMost}) {
        const auto found = std::ranges::find(study.pictures, samples, &SampledPicture::samples);
        if (found == study.pictures.end() || found->png.empty()) continue;
        html += fmt::format(
            "<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}<small>{2}</small></figcaption></figure>\n",
            samples_in_words(samples), report::data_uri(found->png),
            samples == SpectralSamples::kMost
                ? "exact: all lines of the measured spectra"
                : fmt::format("Delta E 2000: {:.1f} on average, {:.1f} at worst", found->off.mean, found->off.max));
    }
    return html.empty() ? "" : "<div class=\"grid samples\">\n" + html + "</div>\n";
}

std::string patch_rows(const SpectralStudy& study, const std::vector<std::string>& lights) {
    std::string rows;
    for (const PatchError& first : study.patches) {
        if (first.light != lights.front()) continue;
        rows += fmt::format("<tr><th scope=\"row\">{}</th>", samples_in_words(first.samples));
        for (const std::string& light : lights) {
            const PatchError* e = find(study, light, first.samples);
            rows += fmt::format("<td>{:.2f} / {:.2f}</td>", e->mean, e->max);
        }
        rows += "</tr>\n";
    }
    return rows;
}

std::string picture_rows(const SpectralStudy& study) {
    std::string rows;
    for (const SampledPicture& p : study.pictures)
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.2f}</td><td>{:.2f}</td>"
            "<td>{:.2f}</td></tr>\n",
            samples_in_words(p.samples), 1000 * median(p.reference_seconds), 1000 * median(p.sampling_shader_seconds),
            1000 * median(p.shader_seconds), p.off.mean, p.off.percentile_95, p.off.max);
    return rows;
}

}  // namespace

std::string spectral_section(const SpectralStudy& study, const std::string& of) {
    constexpr std::size_t kShown = 3;  // sentences; the others are folded
    const std::vector<std::string> lights = lights_of(study);
    std::string head, shown, folded;
    for (const std::string& light : lights) head += fmt::format("<th scope=\"col\">{}</th>", report::escaped(light));
    for (std::size_t i = 0; i < study.findings.size(); ++i)
        (i < kShown ? shown : folded) += fmt::format("<li>{}</li>\n", report::escaped(study.findings[i]));
    return fmt::format(
        "<section>\n<h2>Samples of the spectrum{}</h2>\n{}<ul class=\"findings\">\n{}</ul>\n"
        "<div class=\"scroll\">{}</div>\n"
        "<details>\n<summary>For each light, in numbers</summary>\n<ul>\n{}</ul>\n"
        "<p>Delta E 2000 of the ColorChecker's 24 patches, mean / worst.</p>\n"
        "<div class=\"scroll\"><table class=\"study\"><thead><tr><th "
        "scope=\"col\"></th>{}</tr></thead>\n<tbody>{}</tbody></table></div>\n"
        "<p>The scene's picture: the time to draw it, and the Delta E 2000 of all pixels compared with 81 "
        "samples.</p>\n"
        "<div class=\"scroll\"><table class=\"study\"><thead><tr><th scope=\"col\"></th><th scope=\"col\">reference, "
        "ms</th>"
        "<th scope=\"col\">shaders, per pixel, ms</th><th scope=\"col\">shaders, per draw, ms</th>"
        "<th scope=\"col\">mean</th><th scope=\"col\">95 %</th><th scope=\"col\">worst</th></tr></thead>\n"
        "<tbody>{}</tbody></table></div>\n</details>\n</section>\n",
        of.empty() ? "" : ": " + report::escaped(of), pictures_side_by_side(study), shown, spectral_svg(study), folded,
        head, patch_rows(study, lights), picture_rows(study));
}

}  // namespace twinlight::study

#include "judge/study/spectral.h"

#include <algorithm>
#include <chrono>

#include "base/image/png.h"
#include "base/math/srgb.h"
#include "scene/spectrum/samples.h"

namespace twinlight::study {

namespace {

constexpr int kCounts[] = {0, 3, 4, 5, 6, 7, 9, 12, 16, 24, 31, 41, 81};

// CIELAB, with the light as the white point.
Lab lab_under(Vec3<double> rgb, Vec3<double> light_rgb) {
    const Vec3<double> xyz = kXyzFromSrgb * rgb, white = kXyzFromSrgb * light_rgb;
    return lab_from_xyz(
        {xyz.x / white.x * kSrgbWhite.x, xyz.y / white.y * kSrgbWhite.y, xyz.z / white.z * kSrgbWhite.z});
}

PatchError patch_error(const Spectrum& light, int count, const SpectralSamples& all) {
    const SpectralSamples some(std::max(count, SpectralSamples::kFewest));
    const Vec3<double> light_rgb = rgb_of_light(light.lines);
    PatchError error{.light = std::string(light.name), .samples = count, .worst = ""};
    for (const Spectrum& patch : reflectances()) {
        const Vec3<double> truth = all.color_of_product(all.of_illuminant(light), all.of_reflectance(patch));
        const Vec3<double> seen = count == 0
                                      ? light_rgb * rgb_of_reflectance(patch.lines)
                                      : some.color_of_product(some.of_illuminant(light), some.of_reflectance(patch));
        const double e = delta_e_2000(lab_under(truth, light_rgb), lab_under(seen, light_rgb));
        error.mean += e / static_cast<double>(reflectances().size());
        if (e <= error.max) continue;
        error.max = e;
        error.worst = patch.name;
    }
    return error;
}

bool is_lit_by_spectrum(const LightingState& lighting) {
    return std::ranges::any_of(lighting.lights, [](const LightSource& light) {
        return light.enabled && (light.diffuse_illuminant.spectrum || light.specular_illuminant.spectrum);
    });
}

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::vector<PatchError> patch_errors() {
    const SpectralSamples all(SpectralSamples::kMost);
    std::vector<PatchError> errors;
    for (const Spectrum& light : illuminants())
        for (const int count : kCounts) errors.push_back(patch_error(light, count, all));
    return errors;
}

bool has_spectrum(const Frame& frame) {
    return std::ranges::any_of(frame.draws(),
                               [](const Draw* draw) { return draw->lighting.light_model.spectrum != nullptr; });
}

Frame with_samples(const Frame& frame, int samples) {
    const auto spectrum = samples == 0 ? nullptr : std::make_shared<const SpectralSamples>(samples);
    Frame result = frame;
    for (Draw* draw : result.editable_draws())
        if (draw->lighting.light_model.spectrum || is_lit_by_spectrum(draw->lighting))
            draw->lighting.light_model.spectrum = spectrum;
    return result;
}

SpectralStudy spectral_study(const Frame& frame, const SpectralRenderers& renderers, std::span<const int> samples,
                             int rounds, const std::function<bool(int done, int total)>& goes_on) {
    SpectralStudy study{.patches = patch_errors(), .pictures = {}, .findings = {}};
    const Image truth = renderers.reference(with_samples(frame, SpectralSamples::kMost));
    std::vector<Frame> frames;
    std::vector<std::function<void()>> shaders, sampling_shaders;
    for (const int count : samples) {
        frames.push_back(with_samples(frame, count));
        const Image picture = renderers.reference(frames.back());
        shaders.push_back(renderers.shaders(frames.back()));
        sampling_shaders.push_back(renderers.sampling_shaders(frames.back()));
        study.pictures.push_back({.samples = count,
                                  .reference_seconds = {},
                                  .sampling_shader_seconds = {},
                                  .shader_seconds = {},
                                  .off = perceived_difference(truth, picture),
                                  .png = encode_png(picture)});
    }
    const auto total = static_cast<int>(frames.size()) * rounds;
    for (int i = 0; i < total && goes_on(i, total); ++i) {
        const std::size_t which = static_cast<std::size_t>(i) % frames.size();
        SampledPicture& picture = study.pictures[which];
        picture.reference_seconds.push_back(seconds_of([&] { renderers.reference(frames[which]); }));
        // Draws once before timing, as if the previous frame was drawn in the same way.
        shaders[which]();
        picture.shader_seconds.push_back(seconds_of(shaders[which]));
        sampling_shaders[which]();
        picture.sampling_shader_seconds.push_back(seconds_of(sampling_shaders[which]));
    }
    study.findings = spectral_findings(study);
    return study;
}

}  // namespace twinlight::study

// How accurate samples of the spectrum are, and what they cost (docs/spectra.md): Delta E 2000 of the
// ColorChecker under each light against the number of samples, and the time of the scene's picture.
//
// Errors are differences from 81 samples, all lines of the tables. 0 samples: red, green and blue, multiplied as in GL.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/image/delta_e.h"
#include "scene/frame/frame.h"

namespace twinlight::study {

// The error of a number of samples under one light, over the 24 patches: one reflection, CIELAB with the light as the
// white point.
struct PatchError {
    std::string light;
    int samples = 0;
    double mean = 0, max = 0;
    std::string worst;  // the patch with the error `max`

    friend bool operator==(const PatchError&, const PatchError&) = default;
};
// For every light of scene/spectrum/spectrum.h, and for every number of samples, in order.
std::vector<PatchError> patch_errors();

// The scene's picture with a number of samples.
struct SampledPicture {
    int samples = 0;
    // Times of a frame, one for each round (read from a file: their median): by the reference, by shaders that use the
    // samples at every pixel, and by shaders that multiply lights and materials once per draw.
    std::vector<double> reference_seconds, sampling_shader_seconds, shader_seconds;
    // The difference from 81 samples, drawn by the reference and lit at every pixel (read from a file: without its
    // pixels).
    PerceivedDifference off;
    std::string png{};  // drawn by the reference; empty: missing

    friend bool operator==(const SampledPicture&, const SampledPicture&) = default;
};

struct SpectralStudy {
    std::vector<PatchError> patches;  // for every light and every number of samples
    std::vector<SampledPicture> pictures;
    std::vector<std::string> findings;  // sentences: where three samples are exact, where nine pay off, their cost

    friend bool operator==(const SpectralStudy&, const SpectralStudy&) = default;
};

// Whether a Draw has `#pragma twinlight spectrum(n)`.
bool has_spectrum(const Frame& frame);
// Gives this number of samples to the Draws with `spectrum(n)`, and to those lit by the spectrum of a light. 0: none.
Frame with_samples(const Frame& frame, int samples);

struct SpectralRenderers {
    std::function<Image(const Frame&)> reference;
    // Prepares the frame, and returns a function that draws it.
    std::function<std::function<void()>(const Frame&)> shaders, sampling_shaders;
};

// The numbers of samples that the scene's picture is drawn with: those of a full study, and of a quick one.
inline constexpr int kPictureSamples[] = {0, 3, 5, 9, 16, 31, 81};
inline constexpr int kQuickPictureSamples[] = {0, 9, 81};

// Times every number of samples once per round. Calls `goes_on` before each; false ends the timing.
SpectralStudy spectral_study(const Frame& frame, const SpectralRenderers& renderers, std::span<const int> samples,
                             int rounds, const std::function<bool(int done, int total)>& goes_on);

// The names of its lights, in order.
std::vector<std::string> lights_of(const SpectralStudy& study);

// Sentences that sum up the measurements.
std::vector<std::string> spectral_findings(const SpectralStudy& study);

// {"patches": [{"light", "samples", "mean", "max", "worst"}],
//  "pictures": [{"samples", "reference_seconds", "sampling_shader_seconds", "shader_seconds", "mean", "percentile_95",
//                "max"}],
//  "findings": ["sentence"]}
std::string spectral_json(const SpectralStudy& study);
// A plot of the mean Delta E for each light, against the samples and against their time, on logarithmic axes.
std::string spectral_svg(const SpectralStudy& study);
// A section of the page: three pictures side by side, sentences, the plot, and the tables, folded. `of`: the machine's name, empty if there is only one.
std::string spectral_section(const SpectralStudy& study, const std::string& of);
// The two tables as text: patches and pictures.
std::string spectral_text(const SpectralStudy& study);

}  // namespace twinlight::study

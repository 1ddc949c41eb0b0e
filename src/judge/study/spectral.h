// What samples of the spectrum give and cost (docs/accuracy.md, "Spectra"): Delta E 2000 of the ColorChecker under each light against the
// number of samples, and the time of a scene's picture.
//
// Truth: 81 samples, the lines of the tables themselves. 0 samples: red, green and blue, multiplied as GL does.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/image/delta_e.h"
#include "scene/state/frame.h"

namespace twinlight::study {

// One light's samples, over the 24 patches: one bounce, CIELAB by the light's own white.
struct PatchError {
    std::string light;
    int samples = 0;
    double mean = 0, max = 0;
    std::string worst;  // the patch that has `max`

    friend bool operator==(const PatchError&, const PatchError&) = default;
};
// Of every light of scene/spectrum/spectrum.h, and of every number of samples in their order.
std::vector<PatchError> patch_errors();

// The scene's picture with so many samples.
struct SampledPicture {
    int samples = 0;
    // A frame, one for each round (read back: their median): by the reference, by shaders that light every point in samples,
    // and by shaders whose products of lights and materials are made once a Draw.
    std::vector<double> reference_seconds, sampling_shader_seconds, shader_seconds;
    // From 81 samples, by the reference, pixel by pixel lit (read back: without its pixels).
    PerceivedDifference off;

    friend bool operator==(const SampledPicture&, const SampledPicture&) = default;
};

struct SpectralStudy {
    std::vector<PatchError> patches;  // every light's of every number of samples
    std::vector<SampledPicture> pictures;
    std::vector<std::string> findings;  // sentences: where three are exact, where nine pay, what they cost

    friend bool operator==(const SpectralStudy&, const SpectralStudy&) = default;
};

// Whether a Draw has `#pragma twinlight spectrum(n)`.
bool has_spectrum(const Frame& frame);
Frame with_samples(const Frame& frame, int samples);

struct SpectralRenderers {
    std::function<Image(const Frame&)> reference;
    // The frame made ready to be drawn again and again.
    std::function<std::function<void()>(const Frame&)> shaders, sampling_shaders;
};

// Each number of samples has its turn in every round. `goes_on` is asked before each; false ends the timing.
SpectralStudy spectral_study(const Frame& frame, const SpectralRenderers& renderers, int rounds,
                             const std::function<bool(int done, int total)>& goes_on);

// The lights that it has, in their order.
std::vector<std::string> lights_of(const SpectralStudy& study);

// Sentences of what was measured.
std::vector<std::string> spectral_findings(const SpectralStudy& study);

// {"patches": [{"light", "samples", "mean", "max", "worst"}],
//  "pictures": [{"samples", "reference_seconds", "sampling_shader_seconds", "shader_seconds", "mean", "percentile_95", "max"}], "findings": ["sentence"]}
std::string spectral_json(const SpectralStudy& study);
// Mean Delta E of each light against the samples and against their time, on logarithmic axes.
std::string spectral_svg(const SpectralStudy& study);
// A page's section: plot, tables and sentences. `of`: whose, where there are several.
std::string spectral_section(const SpectralStudy& study, const std::string& of);
// A table of the patches and one of the pictures, as text.
std::string spectral_text(const SpectralStudy& study);

}  // namespace twinlight::study

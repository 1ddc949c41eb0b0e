#include "app/cli/study_samples.h"

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "render/context/gl.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"

namespace twinlight::cli {

namespace {

constexpr Look kPerPixel = {.shading = Shading::kPhong};

std::function<void()> drawn(programmable::Renderer& renderer, const Frame& frame,
                            const programmable::Options& options) {
    const auto ready = std::make_shared<programmable::UploadedFrame>(frame, options);
    return [ready, &renderer] {
        renderer.draw(*ready);
        glFinish();
    };
}

}  // namespace

std::optional<study::SpectralStudy> study_samples(const Frame& frame, bool quick) {
    if (!study::has_spectrum(frame)) return std::nullopt;
    programmable::Renderer renderer;
    const study::SpectralRenderers renderers = {
        .reference = [](const Frame& sampled) { return reference::render(sampled, {kPerPixel}); },
        .shaders = [&renderer](const Frame& sampled) -> std::function<void()> {
            return drawn(renderer, sampled, {{kPerPixel}});
        },
        .sampling_shaders = [&renderer](const Frame& sampled) -> std::function<void()> {
            programmable::Options every_point{{kPerPixel}};
            every_point.fold_spectra = false;
            return drawn(renderer, sampled, every_point);
        }};
    const Interrupt interrupt;
    ProgressBar bar;
    const auto goes_on = [&bar](int done, int total) {
        bar.show(done, total, "samples of the spectrum");
        return !Interrupt::came();
    };
    const std::span<const int> samples =
        quick ? std::span<const int>(study::kQuickPictureSamples) : std::span<const int>(study::kPictureSamples);
    study::SpectralStudy study = study::spectral_study(frame, renderers, samples, quick ? 3 : 9, goes_on);
    bar.wipe();
    return study;
}

}  // namespace twinlight::cli

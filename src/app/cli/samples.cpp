#include "app/cli/samples.h"

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "context/gl.h"
#include "image/file.h"
#include "programmable/programmable.h"
#include "reference/reference.h"
#include "study/spectral.h"

namespace twinlight::cli {

namespace {

constexpr RenderOptions kPerPixel = {.shading = Shading::kPhong};

std::function<void()> drawn(programmable::Renderer& renderer, const Frame& frame, const RenderOptions& options) {
    const auto ready = std::make_shared<programmable::PreparedFrame>(frame, options);
    return [ready, &renderer] {
        renderer.draw(*ready);
        glFinish();
    };
}

}  // namespace

std::string study_samples(const Frame& frame, const std::filesystem::path& folder, bool quick) {
    if (!study::has_spectrum(frame)) return "";
    programmable::Renderer renderer;
    const study::SpectralRenderers renderers = {
        .reference = [](const Frame& sampled) { return reference::render(sampled, kPerPixel); },
        .shaders = [&renderer](const Frame& sampled) -> std::function<void()> {
            return drawn(renderer, sampled, kPerPixel);
        },
        .sampling_shaders = [&renderer](const Frame& sampled) -> std::function<void()> {
            RenderOptions every_point = kPerPixel;
            every_point.fold_spectra = false;
            return drawn(renderer, sampled, every_point);
        }};
    const Interrupt interrupt;
    ProgressBar bar;
    const study::SpectralStudy study =
        study::spectral_study(frame, renderers, quick ? 3 : 9, [&bar](int done, int total) {
            bar.show(done, total, "samples of the spectrum");
            return !Interrupt::came();
        });
    bar.wipe();
    const std::string json = study::spectral_json(study), svg = study::spectral_svg(study);
    write_files_atomically({{(folder / "spectral.json").string(), json}, {(folder / "spectral.svg").string(), svg}});
    return study::spectral_text(study);
}

}  // namespace twinlight::cli

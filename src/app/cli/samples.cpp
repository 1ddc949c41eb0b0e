#include "app/cli/samples.h"

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "context/gl.h"
#include "image/file.h"
#include "programmable/programmable.h"
#include "reference/reference.h"
#include "study/spectral.h"

namespace twinlight::cli {

std::string study_samples(const Frame& frame, const std::filesystem::path& folder, bool quick) {
    if (!study::has_spectrum(frame)) return "";
    constexpr RenderOptions kPerPixel = {.shading = Shading::kPhong};
    programmable::Renderer renderer;
    const study::SpectralRenderers renderers = {
        .reference = [](const Frame& sampled) { return reference::render(sampled, kPerPixel); },
        .shaders = [&renderer](const Frame& sampled) -> std::function<void()> {
            const auto ready = std::make_shared<programmable::PreparedFrame>(sampled, kPerPixel);
            return [ready, &renderer] {
                renderer.draw(*ready);
                glFinish();
            };
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

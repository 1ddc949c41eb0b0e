// What `twinlight study` measures of scenes that have spectra.
#pragma once

#include <optional>

#include "judge/study/spectral.h"

namespace twinlight::cli {

// Where the scene has `#pragma twinlight spectrum(n)`. Draws into the current context. `quick`: three rounds of times in the place of nine.
std::optional<study::SpectralStudy> study_samples(const Frame& frame, bool quick);

}  // namespace twinlight::cli

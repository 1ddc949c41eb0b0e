// A study's parts that only the command line has: spectral samples, and a description of the machine.
#pragma once

#include <optional>

#include "judge/study/spectral.h"
#include "judge/study/study.h"

namespace twinlight::cli {

// For a scene with `#pragma twinlight spectrum(n)`: time and error for each number of wavelength samples. Draws into the current
// context. `quick`: three rounds of measurements instead of nine.
std::optional<study::SpectralStudy> study_samples(const Frame& frame, bool quick);

// The machine that the program runs on.
study::Machine this_machine();

}  // namespace twinlight::cli

// What `twinlight study` says of scenes that have spectra.
#pragma once

#include <filesystem>
#include <string>

#include "state/frame.h"

namespace twinlight::cli {

// Where the scene has `#pragma twinlight spectrum(n)`: writes spectral.json and spectral.svg into the folder, and gives their tables
// and sentences; else nothing. Draws into the current context. `quick`: three rounds of times in the place of nine.
std::string study_samples(const Frame& frame, const std::filesystem::path& folder, bool quick);

}  // namespace twinlight::cli

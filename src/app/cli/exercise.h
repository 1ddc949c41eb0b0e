// An exam sheet: the lighting equation at a pixel with the results left blank, and a second page with the solution.
#pragma once

#include <string>

#include "judge/explain/explain.h"

namespace twinlight::cli {

// As HTML without further files. The pixel's colour must come from lighting; throws UsageError if it does not.
std::string exercise_page(const Scene& scene, const explain::PixelExplanation& explanation);

}  // namespace twinlight::cli

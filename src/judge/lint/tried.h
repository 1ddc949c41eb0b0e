// Tries the fixes of warnings: draws the scene with their edits, in each of its pictures, and runs the linter again.
#pragma once

#include <span>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::lint {

// Keeps the edits of a warning only if with them the warning is gone, no other one comes, the picture changes, and nothing that
// the warning is not about does. A switch that changes more is tried again with the opposite call after the object; then `fix`
// says so. Where nothing passes, there are no edits, and `fix` is advice. Fixes of recordings with very many calls are not tried.
void try_fixes(const Scene& scene, std::span<const LaterScene> later, std::vector<Warning>& warnings);

}  // namespace twinlight::lint

// The linter's warnings, as render and compare print them.
#pragma once

#include <string>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::cli {

// Prints each warning in one line to standard error, and how to see more. `scene` is the name on the command line.
void print_lint_notes(const std::vector<lint::Warning>& warnings, const std::string& scene);

}  // namespace twinlight::cli

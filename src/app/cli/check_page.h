// The page of `twinlight check --html`.
#pragma once

#include <string>
#include <vector>

#include "judge/check/suite.h"

namespace twinlight::cli {

// One file that holds everything: the summary first, then each case with its explanation, findings, pictures and scene.
std::string check_page(const std::string& driver, const std::vector<check::Case>& cases,
                       const std::vector<check::Result>& results);

}  // namespace twinlight::cli

// The page of `twinlight check --html`.
#pragma once

#include <string>
#include <vector>

#include "judge/check/suite.h"

namespace twinlight::cli {

// One file that holds everything: the verdict, then each case with its results, its explanation, its pictures and its
// scene.
std::string check_page(const std::string& driver, const std::vector<check::Case>& cases,
                       const std::vector<check::Result>& results);

}  // namespace twinlight::cli

// The page of `twinlight check --html`.
#pragma once

#include <string>
#include <vector>

#include "judge/check/suite.h"

namespace twinlight::cli {

// One file that holds everything: by what is tested, each case with its words, what was found, its pictures and its text.
std::string check_page(const std::string& driver, const std::vector<check::Case>& cases,
                       const std::vector<check::Result>& results);

}  // namespace twinlight::cli

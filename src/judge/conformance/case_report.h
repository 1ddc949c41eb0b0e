// A bug report on one hard case: `twinlight check --write-reports`.
#pragma once

#include <string>

#include "judge/check/suite.h"

namespace twinlight::conformance {

// Markdown: what is hard, the section, what the driver gives and what is right, and a C program (GLUT) that shows it. Empty if the driver's
// fixed function gives a right answer, or refuses the case.
std::string case_report(const std::string& driver, const check::Case& of, const check::Result& result);

}  // namespace twinlight::conformance

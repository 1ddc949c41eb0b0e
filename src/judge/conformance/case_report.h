// Bug reports on the hard cases that a driver gets wrong: `twinlight check --write-reports`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/image/named_file.h"
#include "judge/check/suite.h"

namespace twinlight::conformance {

// NAME.md, by the case: what is hard, the section, what the driver gives and what is right, where the cause is, and a C program (GLUT) that shows it. A listed bug
// has one report, of its shortest case; the others are named there. `results`: of the cases, in their order.
std::vector<NamedFile> case_reports(const std::string& driver, std::span<const check::Case> cases,
                                    std::span<const check::Result> results);

}  // namespace twinlight::conformance

// Bug reports on the hard cases that a driver gets wrong: `twinlight check --write-reports`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "judge/check/suite.h"

namespace twinlight::conformance {

struct CaseReport {
    std::string name;  // of the case
    std::string text;  // Markdown
};

// What is hard, the section, what the driver gives and what is right, where the cause is, and a C program (GLUT) that shows it. A listed bug
// has one report, of its shortest case; the others are named there. `results`: of the cases, in their order.
std::vector<CaseReport> case_reports(const std::string& driver, std::span<const check::Case> cases,
                                     std::span<const check::Result> results);

}  // namespace twinlight::conformance

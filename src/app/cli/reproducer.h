// The program of `twinlight check --write-reproducers`.
#pragma once

#include <string>

#include "judge/check/suite.h"

namespace twinlight::cli {

// A C program (GLUT) for a bug report: it prints the driver's answers to the case and the expected ones, and exits with 1 if they
// differ. Empty if the driver's answers are right.
std::string reproducer(const std::string& driver, const check::Case& of, const check::Result& result);

}  // namespace twinlight::cli

// The program of `twinlight check --write-reproducers`.
#pragma once

#include <string>

#include "judge/check/suite.h"

namespace twinlight::cli {

// A C program (GLUT) that shows what the driver's fixed function gives of the case and what is right, for a report; its exit status
// is 1 where they differ. Empty where the result has no departure.
std::string reproducer(const std::string& driver, const check::Case& of, const check::Result& result);

}  // namespace twinlight::cli

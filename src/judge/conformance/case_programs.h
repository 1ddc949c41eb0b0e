// The hard cases as C programs that run on any GL: `twinlight check --write-cases`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/image/named_file.h"
#include "judge/check/case.h"

namespace twinlight::conformance {

struct CasePrograms {
    std::vector<NamedFile> files;                // "cases/vertex-w-2.c", "Makefile"
    std::vector<std::string> written, left_out;  // names of cases; GL's fixed function lacks what the second ones need
};

// A program for each case and one for all, a Makefile, and scripts that run them and sum up (suite/README.md). Throws SceneError
// where a case cannot be carried out.
CasePrograms case_programs(std::span<const check::Case> cases);

}  // namespace twinlight::conformance

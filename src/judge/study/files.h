// A study's folder: study.json, study.csv, study.svg, index.html, and its pictures.
#pragma once

#include <string>

#include "judge/study/study.h"

namespace twinlight::study {

// All files or none. Throws FileError.
void write_study(const Study& study, const std::string& folder);

// A study.json with the pictures that lie beside it; those that do not are left empty. Throws FileError, and as read_study().
Study load_study(const std::string& file);

}  // namespace twinlight::study

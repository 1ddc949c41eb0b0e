// Helpers for writing HTML pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/image/embedded.h"
#include "base/text/page.h"

namespace twinlight {

// The files of src/judge/report/pages.
extern const std::vector<EmbeddedFile> kPageFiles;

}  // namespace twinlight

namespace twinlight::report {

// The text of one of kPageFiles. Throws std::logic_error if there is none of this name.
std::string_view page_file(std::string_view name);

using twinlight::escaped;

// "data:image/png;base64,..."
std::string data_uri(std::string_view png);

// Everything of a page before its body.
std::string page_head(std::string_view title, const std::string& style);

}  // namespace twinlight::report

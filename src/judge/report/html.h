// What pages are made with.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/image/file.h"

namespace twinlight {

// The files of src/judge/report/pages.
extern const std::vector<EmbeddedFile> kPageFiles;

}  // namespace twinlight

namespace twinlight::report {

// One of kPageFiles. Throws std::logic_error where there is none.
std::string_view page_file(std::string_view name);

// As text or an attribute's value.
std::string escaped(std::string_view text);

// "data:image/png;base64,..."
std::string data_uri(std::string_view png);

// Replaces each {{name}}; what is put in is not looked at again. Throws std::logic_error for a name without a value.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

// All of a page up to its body.
std::string page_head(std::string_view title, const std::string& style);

}  // namespace twinlight::report

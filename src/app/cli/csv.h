// Tables for spreadsheets.
#pragma once

#include <string>
#include <string_view>

namespace twinlight::cli {

// A field as RFC 4180 writes it. A spreadsheet would take a field that starts with = for a formula, and names of files come from
// strangers: these get an apostrophe in front.
std::string csv_field(std::string_view text);

}  // namespace twinlight::cli

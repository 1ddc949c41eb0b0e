#include "app/cli/csv.h"

namespace twinlight::cli {

std::string csv_field(std::string_view text) {
    std::string written;
    if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) written = "'";
    written += text;
    if (written.find_first_of(",\"\n\r") == std::string::npos) return written;
    std::string in_quotes = "\"";
    for (const char c : written) in_quotes += c == '"' ? "\"\"" : std::string(1, c);
    return in_quotes + "\"";
}

}  // namespace twinlight::cli

#include "judge/report/html.h"

#include <algorithm>
#include <stdexcept>

#include "base/text/page.h"

namespace twinlight::report {

std::string_view page_file(std::string_view name) {
    const auto file = std::ranges::find(kPageFiles, name, &EmbeddedFile::name);
    if (file == kPageFiles.end()) throw std::logic_error("this page file is not embedded: " + std::string(name));
    return file->text;
}

std::string data_uri(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string page_head(std::string_view title, const std::string& style) {
    return filled(page_file("head.html"), {{"title", escaped(title)}, {"style", style}});
}

}  // namespace twinlight::report

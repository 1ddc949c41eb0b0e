#include "base/text/translation.h"

#include <unordered_map>

namespace twinlight {
namespace {

std::unordered_map<std::string_view, const char*> translations;

}  // namespace

void set_translations(std::span<const Translation> rows) {
    translations.clear();
    for (const Translation& row : rows) translations.emplace(row.english, row.translated);
}

const char* tr(const char* english) {
    const auto found = translations.find(english);
    return found == translations.end() ? english : found->second;
}

std::string_view translation_of(std::string_view english) {
    const auto found = translations.find(english);
    return found == translations.end() ? english : found->second;
}

std::string vtr(fmt::string_view english, fmt::format_args arguments) {
    const std::string_view translated = translation_of({english.data(), english.size()});
    return fmt::vformat({translated.data(), translated.size()}, arguments);
}

std::string tr(std::string_view english) { return std::string(translation_of(english)); }

}  // namespace twinlight

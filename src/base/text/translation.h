// The window's texts in another language. A text is written in English where it is used, in tr(...), and one table has its translation.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

namespace twinlight {

struct Translation {
    const char *english, *translated;
};

// From now on tr() returns the translations of these rows, which must outlive its calls; without rows, the English texts. Call it before
// threads start.
void set_translations(std::span<const Translation> rows);

// The translation of a text; the text itself if it has none.
std::string_view translation_of(std::string_view english);
const char* tr(const char* english);
std::string tr(std::string_view english);
// The same for a format: of both languages, with these arguments.
std::string vtr(fmt::string_view english, fmt::format_args arguments);
template <class... Arguments>
requires(sizeof...(Arguments) > 0) std::string tr(fmt::format_string<Arguments...> english, Arguments&&... arguments) {
    return vtr(english, fmt::make_format_args(arguments...));
}

}  // namespace twinlight

// Texts in Chinese, and English that is left in them.
#pragma once

#include <regex>
#include <string>

#include "app/session/language.h"

namespace twinlight {

// The window's language while this object lives.
struct InChinese {
    InChinese() { session::set_language(lesson::Language::kChinese); }
    ~InChinese() { session::set_language(lesson::Language::kEnglish); }
};

// Two English words that follow each other in a text; code is not among those.
inline std::string english_words_in(const std::string& text) {
    static const std::regex kWords("(^|[^A-Za-z0-9_./])[A-Za-z]{2,}[,;:]? [a-z]{2,}($|[^A-Za-z0-9_./(])");
    std::smatch found;
    return std::regex_search(text, found, kWords) ? found.str() : "";
}

}  // namespace twinlight

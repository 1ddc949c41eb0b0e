// Texts in Chinese, and English that is left in them.
#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <string_view>

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

// The same of a message. Words of the scene may be there, lists of names, and code in a translation, such as "twinlight record".
inline std::string english_left(std::string message, const std::string& scene) {
    for (std::string words; !(words = english_words_in(message)).empty();) {
        const auto is_code = [&](const Translation& row) {
            return std::string_view(row.translated).find(words) != std::string_view::npos;
        };
        if (scene.find(words) == scene.npos && words.find(',') == words.npos &&
            std::ranges::none_of(session::chinese(), is_code))
            return words;
        message.replace(message.find(words), words.size(), ",");
    }
    return "";
}

}  // namespace twinlight

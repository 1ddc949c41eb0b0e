#include "app/session/language.h"

#include <algorithm>
#include <string_view>

namespace twinlight::session {
namespace {

constexpr Translation kChinese[] = {
#define CHINESE(english, chinese) {english, chinese},
#include "app/session/chinese.def"
#undef CHINESE
};

lesson::Language current = lesson::Language::kEnglish;

}  // namespace

void set_language(lesson::Language language) {
    current = language;
    set_translations(language == lesson::Language::kChinese ? chinese() : std::span<const Translation>());
}

lesson::Language language() { return current; }

std::span<const Translation> chinese() { return kChinese; }

Caption translated(Caption caption) {
    const std::string title = tr(std::string_view(caption.title)), notice = tr(std::string_view(caption.notice));
    if (title == caption.title) return caption;
    // The table has no more of the comment than these two.
    return {.title = title, .notice = notice, .all = title + "\n\n" + notice};
}

std::string before_colon(const std::string& title) {
    return title.substr(0, std::min(title.find(':'), title.find("：")));
}

std::string first_sentence(const std::string& text) {
    constexpr std::string_view kStop = "。";
    if (const auto stop = text.find(kStop); stop != text.npos) return text.substr(0, stop + kStop.size());
    return text.substr(0, text.find(". ") + 1);
}

}  // namespace twinlight::session

#include "scene/scenes/caption.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace twinlight {
namespace {

constexpr std::string_view kStop = "。";  // of Chinese, which has no blanks

// A sentence ends with a full stop, a question or exclamation mark before a capital letter, or with kStop.
std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences;
    std::size_t from = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool is_mark = text[at] == '.' || text[at] == '?' || text[at] == '!';
        const bool ends = is_mark && at + 2 < text.size() && text[at + 1] == ' ' &&
                          std::isupper(static_cast<unsigned char>(text[at + 2])) != 0;
        const std::size_t bytes = text.compare(at, kStop.size(), kStop) == 0 ? kStop.size() : ends ? 1 : 0;
        if (bytes == 0) continue;
        sentences.push_back(text.substr(from, at + bytes - from));
        from = at + bytes;
        if (from < text.size() && text[from] == ' ') ++from;
        at = from - 1;
    }
    if (from < text.size()) sentences.push_back(text.substr(from));
    return sentences;
}

}  // namespace

Caption caption_of(const CommandList& scene) { return scene.text ? caption_of(*scene.text) : Caption{}; }

Caption caption_of(std::string_view text) {
    std::vector<std::string> paragraphs(1);
    while (text.starts_with("//")) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of("/ "), line.size()));
        if (line.starts_with("twinlight:")) continue;  // for the linter
        if (line.empty())
            paragraphs.emplace_back();
        else
            paragraphs.back().append(paragraphs.back().empty() ? "" : " ").append(line);
    }
    std::erase(paragraphs, "");
    Caption caption;
    std::vector<std::string> sentences;
    for (const std::string& paragraph : paragraphs) {
        caption.all += (caption.all.empty() ? "" : "\n\n") + paragraph;
        const auto more = sentences_of(paragraph);
        sentences.insert(sentences.end(), more.begin(), more.end());
    }
    if (sentences.empty()) return {};
    caption.title = sentences[0];
    const auto notices = std::ranges::find_if(sentences, [](const std::string& s) { return s.starts_with("Notice"); });
    auto first = notices == sentences.end() ? sentences.begin() + 1 : notices;
    for (int i = 0; i < 2 && first != sentences.end(); ++i, ++first)
        caption.notice += (caption.notice.empty() || caption.notice.ends_with(kStop) ? "" : " ") + *first;
    return caption;
}

}  // namespace twinlight

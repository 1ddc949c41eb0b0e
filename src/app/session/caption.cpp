#include "app/session/caption.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/text/input_text.h"

namespace twinlight::session {
namespace {

// A sentence ends with a full stop, a question or exclamation mark before a capital letter.
std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences;
    std::size_t from = 0;
    for (std::size_t at = 0; at + 2 < text.size(); ++at) {
        const bool ends = text[at] == '.' || text[at] == '?' || text[at] == '!';
        const bool begins = text[at + 1] == ' ' && std::isupper(static_cast<unsigned char>(text[at + 2])) != 0;
        if (!ends || !begins) continue;
        sentences.push_back(text.substr(from, at + 1 - from));
        from = at + 2;
    }
    if (from < text.size()) sentences.push_back(text.substr(from));
    return sentences;
}

}  // namespace

Caption caption_of(const CommandList& scene) { return scene.text ? caption_of(*scene.text) : Caption{}; }

Caption caption_of(const std::string& text) {
    std::vector<std::string> paragraphs(1);
    InputText lines(text);
    for (std::string line; std::getline(lines, line) && line.starts_with("//");) {
        line.erase(0, std::min(line.find_first_not_of("/ "), line.size()));
        if (line.starts_with("twinlight:")) continue;  // for the linter
        if (line.empty())
            paragraphs.emplace_back();
        else
            paragraphs.back() += (paragraphs.back().empty() ? "" : " ") + line;
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
        caption.notice += (caption.notice.empty() ? "" : " ") + *first;
    return caption;
}

}  // namespace twinlight::session

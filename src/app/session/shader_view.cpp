#include "app/session/shader_view.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "base/text/translation.h"

namespace twinlight::session {
namespace {

constexpr std::array<std::string_view, 24> kKeywords = {
    "attribute", "break",     "const",  "continue", "discard", "do",        "else",    "false",
    "flat",      "for",       "if",     "in",       "inout",   "invariant", "layout",  "out",
    "precise",   "precision", "return", "smooth",   "struct",  "true",      "uniform", "while"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// float, vec3, ivec2, mat4, sampler2D, ...
bool is_type(std::string_view word) {
    if (word == "void" || word == "bool" || word == "int" || word == "uint" || word == "float" || word == "double")
        return true;
    if (word.starts_with("sampler")) return true;
    const std::size_t digit = word.find_first_of("234");
    if (digit == word.npos) return false;
    const std::string_view stem = word.substr(0, digit);
    return (stem == "vec" || stem == "ivec" || stem == "uvec" || stem == "bvec" || stem == "dvec" || stem == "mat") &&
           (digit + 1 == word.size() || (stem == "mat" && word.size() == digit + 3 && word[digit + 1] == 'x'));
}

// Reads one line; `in_comment`: it starts inside a comment, and is set to whether the next one does.
class LineOfGlsl {
  public:
    LineOfGlsl(std::string_view line, bool& in_comment) : line_(line), in_comment_(in_comment) {}

    std::vector<InkedText> read() {
        if (!in_comment_ && line_.find_first_not_of(" \t") != line_.npos &&
            line_[line_.find_first_not_of(" \t")] == '#') {
            // A comment may follow a directive.
            take(std::min(line_.find("//"), line_.size()), Ink::kDirective);
        }
        while (at_ < line_.size()) read_piece();
        return std::move(pieces_);
    }

  private:
    void take(std::size_t end, Ink ink) {
        if (end == at_) return;
        const std::string_view text = line_.substr(at_, end - at_);
        // Neighbours of one colour are one piece.
        if (!pieces_.empty() && pieces_.back().ink == ink)
            pieces_.back().text = {pieces_.back().text.data(), pieces_.back().text.size() + text.size()};
        else
            pieces_.push_back({ink, text});
        at_ = end;
    }

    template <class Test>
    std::size_t end_of(Test test) const {
        std::size_t end = at_;
        while (end < line_.size() && test(line_[end])) ++end;
        return end;
    }

    void read_piece() {
        const std::string_view rest = line_.substr(at_);
        if (in_comment_ || rest.starts_with("/*")) {
            const std::size_t close = line_.find("*/", in_comment_ ? at_ : at_ + 2);
            in_comment_ = close == line_.npos;
            take(in_comment_ ? line_.size() : close + 2, Ink::kComment);
        } else if (rest.starts_with("//")) {
            take(line_.size(), Ink::kComment);
        } else if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
            take(end_of_number(), Ink::kNumber);
        } else if (is_letter(rest[0])) {
            read_word();
        } else {
            take(at_ + 1, Ink::kPlain);
        }
    }

    // 12, 0x1F, 1.5, .5e-3, 2u
    std::size_t end_of_number() const {
        std::size_t end = at_;
        while (end < line_.size()) {
            const char c = line_[end];
            const bool is_sign =
                (c == '+' || c == '-') && end > at_ && (line_[end - 1] == 'e' || line_[end - 1] == 'E');
            if (!is_digit(c) && !is_letter(c) && c != '.' && !is_sign) break;
            ++end;
        }
        return end;
    }

    void read_word() {
        const std::size_t end = end_of([](char c) { return is_letter(c) || is_digit(c); });
        const std::string_view word = line_.substr(at_, end - at_);
        const std::size_t next = line_.find_first_not_of(' ', end);
        Ink ink = Ink::kPlain;
        if (std::ranges::find(kKeywords, word) != kKeywords.end())
            ink = Ink::kKeyword;
        else if (is_type(word))
            ink = Ink::kType;
        else if (next != line_.npos && line_[next] == '(')
            ink = Ink::kCall;
        take(end, ink);
    }

    std::string_view line_;
    bool& in_comment_;
    std::size_t at_ = 0;
    std::vector<InkedText> pieces_;
};

}  // namespace

std::vector<std::vector<InkedText>> inked_lines(std::string_view glsl) {
    std::vector<std::vector<InkedText>> lines;
    bool in_comment = false;
    while (!glsl.empty()) {
        const std::size_t end = std::min(glsl.find('\n'), glsl.size());
        lines.push_back(LineOfGlsl(glsl.substr(0, end), in_comment).read());
        glsl.remove_prefix(std::min(end + 1, glsl.size()));
    }
    return lines;
}

std::vector<ShownShader> shown_shaders(std::string_view source) {
    constexpr std::string_view kMark = "// ==== Draw ";
    std::vector<ShownShader> shaders;
    for (std::size_t at = source.find(kMark); at != source.npos;) {
        const std::size_t title = at + kMark.size(), line_end = std::min(source.find('\n', at), source.size());
        const std::size_t next = source.find(kMark, line_end);
        ShownShader shader;
        shader.title = tr("draw {}", source.substr(title, line_end - title));
        std::from_chars(source.data() + title, source.data() + line_end, shader.draw);
        const std::size_t start = std::min(line_end + 1, source.size());
        std::string_view text = source.substr(start, next == source.npos ? next : next - start);
        while (text.ends_with("\n\n")) text.remove_suffix(1);
        shader.glsl = text;
        shaders.push_back(std::move(shader));
        at = next;
    }
    return shaders;
}

std::string_view without_reasons(std::string_view glsl) {
    constexpr std::string_view kFirst[] = {"// State that", "// a_position", "// Uniform values"};
    for (std::size_t at = 0; at < glsl.size();) {
        const std::string_view rest = glsl.substr(at);
        if (!rest.starts_with("//")) return glsl;
        if (std::ranges::any_of(kFirst, [&](std::string_view words) { return rest.starts_with(words); })) return rest;
        const std::size_t end = glsl.find('\n', at);
        if (end == glsl.npos) return glsl;
        at = end + 1;
    }
    return glsl;
}

const ExplainedDraw* plan_of(const std::vector<ExplainedDraw>& draws, int number) {
    for (const ExplainedDraw& draw : draws)
        if (std::ranges::find(draw.numbers, number) != draw.numbers.end()) return &draw;
    return nullptr;
}

}  // namespace twinlight::session

#include "scene/command/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/text/translation.h"
#include "scene/command/characters.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr std::string_view kPunctuation = "(){}[],;=+-*/|&";
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

}  // namespace

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string shown = "'";
    for (char c : text.substr(0, kLongest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7F)
            shown += c;
        else
            shown += fmt::format("\\x{:02x}", byte);
    }
    return shown + (text.size() > kLongest ? "...'" : "'");
}

std::string arguments_text(std::size_t count) { return count == 1 ? tr("1 argument") : tr("{} arguments", count); }
std::string values_text(std::size_t count) { return count == 1 ? tr("1 value") : tr("{} values", count); }
std::string did_you_mean(std::optional<std::string_view> near) {
    return near ? tr("; did you mean {}?", *near) : std::string();
}

void fail_with(const Place& place, fmt::string_view message, fmt::format_args values) {
    throw SceneError({TextError{place, vtr(message, values)}});
}

Lexer::Lexer(std::string_view text, const std::string& file, Language language) : text_(text), language_(language) {
    place_.file = std::make_shared<const std::string>(file);
    place_.line = place_.column = 1;
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (at(kByteOrderMark)) position_ = kByteOrderMark.size();
}

// Moves on by one byte. Columns count characters, so the later bytes of a UTF-8 character do not count.
void Lexer::advance() {
    const char c = text_[position_++];
    if (c == '\n') {
        ++place_.line;
        place_.column = 1;
        line_start_ = true;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {
        ++place_.column;
    }
}

void Lexer::skip_space_and_comments() {
    while (position_ < text_.size()) {
        if (is_space(text_[position_])) {
            if ((in_pragma_ || in_directive_) && text_[position_] == '\n') return;
            advance();
        } else if (language_ == Language::kProgram && (at("\\\n") || at("\\\r\n"))) {  // the line continues
            while (text_[position_] != '\n') advance();
            advance();
        } else if (at("//")) {
            while (position_ < text_.size() && text_[position_] != '\n') advance();
        } else if (at("/*")) {
            const Place start = place_;
            while (position_ < text_.size() && !at("*/")) advance();
            if (position_ >= text_.size()) fail(start, "this comment is never closed; end it with */");
            advance();
            advance();
        } else {
            return;
        }
    }
}

// Reads a line that starts with '#': sets pragma_found_, or skips the line.
void Lexer::directive() {
    const Place start = place_;
    const std::size_t line_end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line = text_.substr(position_, line_end - position_);
    const auto word = [&line] {
        while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
        std::size_t n = 0;
        while (n < line.size() && is_letter(line[n])) ++n;
        const std::string_view found = line.substr(0, n);
        line.remove_prefix(n);
        return found;
    };
    line.remove_prefix(1);  // '#'
    const std::string_view name = word();
    if (name == "pragma" && word() == "twinlight") {
        pragma_found_ = in_pragma_ = true;
        const std::size_t words = line_end - line.size();
        while (position_ < words) advance();
        return;
    }
    if (language_ == Language::kProgram) {
        for (std::string_view known :
             {"include", "define", "undef", "if", "ifdef", "ifndef", "elif", "else", "endif"}) {
            if (name != known) continue;
            directive_ = known;
            in_directive_ = true;
            const std::size_t words = static_cast<std::size_t>(name.data() - text_.data()) + name.size();
            while (position_ < words) advance();
            return;
        }
        while (position_ < text_.size() && text_[position_] != '\n') advance();
        return;
    }
    const bool asks_for_prototypes = name == "define" && line.ends_with("GL_GLEXT_PROTOTYPES");
    if (name != "include" && name != "pragma" && !asks_for_prototypes) {
        skip_line();
        fail(start, "a scene cannot use #{}; only #include (which is ignored) and #pragma twinlight are allowed", name);
    }
    skip_line();
}

std::string_view Lexer::skip_line() {
    const std::size_t start = position_;
    while (position_ < text_.size() && text_[position_] != '\n') advance();
    in_directive_ = false;
    return text_.substr(start, position_ - start);
}

// Reads from '"' to '"'. In scenes strings are file names, so they have no escapes.
void Lexer::string() {
    const Place start = place_;
    advance();
    while (position_ < text_.size() && text_[position_] != '"') {
        const auto byte = static_cast<unsigned char>(text_[position_]);
        if (byte == '\n') break;
        if (language_ == Language::kProgram) {
            if (byte == '\\' && position_ + 1 < text_.size()) advance();
            advance();
            continue;
        }
        if (byte < 0x20 || byte == 0x7F || byte == '\\') {
            const Place place = place_;
            const std::string_view character = text_.substr(position_, 1);
            skip_line();
            fail(place, "a string cannot contain {}", in_quotes(character));
        }
        advance();
    }
    if (position_ >= text_.size() || text_[position_] != '"')
        fail(start, "this string has no end on its line; end it with \"");
    advance();
}

// Reads 'a' or '\n'.
void Lexer::character() {
    const Place start = place_;
    advance();
    while (position_ < text_.size() && text_[position_] != '\'' && text_[position_] != '\n') {
        if (text_[position_] == '\\' && position_ + 1 < text_.size()) advance();
        advance();
    }
    if (position_ >= text_.size() || text_[position_] != '\'')
        fail(start, "this character has no end on its line; end it with '");
    advance();
}

std::size_t Lexer::operator_length() const {
    const std::string_view rest = text_.substr(position_);
    for (std::string_view three : {"<<=", ">>="})
        if (rest.starts_with(three)) return 3;
    for (std::string_view two : {"==", "!=", "<=", ">=", "&&", "||", "++", "--", "+=", "-=",
                                 "*=", "/=", "%=", "|=", "&=", "^=", "<<", ">>", "->", "::"})
        if (rest.starts_with(two)) return 2;
    if (rest[0] == '#') return in_directive_ ? 1 : 0;
    return std::string_view("(){}[],;=+-*/|&<>!?:%^~.").find(rest[0]) != rest.npos ? 1 : 0;
}

void Lexer::skip_to_directive() {
    in_directive_ = false;
    while (position_ < text_.size()) {
        while (position_ < text_.size() && is_space(text_[position_])) advance();
        if (position_ < text_.size() && text_[position_] == '#' && line_start_) return;
        line_start_ = false;
        while (position_ < text_.size() && text_[position_] != '\n') advance();
    }
}

// Moves past a character that scenes do not use, and reports it.
void Lexer::refuse_character() {
    const Place place = place_;
    const std::string_view rest = text_.substr(position_);
    const auto [character, bytes] = decode_utf8(rest);
    const auto number = static_cast<std::uint32_t>(character);
    for (std::size_t i = 0; i < std::max<std::size_t>(bytes, 1); ++i) advance();
    const std::string_view shown = rest.substr(0, bytes);
    if (bytes == 0)
        fail(place, "unexpected byte {}, which is not UTF-8; save the scene as UTF-8 text",
             in_quotes(rest.substr(0, 1)));
    if (character < 0x20 || character == 0x7F) {
        position_ = text_.size();  // a file with such a byte is not text
        fail(place, "unexpected {}; a scene consists of C statements such as glEnable(GL_LIGHTING);", in_quotes(shown));
    }
    if (character < 0x80)
        fail(place, "unexpected {}; a scene consists of C statements such as glEnable(GL_LIGHTING);", in_quotes(shown));
    const std::string_view ascii = ascii_for(character);
    if (ascii.empty())
        fail(place, "unexpected character {} (U+{:04X}); only comments may have characters outside ASCII",
             character < 0xA0 ? in_quotes(shown) : fmt::format("'{}'", shown), number);
    if (kPunctuation.find(ascii) != std::string_view::npos) replacement_ = ascii;
    fail(place, "'{}' (U+{:04X}{}) is not C; type {} instead", shown, number,
         is_full_width(character) ? tr(", full width") : "", ascii == " " ? tr("a space") : fmt::format("'{}'", ascii));
}

Token Lexer::next() {
    if (!replacement_.empty()) return {TokenKind::kPunctuation, std::exchange(replacement_, {}), place_};
    while (true) {
        skip_space_and_comments();
        if (position_ >= text_.size() || text_[position_] != '#' || !line_start_) break;
        const Place start = place_;
        directive();
        if (pragma_found_) {
            pragma_found_ = line_start_ = false;
            return {TokenKind::kPragma, "#pragma twinlight", start};
        }
        if (in_directive_) {
            line_start_ = false;
            return {TokenKind::kDirective, directive_, start};
        }
    }
    line_start_ = false;
    Token token{TokenKind::kPunctuation, ";", place_};
    if (in_pragma_ && (position_ >= text_.size() || text_[position_] == '\n')) {
        in_pragma_ = false;
        return token;
    }
    if (in_directive_ && (position_ >= text_.size() || text_[position_] == '\n')) {
        in_directive_ = false;
        return {TokenKind::kLineEnd, "the end of the line", place_};
    }
    if (position_ >= text_.size()) return {TokenKind::kEnd, "the end of the scene", place_};

    const std::size_t start = position_;
    const char c = text_[position_];
    const bool starts_number = is_digit(c) || (c == '.' && start + 1 < text_.size() && is_digit(text_[start + 1]));
    if (is_letter(c)) {
        token.kind = TokenKind::kName;
        while (position_ < text_.size() && (is_letter(text_[position_]) || is_digit(text_[position_]))) advance();
    } else if (starts_number) {
        token.kind = TokenKind::kNumber;
        const bool hex = at("0x") || at("0X");
        while (position_ < text_.size()) {
            const char d = text_[position_];
            const char before = text_[position_ - (position_ > start ? 1 : 0)];
            const bool exponent_sign = (d == '+' || d == '-') && !hex && (before == 'e' || before == 'E');
            if (!is_letter(d) && !is_digit(d) && d != '.' && !exponent_sign) break;
            advance();
        }
    } else if (c == '"') {
        token.kind = TokenKind::kString;
        string();
    } else if (language_ == Language::kScene && kPunctuation.find(c) != std::string_view::npos) {
        advance();
    } else if (const std::size_t length = language_ == Language::kProgram ? operator_length() : 0; length > 0) {
        for (std::size_t i = 0; i < length; ++i) advance();
    } else if (c == '\'' && language_ == Language::kProgram) {
        token.kind = TokenKind::kNumber;
        character();
    } else {
        refuse_character();
    }
    token.text = text_.substr(start, position_ - start);
    return token;
}

std::int64_t character_code(std::string_view quoted) {
    const char c = quoted.size() > 2 ? quoted[1] : '\0';
    if (c != '\\' || quoted.size() < 4) return static_cast<signed char>(c);
    constexpr std::string_view kLetters = "abefnrtv0", kCodes("\a\b\x1b\f\n\r\t\v\0", 9);
    const std::size_t at = kLetters.find(quoted[2]);
    return static_cast<signed char>(at == kLetters.npos ? quoted[2] : kCodes[at]);
}

std::errc read_whole(std::string_view digits, std::int64_t& value) {
    const auto is_suffix = [](char c) { return std::string_view("uUlL").find(c) != std::string_view::npos; };
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    while (!digits.empty() && is_suffix(digits.back())) digits.remove_suffix(1);
    const bool octal = !hex && digits.size() > 1 && digits[0] == '0';
    const std::string_view significant = digits.substr(hex ? 2 : 0);
    const char* const end = significant.data() + significant.size();
    const auto [read, error] = std::from_chars(significant.data(), end, value, hex ? 16 : octal ? 8 : 10);
    if (error != std::errc()) return error;
    return read == end ? std::errc() : std::errc::invalid_argument;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
    if (text.starts_with('\'')) return character_code(text);
    std::int64_t value = 0;
    return read_whole(text, value) == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace twinlight

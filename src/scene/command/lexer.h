// The tokens of the C dialect.
#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight {

enum class TokenKind : std::uint8_t { kName, kNumber, kString, kPunctuation, kPragma, kEnd };

struct Token {
    TokenKind kind = TokenKind::kEnd;
    // Of a pragma: "#pragma twinlight" itself; the words after it are tokens of their own. Of a string: with its quotes.
    std::string_view text;
    Place place;

    bool is(std::string_view punctuation_or_name) const {
        return kind != TokenKind::kNumber && kind != TokenKind::kString && kind != TokenKind::kEnd &&
               text == punctuation_or_name;
    }
};

// Cuts text into tokens, one at a time. Comments, white space, #include lines and pragmas of others are passed over.
// A pragma's words end with a token ";" of its own at the line's end, so a pragma reads like a call.
class Lexer {
  public:
    Lexer(std::string_view text, const std::string& file);

    // Throws SceneError for bytes that are no C, an unclosed comment, a directive that scenes do not have.
    Token next();

  private:
    void skip_space_and_comments();
    void advance();
    void directive();
    void string();
    bool at(std::string_view word) const { return text_.substr(position_).starts_with(word); }

    std::string_view text_;
    std::size_t position_ = 0;
    Place place_;
    bool in_pragma_ = false;
    bool line_start_ = true;
    bool pragma_found_ = false;
};

// What may be shown of untrusted text: printable, one line, not too long; in quotes.
std::string in_quotes(std::string_view text);

// Throws SceneError. The message is formatted by fmt.
[[noreturn]] void fail_with(const Place& place, fmt::string_view message, fmt::format_args values);
template <class... Values>
[[noreturn]] void fail(const Place& place, fmt::format_string<Values...> message, Values&&... values) {
    fail_with(place, message, fmt::make_format_args(values...));
}

}  // namespace twinlight

// The tokens of the C dialect.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "scene/command/command.h"

namespace twinlight {

enum class TokenKind : std::uint8_t { kName, kNumber, kString, kPunctuation, kPragma, kDirective, kLineEnd, kEnd };

struct Token {
    TokenKind kind = TokenKind::kEnd;
    // A pragma's text is "#pragma twinlight"; the words after it are separate tokens. A string includes its quotes. A
    // character such as 'a' is a number. kDirective is the name after '#', as in #define; kLineEnd ends its line. Only
    // whole programs have characters and these two.
    std::string_view text;
    Place place;

    bool is(std::string_view punctuation_or_name) const {
        return kind != TokenKind::kNumber && kind != TokenKind::kString && kind < TokenKind::kDirective &&
               text == punctuation_or_name;
    }
};

// Splits text into tokens. Skips comments, white space, #include lines and foreign pragmas. At the end of a Twinlight
// pragma's line it adds a token ";", so a pragma can be parsed like a call.
//
// In a whole program it knows all of C's operators and characters, and gives the directives that a Preprocessor needs.
class Lexer {
  public:
    enum class Language : std::uint8_t { kScene, kProgram };

    Lexer(std::string_view text, const std::string& file, Language language = Language::kScene);

    // Throws SceneError for a character that C does not use, an unclosed comment or string, or a directive not allowed
    // in scenes. The next call continues after it; after full-width punctuation it returns the ASCII character.
    Token next();
    // Skips lines up to the next one that starts with '#'.
    void skip_to_directive();
    bool at_end() const { return position_ >= text_.size(); }
    // Moves to the end of the line. Returns what it has passed.
    std::string_view skip_line();

  private:
    void skip_space_and_comments();
    void advance();
    void directive();
    void string();
    void character();
    // The length of the operator or bracket here in a program; 0 if there is none.
    std::size_t operator_length() const;
    [[noreturn]] void refuse_character();
    bool at(std::string_view word) const { return text_.substr(position_).starts_with(word); }

    std::string_view text_;
    std::size_t position_ = 0;
    Place place_;
    bool in_pragma_ = false;
    bool line_start_ = true;
    bool pragma_found_ = false;
    Language language_;
    bool in_directive_ = false;
    std::string_view directive_;      // the name of the directive that was just found
    std::string_view replacement_{};  // the ASCII character instead of the last one; empty if there is none
};

// 'a' or '\n'; of longer ones the first character.
std::int64_t character_code(std::string_view quoted);
// Reads 16, 020 or 0x10u: invalid_argument if the text is no whole number, result_out_of_range above 63 bits.
std::errc read_whole(std::string_view digits, std::int64_t& value);
// A number of that form or a character; nullopt for others.
std::optional<std::int64_t> whole_number(std::string_view text);

// Untrusted text for a message: in quotes, one line, only printable characters, shortened if long.
std::string in_quotes(std::string_view text);

// For messages: "1 argument", "2 values".
std::string arguments_text(std::size_t count);
std::string values_text(std::size_t count);
// For the end of a message: "; did you mean glEnable?", or nothing.
std::string did_you_mean(std::optional<std::string_view> near);

// Throws SceneError. The message is a format of fmt, and is translated.
[[noreturn]] void fail_with(const Place& place, fmt::string_view message, fmt::format_args values);
template <class... Values>
[[noreturn]] void fail(const Place& place, fmt::format_string<Values...> message, Values&&... values) {
    fail_with(place, message, fmt::make_format_args(values...));
}

}  // namespace twinlight

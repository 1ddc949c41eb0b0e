// Characters outside ASCII: their numbers, and what to type instead of them in C.
#pragma once

#include <string_view>

namespace twinlight {

struct DecodedCharacter {
    char32_t character = 0;
    std::size_t bytes = 0;  // 0 if the text does not start with valid UTF-8
};
// The first character of a text in UTF-8 (RFC 3629).
DecodedCharacter decode_utf8(std::string_view text);

// The ASCII character that C uses instead of full-width and typographic punctuation: ";" for U+FF1B. "" if there is none.
std::string_view ascii_for(char32_t character);
// Whether it is one of the full-width forms of ASCII (U+FF01 to U+FF5E).
bool is_full_width(char32_t character);
// Whether it takes two columns in a terminal.
bool is_wide(char32_t character);

}  // namespace twinlight

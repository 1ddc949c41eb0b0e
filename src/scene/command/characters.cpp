#include "scene/command/characters.h"

#include <array>

namespace twinlight {

DecodedCharacter decode_utf8(std::string_view text) {
    if (text.empty()) return {};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
    char32_t character = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        character = character << 6 | (byte(i) & 0x3FU);
    }
    constexpr std::array<char32_t, 5> kSmallest = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
    if (character < kSmallest[length] || character > 0x10FFFF || is_surrogate) return {};
    return {character, length};
}

bool is_full_width(char32_t character) { return character >= 0xFF01 && character <= 0xFF5E; }

std::string_view ascii_for(char32_t character) {
    static constexpr std::string_view kAscii =
        "!\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~";
    if (is_full_width(character)) return kAscii.substr(character - 0xFF01, 1);
    switch (character) {
        case 0x00A0:              // no-break space
        case 0x3000: return " ";  // ideographic space
        case 0x037E: return ";";  // Greek question mark
        case 0x00D7: return "*";  // multiplication sign
        case 0x00F7: return "/";  // division sign
        case 0x2010:              // hyphen
        case 0x2013:              // en dash
        case 0x2014:              // em dash
        case 0x2212: return "-";  // minus sign
        case 0x201C:              // double quotation marks
        case 0x201D: return "\"";
        case 0x2018:  // single quotation marks
        case 0x2019: return "'";
        case 0x3001: return ",";  // ideographic comma
        case 0x3002: return ".";  // ideographic full stop
        case 0x3010: return "[";  // lenticular brackets
        case 0x3011: return "]";
        default: return "";
    }
}

bool is_wide(char32_t character) {
    return (character >= 0x1100 && character <= 0x115F) || (character >= 0x2E80 && character <= 0xA4CF) ||
           (character >= 0xAC00 && character <= 0xD7A3) || (character >= 0xF900 && character <= 0xFAFF) ||
           (character >= 0xFE30 && character <= 0xFE6F) || (character >= 0xFF00 && character <= 0xFF60) ||
           (character >= 0xFFE0 && character <= 0xFFE6) || (character >= 0x1F300 && character <= 0x1FAFF) ||
           (character >= 0x20000 && character <= 0x3FFFD);
}

}  // namespace twinlight

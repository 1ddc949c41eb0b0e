// Prints errors of a scene's text as compilers do.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/text/translation.h"
#include "scene/command/characters.h"
#include "scene/command/text.h"

namespace twinlight {

namespace {

std::vector<TextError> first_in_order(std::vector<TextError> errors) {
    std::ranges::stable_sort(errors, {}, [](const TextError& e) { return std::pair(e.place.line, e.place.column); });
    const auto is_same = [](const TextError& a, const TextError& b) {
        return a.place == b.place && a.message == b.message;
    };
    errors.erase(std::unique(errors.begin(), errors.end(), is_same), errors.end());
    errors.resize(std::min(errors.size(), kMaxErrorsShown));
    return errors;
}

std::string first_line(const std::vector<TextError>& errors) {
    return fmt::format("{}: {}", errors.front().place.str(), errors.front().message);
}

std::string_view line_of(std::string_view text, int line) {
    for (int i = 1; i < line; ++i) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    return text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
}

}  // namespace

SceneError::SceneError(std::vector<TextError> errors_in_text, std::shared_ptr<const std::string> scene_text)
    : std::runtime_error(first_line(first_in_order(errors_in_text))),
      errors(first_in_order(std::move(errors_in_text))),
      text(std::move(scene_text)) {}

std::string line_with_caret(std::string_view text, const Place& place) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    if (place.line < 1 || place.column < 1) return "";
    std::string_view line = line_of(text, place.line);
    if (line.empty()) return "";
    constexpr int kWidest = 120, kBefore = 80;  // of a long line, only characters near the column are shown
    const int first = place.column > kWidest ? place.column - kBefore : 1;
    std::string shown = first > 1 ? "..." : "", below = first > 1 ? "   " : "";
    for (int column = 1; !line.empty() && column < first + kWidest; ++column) {
        const auto [character, bytes] = decode_utf8(line);
        const bool is_printable =
            bytes > 0 && character >= 0x20 && character != 0x7F && (character < 0x80 || character >= 0xA0);
        const bool is_tab = character == '\t';
        if (column >= first) {
            shown += is_printable || is_tab ? std::string(line.substr(0, bytes)) : "?";
            if (column < place.column) below += is_tab ? "\t" : is_wide(character) && is_printable ? "  " : " ";
        }
        line.remove_prefix(std::max<std::size_t>(bytes, 1));
        // As in Lexer, bytes that continue a character have no column.
        while (bytes == 0 && !line.empty() && (static_cast<unsigned char>(line[0]) & 0xC0) == 0x80)
            line.remove_prefix(1);
    }
    if (!line.empty()) shown += "...";
    return shown + "\n" + below + "^\n";
}

std::string one_line(std::string_view text) {
    std::string line;
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        // U+0080 to U+009F are control characters, too; in UTF-8 the first byte is 0xc2.
        const bool is_c1 = byte(i) == 0xc2 && byte(i + 1) >= 0x80 && byte(i + 1) < 0xa0;
        if (is_c1) ++i;
        if (is_c1 || byte(i) < 0x20 || byte(i) == 0x7f)
            line += fmt::format("\\x{:02x}", byte(i));
        else
            line += text[i];
    }
    return line;
}

std::string as_compilers_print(const SceneError& error) {
    if (error.errors.empty()) return one_line(error.what()) + "\n";
    std::string printed;
    for (const TextError& one : error.errors) {
        printed += one_line(fmt::format("{}: error: {}", one.place.str(), one.message)) + "\n";
        if (error.text) printed += line_with_caret(*error.text, one.place);
    }
    if (error.errors.size() >= kMaxErrorsShown)
        printed += tr("note: only the first {} errors are shown\n", kMaxErrorsShown);
    if (!error.note.empty()) printed += "note: " + one_line(error.note) + "\n";
    return printed;
}

}  // namespace twinlight

#include "judge/lint/source.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

#include "judge/lint/lint.h"

namespace twinlight::lint {

Allowed::Allowed(std::string_view source) {
    constexpr std::string_view kMark = "// twinlight: allow(";
    int line = 1;
    for (std::size_t start = 0; start < source.size(); ++line) {
        const std::size_t end = std::min(source.find('\n', start), source.size());
        const std::string_view text = source.substr(start, end - start);
        start = end + 1;
        const std::size_t mark = text.find(kMark);
        if (mark == text.npos) continue;
        const bool is_whole_line = text.find_first_not_of(" \t") == mark;
        const std::size_t close = std::min(text.find(')', mark), text.size());
        const std::string_view names = text.substr(mark + kMark.size(), close - mark - kMark.size());
        auto& into = is_whole_line ? everywhere_ : on_line_[line];
        for (std::size_t at = 0; at < names.size();) {
            const std::size_t first = names.find_first_not_of(" ,", at);
            if (first == names.npos) break;
            at = std::min(names.find_first_of(" ,", first), names.size());
            into.emplace(names.substr(first, at - first));
        }
    }
}

bool Allowed::has(std::string_view rule, int line) const {
    const auto found = on_line_.find(line);
    return everywhere_.contains(rule) || (found != on_line_.end() && found->second.contains(rule));
}

namespace {

// Counted from 1; empty if there is none.
std::string_view line_of(std::string_view source, int line) {
    for (; line > 1; --line) {
        const std::size_t end = source.find('\n');
        if (end == source.npos) return {};
        source.remove_prefix(end + 1);
    }
    return source.substr(0, source.find('\n'));
}

// From the first byte of a statement to one past its semicolon; a pragma ends with its line.
struct Span {
    std::size_t start = 0, end = 0;
};

Span statement_at(std::string_view source, const Place& place) {
    const std::string_view line = line_of(source, place.line);
    // Columns count characters, whose later bytes in UTF-8 start with the bits 10.
    std::size_t bytes = 0;
    for (int column = 1; column < place.column && bytes < line.size(); ++column) do
            ++bytes;
        while (bytes < line.size() && (static_cast<unsigned char>(line[bytes]) & 0xC0) == 0x80);
    const std::size_t start = static_cast<std::size_t>(line.data() - source.data()) + bytes;
    if (line.starts_with('#')) return {start, static_cast<std::size_t>(line.data() - source.data()) + line.size()};
    const std::size_t semicolon = source.find(';', start);
    return {start, semicolon == source.npos ? source.size() : semicolon + 1};
}

// The blanks before a statement; empty if something else is there.
std::string indent_at(std::string_view source, std::size_t at) {
    const std::size_t line = source.rfind('\n', at == 0 ? 0 : at - 1);
    const std::size_t start = at == 0 || line == source.npos ? 0 : line + 1;
    const std::string_view before = source.substr(start, at - start);
    return before.find_first_not_of(" \t") == before.npos ? std::string(before) : "";
}

struct Change {
    Span span;  // is replaced
    std::string text;
};

// Removes the whole line if the statement is the only thing on it.
Change removal(std::string_view source, Span span) {
    const std::string indent = indent_at(source, span.start);
    const bool starts_line =
        span.start == indent.size() || (span.start > indent.size() && source[span.start - indent.size() - 1] == '\n');
    if (starts_line && span.end < source.size() && source[span.end] == '\n')
        return {{span.start - indent.size(), span.end + 1}, ""};
    return {span, ""};
}

}  // namespace

std::string mended(std::string_view source, const Warning& warning) {
    std::vector<Change> changes;
    for (const Edit& edit : warning.edits) {
        const Span at = statement_at(source, edit.place);
        const std::string indent = indent_at(source, at.start);
        std::string text = edit.insert;
        if (edit.moved.line > 0) {
            const Span from = statement_at(source, edit.moved);
            text = source.substr(from.start, from.end - from.start);
            changes.push_back(removal(source, from));
        }
        if (edit.removes && text.empty())
            changes.push_back(removal(source, at));
        else if (edit.removes)
            changes.push_back({at, text});
        else if (edit.is_after)
            changes.push_back({{at.end, at.end}, "\n" + indent + text});
        else
            changes.push_back({{at.start, at.start}, text + "\n" + indent});
    }
    std::ranges::stable_sort(changes, std::greater<>(), [](const Change& change) { return change.span.start; });
    std::string result(source);
    for (const Change& change : changes)
        result.replace(change.span.start, change.span.end - change.span.start, change.text);
    return result;
}

}  // namespace twinlight::lint

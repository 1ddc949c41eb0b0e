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

// ---- Words of a text ----

// Visits the characters of a text outside comments, strings and preprocessor lines. Columns count characters.
template <class Visit>
void for_each_character(std::string_view source, Visit visit) {
    Place at{.file = nullptr, .line = 1, .column = 1};
    bool starts_line = true;
    for (std::size_t i = 0; i < source.size();) {
        const char c = source[i];
        std::size_t length = 1;
        bool is_code = true;
        if (source.substr(i, 2) == "//" || (c == '#' && starts_line)) {
            length = std::min(source.find('\n', i), source.size()) - i;
            is_code = false;
        } else if (source.substr(i, 2) == "/*") {
            const std::size_t end = source.find("*/", i + 2);
            length = (end == source.npos ? source.size() : end + 2) - i;
            is_code = false;
        } else if (c == '"' || c == '\'') {
            std::size_t end = i + 1;
            while (end < source.size() && source[end] != c && source[end] != '\n') end += source[end] == '\\' ? 2 : 1;
            length = std::min(end + 1, source.size()) - i;
            is_code = false;
        }
        if (is_code) visit(i, at);
        for (const char passed : source.substr(i, length)) {
            if (passed == '\n') {
                ++at.line;
                at.column = 1;
                starts_line = true;
            } else {
                if ((static_cast<unsigned char>(passed) & 0xC0) != 0x80) ++at.column;
                if (passed != ' ' && passed != '\t') starts_line = false;
            }
        }
        i += length;
    }
}

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The arguments of a call, from after its "(", without blanks.
std::vector<std::string> arguments_at(std::string_view text) {
    std::vector<std::string> arguments(1);
    int depth = 0;
    for (const char c : text) {
        if (c == ')' && depth == 0) break;
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            arguments.emplace_back();
        else if (!is_blank(c))
            arguments.back() += c;
    }
    return arguments;
}

// The setting of the call that starts the text; nullopt for other calls.
std::optional<Setting> setting_of(std::string_view text) {
    struct Known {
        std::string_view function;
        std::size_t first, count;  // the arguments that name what is set
    };
    constexpr Known kKnown[] = {{"glEnable", 0, 1},      {"glLight", 0, 2},  {"glLightModel", 0, 1},
                                {"glMaterial", 1, 1},    {"glTexEnv", 1, 1}, {"glShadeModel", 0, 1},
                                {"glTexParameter", 1, 1}};
    std::size_t end = 0;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view name = text.substr(0, end);
    while (end < text.size() && is_blank(text[end])) ++end;
    if (end >= text.size() || text[end] != '(') return std::nullopt;
    for (const Known& known : kKnown) {
        if (!name.starts_with(known.function)) continue;
        const std::string_view suffix = name.substr(known.function.size());
        if (suffix != "" && suffix != "f" && suffix != "i" && suffix != "fv" && suffix != "iv") continue;
        std::vector<std::string> names = arguments_at(text.substr(end + 1));
        if (names.size() < known.first + known.count) return std::nullopt;
        names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(known.first));
        names.resize(known.count);
        for (std::string& one : names)
            if (!one.starts_with("GL_") || !std::ranges::all_of(one, is_word)) one.clear();
        return Setting{std::string(known.function), std::move(names)};
    }
    return std::nullopt;
}

bool may_be_same(const Setting& a, const Setting& b) {
    if (a.function != b.function) return false;
    for (std::size_t i = 0; i < a.names.size(); ++i)
        if (!a.names[i].empty() && !b.names[i].empty() && a.names[i] != b.names[i]) return false;
    return true;
}

}  // namespace

CallsNotRun::CallsNotRun(const CommandList& list) {
    if (!list.window || !list.text || !list.steps.empty()) return;  // only whole programs have calls that are not run
    std::set<std::pair<int, int>> run;
    for (const Command& command : list.commands) run.emplace(command.place.line, command.place.column);
    const std::string_view source = *list.text;
    for_each_character(source, [&](std::size_t i, const Place& place) {
        const bool starts_word = source.substr(i).starts_with("gl") && (i == 0 || !is_word(source[i - 1]));
        if (!starts_word || run.contains({place.line, place.column})) return;
        if (std::optional<Setting> setting = setting_of(source.substr(i))) settings_.push_back(std::move(*setting));
    });
}

bool CallsNotRun::fix(const Warning& warning) const {
    const auto is_made = [&](std::string_view call) {
        const std::optional<Setting> wanted = setting_of(call);
        return wanted &&
               std::ranges::any_of(settings_, [&](const Setting& made) { return may_be_same(made, *wanted); });
    };
    if (warning.edits.empty()) return is_made(warning.fix);
    return std::ranges::any_of(warning.edits, [&](const Edit& edit) { return is_made(edit.insert); });
}

bool Statement::holds(const Place& place) const {
    const auto position = [](const Place& at) { return std::pair(at.line, at.column); };
    return position(first) <= position(place) && position(place) <= position(last);
}

std::vector<Statement> statements_with(std::string_view source, bool (*test)(const std::string& statement)) {
    std::vector<Statement> found;
    Statement open;
    for_each_character(source, [&](std::size_t i, const Place& place) {
        const char c = source[i];
        if (is_blank(c)) return;
        if (open.text.empty()) open.first = place;
        open.last = place;
        if (c != ';' && c != '{' && c != '}') {
            open.text += c;
            return;
        }
        if (test(open.text)) found.push_back(open);
        open.text.clear();
    });
    return found;
}

std::string corrected(std::string_view source, const Warning& warning) {
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

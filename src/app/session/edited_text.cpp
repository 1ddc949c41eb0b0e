#include "app/session/edited_text.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "app/session/alignment.h"
#include "scene/command/text.h"

namespace twinlight::session {

namespace {

// Where to change the text: by the first byte of a command.
struct TextChange {
    std::string before;                      // statements to insert before the command, a line each
    std::optional<std::string> replacement;  // of the command's statement
};
using TextChanges = std::map<std::size_t, TextChange>;

// Finds bytes by line and column. A column is a character, not a byte.
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {
        for (std::size_t at = 0; at <= text.size(); at = std::min(text.find('\n', at), text.size()) + 1)
            starts_.push_back(at);
    }
    std::size_t at(const Place& place) const {
        if (place.line < 1 || static_cast<std::size_t>(place.line) > starts_.size()) return text_.size();
        std::size_t at = starts_[static_cast<std::size_t>(place.line - 1)];
        const auto continues = [&] { return (static_cast<unsigned char>(text_[at]) & 0xC0) == 0x80; };
        for (int column = 1; column < place.column && at < text_.size(); ++column)
            for (++at; at < text_.size() && continues();) ++at;
        return at;
    }

  private:
    std::string_view text_;
    std::vector<std::size_t> starts_;
};

// The end of the statement that starts here.
std::size_t end_of_statement(std::string_view text, std::size_t at) {
    const auto after = [&](std::string_view end, std::size_t from) {
        const std::size_t found = text.find(end, from);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    if (text.substr(at).starts_with("#")) return std::min(text.find('\n', at), text.size());
    while (at < text.size()) {
        if (text.substr(at).starts_with("//"))
            at = after("\n", at);
        else if (text.substr(at).starts_with("/*"))
            at = after("*/", at + 2);
        else if (text[at] == '"')
            at = after("\"", at + 1);
        else if (text[at++] == ';')
            return at;
    }
    return at;
}

// The arguments of "name(a, b) ;" in a text of C, without those of calls within; each with its blanks. Empty if there are none.
struct Arguments {
    std::vector<std::string_view> texts;
    std::size_t start = 0, end = 0;  // of all of them in the text
};
Arguments arguments_of(std::string_view text) {
    Arguments found;
    const std::size_t open = text.find('(');
    if (open == std::string_view::npos) return found;
    found.start = open + 1;
    std::size_t from = open + 1;
    int depth = 0;
    bool is_string = false;
    for (std::size_t at = open + 1; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') is_string = !is_string;
        if (is_string) continue;
        if (c == '/' && at + 1 < text.size() && (text[at + 1] == '/' || text[at + 1] == '*')) return {};  // a comment
        const bool closes = c == ')' || c == '}' || c == ']';
        if ((closes || c == ',') && depth == 0) {
            found.texts.push_back(text.substr(from, at - from));
            from = at + 1;
            found.end = at;
            if (closes) return found;
        }
        if (c == '(' || c == '{' || c == '[') ++depth;
        if (closes) --depth;
    }
    return {};
}

// The statement with `now`'s arguments where they differ from those before. The others stay as they are written.
std::string changed_statement(std::string_view statement, const Command& before, const Command& now) {
    const std::string printed_before = print_command(before), printed = print_command(now);
    const Arguments written = arguments_of(statement), old = arguments_of(printed_before),
                    wanted = arguments_of(printed);
    const std::size_t count = written.texts.size();
    if (before.id != now.id || count == 0 || old.texts.size() != count || wanted.texts.size() != count) return printed;
    std::string result(statement.substr(0, written.start));
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) result += ',';
        const std::string_view text = old.texts[i] == wanted.texts[i] ? written.texts[i] : wanted.texts[i];
        // The first blanks stay as they are written.
        const std::string_view was = written.texts[i];
        result += was.substr(0, std::min(was.find_first_not_of(" \t\n"), was.size()));
        result += text.substr(std::min(text.find_first_not_of(" \t\n"), text.size()));
    }
    return result + std::string(statement.substr(written.end));
}

// Of several changes at one place, as in a loop, the first counts. Empty if a change is in a text that this one includes.
std::optional<TextChanges> changes_of(std::string_view text, const CommandList& before, const CommandList& edited) {
    const Lines lines(text);
    const auto partners = aligned(before.commands.size(), edited.commands.size(), [&](std::size_t b, std::size_t e) {
        const Place& place = edited.commands[e].place;
        return place.line > 0 && place == before.commands[b].place;
    });
    TextChanges changes;
    bool is_elsewhere = false;
    const auto at_command = [&](const Command& old) -> TextChange& {
        if (old.place.file && before.included.contains(*old.place.file)) is_elsewhere = true;
        return changes[lines.at(old.place)];
    };
    const auto statement_of = [&](const Command& old) {
        const std::size_t at = lines.at(old.place);
        return text.substr(at, end_of_statement(text, at) - at);
    };
    std::size_t next = 0;  // the command of `before` that is looked at next
    std::string inserted;
    for (std::size_t i = 0; i < edited.commands.size(); ++i) {
        const Command& command = edited.commands[i];
        if (!partners[i]) {
            inserted += print_command(command) + "\n";
            continue;
        }
        for (; next < *partners[i]; ++next) at_command(before.commands[next]).replacement = "";
        const Command& old = before.commands[next++];
        if (!inserted.empty()) at_command(old).before += std::exchange(inserted, {});
        if (command == old) continue;
        TextChange& change = at_command(old);
        if (!change.replacement) change.replacement = changed_statement(statement_of(old), old, command);
    }
    for (; next < before.commands.size(); ++next) at_command(before.commands[next]).replacement = "";
    if (!inserted.empty()) changes[text.size()].before += inserted;
    if (is_elsewhere) return {};
    return changes;
}

std::string with_changes(std::string_view text, const TextChanges& changes) {
    std::string result;
    std::size_t done = 0;
    for (const auto& [at, change] : changes) {
        if (at < done) continue;  // a place within a statement that was replaced
        result += text.substr(done, at - done);
        done = at;
        // Inserted lines are indented as the command's own line.
        const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
        const std::string_view indent = text.substr(line, at - line);
        const bool is_first = indent.find_first_not_of(" \t") == std::string_view::npos;
        for (const char c : change.before)
            if (c != '\n')
                result += c;
            else
                result += is_first ? "\n" + std::string(indent) : " ";
        if (!change.replacement) continue;
        result += *change.replacement;
        done = end_of_statement(text, at);
        if (!change.replacement->empty()) continue;
        // Nothing stays of a line that has only the statement.
        const std::size_t rest = text.find_first_not_of(" \t", done);
        if (!is_first || (rest != std::string_view::npos && text[rest] != '\n')) continue;
        done = rest == std::string_view::npos ? text.size() : rest + 1;
        result.resize(result.size() - indent.size());
    }
    return result + std::string(text.substr(done));
}

}  // namespace

std::optional<std::string> edited_text(std::string_view text, const CommandList& before, const CommandList& edited,
                                       const std::function<CommandList(std::string_view)>& read) {
    if (edited.commands == before.commands) return std::string(text);
    const std::optional<TextChanges> changes = changes_of(text, before, edited);
    if (!changes) return {};
    std::string result = with_changes(text, *changes);
    try {
        if (read(result).commands == edited.commands) return result;
    } catch (const SceneError&) {
    }
    return {};
}

CommandList with_places_of(const CommandList& opened, CommandList edited) {
    const auto& before = opened.commands;
    const auto partners = aligned(before.size(), edited.commands.size(),
                                  [&](std::size_t b, std::size_t e) { return before[b] == edited.commands[e]; });
    std::size_t next = 0;  // the command of `before` that is looked at next
    for (std::size_t i = 0, end = 0; i < edited.commands.size(); ++i) {
        Command& command = edited.commands[i];
        if (partners[i]) {
            next = *partners[i];
        } else {
            // A command that was changed takes the place of the next one with its name, before those that are equal.
            for (end = i; end < partners.size() && !partners[end];) ++end;
            const std::size_t last = end < partners.size() ? *partners[end] : before.size();
            std::size_t found = next;
            while (found < last && before[found].id != command.id) ++found;
            if (found == last) {
                command.place = Place{command.place.file};
                continue;
            }
            next = found;
        }
        command.place = before[next++].place;
    }
    edited.text = opened.text;  // the one that the places are in
    edited.name = opened.name;
    return edited;
}

}  // namespace twinlight::session

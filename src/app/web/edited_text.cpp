#include "app/web/edited_text.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "scene/command/text.h"

namespace twinlight::web {

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

// Of several changes at one place, as in a loop, the first counts.
TextChanges changes_of(const Lines& lines, const CommandList& before, const CommandList& edited, std::size_t end) {
    TextChanges changes;
    TextChange next;
    std::size_t i = 0;
    for (const Command& command : edited.commands) {
        if (command.place.line == 0) {
            next.before += print_command(command) + "\n";
            continue;
        }
        if (i == before.commands.size()) break;
        const Command& old = before.commands[i++];
        if (command != old) next.replacement = print_command(command);
        if (next.before.empty() && !next.replacement) continue;
        changes.try_emplace(lines.at(old.place), std::move(next));
        next = {};
    }
    if (!next.before.empty()) changes.try_emplace(end, std::move(next));
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
    }
    return result + std::string(text.substr(done));
}

}  // namespace

std::optional<std::string> edited_text(std::string_view text, const CommandList& before, const CommandList& edited,
                                       const std::function<CommandList(std::string_view)>& read) {
    if (edited.commands == before.commands) return std::string(text);
    std::string result = with_changes(text, changes_of(Lines(text), before, edited, text.size()));
    try {
        if (read(result).commands == edited.commands) return result;
    } catch (const SceneError&) {
    }
    return {};
}

}  // namespace twinlight::web

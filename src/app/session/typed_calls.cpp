#include "app/session/typed_calls.h"

#include <algorithm>
#include <utility>

#include "app/session/edits.h"
#include "base/text/translation.h"
#include "scene/command/text.h"

namespace twinlight::session {

void insert_calls(Session& session, std::string_view text, std::optional<std::size_t> replaced) {
    const CommandList typed = read_scene(text, tr("the typed call"), tr("the typed call"));
    CommandList edited = commands(session);
    std::size_t at = edited.commands.size();
    if (session.selected_command && *session.selected_command < at)
        at = end_of_group(edited, *session.selected_command) + 1;
    if (replaced) {
        at = *replaced;
        edited = without_command(edited, at);
    }
    at = std::min(at, edited.commands.size());
    for (std::size_t i = 0; i < typed.commands.size(); ++i) {
        Command command = typed.commands[i];
        // One that is not the replaced call has no place in the scene's text.
        command.place = replaced && i == 0 ? commands(session).commands[*replaced].place : Place{};
        edited = with_inserted(edited, at + i, std::move(command));
    }
    edit(session, std::move(edited), tr(replaced ? "change a call" : "insert a call"));
    session.selected_command = at;
}

std::string selected_calls(const Session& session) {
    const CommandList& list = commands(session);
    if (!session.selected_command || *session.selected_command >= list.commands.size()) return "";
    std::string text;
    for (std::size_t i = *session.selected_command; i <= end_of_group(list, *session.selected_command); ++i)
        text += print_command(list.commands[i]) + "\n";
    return text;
}

std::optional<std::size_t> find_call(const Session& session, std::string_view pattern, std::size_t start) {
    const std::vector<Command>& list = commands(session).commands;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t at = (start + i) % list.size();
        if (has_text(print_command(list[at]), pattern)) return at;
    }
    return {};
}

// (With g++ 12's library, clang 14 cannot compile std::ranges::search().)
bool has_text(std::string_view text, std::string_view pattern) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    const auto is_same = [&](char a, char b) { return lower(a) == lower(b); };
    return std::search(text.begin(), text.end(), pattern.begin(), pattern.end(), is_same) != text.end();
}

}  // namespace twinlight::session

#include "app/session/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include "app/session/edits.h"
#include "base/text/translation.h"
#include "judge/lint/source.h"
#include "judge/lint/tried.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session {
namespace {

// Commands may come from several texts or from none, so each gets its number as its place.
std::shared_ptr<const CommandList> numbered(const CommandList& commands) {
    auto list = std::make_shared<CommandList>(commands);
    list->text = nullptr;
    list->later = nullptr;  // they are of the text, not of the edited commands
    int line = 0;
    for (Command& command : list->commands) command.place = {nullptr, ++line, 1};
    return list;
}

std::optional<std::size_t> index_of(const Place& place, std::size_t count) {
    if (place.line < 1 || static_cast<std::size_t>(place.line) > count) return {};
    return static_cast<std::size_t>(place.line) - 1;
}

bool is_silenced(const CommandList& commands, const lint::Allowed& allowed, const Finding& finding) {
    return allowed.has(finding.warning.rule->name, commands.commands[finding.command].place.line);
}

std::string where(const Command& command) {
    const Place& place = command.place;
    return place.line > 0 && place.column > 0 ? tr("line {}", place.line) : tr("inserted here");
}

// The linter saw the numbers of commands as lines. "(line 12)" becomes the line of command 12, in any language.
std::string with_lines(const std::string& message, const CommandList& commands) {
    const std::string_view line = translation_of("line {}"), before = line.substr(0, line.find('{')),
                           after = line.substr(line.find('}') + 1);
    std::string text;
    for (std::size_t at = 0; at < message.size();) {
        int number = 0;
        const char* digits = message.data() + at + before.size();
        const char* end = message.data() + message.size();
        if (message.compare(at, before.size(), before) == 0) {
            const auto read = std::from_chars(digits, end, number);
            const auto next = static_cast<std::size_t>(read.ptr - message.data());
            if (read.ec == std::errc() && number >= 1 && static_cast<std::size_t>(number) <= commands.commands.size() &&
                message.compare(next, after.size(), after) == 0) {
                text += where(commands.commands[static_cast<std::size_t>(number) - 1]);
                at = next + after.size();
                continue;
            }
        }
        text += message[at++];
    }
    return text;
}

// As for `twinlight lint --fix`: a statement that is removed in many places is not corrected at one of them.
bool can_fix(const lint::Warning& warning, std::size_t count) {
    if (warning.edits.empty()) return false;
    for (const lint::Edit& edit : warning.edits) {
        if (!index_of(edit.place, count)) return false;
        if (edit.moved.line > 0 && !index_of(edit.moved, count)) return false;
        if (edit.removes && warning.count > 1) return false;
    }
    return true;
}

}  // namespace

std::vector<Finding> findings_of(const CommandList& commands, WindowSize size) {
    StateOptions options;
    options.width = size.width;
    options.height = size.height;
    const Scene scene = make_scene(numbered(commands), options);
    std::vector<lint::Warning> warnings = lint::lint(scene);
    lint::try_fixes(scene, {}, warnings);
    std::vector<Finding> findings;
    for (lint::Warning& warning : warnings) {
        const auto index = index_of(warning.place, commands.commands.size());
        if (!index) continue;
        const bool fixes = can_fix(warning, commands.commands.size());
        warning.message = with_lines(warning.message, commands);
        warning.fix = with_lines(warning.fix, commands);
        findings.push_back({std::move(warning), *index, where(commands.commands[*index]), fixes});
    }
    if (commands.text) {
        const lint::Allowed allowed(*commands.text);
        const lint::CallsNotRun not_run(commands);
        std::erase_if(findings, [&](const Finding& finding) {
            return is_silenced(commands, allowed, finding) || not_run.fix(finding.warning);
        });
    }
    return findings;
}

CommandList corrected(const CommandList& commands, const Finding& finding) {
    // What to write before and after each command, and which commands go.
    struct Change {
        std::vector<Command> before, after;
        bool removed = false;
    };
    const std::size_t count = commands.commands.size();
    std::vector<Change> changes(count);
    for (const lint::Edit& edit : finding.warning.edits) {
        const auto at = index_of(edit.place, count);
        if (!at) continue;
        std::vector<Command> written;
        if (const auto from = index_of(edit.moved, count)) {
            written = {commands.commands[*from]};
            changes[*from].removed = true;
        } else if (!edit.insert.empty()) {
            written = read_scene(edit.insert, tr("the window"), tr("the window")).commands;
            // They keep the place of what they replace.
            for (Command& command : written) {
                if (edit.removes)
                    command.place = commands.commands[*at].place;
                else
                    command.place.line = command.place.column = 0;  // "the window"
            }
        }
        Change& change = changes[*at];
        change.removed = change.removed || edit.removes;
        std::vector<Command>& into = edit.is_after ? change.after : change.before;
        into.insert(into.end(), written.begin(), written.end());
    }
    CommandList result = commands;
    result.commands.clear();
    for (std::size_t i = 0; i < count; ++i) {
        Change& change = changes[i];
        std::ranges::move(change.before, std::back_inserter(result.commands));
        if (!change.removed) result.commands.push_back(commands.commands[i]);
        std::ranges::move(change.after, std::back_inserter(result.commands));
    }
    return result;
}

}  // namespace twinlight::session

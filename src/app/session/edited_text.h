// A scene's text after its commands were edited. The text changes only where arguments of commands have changed, so comments,
// expressions, steps and layout stay.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight::session {

// `before` are the commands of the text, `edited` the same after edits of app/session: some are changed, missing or moved, and
// inserted ones have line 0. `read` reads a text as `before` was read. Empty if no such text gives these commands: for example,
// because a loop has a command whose repetitions differ now.
std::optional<std::string> edited_text(std::string_view text, const CommandList& before, const CommandList& edited,
                                       const std::function<CommandList(std::string_view)>& read);

// `edited`, the commands of another version of the text, with the places that they have in `opened`'s text.
CommandList with_places_of(const CommandList& opened, CommandList edited);

}  // namespace twinlight::session

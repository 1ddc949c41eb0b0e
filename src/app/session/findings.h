// Findings: the linter's warnings about the window's commands, each with its command and an edit that fixes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/lint/lint.h"
#include "scene/command/command.h"

namespace twinlight::session {

struct Finding {
    lint::Warning warning;    // its places are numbers of commands, not of lines
    std::size_t command = 0;  // the index of the command that it is about
    std::string where;        // "line 14", "inserted here": where that command came from
    bool can_fix = false;     // otherwise the user must choose; Warning::fix says what to write
};

// The warnings about these commands in a picture of this size. Comments in the scene's text silence rules, as in `twinlight
// lint`. Throws SceneError for commands that GL refuses.
std::vector<Finding> findings_of(const CommandList& commands, WindowSize size);

// The commands with the mistake corrected. They must be the ones that the finding is about.
CommandList corrected(const CommandList& commands, const Finding& finding);

}  // namespace twinlight::session

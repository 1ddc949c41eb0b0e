// History: the commands that the window shows, with the edits that can be undone.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::session {

class History {
  public:
    explicit History(std::shared_ptr<const CommandList> opened);

    // The commands as they are now.
    const std::shared_ptr<const CommandList>& now() const { return steps_[at_].commands; }
    // Counts every change, undo and redo, so that equal numbers mean equal commands.
    int revision() const { return revision_; }
    // Counts on from another history, so that this holds for both.
    void count_from(int revision) { revision_ = revision; }

    // Replaces the commands. `what` names the edit for the user ("glLightfv, value 2"). Edits of the same non-empty `group`
    // that follow each other are one step: a drag. A list that equals the present one is no edit.
    void edit(CommandList commands, std::string what, std::string group = {});
    // The next edit starts a step of its own.
    void end_group() { steps_[at_].group.clear(); }

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    // What was undone or redone; empty if there was nothing.
    std::string undo();
    std::string redo();

  private:
    struct Step {
        std::shared_ptr<const CommandList> commands;
        std::string what, group;
    };
    std::vector<Step> steps_;
    std::size_t at_ = 0;
    int revision_ = 0;
};

}  // namespace twinlight::session

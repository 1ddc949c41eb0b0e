#include "app/session/history.h"

#include <algorithm>
#include <utility>

namespace twinlight::session {
namespace {

constexpr std::size_t kMostSteps = 200;  // the oldest are forgotten

}  // namespace

History::History(std::shared_ptr<const CommandList> opened) { steps_.push_back({std::move(opened), "", ""}); }

void History::edit(CommandList commands, std::string what, std::string group) {
    if (commands.commands == now()->commands && commands.step == now()->step) return;
    const bool same_step = !group.empty() && group == steps_[at_].group;
    steps_.resize(at_ + 1);
    Step step{std::make_shared<const CommandList>(std::move(commands)), std::move(what), std::move(group)};
    if (same_step) {
        steps_[at_] = std::move(step);
    } else {
        steps_.push_back(std::move(step));
        if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
        at_ = steps_.size() - 1;
    }
    ++revision_;
}

std::string History::undo() {
    if (!can_undo()) return "";
    end_group();
    ++revision_;
    return steps_[at_--].what;
}

std::string History::redo() {
    if (!can_redo()) return "";
    ++revision_;
    ++at_;
    end_group();
    return steps_[at_].what;
}

}  // namespace twinlight::session

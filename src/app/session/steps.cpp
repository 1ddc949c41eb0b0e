#include "app/session/steps.h"

#include <fmt/format.h>

#include <utility>

#include "app/session/camera.h"
#include "base/text/translation.h"

namespace twinlight::session {

std::string step_caption(const CommandList& commands) {
    if (commands.step == 0) return "";
    return tr("step {} of {}: {}", commands.step, commands.steps.size(), tr(commands.steps[commands.step - 1]));
}

std::string neighbour_step(const CommandList& commands, int away) {
    const int count = static_cast<int>(commands.steps.size());
    const int step = ((static_cast<int>(commands.step) - 1 + away) % count + count) % count;
    return std::to_string(step + 1);
}

void show_step(Session& session, std::shared_ptr<const CommandList> step) {
    const CommandList& now = commands(session);
    const bool is_edited = with_camera_of(*session.opened, *session.opened, now).commands != now.commands;
    CommandList shown = with_camera_of(*step, *session.opened, now);
    std::string caption = step_caption(*step);
    session.opened_steps[step->step] = step;
    session.opened = std::move(step);
    session.selected_command.reset();
    edit(session, std::move(shown), std::move(caption));
    session.history.end_group();
    say(session, is_edited ? tr("the step as the file has it; z brings your changes back") : "");
}

}  // namespace twinlight::session

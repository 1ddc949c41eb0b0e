#include "app/session/tutor.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "app/session/argument_places.h"
#include "base/text/translation.h"
#include "scene/scenes/load.h"

namespace twinlight::session {
namespace {

bool is_of_lighting(const Command& command) {
    const auto owner = owner_of_command(command);
    return owner == Owner::kLight || owner == Owner::kMaterial || owner == Owner::kLightModel ||
           effect_of(command) == "normal";
}

std::string scene_name(std::string_view tutor) { return "tutor-" + std::string(tutor); }

}  // namespace

std::string tutor_text(std::string_view tutor) {
    return std::string(std::ranges::find(kTutorFiles, std::string(tutor) + ".gl", &EmbeddedFile::name)->text);
}

std::shared_ptr<const CommandList> tutor_scene(std::string_view tutor) {
    return std::make_shared<const CommandList>(read_text_of("", scene_name(tutor), tutor_text(tutor)));
}

void open_tutor(Session& session, std::string_view tutor) {
    const std::string name = scene_name(tutor);
    if (key_of(session) != name && !reopen(session, name)) open(session, tutor_scene(tutor), std::nullopt);
    session.view = View::kTutor;
    session.panes[0] = Pane{Path::kFixed};
    session.active = 0;
    session.overlays.normals = tutor == "normals";
    say(session, tr("drag a number; u: the next tutor; Shift+Tab: the other views"));
}

void next_tutor(Session& session) {
    const auto here =
        std::ranges::find_if(kTutors, [&](const TutorName& tutor) { return scene_name(tutor.key) == key_of(session); });
    const auto count = std::ssize(kTutors);
    const bool is_shown = here != std::end(kTutors) && session.view == View::kTutor;
    const std::ptrdiff_t next = is_shown ? (here - std::begin(kTutors) + 1) % count : 0;
    open_tutor(session, kTutors[next].key);
}

std::vector<std::size_t> tutor_calls(const CommandList& commands) {
    std::vector<std::size_t> calls;
    for (std::size_t i = 0; i < commands.commands.size() && calls.size() < kTutorCalls; ++i)
        if (is_of_lighting(commands.commands[i])) calls.push_back(i);
    return calls;
}

}  // namespace twinlight::session

#include "app/web/page_controls.h"

#include <algorithm>
#include <utility>

#include "app/session/edited_text.h"
#include "base/text/json.h"
#include "scene/command/text.h"

namespace twinlight::web {

std::string page_keys() {
    Json keys = Json::array();
    for (const session::Key& key : session::keys())
        if (key.in_page)
            keys.push_back({{"first", key.first}, {"last", key.last}, {"label", key.label}, {"what", key.what}});
    return dumped(keys);
}

PageControls::PageControls(std::shared_ptr<const CommandList> opened, std::string text, WindowSize size, Read read)
    : session_(std::move(opened)), opened_text_(std::move(text)), text_(opened_text_), read_(std::move(read)) {
    refresh(session_, size.width, size.height);
    text_of_ = session_.history.revision();
}

bool PageControls::shows(std::string_view text, std::size_t step) const {
    return text == text_ &&
           (step == session_.opened->step || step == 0);  // 0: the text that is written again has no steps
}

std::string PageControls::press(int code) {
    const auto has = [code](const session::Key& key) { return key.in_page && key.first <= code && code <= key.last; };
    return answer(std::ranges::any_of(session::keys(), has) && session::press(session_, code));
}

void PageControls::start_drag(bool may_go_under) {
    refresh(session_, session_.width, session_.height);
    session_.history.end_group();
    drag_start_ = session::start_drag(session_);
    drag_start_.may_go_under = may_go_under;
}

std::string PageControls::drag(bool looks, int dx, int dy) {
    (looks ? session::look : session::orbit)(session_, drag_start_, dx, dy);
    return answer(true);
}

std::string PageControls::zoom(int steps) {
    session::zoom(session_, steps);
    return answer(true);
}

// Makes the text from the commands.
void PageControls::follow() {
    if (text_of_ == session_.history.revision()) return;
    text_of_ = session_.history.revision();
    const CommandList& now = commands(session_);
    if (auto edited = session::edited_text(opened_text_, *session_.opened, now, read_)) {
        text_ = std::move(*edited);
        return;
    }
    text_ = print_scene(now);
    say(session_,
        "The scene is written again, command by command, because this change does not fit into its text; z brings it "
        "back.");
}

std::string PageControls::answer(bool known) {
    refresh(session_, session_.width, session_.height);
    follow();
    const Json json = {
        {"known", known},
        {"text", text_},
        {"shown", session_.opened->step},
        {"message", std::exchange(messages_, session_.messages) == session_.messages ? "" : session_.message},
        {"scene", std::exchange(session_.scene_requested, 0)},
        {"step", std::exchange(session_.step_requested, 0)},
        {"exports", std::exchange(session_.export_requested, false)},
        {"keys", std::exchange(session_.keys_shown, false)}};
    return dumped(json);
}

}  // namespace twinlight::web

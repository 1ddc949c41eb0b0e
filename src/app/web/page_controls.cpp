#include "app/web/page_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/argument_places.h"
#include "app/session/arguments.h"
#include "app/session/edited_text.h"
#include "app/session/edits.h"
#include "app/session/tutor.h"
#include "base/text/json.h"
#include "scene/command/print_parts.h"
#include "scene/command/text.h"

namespace twinlight::web {

std::string page_keys() {
    Json keys = Json::array();
    for (const session::Key& key : session::keys())
        if (key.in_page)
            keys.push_back({{"first", key.first}, {"last", key.last}, {"label", key.label}, {"what", key.what}});
    return dumped(keys);
}

std::string page_tutors() {
    Json tutors = Json::array();
    for (const session::TutorName& tutor : session::kTutors)
        tutors.push_back({{"name", tutor.key}, {"text", session::tutor_text(tutor.key)}});
    return dumped(tutors);
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
    if (looks)
        session::look(session_, drag_start_, dx, dy);
    else
        session::orbit(session_, drag_start_, dx, dy);
    return answer(true);
}

std::string PageControls::zoom(int steps) {
    session::zoom(session_, steps);
    return answer(true);
}

namespace {

constexpr std::size_t kNumbers = 3;

// What a change shows best comes first: where a lamp is, then how its light spreads or how smooth the surface is.
int rank_of(const Command& command) {
    const ParameterInfo* set = session::parameter_set(command);
    if (!set) return 2;
    if (set->pname == kGL_POSITION) return 0;
    return set->pname == kGL_SHININESS || set->pname == kGL_SPOT_CUTOFF ? 1 : 2;
}

// "GL_LIGHT0 GL_POSITION x", "glNormal3f x"
std::string name_of_number(const Command& command, std::size_t argument) {
    const auto pname = session::pname_argument(command);
    std::string name = pname ? "" : std::string(command.name()) + " ";
    for (std::size_t i = 0; pname && i <= *pname; ++i)
        name += session::printed_argument(command, i, command.number(i)) + " ";
    const std::string own = session::argument_info(command, argument).name;
    return name.find(own + " ") == std::string::npos ? name + own : name.substr(0, name.size() - 1);
}

}  // namespace

std::vector<PageControls::Number> PageControls::found_numbers() const {
    const std::vector<Command>& all = commands(session_).commands;
    std::vector<std::size_t> ranked;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (session::pname_argument(all[i]) && (session::owner_of_command(all[i]) == Owner::kLight ||
                                                session::owner_of_command(all[i]) == Owner::kMaterial))
            ranked.push_back(i);
    std::ranges::stable_sort(ranked, {}, [&](std::size_t i) { return rank_of(all[i]); });
    std::vector<Number> numbers;
    std::size_t of_first_rank = 0;
    for (const std::size_t command : ranked) {
        // Two of the lamp's place, so that the third may be something else.
        const bool is_place = rank_of(all[command]) == 0;
        for (std::size_t argument = 0; argument < all[command].arguments.size(); ++argument) {
            if (numbers.size() == kNumbers) return numbers;
            if (is_place && of_first_rank == 2) break;
            if (!session::is_parameter_value(all[command], argument) ||
                session::argument_info(all[command], argument).editing != session::Editing::kNumber)
                continue;
            numbers.push_back({command, argument});
            if (is_place) ++of_first_rank;
        }
    }
    return numbers;
}

namespace {

Json json_of_number(const CommandList& commands, std::size_t index, std::size_t argument) {
    const Command& command = commands.commands[index];
    const session::ArgumentInfo info = session::argument_info(command, argument);
    const bool is_flag = info.editing == session::Editing::kFlag;
    return {{"command", index},
            {"argument", argument},
            {"name", name_of_number(command, argument)},
            {"value", command.number(argument)},
            {"smallest", is_flag ? 0 : info.smallest},
            {"largest", is_flag ? 1 : info.largest},
            {"step", info.drag_speed}};
}

}  // namespace

std::string PageControls::numbers() const {
    Json json = Json::array();
    for (const auto& [command, argument] : found_numbers())
        json.push_back(json_of_number(commands(session_), command, argument));
    return dumped(json);
}

std::string PageControls::calls() const {
    Json json = Json::array();
    for (const std::size_t index : session::tutor_calls(commands(session_))) {
        const Command& command = commands(session_).commands[index];
        Json parts = Json::array();
        for (const PrintedPart& printed : print_parts(command)) {
            Json& part = parts.emplace_back(Json{{"text", printed.text}});
            if (!printed.argument) continue;
            const session::ArgumentInfo info = session::argument_info(command, *printed.argument);
            part["help"] = session::argument_help(command, *printed.argument);
            part["is_color"] = info.is_color;
            if (info.editing == session::Editing::kNumber || info.editing == session::Editing::kFlag)
                part["number"] = json_of_number(commands(session_), index, *printed.argument);
        }
        json.push_back(std::move(parts));
    }
    return dumped(json);
}

std::string PageControls::set_argument(std::size_t command, std::size_t argument, double value) {
    const std::vector<Command>& all = commands(session_).commands;
    if (command < all.size() && argument < all[command].arguments.size()) {
        const double legal = session::nearest_legal(all[command], argument, value);
        edit(session_, session::with_argument(commands(session_), command, argument, legal),
             name_of_number(all[command], argument), fmt::format("argument {} {}", command, argument));
    }
    return answer(true);
}

void PageControls::press_world(int x, int y) {
    session_.history.end_group();
    world_.press(session_, x, y);
}

std::string PageControls::drag_world(int dx, int dy) {
    world_.drag(session_, dx, dy);
    return answer(true);
}

std::string PageControls::zoom_world(int steps) {
    world_.zoom(steps);
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

#include "app/demo/dialogs.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <utility>

#include "app/demo/panel_lesson.h"
#include "app/demo/panes.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/keys.h"
#include "app/session/language.h"
#include "app/session/lesson_state.h"
#include "app/session/saving.h"
#include "app/session/scenes.h"
#include "app/session/tutor.h"
#include "app/session/typed_calls.h"
#include "base/image/file.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "scene/command/names.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/scenes/scene_groups.h"

namespace twinlight::demo {

namespace fs = std::filesystem;
using session::Dialog;
using session::Session;

namespace {

// By the values of Dialog.
constexpr const char* kDialogTitles[] = {"",
                                         "menu",
                                         "Open a scene",
                                         "Save as",
                                         "find",
                                         "Save the changes?",
                                         "The file has changed",
                                         "Changes were not saved",
                                         "Record the program?"};
static_assert(std::size(kDialogTitles) == static_cast<std::size_t>(Dialog::kRecord) + 1);

bool is_popup(Dialog dialog) { return dialog == Dialog::kMenu || dialog == Dialog::kFind; }

bool begin_dialog(Dialog dialog) {
    const char* const title = tr(kDialogTitles[static_cast<std::size_t>(dialog)]);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    return is_popup(dialog) ? ImGui::BeginPopup(title, kFlags) : ImGui::BeginPopupModal(title, nullptr, kFlags);
}

std::string names_of(const std::vector<const session::OpenScene*>& scenes) {
    std::string names;
    for (const session::OpenScene* scene : scenes) names += (names.empty() ? "" : ", ") + session::title_of(*scene);
    return names;
}

}  // namespace

void Dialogs::offer(Session& session, session::LostScenes lost) {
    lost_ = std::move(lost);
    session.dialog = Dialog::kRecovered;
}

// What the dialog starts with.
void Dialogs::begin(const Session& session) {
    error_.clear();
    replaced_.clear();
    text_[0] = '\0';
    takes_focus_ = true;
    if (session.dialog == Dialog::kSaveAs) {
        const std::string path =
            session.file.value_or(session::free_path("", session::stem_of(key_of(session)), ".gl"));
        path.copy(text_.data(), text_.size() - 1);
        text_[std::min(path.size(), text_.size() - 1)] = '\0';
    }
    if (session.dialog == Dialog::kOpen) list_openable(session);
}

void Dialogs::show(Session& session, Panes& panes) {
    if (recording_ && session.dialog != Dialog::kRecord) {  // Esc: what there is will do
        recording_->stop();
        session.dialog = Dialog::kRecord;
    }
    if (shown_ != session.dialog) {
        if (shown_ != Dialog::kNone && begin_dialog(shown_)) {
            ImGui::CloseCurrentPopup();
            ImGui::EndPopup();
        }
        shown_ = session.dialog;
        if (shown_ != Dialog::kNone) {
            begin(session);
            ImGui::OpenPopup(tr(kDialogTitles[static_cast<std::size_t>(shown_)]));
        }
    }
    if (shown_ == Dialog::kNone) return;
    if (shown_ != Dialog::kMenu) {
        const ImVec2 size = ImGui::GetIO().DisplaySize;
        // What is found should be in sight.
        const float x = shown_ == Dialog::kFind ? size.x - at_scale(180) : size.x / 2;
        const float y = shown_ == Dialog::kOpen ? size.y / 2 : size.y / 3;
        ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, {0.5F, 0.5F});
    }
    if (!begin_dialog(shown_)) {  // a click beside it
        shown_ = session.dialog = Dialog::kNone;
        return;
    }
    switch (shown_) {
        case Dialog::kNone: break;
        case Dialog::kMenu: menu(session); break;
        case Dialog::kOpen: open_scene(session, panes); break;
        case Dialog::kSaveAs: save_as(session); break;
        case Dialog::kFind: find(session); break;
        case Dialog::kEnd: end(session); break;
        case Dialog::kFileChanged: file_changed(session); break;
        case Dialog::kRecovered: recovered(session); break;
        case Dialog::kRecord: record(session); break;
    }
    if (!error_.empty()) colored_text(kBad, error_);
    ImGui::EndPopup();
    enter_ = false;
}

// Closes the dialog if the action succeeds; otherwise it shows why not.
template <class Action>
void Dialogs::attempt(Session& session, const Action& action) {
    const Dialog before = session.dialog;
    try {
        action();
        if (session.dialog == before) session.dialog = Dialog::kNone;
    } catch (const std::exception& problem) {
        error_ = reason_of(problem);
        takes_focus_ = true;
    }
}

bool Dialogs::first_button(const char* label) {
    const bool pressed = ImGui::Button(label);
    ImGui::SameLine();
    return pressed || std::exchange(enter_, false);
}

void Dialogs::menu(Session& session) {
    session.dialog = Dialog::kNone;  // until an item opens another
    bool is_chosen = false;
    const auto item = [&](const std::string& words, const std::string& key, int code) {
        if (!ImGui::MenuItem(words.c_str(), key.c_str())) return;
        is_chosen = true;
        session::press(session, code);
    };
    const auto items = [&](session::Menu menu) {
        for (const session::Key& row : session::keys()) {
            if (row.label.empty() || row.menu != menu) continue;
            if (row.first == row.last)
                item(tr(row.what), tr(row.label), row.first);
            else
                for (int i = 0; i < kMaxLights; ++i) item(light_name(i), std::to_string(i + 1), row.first + i);
        }
    };
    items(session::Menu::kTop);
    ImGui::Separator();
    constexpr std::pair<session::Menu, const char*> kMenus[] = {{session::Menu::kLighting, "Lighting"},
                                                                {session::Menu::kView, "View"},
                                                                {session::Menu::kScene, "Scene"},
                                                                {session::Menu::kWindow, "Window"}};
    for (const auto& [menu, title] : kMenus) {
        if (!ImGui::BeginMenu(tr(title))) continue;
        items(menu);
        ImGui::EndMenu();
    }
    if (!is_chosen) session.dialog = Dialog::kMenu;
}

void Dialogs::list_openable(const Session& session) {
    openable_.clear();
    for (const std::string& file : recent_files(session)) {
        const fs::path path(file);
        openable_.push_back(
            {Group::kFiles, tr("Recent files"), file, path.parent_path().string(), path.filename().string()});
    }
    for (const SceneGroup& group : scene_groups())
        for (const std::string_view name : group.scenes)
            openable_.push_back({Group::kScenes, tr(group.heading), std::string(name),
                                 session::translated(caption_of(find_built_in(name)->text)).title});
    for (const std::string_view name : lesson::names())
        openable_.push_back(
            {Group::kLessons, tr("Lessons"), std::string(name), lesson::load_lesson(name, lessons_language()).title});
    for (const session::TutorName& tutor : session::kTutors)
        openable_.push_back({Group::kTutors, tr("Tutors"), std::string(tutor.key),
                             session::translated(caption_of(session::tutor_text(tutor.key))).title});
    std::error_code error;
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(".", error))
        if (entry.path().extension() == ".gl" || entry.path().extension() == ".c")
            files.push_back(entry.path().filename().string());
    std::ranges::sort(files);
    for (std::string& name : files) openable_.push_back({Group::kFiles, tr("Files in this folder"), std::move(name)});
}

void Dialogs::open_entry(Session& session, const Openable& entry) {
    switch (entry.group) {
        case Group::kTutors: session::open_tutor(session, entry.name); break;
        case Group::kLessons:
            session::start_lesson(session, lesson::load_lesson(entry.name, lessons_language()));
            break;
        case Group::kFiles:
        case Group::kScenes: session::show_scene(session, entry.name); break;
    }
}

bool Dialogs::show_row(const Session& session, const Openable& entry, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float name_at = 1.6F * ImGui::GetFontSize(), title_at = name_at + at_scale(160);
    const bool is_chosen = ImGui::Selectable("##open");
    if (entry.group == Group::kLessons && session::is_solved(session, entry.name)) draw_tick(at);
    ImGui::SameLine(name_at);
    ImGui::TextUnformatted(fitting({entry.label.empty() ? entry.name : entry.label}, title_at - name_at - 8).c_str());
    ImGui::SameLine(title_at);
    colored_text_line(kDim, fitting({entry.title, session::before_colon(entry.title)}, width - title_at - 24));
    return is_chosen;
}

// A picture, once it is drawn, and the name below it.
bool Dialogs::show_tile(Panes& panes, const Openable& entry, const ImVec2& size) {
    const ImVec2 from = ImGui::GetCursorScreenPos(), to = plus(from, size);
    const float picture = to.y - ImGui::GetFontSize() - at_scale(4);
    const bool is_chosen = ImGui::Selectable("##open", false, 0, size);
    if (!ImGui::IsItemVisible()) return is_chosen;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(from, {to.x, picture}, kBar, 3);
    if (const unsigned texture = panes.small_picture(entry.name); texture != 0)
        add_picture(draw, texture, from, {to.x, picture});
    if (ImGui::IsItemHovered()) {
        draw.AddRect(from, {to.x, picture}, kAccent, 3, ImDrawFlags_None, 2);
        ImGui::SetTooltip("%s", wrapped(entry.title, 26 * ImGui::GetFontSize()).c_str());
    }
    draw.AddText({from.x + at_scale(2), picture + at_scale(2)}, kText, fitting({entry.name}, size.x).c_str());
    return is_chosen;
}

// A start page as well: your last files, the built-in scenes as pictures, lessons with ticks, tutors, and the files here.
void Dialogs::open_scene(Session& session, Panes& panes) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(at_scale(800), 0.9F * window.x), gap = at_scale(10);
    ImGui::SetNextItemWidth(width);
    const bool is_typed = text_field("##file", tr("a file, or a word to look for in the list"), text_, takes_focus_);
    std::optional<Openable> chosen;
    if (is_typed) {
        // Of those with one name, the scene.
        for (const Openable& entry : openable_)
            if (entry.name == text_.data() && (!chosen || entry.group == Group::kScenes)) chosen = entry;
        if (!chosen) chosen = Openable{Group::kFiles, "", text_.data()};
    }
    ImGui::BeginChild("names", {width, std::min(at_scale(560), 0.62F * window.y)}, false);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + gap) / (at_scale(140) + gap)));
    const float tile = (room + gap) / static_cast<float>(columns) - gap;
    std::string last;
    int column = 0;
    for (const Openable& entry : openable_) {
        if (!session::has_text(entry.name + " " + entry.title, text_.data())) continue;
        if (last != entry.heading) {
            heading(entry.heading);
            column = 0;
        }
        last = entry.heading;
        ImGui::PushID(&entry);
        if (entry.group != Group::kScenes) {
            if (show_row(session, entry, width)) chosen = entry;
        } else {
            if (column++ % columns != 0) ImGui::SameLine(0, gap);
            if (show_tile(panes, entry, {tile, 0.75F * tile + ImGui::GetFontSize() + at_scale(4)})) chosen = entry;
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (!chosen) return;
    attempt(session, [&] { open_entry(session, *chosen); });
    if (error_.empty() || chosen->group != Group::kFiles || !session::can_be_recorded(chosen->name)) return;
    program_ = chosen->name;
    unreadable_ = std::exchange(error_, "");
    session.dialog = Dialog::kRecord;
}

void Dialogs::save_as(Session& session) {
    ImGui::SetNextItemWidth(at_scale(460));
    bool saves = text_field("##file", tr("a file: NAME.gl"), text_, takes_focus_);
    const std::string path = text_.data();
    const bool is_asked = !replaced_.empty() && replaced_ == path;
    if (is_asked) colored_text(kAccent, tr("This file exists. Enter replaces it."));
    saves |= ImGui::Button(tr(is_asked ? "Replace" : "Save"));
    ImGui::SameLine();
    if (ImGui::Button(tr("Cancel"))) session.dialog = Dialog::kNone;
    if (!saves) return;
    error_.clear();
    std::error_code ignored;
    if (!is_asked && path != session.file && fs::exists(path, ignored)) {
        replaced_ = path;
        takes_focus_ = true;
        return;
    }
    attempt(session, [&] {
        session::save_as(session, path);
        say(session, tr("saved {}", path));
    });
}

void Dialogs::find(Session& session) {
    ImGui::SetNextItemWidth(at_scale(300));
    const std::string before = text_.data();
    const bool next = text_field("##find", tr("find a call, such as GL_POSITION"), text_, takes_focus_);
    const std::string pattern = text_.data();
    if (pattern.empty() || (pattern == before && !next)) return;
    takes_focus_ |= next;
    const std::size_t start = session.selected_command.value_or(0) + (next ? 1 : 0);
    const auto found = session::find_call(session, pattern, start);
    error_ = found ? "" : tr("no call has this text");
    if (!found) return;
    session.panel_shown = true;
    session.panel = session::Panel::kCommands;
    session.selected_command = found;
}

void Dialogs::end(Session& session) {
    ImGui::TextUnformatted(tr("Unsaved changes: {}.", names_of(edited_scenes(session))).c_str());
    if (first_button(tr("Save")))
        attempt(session, [&] {
            session::save_all(session, "");
            session.quit_requested = true;
        });
    if (ImGui::Button(tr("Discard"))) session.quit_requested = true;
    ImGui::SameLine();
    if (ImGui::Button(tr("Stay"))) session.dialog = Dialog::kNone;
}

void Dialogs::file_changed(Session& session) {
    ImGui::TextUnformatted(
        tr("{} was saved by another program, which changed a line that you changed here.", *session.file).c_str());
    dim_text(tr("Undo and redo switch between the two versions; Ctrl+S writes the one shown."));
    if (first_button(tr("Keep mine"))) session.dialog = Dialog::kNone;
    if (ImGui::Button(tr("Use the file's"))) {
        session.history.undo();
        session.dialog = Dialog::kNone;
        say(session, tr("this is the file's version; y brings yours back"));
    }
}

void Dialogs::recovered(Session& session) {
    ImGui::TextUnformatted(tr("A window closed with unsaved changes: {}.", lost_->summary).c_str());
    if (first_button(tr("Restore the changes"))) attempt(session, [&] { session::restore(session, *lost_); });
    if (ImGui::Button(tr("Discard them"))) {
        session::forget(*lost_);
        session.dialog = Dialog::kNone;
    }
    ImGui::SameLine();
    if (ImGui::Button(tr("Ask again later"))) session.dialog = Dialog::kNone;
}

void Dialogs::record(Session& session) {
    const std::string name = fs::path(program_).filename().string();
    if (recording_ && recording_->is_done()) {
        const auto done = std::exchange(recording_, nullptr);
        attempt(session, [&] {
            open(session, done->scene(), std::nullopt);
            say(session, tr("this is a picture of {}; Ctrl+S saves it as a scene", name));
        });
        if (session.dialog == Dialog::kNone) return;
    }
    if (!recording_) {
        ImGui::TextUnformatted(tr("{} cannot be read as a scene:", name).c_str());
        dim_text(unreadable_);
        ImGui::TextUnformatted(
            tr("A recording shows it as well: the program runs for 3 seconds, with all your rights."));
        if (first_button(tr("Record it"))) {
            error_.clear();
            attempt(session, [&] { recording_ = std::make_unique<session::ProgramRecording>(program_); });
            session.dialog = Dialog::kRecord;
        }
        if (ImGui::Button(tr("Cancel"))) session.dialog = Dialog::kNone;
        return;
    }
    ImGui::TextUnformatted(tr("{} runs and is recorded.", name).c_str());
    if (first_button(tr("That is enough"))) recording_->stop();
    ImGui::NewLine();
}

}  // namespace twinlight::demo

// What is shown over the pictures: the menu of a click with the right button, and the window's questions.
#pragma once

#include <imgui.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/recorded_program.h"
#include "app/session/recovery.h"
#include "app/session/session.h"

namespace twinlight::demo {

class Panes;

class Dialogs {
  public:
    // Asks whether to bring these scenes back.
    void offer(session::Session& session, session::LostScenes lost);
    // To be called in every frame.
    void show(session::Session& session, Panes& panes);
    // The key Enter: the first button.
    void press_enter() { enter_ = true; }
    // Whether a program is recorded, so that frames must go on.
    bool is_busy() const { return recording_ != nullptr; }

  private:
    void begin(const session::Session& session);
    void menu(session::Session& session);
    void open_scene(session::Session& session, Panes& panes);
    void save_as(session::Session& session);
    void find(session::Session& session);
    void end(session::Session& session);
    void file_changed(session::Session& session);
    void recovered(session::Session& session);
    void record(session::Session& session);
    bool first_button(const char* label);
    template <class Action>
    void attempt(session::Session& session, const Action& action);

    session::Dialog shown_ = session::Dialog::kNone;
    bool takes_focus_ = false, enter_ = false;
    std::array<char, 4096> text_{};  // of the field; ends with 0
    std::string error_;              // of the last attempt
    std::string replaced_;           // the file that exists, whose replacement was asked
    // What can be opened, in groups.
    enum class Group : std::uint8_t { kFiles, kTutors, kLessons, kScenes };
    struct Openable {
        Group group = Group::kFiles;
        std::string heading, name;
        std::string title{};  // beside the name
        std::string label{};  // what is shown instead of the name, unless it is empty
    };
    void list_openable(const session::Session& session);
    static bool show_row(const session::Session& session, const Openable& entry, float width);
    static bool show_tile(Panes& panes, const Openable& entry, const ImVec2& size);
    void open_entry(session::Session& session, const Openable& entry);
    std::vector<Openable> openable_;
    std::optional<session::LostScenes> lost_;
    std::string program_, unreadable_;  // a program that can be recorded, and why it is no scene
    std::unique_ptr<session::ProgramRecording> recording_;
};

}  // namespace twinlight::demo

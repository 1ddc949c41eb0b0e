// The panel "Save": the scene, programs and pages made from it, screenshots and clips.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <string>

#include "app/session/clip.h"
#include "app/session/saving.h"
#include "app/session/session.h"

namespace twinlight::demo {

class SavePanel {
  public:
    SavePanel();

    // To be called in every frame: says in the window when a clip is written.
    void update(session::Session& session);
    void show(session::Session& session);
    void save(session::Session& session, session::Form form);
    // The file for the next screenshot.
    std::string screenshot_path(const session::Session& session) const;

    // Whether the window is to pass each frame that it shows to add_frame().
    bool is_recording() const { return clip_ && !clip_->is_ending(); }
    void add_frame(Image picture);
    // Whether a clip is recorded or written, so that frames must go on.
    bool is_busy() const { return clip_ != nullptr; }

  private:
    double seconds() const;
    void toggle_clip(session::Session& session);

    std::array<char, 4096> folder_{};  // ends with 0
    std::unique_ptr<session::Clip> clip_;
    std::chrono::steady_clock::time_point started_;
    std::string last_;  // what was said last
    bool last_failed_ = false;
};

}  // namespace twinlight::demo

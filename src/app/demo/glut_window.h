// The window itself: GLUT's events change the session, and frames show it. window.cpp has its life and its frames,
// window_events.cpp what events do.
#pragma once

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/demo/dialogs.h"
#include "app/demo/panels.h"
#include "app/demo/panes.h"
#include "app/demo/status_line.h"
#include "app/demo/window.h"
#include "app/session/keys.h"
#include "app/session/layout.h"
#include "app/session/preferences.h"
#include "app/session/recovery.h"
#include "app/session/session.h"
#include "base/text/reason.h"

namespace twinlight::demo {

class Window {
  public:
    Window(std::shared_ptr<const CommandList> scene, const WindowOptions& options);

    // Until the user quits; returns the exit status.
    int run();

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr int kFramesAfterEvent = 3;  // ImGui settles sizes and highlights in so many frames

    // A script starts and leaves the window as if it were the first.
    bool is_script() const { return options_.quit_after > 0; }
    WindowSize first_size() const;
    void remember();
    void start_imgui();
    void end_imgui();
    void end();
    void reshape(int width, int height);
    void display();
    void draw();
    void frame();
    void key(int code);
    void press_keys();
    void press_timed_keys();
    void come_to_rest();
    void mouse(int button, int state, int x, int y);
    void motion(int x, int y);
    void passive_motion(int x, int y);
    void carry_out_requests();
    void show_neighbour(int away);
    void open_step(int away);
    void reload_if_saved();
    void take_file();
    void save();
    void copy();
    void paste();
    void set_letters(int larger);
    void keep_for_recovery();
    bool is_busy_with_input() const;
    void save_screenshot();
    void write_times() const;
    void register_callbacks();
    bool is_in_world(int x, int y) const;
    bool is_on_panels_edge(int x, int y) const;
    void press(int button, int x, int y);
    void release(int x, int y);
    void settle();
    void settle_input();
    void wake(int frames = kFramesAfterEvent);  // draws so many frames
    void set_timers();
    void quit();
    static double screen_scale();  // 1 for 96 dots per inch, in steps of a half

    // An exception must not pass through GLUT's C code, so this ends the main loop.
    template <class Action>
    static void guarded(void* window, Action action) {
        Window& self = *static_cast<Window*>(window);
        if (!self.imgui_runs_) return;  // the window is closing
        try {
            action(self);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "twinlight-demo: %s\n", reason_of(e).c_str());
            self.status_ = 2;
            self.quit();
        }
    }
    enum class Drag { kNone, kOrbit, kLook, kSlider, kPanel };
    struct Timer {
        void (*action)(Window&);
        Window* window = nullptr;
        bool is_pending = false;
    };
    void after(unsigned ms, Timer& timer);
    // From a key to the end of the next frame, and to the end of the first one with all pictures that the driver draws.
    struct KeyTime {
        std::string key;
        double answer_ms = 0, picture_ms = 0;
    };

    WindowOptions options_;
    session::Preferences preferences_;
    session::Session session_;
    std::unique_ptr<Panes> panes_;
    std::unique_ptr<Panels> panels_;
    session::Layout layout_;
    int width_ = 0, height_ = 0;
    int frames_shown_ = 0, frames_wanted_ = 0;
    bool imgui_runs_ = false;
    Timer busy_timer_{[](Window&self) { self.wake(1); }}, animation_timer_{[](Window&self) { self.wake(1); }},
        message_timer_{[](Window&self) {
            // What a panel or a dialog shows when its work is done must settle, too.
            const bool is_busy = self.panels_->is_busy(self.session_) || self.dialogs_.is_busy();
            self.wake(is_busy ? kFramesAfterEvent : 1);
        }},
        recovery_timer_{[](Window&self) { self.keep_for_recovery(); }}, file_timer_{[](Window&self) {
            self.reload_if_saved();
            self.set_timers();
        }};
    Drag drag_ = Drag::kNone;
    session::DragStart drag_start_;
    int shown_x_ = -1, shown_y_ = -1;  // the mouse in the last frame
    int pressed_x_ = 0, pressed_y_ = 0;
    bool moved_ = false;          // since the button was pressed
    bool input_changed_ = false;  // a button, or a key in a field, since the last frame
    bool leaves_field_ = false;   // the button that is down was pressed while something was typed or open
    bool on_edge_ = false;        // the mouse is between the panel and the pictures
    bool close_pressed_ = false;  // the window's button
    double scale_ = 1;            // of letters and lines
    std::string file_read_;       // the file that file_time_ is of
    StatusLine status_line_;
    Clock::time_point animated_since_{};
    std::optional<std::filesystem::file_time_type> file_time_;
    std::vector<double> frame_ms_;  // for options_.times
    std::array<std::vector<double>, session::kPanes> pane_ms_;
    std::vector<KeyTime> key_times_;
    std::vector<std::array<int, 2>> cut_letters_, overlapping_letters_;  // in the last frame, for options_.times
    std::vector<std::string> texts_;                                     // the same
    Dialogs dialogs_;
    session::RecoveryFile recovery_;
    int recovery_revision_ = 0;  // of the history, that the recovery file has
    std::string title_;
    int status_ = EXIT_SUCCESS;
};

}  // namespace twinlight::demo

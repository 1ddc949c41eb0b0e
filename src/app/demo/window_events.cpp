// What GLUT's events do: the keys, the mouse, the scene's file.
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/demo/clipboard.h"
#include "app/demo/glut_window.h"
#include "app/demo/theme.h"
#include "app/demo/window_close_button.h"
#include "app/session/saving.h"
#include "app/session/scenes.h"
#include "app/session/steps.h"
#include "app/session/tutor.h"
#include "app/session/typed_calls.h"
#include "base/image/file.h"
#include "base/text/reason.h"
#include "base/text/translation.h"
#include "render/context/gl.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

// freeglut's headers come after render/context/gl.h, which declares GL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>
#include <backends/imgui_impl_glut.h>

namespace twinlight::demo {
namespace {

static_assert(GLUT_KEY_F1 == 1 && GLUT_KEY_LEFT == 100 && GLUT_KEY_UP == 101 && GLUT_KEY_RIGHT == 102 &&
                  GLUT_KEY_DOWN == 103,
              "the codes of the keys in keys.cpp");
constexpr int kWheelUp = 3, kWheelDown = 4;  // how freeglut reports the wheel as buttons
constexpr int kClickPixels = 4;              // a drag that is shorter is a click
constexpr int kEdgePixels = 8;               // beside the panel, where a drag makes it wider
constexpr int kLinePixels = 14;              // how near to the slider's line a drag takes it

// The session's code of a key. With Ctrl, a letter comes as its number in the alphabet, in which Tab, Enter and Backspace are too.
int key_code(int code, int modifiers) {
    const bool shift = (modifiers & GLUT_ACTIVE_SHIFT) != 0;
    if (code == '\t' && shift) return session::kShiftTab;
    if ((modifiers & GLUT_ACTIVE_CTRL) == 0 || code == session::kEscape) return code;
    if (code >= 1 && code <= 26) return (shift ? session::kCtrlShift : session::kCtrl) + 'a' + code - 1;
    return session::kCtrl + code;
}

// The letter that is pressed with Ctrl, for ImGui. Enter, Tab and Backspace stay what they are.
unsigned char imgui_code(unsigned char code, int modifiers) {
    const bool is_letter = code >= 1 && code <= 26 && code != '\r' && code != '\t' && code != '\b';
    if (!is_letter || (modifiers & GLUT_ACTIVE_CTRL) == 0) return code;
    return static_cast<unsigned char>('a' + code - 1);
}

bool is_any_popup_open() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }

void release_ctrl() {
#if IMGUI_VERSION_NUM >= 18900
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, false);
#else
    ImGui::GetIO().KeyCtrl = false;
#endif
}

}  // namespace

void Window::register_callbacks() {
    // X has a name of its own for Shift+Tab, which freeglut does not know.
    XRebindKeysym(glXGetCurrentDisplay(), XK_ISO_Left_Tab, nullptr, 0, reinterpret_cast<const unsigned char*>("\t"), 1);
    glutDisplayFuncUcall([](void* w) { guarded(w, [](Window& self) { self.display(); }); }, this);
    glutReshapeFuncUcall(
        [](int width, int height, void* w) { guarded(w, [=](Window& self) { self.reshape(width, height); }); }, this);
    glutKeyboardFuncUcall(
        [](unsigned char code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                const int modifiers = glutGetModifiers();
                self.settle_input();
                if (!self.imgui_runs_) return;
                ImGui_ImplGLUT_KeyboardFunc(imgui_code(code, modifiers), x, y);
                self.key(key_code(code, modifiers));
            });
        },
        this);
    glutKeyboardUpFuncUcall(
        [](unsigned char code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                const int modifiers = glutGetModifiers();
                self.settle();
                if (!self.imgui_runs_) return;
                ImGui_ImplGLUT_KeyboardUpFunc(imgui_code(code, modifiers), x, y);
                // Otherwise the same key, pressed again at once, would be lost.
                self.input_changed_ = self.is_busy_with_input();
            });
        },
        this);
    glutSpecialFuncUcall(
        [](int code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                self.settle_input();
                if (!self.imgui_runs_) return;
                ImGui_ImplGLUT_SpecialFunc(code, x, y);
                self.key(session::kSpecialKey + code);
            });
        },
        this);
    glutSpecialUpFuncUcall(
        [](int code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                self.settle();
                if (!self.imgui_runs_) return;
                ImGui_ImplGLUT_SpecialUpFunc(code, x, y);
                // X counts a modifier that is released as still held.
                if (code == GLUT_KEY_CTRL_L || code == GLUT_KEY_CTRL_R) release_ctrl();
            });
        },
        this);
    glutMouseFuncUcall([](int button, int state, int x, int y,
                          void* w) { guarded(w, [=](Window& self) { self.mouse(button, state, x, y); }); },
                       this);
    glutMotionFuncUcall([](int x, int y, void* w) { guarded(w, [=](Window& self) { self.motion(x, y); }); }, this);
    glutPassiveMotionFuncUcall(
        [](int x, int y, void* w) { guarded(w, [=](Window& self) { self.passive_motion(x, y); }); }, this);
    // Another program can destroy the window without asking.
    glutCloseFuncUcall([](void* w) { static_cast<Window*>(w)->end(); }, this);
    take_close_button(
        [](void* w) {
            static_cast<Window*>(w)->close_pressed_ = true;
            glutPostRedisplay();
        },
        this);
}

void Window::reshape(int width, int height) {
    width_ = std::max(width, 1);
    height_ = std::max(height, 1);
    if (!glutGet(GLUT_FULL_SCREEN)) {
        preferences_.width = width_;
        preferences_.height = height_;
    }
    ImGui_ImplGLUT_ReshapeFunc(width, height);
    wake();
}

// Whether something is typed, dragged or chosen in a panel or a popup.
bool Window::is_busy_with_input() const {
    return ImGui::GetIO().WantTextInput || ImGui::IsAnyItemActive() || panels_->is_typing() || is_any_popup_open();
}

// Letters that are typed are no shortcuts, nor are those that come while a click leaves a field.
void Window::key(int code) {
    constexpr int kEnter = 13;
    if (session_.dialog != session::Dialog::kNone) {
        if (code == session::kEscape) session::press(session_, code);
        if (code == kEnter) dialogs_.press_enter();
    } else if (code == session::kEscape && is_any_popup_open()) {
        ImGui::SetWindowFocus(nullptr);  // closes the popups
    } else if (!is_busy_with_input() && !leaves_field_) {
        session::press(session_, code);
    }
    if (session_.animating) animated_since_ = Clock::now();
    carry_out_requests();
    wake();
}

void Window::carry_out_requests() {
    if (session_.quit_requested) {
        recovery_.remove();
        quit();
        return;
    }
    if (session_.scene_requested != 0) show_neighbour(std::exchange(session_.scene_requested, 0));
    if (std::exchange(session_.tutor_requested, false)) session::next_tutor(session_);
    if (session_.step_requested != 0) open_step(std::exchange(session_.step_requested, 0));
    if (std::exchange(session_.export_requested, false)) panels_->saving().save(session_, session::Form::kC);
    if (std::exchange(session_.save_requested, false)) save();
    if (std::exchange(session_.full_screen_requested, false)) glutFullScreenToggle();
    if (std::exchange(session_.copy_requested, false)) copy();
    if (std::exchange(session_.paste_requested, false)) paste();
    if (session_.letters_requested) set_letters(*std::exchange(session_.letters_requested, std::nullopt));
    if (session_.screenshot_requested) wake();
}

void Window::show_neighbour(int away) {
    session::show_scene(session_, session::neighbour_scene(session_, away));
    wake();
}

void Window::save() {
    try {
        if (session_.file) take_file();
        if (session_.dialog != session::Dialog::kNone) return;
        if (!session_.file) {
            session_.dialog = session::Dialog::kSaveAs;
            return;
        }
        session::save(session_);
        say(session_, tr("saved {}", *session_.file));
        keep_for_recovery();
    } catch (const std::exception& problem) {
        say(session_, reason_of(problem));
    }
}

void Window::copy() {
    const std::string text = session::selected_calls(session_);
    if (!text.empty()) copy_text(text);
    say(session_, tr(text.empty()         ? "click a call in the tab Commands first; Ctrl+C copies it"
                     : shares_clipboard() ? "copied"
                                          : "copied within this window; other programs get it if xclip is installed"));
}

void Window::paste() {
    try {
        const std::string text = copied_text();
        if (text.empty()) throw std::runtime_error(tr("the clipboard has no text"));
        session::insert_calls(session_, text);
        say(session_, tr("inserted what was copied"));
    } catch (const std::exception& problem) {
        say(session_, reason_of(problem));
    }
}

// ImGui's fonts have one size, so it starts again with others.
void Window::set_letters(int larger) {
    constexpr double kStep = 1.1, kSmallest = 0.5, kLargest = 4;
    const double first = options_.scale.value_or(screen_scale());
    scale_ = larger == 0 ? first : std::clamp(larger > 0 ? scale_ * kStep : scale_ / kStep, kSmallest, kLargest);
    end_imgui();
    start_imgui();
    ImGui_ImplGLUT_ReshapeFunc(width_, height_);
}

void Window::keep_for_recovery() {
    recovery_revision_ = session_.history.revision();
    recovery_.keep(session_);
}

void Window::open_step(int away) {
    const CommandList& now = commands(session_);
    if (now.steps.empty()) {
        say(session_, tr("this scene has no steps; [ and ] show other scenes"));
        return;
    }
    const std::string step = session::neighbour_step(now, away);
    const bool from_input = !session_.file && now.name == "stdin";
    try {
        session::show_step(session_, load_step(from_input ? "-" : session_.file.value_or(now.name), now, step));
    } catch (const std::exception& problem) {
        session_.error = reason_of(problem);
    }
    wake();
}

// The time of a file tells cheaply that it may have changed.
void Window::reload_if_saved() {
    if (!session_.file) return;
    std::error_code error;
    const auto time = std::filesystem::last_write_time(*session_.file, error);
    if (error || (file_time_ == time && file_read_ == *session_.file)) return;
    file_time_ = time;
    file_read_ = *session_.file;
    try {
        take_file();
    } catch (const std::exception& problem) {
        session_.error = reason_of(problem);
    }
    wake();
}

void Window::take_file() {
    std::error_code ignored;
    if (std::filesystem::exists(*session_.file, ignored))
        session::take_file_text(session_, read_file(*session_.file, kMaxSceneBytes + 1));
}

// ImGui looks at the mouse and the keys once a frame. A press and a release without a frame between them, or a press where
// the mouse has only just arrived, would be lost.
void Window::settle() { draw(); }

// What the next key or click does depends on the events before it: they may have opened a menu, or left a field.
void Window::settle_input() {
    while (imgui_runs_ && frames_wanted_ > 0 && (input_changed_ || is_busy_with_input())) settle();
}

void Window::mouse(int button, int state, int x, int y) {
    const bool down = state == GLUT_DOWN;
    const bool wheel = button == kWheelUp || button == kWheelDown;
    ImGui_ImplGLUT_MotionFunc(x, y);
    if (!wheel || x != shown_x_ || y != shown_y_) settle();
    settle_input();
    if (!imgui_runs_) return;
    if (down) leaves_field_ = is_busy_with_input();
    const bool only_leaves = leaves_field_;
    if (!wheel && !down) leaves_field_ = false;
    input_changed_ = true;
    if (wheel) {
        if (down) ImGui_ImplGLUT_MouseWheelFunc(button, button == kWheelUp ? 1 : -1, x, y);
    } else {
        ImGui_ImplGLUT_MouseFunc(button, state, x, y);
    }
    wake();
    // The world view has its own drags and wheel; the right button opens the menu.
    if (only_leaves) return;
    const bool in_world = is_in_world(x, y);
    if (in_world ? button != GLUT_RIGHT_BUTTON : down && ImGui::GetIO().WantCaptureMouse) return;
    if (wheel) {
        if (down && hit(layout_, x, y)) session::zoom(session_, button == kWheelUp ? 1 : -1);
        return;
    }
    if (down)
        press(button, x, y);
    else
        release(x, y);
}

bool Window::is_in_world(int x, int y) const {
    const auto where = hit(layout_, x, y);
    return where && (session_.view == session::View::kWorld || where->pane == session::kWorldPane);
}

// The gap between the panel and the pictures.
bool Window::is_on_panels_edge(int x, int y) const {
    return layout_.panel.width > 0 && y < layout_.panel.height && x >= layout_.panel.width &&
           x <= layout_.panel.width + static_cast<int>(kEdgePixels * scale());
}

void Window::press(int button, int x, int y) {
    pressed_x_ = x;
    pressed_y_ = y;
    moved_ = false;
    drag_start_ = session::start_drag(session_);
    drag_start_.may_go_under = (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
    session_.history.end_group();
    if (button == GLUT_LEFT_BUTTON && is_on_panels_edge(x, y)) drag_ = Drag::kPanel;
    const auto where = hit(layout_, x, y);
    if (drag_ == Drag::kPanel || !where) return;
    const Rectangle& box = layout_.cells.front().picture;
    const bool on_line = session_.view == session::View::kSlider && button == GLUT_LEFT_BUTTON &&
                         std::abs(x - (box.x + session_.slider_at * box.width)) < kLinePixels;
    drag_ = on_line                       ? Drag::kSlider
            : button == GLUT_LEFT_BUTTON  ? Drag::kOrbit
            : button == GLUT_RIGHT_BUTTON ? Drag::kLook
                                          : Drag::kNone;
}

void Window::release(int x, int y) {
    if (drag_ == Drag::kNone) return;
    session_.history.end_group();
    if (drag_ == Drag::kPanel) widen_panel(session_, x, width_, scale());
    const Drag ended = std::exchange(drag_, Drag::kNone);
    if (moved_) return;
    if (ended == Drag::kLook) session_.dialog = session::Dialog::kMenu;
    if (ended != Drag::kOrbit) return;
    if (const auto where = hit(layout_, x, y)) {
        const Rectangle& box = layout_.cells.front().picture;
        session_.active = session_.view == session::View::kSlider
                              ? (x < box.x + session_.slider_at * box.width ? session_.slider.a : session_.slider.b)
                              : where->pane;
        session_.probe = session::Probe{false, where->x, where->y};
        session_.panel = session::Panel::kProbe;
    }
}

void Window::motion(int x, int y) {
    if (input_changed_) settle();  // a click or a key that the motion before a frame would take away
    if (!imgui_runs_) return;
    ImGui_ImplGLUT_MotionFunc(x, y);
    wake();
    if (drag_ == Drag::kNone) return;
    if (!moved_ && std::max(std::abs(x - pressed_x_), std::abs(y - pressed_y_)) < kClickPixels) return;
    moved_ = true;
    if (drag_ == Drag::kOrbit) session::orbit(session_, drag_start_, x - pressed_x_, y - pressed_y_);
    if (drag_ == Drag::kLook) session::look(session_, drag_start_, x - pressed_x_, y - pressed_y_);
    if (drag_ == Drag::kPanel) widen_panel(session_, x, width_, scale());
    if (drag_ == Drag::kSlider) {
        const Rectangle& box = layout_.cells.front().picture;
        session_.slider_at = std::clamp(static_cast<double>(x - box.x) / box.width, 0.0, 1.0);
    }
}

void Window::passive_motion(int x, int y) {
    if (input_changed_) settle();
    if (!imgui_runs_) return;
    const bool on_edge = is_on_panels_edge(x, y);
    if (std::exchange(on_edge_, on_edge) != on_edge)
        glutSetCursor(on_edge ? GLUT_CURSOR_LEFT_RIGHT : GLUT_CURSOR_INHERIT);
    ImGui_ImplGLUT_MotionFunc(x, y);
    const auto where = hit(layout_, x, y);
    const bool is_tutor = session_.view == session::View::kTutor;
    if (is_tutor) session_.probe.reset();
    if (is_tutor && where && !is_in_world(x, y)) session_.probe = session::Probe{false, where->x, where->y};
    // Over other pictures nothing lights up under the mouse, except the lights of the world view.
    if (!where || ImGui::GetIO().WantCaptureMouse || is_tutor || is_in_world(x, y)) wake();
}

}  // namespace twinlight::demo

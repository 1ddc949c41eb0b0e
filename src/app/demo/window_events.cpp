// What GLUT's events do: the keys, the mouse, the scene's file.
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "app/demo/glut_window.h"
#include "app/session/steps.h"
#include "base/text/reason.h"
#include "render/context/gl.h"
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
constexpr int kLinePixels = 14;              // how near to the slider's line a drag takes it

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
                ImGui_ImplGLUT_KeyboardFunc(code, x, y);
                const bool shift = (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
                self.key(code == '\t' && shift ? session::kShiftTab : code);
            });
        },
        this);
    glutKeyboardUpFuncUcall(
        [](unsigned char code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                self.settle();
                if (self.imgui_runs_) ImGui_ImplGLUT_KeyboardUpFunc(code, x, y);
            });
        },
        this);
    glutSpecialFuncUcall(
        [](int code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                ImGui_ImplGLUT_SpecialFunc(code, x, y);
                self.key(session::kSpecialKey + code);
            });
        },
        this);
    glutSpecialUpFuncUcall(
        [](int code, int x, int y, void* w) {
            guarded(w, [=](Window& self) {
                self.settle();
                if (self.imgui_runs_) ImGui_ImplGLUT_SpecialUpFunc(code, x, y);
            });
        },
        this);
    glutMouseFuncUcall([](int button, int state, int x, int y,
                          void* w) { guarded(w, [=](Window& self) { self.mouse(button, state, x, y); }); },
                       this);
    glutMotionFuncUcall([](int x, int y, void* w) { guarded(w, [=](Window& self) { self.motion(x, y); }); }, this);
    glutMenuStatusFuncUcall(
        [](int status, int, int, void* w) {
            if (status == GLUT_MENU_NOT_IN_USE) guarded(w, [](Window&) { glutDetachMenu(GLUT_RIGHT_BUTTON); });
        },
        this);
    glutPassiveMotionFuncUcall(
        [](int x, int y, void* w) { guarded(w, [=](Window& self) { self.passive_motion(x, y); }); }, this);
    // Textures and programs must be deleted while their context is current.
    glutCloseFuncUcall([](void* w) { static_cast<Window*>(w)->end_imgui(); }, this);
}

void Window::reshape(int width, int height) {
    width_ = std::max(width, 1);
    height_ = std::max(height, 1);
    ImGui_ImplGLUT_ReshapeFunc(width, height);
    wake();
}

void Window::key(int code) {
    const ImGuiIO& io = ImGui::GetIO();
    constexpr int kEscape = 27;
    if (code == kEscape && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
        ImGui::SetWindowFocus(nullptr);  // closes the popups
        wake();
        return;
    }
    if (!(io.WantCaptureKeyboard && io.WantTextInput)) session::press(session_, code);
    if (session_.animating) animated_since_ = Clock::now();
    carry_out_requests();
    wake();
}

void Window::carry_out_requests() {
    if (session_.quit_requested) {
        quit();
        return;
    }
    if (session_.scene_requested != 0) open_neighbour(std::exchange(session_.scene_requested, 0));
    if (session_.step_requested != 0) open_step(std::exchange(session_.step_requested, 0));
    if (std::exchange(session_.export_requested, false)) panels_->saving().save(session_, session::Form::kC);
    if (session_.screenshot_requested) wake();
}

void Window::open_neighbour(int step) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) names.emplace_back(file.name.substr(0, file.name.rfind(".gl")));
    const auto here = std::ranges::find(names, commands(session_).name);
    const auto count = std::ssize(names);
    // A scene that is not built in is before the first and after the last.
    const auto index = here != names.end() ? here - names.begin() : step > 0 ? count - 1 : 0;
    const std::string& name = names[static_cast<std::size_t>((index + step + count) % count)];
    session::open(session_, load_commands(name), {});
    say(session_, "scene " + name);
    wake();
}

void Window::open_step(int away) {
    const CommandList& now = commands(session_);
    if (now.steps.empty()) {
        say(session_, "this scene has no steps; [ and ] show other scenes");
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

void Window::reload_if_saved() {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(*session_.file, error);
    if (error) return;
    if (!file_time_) file_time_ = time;
    if (*file_time_ == time) return;
    file_time_ = time;
    try {
        auto scene = load_commands(*session_.file);
        const std::size_t step = commands(session_).step;
        if (step > 1 && step <= scene->steps.size()) scene = load_commands(*session_.file, std::to_string(step));
        session::open(session_, std::move(scene), session_.file);
        say(session_, "read again: " + *session_.file);
    } catch (const std::exception& problem) {
        session_.error = reason_of(problem);
    }
    wake();
}

// ImGui looks at the mouse and the keys once a frame. A press and a release without a frame between them, or a press where
// the mouse has only just arrived, would be lost.
void Window::settle() { display(); }

void Window::mouse(int button, int state, int x, int y) {
    const bool down = state == GLUT_DOWN;
    const bool wheel = button == kWheelUp || button == kWheelDown;
    ImGui_ImplGLUT_MotionFunc(x, y);
    if (!wheel || x != shown_x_ || y != shown_y_) settle();
    if (!imgui_runs_) return;
    if (wheel) {
        if (down) ImGui_ImplGLUT_MouseWheelFunc(button, button == kWheelUp ? 1 : -1, x, y);
    } else {
        ImGui_ImplGLUT_MouseFunc(button, state, x, y);
    }
    wake();
    // The world view has its own drags and wheel; the right button opens the menu.
    const bool in_world = session_.view == session::View::kWorld && hit(layout_, x, y);
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

void Window::press(int button, int x, int y) {
    pressed_x_ = x;
    pressed_y_ = y;
    moved_ = false;
    drag_start_ = session::start_drag(session_);
    drag_start_.may_go_under = (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
    session_.history.end_group();
    const auto where = hit(layout_, x, y);
    if (!where) return;
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
    const Drag ended = std::exchange(drag_, Drag::kNone);
    if (moved_) return;
    if (ended == Drag::kLook) menu_.open(x, y);
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
    ImGui_ImplGLUT_MotionFunc(x, y);
    wake();
    if (drag_ == Drag::kNone) return;
    if (!moved_ && std::max(std::abs(x - pressed_x_), std::abs(y - pressed_y_)) < kClickPixels) return;
    moved_ = true;
    if (drag_ == Drag::kOrbit) session::orbit(session_, drag_start_, x - pressed_x_, y - pressed_y_);
    if (drag_ == Drag::kLook) session::look(session_, drag_start_, x - pressed_x_, y - pressed_y_);
    if (drag_ == Drag::kSlider) {
        const Rectangle& box = layout_.cells.front().picture;
        session_.slider_at = std::clamp(static_cast<double>(x - box.x) / box.width, 0.0, 1.0);
    }
}

void Window::passive_motion(int x, int y) {
    ImGui_ImplGLUT_MotionFunc(x, y);
    // Over a picture nothing lights up under the mouse, except the lights of the world view.
    if (!hit(layout_, x, y) || ImGui::GetIO().WantCaptureMouse || session_.view == session::View::kWorld) wake();
}

}  // namespace twinlight::demo

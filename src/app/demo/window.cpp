// The part of the window that uses freeglut. Callbacks get a pointer to the Window (the ...Ucall functions of freeglut 3.4).
//
// A frame: the panes draw what changed, at the window's lower left corner, into textures; then ImGui draws the pictures,
// the bars and the panels. Frames are drawn only after events, while something moves, and while the reference is at work.
#include "app/demo/window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/demo/panels.h"
#include "app/demo/panes.h"
#include "app/demo/theme.h"
#include "app/demo/widgets.h"
#include "app/session/clip.h"
#include "app/session/keys.h"
#include "app/session/layout.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/report/words.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"

// freeglut's headers come after render/context/gl.h, which declares GL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <backends/imgui_impl_glut.h>
#include <backends/imgui_impl_opengl2.h>

namespace twinlight::demo {
namespace {

using session::Session;
using Clock = std::chrono::steady_clock;

static_assert(GLUT_KEY_F1 == 1 && GLUT_KEY_LEFT == 100 && GLUT_KEY_UP == 101 && GLUT_KEY_RIGHT == 102 &&
                  GLUT_KEY_DOWN == 103,
              "the codes of the keys in keys.cpp");
constexpr int kWheelUp = 3, kWheelDown = 4;  // how freeglut reports the wheel as buttons
constexpr int kFramesAfterEvent = 3;         // ImGui settles sizes and highlights in so many frames
constexpr unsigned kFrameMs = 16;            // between frames while something moves
constexpr unsigned kBusyMs = 30;             // between looks at the reference's work
constexpr unsigned kMessageMs = 200;         // between looks at a message's age
constexpr unsigned kFileMs = 500;            // between looks at the scene's file
constexpr int kClickPixels = 4;              // a drag that is shorter is a click
constexpr double kMessageSeconds = 6;

[[noreturn]] void refuse(const char* format, va_list arguments, void*) {
    char reason[512];
    std::vsnprintf(reason, sizeof reason, format, arguments);
    const char* display = std::getenv("DISPLAY");
    std::fprintf(stderr,
                 "twinlight-demo: cannot open a window: %s (DISPLAY is %s); "
                 "without a display, use 'twinlight compare SCENE -o DIR'\n",
                 reason, display && *display ? display : "not set");
    std::exit(2);
}

// 1 for 96 dots per inch, in steps of a half.
double screen_scale() {
    const int millimetres = glutGet(GLUT_SCREEN_WIDTH_MM), pixels = glutGet(GLUT_SCREEN_WIDTH);
    if (millimetres <= 0 || pixels <= 0) return 1;
    const double dots_per_inch = pixels / (millimetres / 25.4);
    return std::clamp(std::floor(2 * dots_per_inch / 96) / 2, 1.0, 3.0);
}

enum class Drag { kNone, kOrbit, kLook, kSlider };

class Window {
  public:
    Window(std::shared_ptr<const CommandList> scene, const WindowOptions& options)
        : options_(options), session_(std::move(scene)) {
        session_.file = options.file;
        session_.view = options.view;
        session_.panel = options.panel;
        session_.probe = options.probe;
        const WindowSize size = session::natural_size(commands(session_));
        refresh(session_, size.width, size.height);
    }

    int run();

  private:
    void start_imgui();
    void end_imgui();
    void reshape(int width, int height);
    void display();
    void frame();
    void key(int code);
    void mouse(int button, int state, int x, int y);
    void motion(int x, int y);
    void passive_motion(int x, int y);
    void carry_out_requests();
    void open_neighbour(int step);
    void reload_if_saved();
    void show_status(const session::Layout& layout);
    void show_keys() const;
    void save_screenshot();
    void write_times() const;
    void make_menu();
    void open_menu(int x, int y);
    void settle();
    void wake(int frames = kFramesAfterEvent);  // draws so many frames
    void set_timers();
    void quit();

    // An exception must not pass through GLUT's C code, so this ends the main loop.
    template <class Action>
    static void guarded(void* window, Action action) {
        Window& self = *static_cast<Window*>(window);
        if (!self.imgui_runs_) return;  // the window is closing
        try {
            action(self);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "twinlight-demo: %s\n", e.what());
            self.status_ = EXIT_FAILURE;
            self.quit();
        }
    }
    struct Timer {
        void (*action)(Window&);
        Window* window = nullptr;
        bool is_pending = false;
    };
    void after(unsigned ms, Timer& timer);

    WindowOptions options_;
    Session session_;
    std::unique_ptr<Panes> panes_;
    std::unique_ptr<Panels> panels_;
    session::Layout layout_;
    int width_ = 0, height_ = 0;
    int frames_shown_ = 0, frames_wanted_ = 0;
    bool imgui_runs_ = false;
    Timer busy_timer_{[](Window&self) { self.wake(1); }}, animation_timer_{[](Window&self) { self.wake(1); }},
        message_timer_{[](Window&self) { self.wake(1); }}, file_timer_{[](Window&self) {
            self.reload_if_saved();
            self.set_timers();
        }};
    Drag drag_ = Drag::kNone;
    session::DragStart drag_start_;
    int shown_x_ = -1, shown_y_ = -1;  // the mouse in the last frame
    int pressed_x_ = 0, pressed_y_ = 0;
    bool moved_ = false;  // since the button was pressed
    int messages_seen_ = 0;
    Clock::time_point message_since_{}, animated_since_{};
    std::optional<std::filesystem::file_time_type> file_time_;
    std::vector<double> frame_ms_;  // for options_.times
    std::array<std::vector<double>, session::kPanes> pane_ms_;
    int menu_ = 0;
    std::string title_;
    int status_ = EXIT_SUCCESS;
};

// Calls the timer's action in so many milliseconds, unless such a call is pending.
void Window::after(unsigned ms, Timer& timer) {
    if (timer.is_pending) return;
    timer.is_pending = true;
    timer.window = this;
    glutTimerFuncUcall(
        ms,
        [](int, void* data) {
            Timer& due = *static_cast<Timer*>(data);
            due.is_pending = false;
            guarded(due.window, due.action);
        },
        0, &timer);
}

void Window::start_imgui() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // writes no files
    io.ConfigFlags |= ImGuiConfigFlags_None;
    ImGui_ImplGLUT_Init();
    ImGui_ImplOpenGL2_Init();
    set_theme(options_.scale.value_or(screen_scale()));
    imgui_runs_ = true;
}

void Window::end_imgui() {
    panels_.reset();
    panes_.reset();
    if (!imgui_runs_) return;
    imgui_runs_ = false;
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGLUT_Shutdown();
    ImGui::DestroyContext();
}

int Window::run() {
    if (!session_.error.empty()) throw SceneError(session_.error);
    int argument_count = 1;
    char program[] = "twinlight-demo";
    char* arguments[] = {program, nullptr};
    glutInitErrorFuncUcall(refuse, nullptr);
    glutInit(&argument_count, arguments);
    // No GLUT_MULTISAMPLE: one sample, as in OSMesa. With alpha, since the reference's pictures have it, too.
    glutInitDisplayMode(GLUT_RGBA | GLUT_ALPHA | GLUT_DOUBLE | GLUT_DEPTH);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    glutInitWindowSize(options_.width, options_.height);
    glutCreateWindow("twinlight-demo");
    start_imgui();
    panes_ = std::make_unique<Panes>();
    panels_ = std::make_unique<Panels>();

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
    make_menu();

    guarded(this, [](Window& self) {
        for (const char code : self.options_.keys) {
            press(self.session_, static_cast<unsigned char>(code));
            refresh(self.session_, self.session_.width, self.session_.height);
        }
        self.carry_out_requests();
    });
    if (status_ == EXIT_SUCCESS && !session_.quit_requested) {
        set_timers();
        glutMainLoop();
    }
    end_imgui();
    write_times();
    return status_;
}

void Window::wake(int frames) {
    frames_wanted_ = std::max(frames_wanted_, frames);
    glutPostRedisplay();
}

void Window::set_timers() {
    if (panes_ && panes_->is_busy(session_)) after(kBusyMs, busy_timer_);
    if (session_.animating) after(kFrameMs, animation_timer_);
    if (session_.file) after(kFileMs, file_timer_);
    // A cursor that blinks in a field, a message that goes, and a panel's own work.
    const bool wants_frames =
        ImGui::GetIO().WantTextInput || !session_.message.empty() || (panels_ && panels_->is_busy(session_));
    if (wants_frames) after(kMessageMs, message_timer_);
}

void Window::reshape(int width, int height) {
    width_ = std::max(width, 1);
    height_ = std::max(height, 1);
    ImGui_ImplGLUT_ReshapeFunc(width, height);
    wake();
}

void Window::display() {
    const Clock::time_point start = Clock::now();
    if (session_.animating) {
        const double seconds = std::chrono::duration<double>(start - animated_since_).count();
        animated_since_ = start;
        session::animate(session_, std::min(seconds, 0.2));
    }
    frame();
    ++frames_shown_;
    // A script's last frame shows the reference's final picture.
    const bool last = options_.quit_after > 0 && frames_shown_ >= std::max(options_.quit_after, kFramesAfterEvent);
    if (last) {
        while (panes_->is_busy(session_)) {
            panes_->wait();
            frame();
        }
        frame();
        if (!options_.screenshot.empty()) save_screenshot();
    }
    if (session_.screenshot_requested) save_screenshot();
    if (panels_->saving().is_recording()) {
        const int left = layout_.panel.width;
        panels_->saving().add_frame(
            session::part_of(read_pixels(width_, height_), left, 0, width_ - left, layout_.status.y));
    }
    glutSwapBuffers();
    if (!options_.times.empty()) {
        frame_ms_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        for (std::size_t i = 0; i < session::kPanes; ++i) pane_ms_[i].push_back(panes_->last_ms(i).value_or(0));
    }

    if (last) {
        quit();
        return;
    }
    carry_out_requests();
    if (!imgui_runs_) return;
    if (--frames_wanted_ > 0 || options_.quit_after > 0) glutPostRedisplay();
    set_timers();
}

void Window::frame() {
    layout_ = session::layout(session_, width_, height_, scale());
    if (const std::string title = commands(session_).name + " - twinlight"; title != title_) {
        title_ = title;
        glutSetWindowTitle(title.c_str());
    }
    session::refresh(session_, layout_.picture.width, layout_.picture.height);
    panes_->update(session_, layout_);

    shown_x_ = static_cast<int>(ImGui::GetIO().MousePos.x);
    shown_y_ = static_cast<int>(ImGui::GetIO().MousePos.y);
    const fixed::InitialState initial(width_, height_);
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplGLUT_NewFrame();
    if (IMGUI_VERSION_NUM >= 18700) ImGui::NewFrame();  // 1.86's GLUT back end calls it itself
    panes_->show(session_, layout_);
    panels_->update(session_);
    if (layout_.panel.width > 0) panels_->show(session_, layout_.panel, *panes_);
    show_status(layout_);
    if (session_.keys_shown) show_keys();
    ImGui::Render();
    const ImVec4 background = ImGui::ColorConvertU32ToFloat4(kBackground);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void Window::show_status(const session::Layout& layout) {
    if (session_.messages != messages_seen_) {
        messages_seen_ = session_.messages;
        message_since_ = Clock::now();
    }
    if (Clock::now() - message_since_ > std::chrono::duration<double>(kMessageSeconds) && options_.quit_after == 0)
        session_.message.clear();

    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    const session::Box& bar = layout.status;
    const ImVec2 from(0, static_cast<float>(bar.y)), to(static_cast<float>(width_), static_cast<float>(height_));
    draw.AddRectFilled(from, to, session_.error.empty() ? kBar : IM_COL32(96, 34, 28, 255));
    const float y = from.y + (static_cast<float>(bar.height) - ImGui::GetFontSize()) / 2;
    const std::string& scene = commands(session_).name;
    draw.AddText(fonts().bold, fonts().bold->FontSize, {12, y}, kText, scene.c_str());
    const float after_name = 12 + fonts().bold->CalcTextSizeA(fonts().bold->FontSize, 1e4F, 0, scene.c_str()).x + 18;
    const char* help = "? keys   right click: menu";
    const float help_x = to.x - ImGui::CalcTextSize(help).x - 12;
    if (session_.error.empty()) {
        draw.AddText({help_x, y}, kDim, help);
        draw.PushClipRect(from, {help_x - 12, to.y});
    } else {
        draw.PushClipRect(from, to);
    }
    if (!session_.error.empty()) {
        draw.AddText({after_name, y}, kText, session_.error.c_str());
    } else if (!session_.message.empty()) {
        draw.AddText({after_name, y}, kAccent, session_.message.c_str());
    } else {
        draw.AddText({after_name, y}, kDim, session::lights_summary(session_.scene.frame).c_str());
    }
    draw.PopClipRect();
}

void Window::show_keys() const {
    ImGui::SetNextWindowPos({static_cast<float>(width_) / 2, static_cast<float>(height_) / 2}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.97F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {24, 18});
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs);
    ImGui::SetWindowFocus();
    bold_text("Keys");
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const session::Key& row : session::keys()) {
            if (row.label.empty()) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushFont(fonts().code_bold);
            ImGui::TextUnformatted(row.label.data(), row.label.data() + row.label.size());
            ImGui::PopFont();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(row.what.data(), row.what.data() + row.what.size());
        }
        ImGui::EndTable();
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
}

// If the file cannot be written, says so and goes on.
void Window::save_screenshot() {
    session_.screenshot_requested = false;
    const std::string file =
        options_.screenshot.empty() ? panels_->saving().screenshot_path(session_) : options_.screenshot;
    try {
        Image image = read_pixels(width_, height_);
        for (Rgba& pixel : image.pixels) pixel[3] = 1;
        write_png(file, image);
        say(session_, fmt::format("wrote {}, {} x {}", file, width_, height_));
        std::fprintf(stderr, "wrote %s, %d x %d\n", file.c_str(), width_, height_);
    } catch (const FileError& error) {
        say(session_, error.what());
        std::fprintf(stderr, "twinlight-demo: %s\n", error.what());
        status_ = 2;
    }
    wake();
}

void Window::write_times() const {
    if (options_.times.empty()) return;
    write_file_atomically(options_.times, nlohmann::json{{"frame_ms", frame_ms_}, {"pane_ms", pane_ms_}}.dump() + "\n");
}

void Window::key(int code) {
    const ImGuiIO& io = ImGui::GetIO();
    constexpr int kEscape = 27;
    if (code == kEscape && ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
        ImGui::SetWindowFocus(nullptr);  // closes the popups
        wake();
        return;
    }
    if (!(io.WantCaptureKeyboard && io.WantTextInput)) press(session_, code);
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
    if (std::exchange(session_.export_requested, false)) panels_->saving().save(session_, session::Form::kC);
    if (session_.screenshot_requested) wake();
}

void Window::open_neighbour(int step) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : kSceneFiles) names.emplace_back(file.name.substr(0, file.name.rfind(".gl")));
    const auto here = std::ranges::find(names, commands(session_).name);
    const std::size_t index =
        here == names.end() ? (step > 0 ? names.size() - 1 : 0) : static_cast<std::size_t>(here - names.begin());
    const std::string& name =
        names[(index + names.size() + static_cast<std::size_t>(step + static_cast<int>(names.size()))) % names.size()];
    session::open(session_, load_commands(name), {});
    say(session_, "scene " + name);
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
        session::open(session_, load_commands(*session_.file), session_.file);
        say(session_, "read again: " + *session_.file);
    } catch (const std::exception& problem) {
        session_.error = problem.what();
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
    if (down) {
        pressed_x_ = x;
        pressed_y_ = y;
        moved_ = false;
        drag_start_ = session::start_drag(session_);
        drag_start_.may_go_under = (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
        session_.history.end_group();
        const auto where = hit(layout_, x, y);
        if (!where) return;
        const session::Box& box = layout_.cells.front().picture;
        const bool on_line = session_.view == session::View::kSlider && button == GLUT_LEFT_BUTTON &&
                             std::abs(x - (box.x + session_.slider_at * box.width)) < 14;
        drag_ = on_line                       ? Drag::kSlider
                : button == GLUT_LEFT_BUTTON  ? Drag::kOrbit
                : button == GLUT_RIGHT_BUTTON ? Drag::kLook
                                              : Drag::kNone;
        return;
    }
    if (drag_ == Drag::kNone) return;
    session_.history.end_group();
    const Drag ended = std::exchange(drag_, Drag::kNone);
    if (moved_) return;
    if (ended == Drag::kLook) open_menu(x, y);
    if (ended != Drag::kOrbit) return;
    if (const auto where = hit(layout_, x, y)) {
        const session::Box& box = layout_.cells.front().picture;
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
        const session::Box& box = layout_.cells.front().picture;
        session_.slider_at = std::clamp(static_cast<double>(x - box.x) / box.width, 0.0, 1.0);
    }
}

void Window::passive_motion(int x, int y) {
    ImGui_ImplGLUT_MotionFunc(x, y);
    // Over a picture nothing lights up under the mouse, except the lights of the world view.
    if (!hit(layout_, x, y) || ImGui::GetIO().WantCaptureMouse || session_.view == session::View::kWorld) wake();
}

void Window::make_menu() {
    const auto new_menu = [this] {
        return glutCreateMenuUcall([](int code, void* w) { guarded(w, [=](Window& self) { self.key(code); }); }, this);
    };
    const int lights = new_menu();
    for (int i = 0; i < kMaxLights; ++i)
        glutAddMenuEntry(fmt::format("{}    {}", i + 1, light_name(i)).c_str(), '1' + i);
    menu_ = new_menu();
    for (const session::Key& row : session::keys()) {
        if (row.label.empty() || !row.in_menu) continue;
        const std::string line = fmt::format("{}    {}", row.label, row.what);
        if (row.first == '1')
            glutAddSubMenu(line.c_str(), lights);
        else
            glutAddMenuEntry(line.c_str(), row.first);
    }
}

// GLUT opens its menu when the button goes down, which would take the drag. So the menu is attached when a click turns out not
// to be a drag, and the click is sent again.
void Window::open_menu(int x, int y) {
    glutSetMenu(menu_);
    glutAttachMenu(GLUT_RIGHT_BUTTON);
    Display* display = glXGetCurrentDisplay();
    XButtonEvent press{};
    press.type = ButtonPress;
    press.display = display;
    press.window = glXGetCurrentDrawable();
    press.root = DefaultRootWindow(display);
    press.same_screen = True;
    press.button = Button3;
    press.x = x;
    press.y = y;
    ::Window child = 0;
    XTranslateCoordinates(display, press.window, press.root, x, y, &press.x_root, &press.y_root, &child);
    XSendEvent(display, press.window, True, ButtonPressMask, reinterpret_cast<XEvent*>(&press));
    XFlush(display);
}

void Window::quit() {
    end_imgui();
    glutLeaveMainLoop();
}

}  // namespace

int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options) {
    return Window(scene, options).run();
}

}  // namespace twinlight::demo

std::string_view twinlight::context_provider() { return "GLUT"; }

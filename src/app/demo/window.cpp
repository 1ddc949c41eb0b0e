// The window's life and its frames. Callbacks get a pointer to the Window (the ...Ucall functions of freeglut 3.4).
//
// A frame: the panes draw what changed, at the window's lower left corner, into textures; then ImGui draws the pictures,
// the bars and the panels. Frames are drawn only after events, while something moves, and while the reference is at work.
#include "app/demo/window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "app/demo/clipboard.h"
#include "app/demo/drawn_texts.h"
#include "app/demo/glut_window.h"
#include "app/demo/theme.h"
#include "app/demo/x_drawing_context.h"
#include "app/session/clip.h"
#include "app/session/lesson_state.h"
#include "app/session/tutor.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "base/text/translation.h"
#include "render/context/context.h"
#include "render/context/driver_choice.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"

// freeglut's headers come after render/context/gl.h, which declares GL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>
#include <backends/imgui_impl_glut.h>
#include <backends/imgui_impl_opengl2.h>

namespace twinlight::demo {
namespace {

constexpr unsigned kFrameMs = 16;      // between frames while something moves
constexpr unsigned kBusyMs = 30;       // between looks at the reference's work
constexpr unsigned kMessageMs = 200;   // between looks at a message's age
constexpr unsigned kFileMs = 500;      // between looks at the scene's file
constexpr unsigned kRecoveryMs = 250;  // from a change to the recovery file

[[noreturn]] void refuse(const char* format, va_list arguments, void*) {
    char reason[512];
    std::vsnprintf(reason, sizeof reason, format, arguments);
    const char* display = std::getenv("DISPLAY");
    const std::string wrong = one_line(wrong_driver_choice());
    std::fprintf(stderr, "twinlight-demo: cannot open a window: %s (DISPLAY is %s); %s\n", reason,
                 display && *display ? display : "not set",
                 wrong.empty() ? "without a display, use 'twinlight compare SCENE -o DIR'" : wrong.c_str());
    std::_Exit(2);  // without freeglut's last words to a display that refused it
}

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A script is not asked, and leaves nothing.
std::string recovery_folder_of(const WindowOptions& options) {
    return options.quit_after > 0 ? "" : session::recovery_folder();
}

}  // namespace

double Window::screen_scale() {
    const int millimetres = glutGet(GLUT_SCREEN_WIDTH_MM), pixels = glutGet(GLUT_SCREEN_WIDTH);
    if (millimetres <= 0 || pixels <= 0) return 1;
    const double dots_per_inch = pixels / (millimetres / 25.4);
    return std::clamp(std::floor(2 * dots_per_inch / 96) / 2, 1.0, 3.0);
}

// As it was last, or 1280 x 800 for letters of the usual size; never larger than the screen, whose bars and frames need room, too.
WindowSize Window::first_size() const {
    if (options_.size) return *options_.size;
    constexpr WindowSize kUsual{1280, 800};
    if (is_script()) return kUsual;
    const auto fit = [&](int last, int usual, int screen, int room) {
        const int wanted = last > 0 ? last : static_cast<int>(std::lround(usual * scale_));
        return screen > 0 ? std::min(wanted, std::max(screen - room, 1)) : wanted;
    };
    constexpr int kFrame = 16, kBars = 64;
    return {fit(preferences_.width, kUsual.width, glutGet(GLUT_SCREEN_WIDTH), kFrame),
            fit(preferences_.height, kUsual.height, glutGet(GLUT_SCREEN_HEIGHT), kBars)};
}

void Window::remember() {
    if (is_script()) return;
    preferences_.solved_lessons = session_.solved_lessons;
    preferences_.recent_files = session_.recent_files;
    preferences_.lecture_symbols = session_.symbols == session::Symbols::kLecture;
    for (const session::PanelName& panel : session::kPanels)
        if (panel.value == session_.panel) preferences_.panel = panel.key;
    session::write_preferences(session::preferences_file(), preferences_);
}

Window::Window(std::shared_ptr<const CommandList> scene, const WindowOptions& options)
    : options_(options), session_(std::move(scene), options.file), recovery_(recovery_folder_of(options)) {
    if (!is_script()) preferences_ = session::read_preferences(session::preferences_file());
    session_.solved_lessons = preferences_.solved_lessons;
    session_.recent_files = preferences_.recent_files;
    if (preferences_.lecture_symbols) session_.symbols = session::Symbols::kLecture;
    session_.view = options.view;
    for (const session::PanelName& panel : session::kPanels)
        if (panel.key == preferences_.panel) session_.panel = panel.value;
    session_.panel = options.panel.value_or(session_.panel);
    session_.probe = options.probe;
    if (!options.tutor.empty()) session::open_tutor(session_, options.tutor);
    if (options.lesson) session::start_lesson(session_, *options.lesson);
    const WindowSize size = session::natural_size(commands(session_));
    refresh(session_, size.width, size.height);
}

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
    ImGui::GetIO().IniFilename = nullptr;  // writes no files
    ImGui_ImplGLUT_Init();
    ImGui_ImplOpenGL2_Init();
    give_imgui_the_clipboard();
    set_theme(scale_, options_.language);
    imgui_runs_ = true;
}

void Window::end_imgui() {
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
    DrawingContext::allow_threads();
    glutInitErrorFuncUcall(refuse, nullptr);
    glutInit(&argument_count, arguments);
    // No GLUT_MULTISAMPLE: one sample, as in OSMesa. With alpha, since the reference's pictures have it, too.
    glutInitDisplayMode(GLUT_RGBA | GLUT_ALPHA | GLUT_DOUBLE | GLUT_DEPTH | GLUT_STENCIL);
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    scale_ = options_.scale.value_or(screen_scale());
    const WindowSize size = first_size();
    glutInitWindowSize(size.width, size.height);
    glutCreateWindow("twinlight-demo");
    start_imgui();
    panes_ = std::make_unique<Panes>();
    panels_ = std::make_unique<Panels>();

    register_callbacks();

    if (options_.times.empty()) guarded(this, [](Window& self) { self.press_keys(); });
    if (status_ == EXIT_SUCCESS && !session_.quit_requested) {
        auto lost = session::find_lost_scenes(recovery_folder_of(options_));
        if (lost) dialogs_.offer(session_, std::move(*lost));
        set_timers();
        glutMainLoop();
    }
    end();
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
    if (session_.history.revision() != recovery_revision_) after(kRecoveryMs, recovery_timer_);
    // A cursor that blinks in a field, a message that goes, and a panel's own work.
    const bool wants_frames = ImGui::GetIO().WantTextInput || !session_.message.empty() ||
                              (panels_ && panels_->is_busy(session_)) || dialogs_.is_busy();
    if (wants_frames) after(kMessageMs, message_timer_);
}

// GLUT calls it when no event waits, so the changes that came before the button are made.
void Window::display() {
    if (std::exchange(close_pressed_, false)) session::request_end(session_);
    if (!options_.times.empty() && frames_shown_ == 0) press_timed_keys();
    if (!imgui_runs_) return;
    ++frames_shown_;
    draw();
}

// Before the first frame.
void Window::press_keys() {
    for (const int code : options_.keys) {
        session::press(session_, code);
        carry_out_requests();
        refresh(session_, session_.width, session_.height);
    }
}

// Each key is pressed when nothing is at work.
void Window::press_timed_keys() {
    for (const int code : options_.keys) {
        come_to_rest();
        if (!imgui_runs_) return;
        const Clock::time_point start = Clock::now();
        key(code);
        if (!imgui_runs_) return;
        draw();
        KeyTime& times =
            key_times_.emplace_back(KeyTime{.key = session::name_of_key(code), .answer_ms = ms_since(start)});
        while (panes_->is_late()) {
            panes_->wait_for_driver();
            draw();
        }
        times.picture_ms = ms_since(start);
    }
}

// What is animated never rests.
void Window::come_to_rest() {
    while (imgui_runs_ && (frames_wanted_ > 0 || (panes_->is_busy(session_) && !session_.animating))) {
        panes_->wait(session_);
        draw();
    }
}

void Window::draw() {
    const Clock::time_point start = Clock::now();
    if (session_.animating) {
        const double seconds = std::chrono::duration<double>(start - animated_since_).count();
        animated_since_ = start;
        session::animate(session_, std::min(seconds, 0.2));
    }
    frame();
    // A script's last frame shows the reference's final picture.
    const bool last = options_.quit_after > 0 && frames_shown_ >= std::max(options_.quit_after, kFramesAfterEvent);
    if (last) {
        while (panes_->is_busy(session_)) {
            panes_->wait(session_);
            frame();
        }
        frame();
        if (!options_.screenshot.empty()) save_screenshot();
        if (!options_.times.empty()) {
            cut_letters_ = cut_letters(*ImGui::GetDrawData());
            overlapping_letters_ = overlapping_letters(*ImGui::GetDrawData());
            texts_ = drawn_texts(*ImGui::GetDrawData());
        }
    }
    if (session_.screenshot_requested) save_screenshot();
    if (panels_->saving().is_recording()) {
        const int left = layout_.panel.width;
        panels_->saving().add_frame(
            session::part_of(read_pixels(width_, height_), left, 0, width_ - left, layout_.status.y));
    }
    glutSwapBuffers();
    if (!options_.times.empty()) {
        frame_ms_.push_back(ms_since(start));
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
    if (const std::string title = title_of(session_) + " - twinlight"; title != title_) {
        title_ = title;
        glutSetWindowTitle(title.c_str());
        session::note_recent_file(session_);
    }
    session::refresh(session_, layout_.picture.width, layout_.picture.height);
    // What is written to a file shows no earlier picture.
    panes_->update(session_, layout_, session_.screenshot_requested || panels_->saving().is_recording());

    input_changed_ = false;
    shown_x_ = static_cast<int>(ImGui::GetIO().MousePos.x);
    shown_y_ = static_cast<int>(ImGui::GetIO().MousePos.y);
    const fixed::InitialState initial(width_, height_);
    ImGui_ImplOpenGL2_NewFrame();
    ImGui_ImplGLUT_NewFrame();
    if (IMGUI_VERSION_NUM >= 18700) ImGui::NewFrame();  // 1.86's GLUT back end calls it itself
    panes_->show(session_, layout_);
    panels_->update(session_);
    if (layout_.panel.width > 0) panels_->show(session_, layout_.panel, *panes_);
    if (layout_.caption.height > 0) show_caption(session_, layout_.caption);
    if (layout_.code.height > 0) panels_->show_tutor(session_, layout_.code);
    status_line_.show(session_, layout_.status, options_.quit_after > 0);
    if (session_.keys_shown) show_keys(width_, height_);
    dialogs_.show(session_, *panes_);
    ImGui::Render();
    const ImVec4 background = ImGui::ColorConvertU32ToFloat4(kBackground);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
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
        say(session_, tr("wrote {}, {} x {}", file, width_, height_));
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
    Json keys = Json::array();
    for (const KeyTime& time : key_times_)
        keys.push_back({{"key", time.key}, {"answer_ms", time.answer_ms}, {"picture_ms", time.picture_ms}});
    const Json json = {{"frame_ms", frame_ms_},
                       {"pane_ms", pane_ms_},
                       {"keys", keys},
                       {"cut_letters", cut_letters_},
                       {"overlapping_letters", overlapping_letters_},
                       {"texts", texts_}};
    write_file_atomically(options_.times, dumped(json) + "\n");
}

// Also remembers what the next window starts with. Textures and programs are deleted while their context is current.
void Window::end() {
    if (panes_) remember();
    panels_.reset();
    panes_.reset();
    end_imgui();
}

void Window::quit() {
    end();
    glutLeaveMainLoop();
}

int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options) {
    return Window(scene, options).run();
}

}  // namespace twinlight::demo

// The part of the demo that uses freeglut. Callbacks get a pointer to the Window (the ...Ucall functions of freeglut 3.4).
//
// For each frame, the renderer first draws at the window's lower left corner, where a scene's own glViewport expects to be.
// The key s and --screenshot write that picture. The bars, the overlays and the swap come after it.
#include "app/demo/window.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <sstream>

#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "judge/report/words.h"
#include "render/context/context.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "scene/state/state.h"

// freeglut's headers come after render/context/gl.h, which declares GL.
#include <GL/freeglut.h>
#include <GL/freeglut_ucall.h>

namespace twinlight::demo {
namespace {

static_assert(GLUT_KEY_F1 == 1 && GLUT_KEY_LEFT == 100 && GLUT_KEY_UP == 101 && GLUT_KEY_RIGHT == 102 &&
                  GLUT_KEY_DOWN == 103,
              "the codes of the keys in controls.cpp");
constexpr int kWheelUp = 3, kWheelDown = 4;   // how freeglut reports the wheel as buttons
constexpr int kLineHeight = 15, kMargin = 6;  // of the overlays, in pixels; the font is 8 by 13

// The two renderers are compared, so both follow GL's own model, without the lecture's variants.
constexpr programmable::Options kOptions{{{.shading = {}, .lecture_variants = false}}};
// For drawing frame after frame: numbers that do not change are baked into the shaders. Difference pictures use kOptions.
constexpr programmable::Options kLiveOptions{{{.shading = {}, .lecture_variants = false}}, programmable::Tier::kAuto};

// The title of an incomplete picture has "(partial)"; the terminal lists the missing commands.
void warn_unsupported(const Frame& frame) {
    constexpr std::array shown = {Path::kFixed, Path::kProgrammable};
    for (const Unsupported& item : frame.unsupported)
        if (!report::names_of(item, shown).empty())
            std::fprintf(stderr, "twinlight-demo: note: %s\n", report::sentence_of(item, shown).c_str());
}

class Window {
  public:
    Window(std::shared_ptr<const CommandList> scene, const WindowOptions& options)
        : scene_(std::move(scene)), options_(options) {
        remake_frame();  // reports a bad scene before a window opens
        controls_ = make_controls(shown_.frame);
        controls_.renderer = options.renderer;
        warn_unsupported(shown_.frame);
    }

    int run();

  private:
    void reshape(int width, int height);
    void display();
    void key(int code);
    void mouse(int button, int state, int x, int y);
    void motion(int x, int y);

    void act();  // quits or redraws, as the controls ask
    void quit();
    void save();
    void remake_frame();
    void draw_picture();
    void place_picture();
    void draw_overlays();
    Image render(Path renderer);

    // An exception must not pass through GLUT's C code, so this ends the main loop.
    template <class Action>
    static void guarded(void* window, Action action) {
        Window& self = *static_cast<Window*>(window);
        try {
            action(self);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "twinlight-demo: %s\n", e.what());
            self.status_ = EXIT_FAILURE;
            self.quit();
        }
    }

    std::shared_ptr<const CommandList> scene_;
    WindowOptions options_;
    Controls controls_;
    int width_ = 0, height_ = 0;  // of the window
    Viewport picture_;            // its size, and where in the window it is shown
    std::optional<View> framed_view_;
    Scene shown_;  // made from the scene under framed_view_
    std::unique_ptr<programmable::Renderer> programmable_;
    int amplification_ = 1;  // of the difference shown
    std::string summary_;    // of what is shown
    int frames_shown_ = 0;
    bool dragging_ = false;
    int mouse_x_ = 0, mouse_y_ = 0;
    int status_ = EXIT_SUCCESS;
};

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

// The corner is the picture's top left in window coordinates (y up). Exact for images of 8 bits a channel.
void draw_image(const Image& image, int x, int y_top) {
    glWindowPos2i(x, y_top);
    glPixelZoom(1, -1);  // rows go downward from y_top
    glDrawPixels(image.width, image.height, GL_RGBA, GL_FLOAT, image.pixels.data());
    glPixelZoom(1, 1);
}

// White letters with a black shadow are readable on any picture.
void draw_text(const std::string& text, int x, int y_top) {
    std::istringstream lines(text);
    std::string line;
    for (int y = y_top - kLineHeight; std::getline(lines, line); y -= kLineHeight) {
        for (const int shadow : {1, 0}) {
            glColor3ub(shadow ? 0 : 255, shadow ? 0 : 255,
                       shadow ? 0 : 255);  // glWindowPos uses the current colour
            glWindowPos2i(x + shadow, y - shadow);
            glutBitmapString(GLUT_BITMAP_8_BY_13, reinterpret_cast<const unsigned char*>(line.c_str()));
        }
    }
}

// Makes the list of keys readable on a bright picture. Needs GL's initial matrices.
void dim_picture() {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(0, 0, 0, 0.65F);
    glRecti(-1, -1, 1, 1);
    glDisable(GL_BLEND);
}

int Window::run() {
    int argument_count = 1;
    char program[] = "twinlight-demo";
    char* arguments[] = {program, nullptr};
    glutInitErrorFuncUcall(refuse, nullptr);
    glutInit(&argument_count, arguments);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);  // no GLUT_MULTISAMPLE: one sample, as in OSMesa
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS);
    glutInitWindowSize(options_.width, options_.height);
    glutCreateWindow("twinlight-demo");

    glutDisplayFuncUcall([](void* w) { guarded(w, [](Window& self) { self.display(); }); }, this);
    glutReshapeFuncUcall(
        [](int width, int height, void* w) { guarded(w, [=](Window& self) { self.reshape(width, height); }); }, this);
    glutKeyboardFuncUcall(
        [](unsigned char code, int, int, void* w) { guarded(w, [=](Window& self) { self.key(code); }); }, this);
    glutSpecialFuncUcall(
        [](int code, int, int, void* w) { guarded(w, [=](Window& self) { self.key(kSpecialKey + code); }); }, this);
    glutMouseFuncUcall([](int button, int state, int x, int y,
                          void* w) { guarded(w, [=](Window& self) { self.mouse(button, state, x, y); }); },
                       this);
    glutMotionFuncUcall([](int x, int y, void* w) { guarded(w, [=](Window& self) { self.motion(x, y); }); }, this);
    // The programs must be deleted while their context is current.
    glutCloseFuncUcall([](void* w) { static_cast<Window*>(w)->programmable_.reset(); }, this);

    guarded(this, [](Window& self) {
        for (const char code : self.options_.keys) press(self.controls_, static_cast<unsigned char>(code));
        self.act();
    });
    if (status_ == EXIT_SUCCESS && !controls_.quit_requested) glutMainLoop();
    return status_;
}

void Window::reshape(int width, int height) {
    width_ = width;
    height_ = height;
    picture_ = fit(options_.width, options_.height, width, height);
    framed_view_.reset();
    glutPostRedisplay();
}

void Window::remake_frame() {
    if (framed_view_ == controls_.view) return;
    const auto seen = std::make_shared<const CommandList>(apply_view(*scene_, controls_.view));
    StateOptions options;
    options.width = picture_.width > 0 ? picture_.width : options_.width;
    options.height = picture_.height > 0 ? picture_.height : options_.height;
    shown_ = make_scene(seen, options);
    framed_view_ = controls_.view;
}

void Window::display() {
    remake_frame();
    draw_picture();
    summary_ = summary(scene_->name, controls_, shown_.frame, amplification_);
    glutSetWindowTitle((summary_ + " - twinlight").c_str());
    ++frames_shown_;
    const bool last = options_.quit_after > 0 && frames_shown_ >= options_.quit_after;
    if (controls_.save_requested || (last && !options_.screenshot.empty())) {
        save();
    }
    place_picture();
    draw_overlays();
    glutSwapBuffers();

    if (last) {
        quit();
    } else if (options_.quit_after > 0) {
        glutPostRedisplay();
    }
}

// If the file cannot be written, prints an error and goes on.
void Window::save() {
    controls_.save_requested = false;
    const std::string file = options_.screenshot.empty() ? "twinlight-demo.png" : options_.screenshot;
    try {
        write_png(file, read_pixels(picture_.width, picture_.height));
        std::fprintf(stderr, "wrote %s, %d x %d\n", file.c_str(), picture_.width, picture_.height);
    } catch (const FileError& e) {
        std::fprintf(stderr, "twinlight-demo: %s\n", e.what());
        status_ = 2;
    }
}

void Window::draw_picture() {
    if (controls_.difference) {
        const Image fixed = render(Path::kFixed);
        const Image programmable = render(Path::kProgrammable);
        const PixelMask no_edges(fixed.pixels.size());
        amplification_ = amplification_for(difference(fixed, programmable, no_edges).interior.max);
        const fixed::InitialState initial(width_, height_);
        draw_image(difference_picture(fixed, programmable, amplification_), 0, picture_.height);
    } else if (controls_.renderer == Path::kFixed) {
        fixed::draw(shown_);
    } else {
        if (!programmable_) programmable_ = std::make_unique<programmable::Renderer>();
        programmable_->draw(shown_.frame, kLiveOptions);
    }
}

Image Window::render(Path renderer) {
    if (renderer == Path::kFixed) return fixed::render(shown_);
    if (!programmable_) programmable_ = std::make_unique<programmable::Renderer>();
    return programmable_->render(shown_.frame, kOptions).image;
}

// Moves the picture from the lower left corner to the middle, between black bars.
void Window::place_picture() {
    if (picture_.width == width_ && picture_.height == height_) return;
    const Image image = read_pixels(picture_.width, picture_.height);
    const fixed::InitialState initial(width_, height_);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_image(image, picture_.x, picture_.y + picture_.height);
}

void Window::draw_overlays() {
    const fixed::InitialState initial(width_, height_);
    if (controls_.keys_shown) {
        dim_picture();
        draw_text(keys_help(), kMargin, height_ - kMargin);
    }
    if (controls_.status_shown) {
        draw_text("F1: keys - " + summary_, kMargin, kMargin + kLineHeight);
    }
}

void Window::key(int code) {
    const bool keys_were_shown = controls_.keys_shown;
    press(controls_, code);
    if (controls_.keys_shown && !keys_were_shown) {
        std::fputs(keys_help().c_str(), stdout);
        std::fflush(stdout);
    }
    act();
}

void Window::act() {
    if (controls_.quit_requested) {
        quit();
    } else {
        glutPostRedisplay();
    }
}

void Window::mouse(int button, int state, int x, int y) {
    if (button == GLUT_LEFT_BUTTON) dragging_ = state == GLUT_DOWN;
    mouse_x_ = x;
    mouse_y_ = y;
    if (state == GLUT_DOWN && (button == kWheelUp || button == kWheelDown)) {
        zoom(controls_, button == kWheelUp ? 1 : -1);
        act();
    }
}

void Window::motion(int x, int y) {
    if (!dragging_) return;
    drag(controls_, x - mouse_x_, y - mouse_y_);
    mouse_x_ = x;
    mouse_y_ = y;
    act();
}

void Window::quit() {
    programmable_.reset();
    glutLeaveMainLoop();
}

}  // namespace

int show(const std::shared_ptr<const CommandList>& scene, const WindowOptions& options) {
    return Window(scene, options).run();
}

}  // namespace twinlight::demo

std::string_view twinlight::context_provider() { return "GLUT"; }

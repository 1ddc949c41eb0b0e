// What only X can do with the window: press its close button, as a window manager does, and see what is on the screen without a key.
// Apart from the other tests of the window, because X's macros disturb what follows them in a room.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/image/png.h"
#include "demo_window.h"
#include "xvfb.h"

namespace twinlight::window_x11_test {
namespace {

// The tests are not linked with libX11.
template <class Function>
Function* of_x11(const char* name) {
    static void* const kLibrary = ::dlopen("libX11.so.6", RTLD_NOW);
    return kLibrary ? reinterpret_cast<Function*>(::dlsym(kLibrary, name)) : nullptr;
}
#define OF_X11(name) of_x11<decltype(name)>(#name)

void press_close_button(const std::string& display_name, unsigned long window) {
    Display* const display = OF_X11(XOpenDisplay)(display_name.c_str());
    ASSERT_NE(display, nullptr);
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = OF_X11(XInternAtom)(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(OF_X11(XInternAtom)(display, "WM_DELETE_WINDOW", False));
    OF_X11(XSendEvent)(display, window, False, NoEventMask, &event);
    OF_X11(XCloseDisplay)(display);
}

using demo_window::folder, demo_window::run;

class WindowX11 : public testing::Test {
  protected:
    void SetUp() override {
        if (!server_.running()) GTEST_SKIP() << server_.reason();
        if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
        std::filesystem::create_directories(folder());
    }
    void TearDown() override { std::filesystem::remove_all(folder()); }

    const Xvfb server_;
};

TEST_F(WindowX11, TheCloseButtonAsksBeforeChangesAreLost) {
    const std::string scene = (folder() / "closed.gl").string();
    const std::string text = "// A ball.\nglutSolidSphere(0.8, 24, 12);\n";
    const auto xdo = [&](const std::string& commands) {
        return run("DISPLAY=" + server_.display() + " xdotool " + commands).output;
    };
    const auto start = [&] {
        // A window that has just ended may still be there.
        EXPECT_TRUE(demo_window::wait_for([&] { return xdo("search --onlyvisible --name twinlight").empty(); }));
        auto demo = std::make_unique<demo_window::RunningDemo>(
            server_.display(), std::vector<std::string>{scene, "--scale", "1", "--size", "800x600"});
        const std::string window = xdo("search --sync --onlyvisible --name twinlight");
        xdo("mousemove 600 300");
        EXPECT_TRUE(demo->comes_to_rest());
        return std::pair(std::move(demo), std::stoul(window));
    };
    write_file_atomically(scene, text);
    {
        const auto [demo, window] = start();
        press_close_button(server_.display(), window);
        EXPECT_EQ(demo->ended(), 0) << "nothing was changed";
    }
    const auto [demo, window] = start();
    xdo("key f");
    press_close_button(server_.display(), window);
    EXPECT_TRUE(demo->comes_to_rest());  // it asks
    xdo("key Escape key ctrl+s");        // stays, and still works
    EXPECT_TRUE(demo_window::wait_for(
        [&] { return read_file(scene) == "// A ball.\nglShadeModel(GL_FLAT);\nglutSolidSphere(0.8, 24, 12);\n"; }));
    xdo("key z");
    press_close_button(server_.display(), window);
    EXPECT_TRUE(demo->comes_to_rest());
    xdo("key Return");  // saves
    EXPECT_EQ(demo->ended(), 0);
    EXPECT_EQ(read_file(scene), text);
}

// The table of the tab Accuracy is shown when the measurement is done, without further events. Its last column is in the right half of
// the panel, in the green of good rows.
TEST_F(WindowX11, TheTableOfAMeasurementIsAsWideAsItsNumbers) {
    const std::string scene = (folder() / "lamp.gl").string();
    write_file_atomically(scene, "glEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\nglutSolidSphere(0.8, 24, 12);\n");
    const demo_window::RunningDemo demo(
        server_.display(), {scene, "--panel", "accuracy", "--view", "single", "--scale", "1", "--size", "800x600"});
    const std::string xdotool = "DISPLAY=" + server_.display() + " xdotool ";
    run(xdotool + "search --sync --onlyvisible --name twinlight");
    ASSERT_TRUE(demo.comes_to_rest());
    run(xdotool + "mousemove 50 180 click 1");
    ASSERT_TRUE(demo.comes_to_rest());
    Display* const display = OF_X11(XOpenDisplay)(server_.display().c_str());
    ASSERT_NE(display, nullptr);
    XImage* const screen = OF_X11(XGetImage)(display, DefaultRootWindow(display), 0, 0, 800, 600, ~0UL, ZPixmap);
    ASSERT_NE(screen, nullptr);
    int last = 0;
    for (int y = 340; y < 560; ++y)
        for (int x = 0; x < 350; ++x) {
            const unsigned long pixel = XGetPixel(screen, x, y);
            if ((pixel >> 8 & 255) > 180 && (pixel >> 16 & 255) < 140) last = std::max(last, x);
        }
    EXPECT_GT(last, 175);
    XDestroyImage(screen);
    OF_X11(XCloseDisplay)(display);
}

// In a narrow panel, the tabs that do not fit are under "More". Here it is chosen by its place; so is its third line, Accuracy.
TEST_F(WindowX11, TabsThatDoNotFitAreUnderMore) {
    const std::string scene = (folder() / "lamp.gl").string(), picture = (folder() / "window.png").string();
    write_file_atomically(scene, "glEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\nglutSolidSphere(0.8, 24, 12);\n");
    const std::string xdotool = "DISPLAY=" + server_.display() + " xdotool ";
    const auto opened_with = [&](const std::string& tab) {
        const std::vector<std::string> options{scene, "--panel", tab,       "--view",       "single", "--scale",
                                               "1",   "--size",  "800x600", "--screenshot", picture};
        auto demo = std::make_unique<demo_window::RunningDemo>(server_.display(), options);
        run(xdotool + "search --sync --onlyvisible --name twinlight");
        EXPECT_TRUE(demo->comes_to_rest());
        return demo;
    };
    const auto panel = [&] {
        std::filesystem::remove(picture);
        run(xdotool + "mousemove 600 300 key p");
        EXPECT_TRUE(demo_window::wait_for([&] { return std::filesystem::exists(picture); }));
        const Image window = read_png(picture);
        std::vector<Rgba> pixels;
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 350; ++x) pixels.push_back(window.at(x, y));
        return pixels;
    };
    auto demo = opened_with("commands");
    const auto commands = panel();
    for (const std::string step : {"mousemove 304 21 click 1", "mousemove 310 90", "click 1"}) {
        run(xdotool + step);
        EXPECT_TRUE(demo->comes_to_rest());
    }
    const auto chosen = panel();
    EXPECT_FALSE(chosen == commands);
    demo.reset();
    demo = opened_with("accuracy");
    EXPECT_TRUE(chosen == panel());
}

}  // namespace
}  // namespace twinlight::window_x11_test

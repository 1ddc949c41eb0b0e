// What the window does with a user's work: Esc, the questions before it ends, saving, fields that take letters, the clipboard. By real
// keys and clicks under Xvfb; the results are the files that the window writes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../unit/pictures.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "demo_window.h"
#include "xvfb.h"

namespace twinlight::demo_editing_test {
namespace {

using demo_window::folder, demo_window::run, demo_window::RunningDemo, demo_window::wait_for;

const std::string kLamp = R"(// A lamp and a ball.
gluPerspective(45, 4.0 / 3.0, 0.1, 100);  // as in the lecture
glTranslatef(0, 0, -5);
glEnable(GL_LIGHTING);
glEnable(GL_LIGHT0);  // the lamp
GLfloat lamp[] = {2, 3, 4, 1};
glLightfv(GL_LIGHT0, GL_POSITION, lamp);
glutSolidSphere(0.8, 24, 12);
)";
// What the key f inserts at the start.
const std::string kFlat = "glShadeModel(GL_FLAT);\n";

std::string flat(const std::string& text) {
    std::string result = text;
    return result.insert(text.find("gluPersp"), kFlat);
}

class DemoEditing : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        std::filesystem::create_directories(folder());
        server_ = std::make_unique<Xvfb>();
    }
    static void TearDownTestSuite() {
        server_.reset();
        std::filesystem::remove_all(folder());
    }
    void SetUp() override {
        if (!server_->running()) GTEST_SKIP() << server_->reason();
        if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
        std::filesystem::remove_all(folder() / "state");
        std::filesystem::remove_all(folder() / "config");
        std::filesystem::remove(picture_);
        write_file_atomically(scene_, kLamp);
    }

    // A window that has something to offer, or one that answers keys.
    enum class Start { kAnswers, kAsks };
    void open(std::vector<std::string> options, Start start = Start::kAnswers) {
        options.insert(options.end(),
                       {"--view", "single", "--scale", "1", "--size", "800x600", "--screenshot", picture_});
        // A window that has just ended may still be there.
        const auto is_there = [&] { return xdo("search --onlyvisible --name twinlight").status == 0; };
        ASSERT_TRUE(wait_for([&] { return !is_there(); })) << "a window of before";
        demo_.emplace(server_->display(), options);
        ASSERT_TRUE(wait_for(is_there)) << read_file((folder() / "demo.log").string());
        xdo("mousemove 600 300");  // without a window manager, the window under the pointer has the keys
        ASSERT_TRUE(start == Start::kAsks ? demo_->comes_to_rest() : answers()) << "the start";
    }
    demo_window::Ran xdo(const std::string& commands) {
        return run("DISPLAY=" + server_->display() + " xdotool " + commands);
    }
    // Whether the program still answers: it writes a picture.
    bool answers() {
        std::filesystem::remove(picture_);
        xdo("key p");
        return wait_for([&] { return std::filesystem::exists(picture_); });
    }
    Image picture() {
        EXPECT_TRUE(answers());
        return read_png(picture_);
    }
    bool file_becomes(const std::string& text) {
        return wait_for([&] { return read_file(scene_) == text; });
    }
    bool has_recovery_file() {
        std::error_code missing;
        return std::filesystem::directory_iterator(folder() / "state/twinlight", missing) !=
               end(std::filesystem::directory_iterator());
    }

    static inline std::unique_ptr<Xvfb> server_;
    const std::string scene_ = (folder() / "lamp.gl").string(), picture_ = (folder() / "picture.png").string();
    std::optional<RunningDemo> demo_;
};

TEST_F(DemoEditing, EscClosesWhatIsOnTopAndThenEnds) {
    open({scene_});
    xdo("key question key Escape");
    EXPECT_TRUE(answers()) << "the help";
    xdo("click 3 key Escape");
    EXPECT_TRUE(answers()) << "the menu";
    for (const std::string dialog : {"f", "o", "shift+s"}) {
        xdo("key ctrl+" + dialog + " key Escape");
        EXPECT_TRUE(answers()) << dialog;
    }
    xdo("key Escape");
    EXPECT_EQ(demo_->ended(), 0);
    EXPECT_EQ(read_file(scene_), kLamp);
}

TEST_F(DemoEditing, AsksBeforeItEndsWithUnsavedChanges) {
    open({scene_});
    xdo("key f key Escape key Escape");  // asks; stays
    EXPECT_TRUE(answers());
    xdo("key Escape key Return");  // asks; saves
    EXPECT_EQ(demo_->ended(), 0);
    EXPECT_EQ(read_file(scene_), flat(kLamp));
    EXPECT_FALSE(has_recovery_file());
}

TEST_F(DemoEditing, ForgetsTheChangesIfTheyAreUndone) {
    open({scene_});
    xdo("key f key ctrl+z key Escape");
    EXPECT_EQ(demo_->ended(), 0);
}

TEST_F(DemoEditing, OffersWhatAKilledWindowHadNotSaved) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGKILL}) {
        SCOPED_TRACE(signal);
        open({scene_});
        xdo("key f");
        ASSERT_TRUE(wait_for([&] { return has_recovery_file(); }));
        ::kill(demo_->pid(), signal);
        demo_->ended();
        EXPECT_EQ(read_file(scene_), kLamp);
        open({scene_}, Start::kAsks);
        xdo("key Return");  // brings the changes back
        EXPECT_TRUE(answers());
        xdo("key ctrl+s");
        EXPECT_TRUE(file_becomes(flat(kLamp)));
        xdo("key Escape");
        EXPECT_EQ(demo_->ended(), 0);
        EXPECT_FALSE(has_recovery_file());
        write_file_atomically(scene_, kLamp);
    }
}

TEST_F(DemoEditing, SavesIntoTheOpenedFileAndKeepsItsText) {
    open({scene_});
    xdo("key f key ctrl+s");
    EXPECT_TRUE(file_becomes(flat(kLamp)));
    xdo("key ctrl+z key ctrl+s");
    EXPECT_TRUE(file_becomes(kLamp));
    xdo("key ctrl+y key ctrl+s");
    EXPECT_TRUE(file_becomes(flat(kLamp)));
    // Elsewhere: the field has the file's name.
    const std::string other = (folder() / "lamp.gl2").string();
    xdo("key z key ctrl+shift+s");
    EXPECT_TRUE(wait_for([&] {
        xdo("key 2 key Return");
        return std::filesystem::exists(other);
    }));
    EXPECT_EQ(read_file(other), kLamp);
    EXPECT_EQ(read_file(scene_), flat(kLamp));
}

TEST_F(DemoEditing, MergesWhatAnotherProgramSaves) {
    open({scene_});
    xdo("key f");
    EXPECT_TRUE(answers());
    std::string theirs = kLamp;
    theirs.replace(theirs.find("24, 12"), 6, "48, 24");
    write_file_atomically(scene_, theirs);
    // Ctrl+S takes the file's change first, if the window has not seen it yet.
    xdo("key ctrl+s");
    EXPECT_TRUE(file_becomes(flat(theirs)));
}

TEST_F(DemoEditing, KeepsTheEditsOfASceneWhileAnotherIsShown) {
    open({scene_});
    xdo("key f key bracketright");
    EXPECT_TRUE(answers());
    xdo("key bracketleft");
    EXPECT_TRUE(answers());
    xdo("key ctrl+s");
    EXPECT_TRUE(file_becomes(flat(kLamp)));
    xdo("key z key ctrl+s");
    EXPECT_TRUE(file_becomes(kLamp)) << "the history is gone";
}

// The button Insert... of the tab Commands.
TEST_F(DemoEditing, LettersAreNoShortcutsWhileACallIsTyped) {
    open({scene_});
    xdo("mousemove 43 85 click 1");
    xdo("type --delay 20 'glEnable(GL_FOGF);'");
    xdo("key Return");  // wrong: the field keeps the keys
    xdo("key BackSpace key BackSpace key BackSpace");
    xdo("type --delay 20 ');'");
    xdo("key Return");
    xdo("mousemove 600 300 key ctrl+s");
    EXPECT_TRUE(file_becomes(kLamp + "glEnable(GL_FOG);\n")) << read_file(scene_);
}

// A click beside a field only leaves it: it does not explain the pixel, and letters within it are no shortcuts.
TEST_F(DemoEditing, TheClickThatLeavesAFieldDoesNothingElse) {
    open({scene_});
    xdo("mousemove 43 85 click 1 mousemove 600 440 mousedown 1 key f mouseup 1");
    xdo("key ctrl+s");
    EXPECT_TRUE(answers());
    EXPECT_EQ(read_file(scene_), kLamp);
    xdo("key f key ctrl+s");
    EXPECT_TRUE(file_becomes(flat(kLamp))) << "after the click, letters are shortcuts again";
}

// Ctrl+F selects a call, Ctrl+C copies it for other programs, Ctrl+V inserts what they copied.
TEST_F(DemoEditing, CopiesAndPastesCallsThroughTheClipboard) {
    if (run("command -v xclip").status != 0) GTEST_SKIP() << "xclip is missing (Debian's package xclip)";
    const std::string xclip = "DISPLAY=" + server_->display() + " xclip -selection clipboard ";
    open({scene_});
    xdo("key ctrl+f type --delay 20 light0");
    xdo("key ctrl+a key ctrl+c key End key ctrl+v key BackSpace key Escape");  // in the field
    EXPECT_TRUE(answers());
    EXPECT_EQ(run(xclip + "-out").output, "light0");
    xdo("key ctrl+f type --delay 20 light0");
    xdo("key Escape key ctrl+c");
    EXPECT_TRUE(answers());
    EXPECT_EQ(run(xclip + "-out").output, "glEnable(GL_LIGHT0);\n");
    run("printf 'glEnable(GL_FOG);' | " + xclip + ">/dev/null 2>&1");
    xdo("key ctrl+v key ctrl+s");
    std::string text = kLamp;
    text.insert(text.find("glLightfv"), "glEnable(GL_FOG);\n");
    EXPECT_TRUE(file_becomes(text)) << read_file(scene_);
}

TEST_F(DemoEditing, OpensAnotherScene) {
    open({scene_});
    xdo("key ctrl+o type --delay 20 lab");
    xdo("key Return");
    EXPECT_TRUE(answers());
    const auto title = [&] { return xdo("search --name twinlight getwindowname").output; };
    EXPECT_NE(title().find("lab - twinlight"), std::string::npos);
    xdo("key ctrl+o type --delay 20 second-light");  // a lesson
    xdo("key Return");
    EXPECT_TRUE(answers());
    EXPECT_NE(title().find("second-light - twinlight"), std::string::npos);
    // The first line of the list that has this word: the tutor of materials.
    xdo("key ctrl+o type --delay 20 'each kind of light'");
    xdo("mousemove 300 181 click 1");
    EXPECT_TRUE(answers());
    EXPECT_NE(title().find("tutor-material - twinlight"), std::string::npos);
}

TEST_F(DemoEditing, RecordsAProgramThatItCannotRead) {
    for (const char* tool : {"apitrace", "g++"})
        if (run(std::string("command -v ") + tool).status != 0) GTEST_SKIP() << tool << " is not installed";
    const std::string program = (folder() / "lamp.cpp").string();
    const auto writes = [&](const std::string& drawing) {
        write_file_atomically(program,
                              "#include <vector>\n#include <GL/glut.h>\nstd::vector<float> red = {1, 0, 0};\n"
                              "void display() {\n    " +
                                  drawing +
                                  "\n    glutSwapBuffers();\n}\n"
                                  "int main(int argc, char** argv) {\n    glutInit(&argc, argv);\n"
                                  "    glutInitDisplayMode(GLUT_DOUBLE);\n    glutCreateWindow(\"lamp\");\n"
                                  "    glutDisplayFunc(display);\n    glutMainLoop();\n}\n");
    };
    writes("nothing();");
    open({scene_});
    const auto title = [&] { return xdo("search --name twinlight getwindowname").output; };
    xdo("key ctrl+o type --delay 20 " + program);
    xdo("key Return");
    EXPECT_TRUE(demo_->comes_to_rest());  // and asks
    xdo("key Return");                    // it does not compile, and the dialog says so
    EXPECT_TRUE(demo_->comes_to_rest());
    EXPECT_NE(title().find("lamp.gl - twinlight"), std::string::npos) << title();
    writes("glColor3fv(red.data());\n    glRectf(-1, -1, 1, 1);");
    xdo("key Return");
    EXPECT_TRUE(wait_for([&] { return title().find("lamp.trace, frame 0 - twinlight") != std::string::npos; }))
        << title();
    EXPECT_TRUE(answers());
    const Image shown = picture();
    EXPECT_EQ(shown.at(shown.width - 100, shown.height / 2), (Rgba{1, 0, 0, 1}));
}

TEST_F(DemoEditing, MakesLettersLargerAndTheWindowFull) {
    open({scene_});
    ASSERT_TRUE(demo_->comes_to_rest());  // the linter's count is in its tab
    const auto panel = [&] {
        const Image image = picture();
        std::vector<Rgba> pixels;
        for (int y = 0; y < 500; ++y)
            for (int x = 0; x < 350; ++x) pixels.push_back(image.at(x, y));
        return pixels;
    };
    const Image first = picture();
    const auto letters = panel();
    xdo("key ctrl+plus key ctrl+plus");
    EXPECT_NE(panel(), letters);
    xdo("key ctrl+minus key ctrl+equal key ctrl+0");
    EXPECT_TRUE(wait_for([&] { return panel() == letters; }));
    xdo("key F11");
    Image full;
    EXPECT_TRUE(wait_for([&] { return (full = picture()).width > first.width; }));
    xdo("key F11");
    EXPECT_TRUE(wait_for([&] { return picture().width == first.width; }));
}

// The screen has 1280 x 1024 pixels, of which frames and bars take some.
TEST_F(DemoEditing, FitsTheScreenAndRemembersItsSizeAndPanel) {
    std::filesystem::remove_all(folder() / "config");
    const auto start = [&](const std::vector<std::string>& more) {
        std::vector<std::string> options{scene_, "--scale", "1", "--view", "single", "--screenshot", picture_};
        options.insert(options.end(), more.begin(), more.end());
        demo_.emplace(server_->display(), options);
        ASSERT_TRUE(wait_for([&] { return xdo("search --onlyvisible --name twinlight").status == 0; }));
        xdo("mousemove 700 300");
    };
    const auto panel = [&](const Image& image) {
        std::vector<Rgba> pixels;
        for (int y = 0; y < 500; ++y)
            for (int x = 0; x < 350; ++x) pixels.push_back(image.at(x, y));
        return pixels;
    };
    const auto end = [&] {
        xdo("key Escape");
        EXPECT_EQ(demo_->ended(), 0);
    };
    start({});
    const Image first = picture();
    EXPECT_EQ(first.width, 1264);
    EXPECT_EQ(first.height, 800);
    end();
    start({"--panel", "save"});
    xdo("search --onlyvisible --name twinlight windowsize --sync 900 700");
    Image resized;
    EXPECT_TRUE(wait_for([&] { return (resized = picture()).width == 900; }));
    end();
    start({});
    const Image again = picture();
    EXPECT_EQ(again.width, 900);
    EXPECT_EQ(again.height, 700);
    EXPECT_EQ(panel(again), panel(resized));
    EXPECT_NE(panel(again), panel(first));
    end();
}

// The button Insert... again: the pointer has left it before the next frame.
TEST_F(DemoEditing, AClickCountsIfThePointerMovesOnAtOnce) {
    open({scene_});
    for (int times = 0; times < 3; ++times) {
        xdo("mousemove 43 85 click 1 mousemove 600 300");
        xdo("type --delay 20 'glEnable(GL_FOG);'");
        xdo("key Return mousemove 620 310");
    }
    xdo("key ctrl+s");
    EXPECT_TRUE(file_becomes(kLamp + "glEnable(GL_FOG);\nglEnable(GL_FOG);\nglEnable(GL_FOG);\n")) << read_file(scene_);
}

// The call that a key changes is far below those that the list shows; changed calls are orange.
TEST_F(DemoEditing, TheListGoesToTheCallThatAKeyChanges) {
    std::string text;
    for (int i = 0; i < 80; ++i) text += "glTranslatef(0, 0, 0);\n";
    text += kLamp;
    write_file_atomically(scene_, text);
    open({scene_});
    ASSERT_TRUE(demo_->comes_to_rest());
    const auto shows_orange = [&] {
        const Image image = picture();
        for (int y = 135; y < 490; ++y)
            for (int x = 0; x < 330; ++x)
                if (image.at(x, y)[0] > 0.85F && image.at(x, y)[2] < 0.4F) return true;
        return false;
    };
    EXPECT_FALSE(shows_orange());
    xdo("key 1");
    EXPECT_TRUE(wait_for(shows_orange));
}

// The list's letters end before the scrollbar.
TEST_F(DemoEditing, NoCodeIsUnderTheScrollbar) {
    open({"report"});
    ASSERT_TRUE(demo_->comes_to_rest());
    const Image image = picture();
    for (int y = 135; y < 490; ++y)
        for (int x = 331; x < 336; ++x) ASSERT_LT(image.at(x, y)[0], 0.2F) << x << ", " << y;
}

// A drag of the panel's edge.
TEST_F(DemoEditing, ThePanelCanBeMadeWider) {
    open({scene_});
    const auto width = [&] {
        const Image image = picture();
        int x = 0;
        while (x < image.width && image.at(x, 560) == image.at(0, 560)) ++x;
        return x;
    };
    EXPECT_EQ(width(), 360);
    xdo("mousemove 363 300 mousedown 1 mousemove 400 300 mousemove 464 300 mouseup 1 mousemove 700 300");
    EXPECT_TRUE(wait_for([&] { return width() > 440; }));
}

// The menu of a click with the right button: its first line is under the pointer, and resets the scene.
TEST_F(DemoEditing, TheMenuOpensAtThePointer) {
    open({scene_});
    xdo("key f mousemove 500 200 click 3");
    xdo("mousemove_relative 30 18");
    xdo("click 1");
    EXPECT_TRUE(answers());
    xdo("key Escape");
    EXPECT_EQ(demo_->ended(), 0) << "the scene is not as it was opened";
}

}  // namespace
}  // namespace twinlight::demo_editing_test

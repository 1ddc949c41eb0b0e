// twinlight-demo as a user meets it: the real program on libGL under Xvfb, keys and mouse from xdotool, its
// pictures against OSMesa's of the same commands. The demo is a process of its own, so the two GL libraries never meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "app/demo/controls.h"
#include "app/demo/view.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "render/context/context.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"
#include "xvfb.h"

namespace twinlight::demo {
namespace {

// Two lights, one of them the camera's, a flat and a smooth object, specular: what the keys change is to be
// seen.
// GL knows no variants, and the window holds the two renderers against each other: it leaves the pragma out.
constexpr const char* kScene = R"(
#pragma twinlight specular(reflection)
glMatrixMode(GL_PROJECTION);
gluPerspective(45, 4.0 / 3.0, 0.1, 100);
glMatrixMode(GL_MODELVIEW);
GLfloat headlight[] = {0, 0, 0, 1};
GLfloat dim[] = {0.4, 0.3, 0.2, 1};
glLightfv(GL_LIGHT1, GL_POSITION, headlight);
glLightfv(GL_LIGHT1, GL_DIFFUSE, dim);
gluLookAt(0, 1, 5, 0, 0, 0, 0, 1, 0);
GLfloat key[] = {2, 3, 4, 1};
glLightfv(GL_LIGHT0, GL_POSITION, key);
glEnable(GL_LIGHTING);
glEnable(GL_LIGHT0);
glEnable(GL_LIGHT1);
glEnable(GL_DEPTH_TEST);
glEnable(GL_NORMALIZE);
GLfloat orange[] = {1, 0.5, 0.31, 1};
GLfloat grey[] = {0.5, 0.5, 0.5, 1};
glMaterialfv(GL_FRONT, GL_DIFFUSE, orange);
glMaterialfv(GL_FRONT, GL_SPECULAR, grey);
glMaterialf(GL_FRONT, GL_SHININESS, 32);
glTranslatef(-0.9, 0, 0);
glutSolidSphere(0.8, 24, 12);
glTranslatef(1.8, 0, 0);
glRotatef(30, 1, 1, 0);
glutSolidCube(1);
)";

constexpr programmable::Options kOptions{{{.shading = {}, .lecture_variants = false}}};

std::string program() { return build_folder() + "/twinlight-demo"; }

const std::filesystem::path& folder() {
    static const std::filesystem::path kFolder = [] {
        std::string name = (std::filesystem::temp_directory_path() / "twinlight-demo-test-XXXXXX").string();
        return std::filesystem::path(::mkdtemp(name.data()));
    }();
    return kFolder;
}

// Pictures of failures stay here.
std::filesystem::path kept_folder() {
    std::filesystem::path kept = build_folder() + "/failed";
    std::filesystem::create_directories(kept);
    return kept;
}

// For a sanitized program: what the driver and GLX leak is not ours.
constexpr const char* kSanitizer = "detect_leaks=0";

struct Ran {
    int status = -1;
    std::string output;  // stdout and stderr
};

Ran run(const std::string& command) {
    Ran ran;
    FILE* pipe =
        ::popen(("{ export ASAN_OPTIONS=" + std::string(kSanitizer) + "; " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) return ran;
    char piece[4096];
    while (const std::size_t n = std::fread(piece, 1, sizeof piece, pipe)) ran.output.append(piece, n);
    const int waited = ::pclose(pipe);
    ran.status = WIFEXITED(waited) ? WEXITSTATUS(waited) : -1;
    return ran;
}

bool wait_for(const std::function<bool()>& condition) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::seconds(20);  // only a broken program waits that long
    while (Clock::now() < deadline) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

// The demo, running with a window.
class RunningDemo {
  public:
    RunningDemo(const std::string& display, const std::vector<std::string>& options) {
        pid_ = ::fork();
        if (pid_ != 0) return;
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        ::setenv("DISPLAY", display.c_str(), 1);
        ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // Xvfb has no GPU; the host may
        ::setenv("ASAN_OPTIONS", kSanitizer, 1);
        const std::string path = program();
        std::vector<char*> arguments{const_cast<char*>(path.c_str())};
        for (const std::string& option : options) arguments.push_back(const_cast<char*>(option.c_str()));
        arguments.push_back(nullptr);
        const int log = ::open((folder() / "demo.log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(log, STDOUT_FILENO);
        ::dup2(log, STDERR_FILENO);
        ::execv(path.c_str(), arguments.data());
        ::_exit(127);
    }
    ~RunningDemo() {
        if (pid_ <= 0) return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    RunningDemo(const RunningDemo&) = delete;
    RunningDemo& operator=(const RunningDemo&) = delete;

    // The exit status once it has ended by itself; -1 if it does not.
    int ended() {
        int waited = 0;
        if (!wait_for([&] { return ::waitpid(pid_, &waited, WNOHANG) == pid_; })) return -1;
        pid_ = -1;
        return WIFEXITED(waited) ? WEXITSTATUS(waited) : -1;
    }

  private:
    pid_t pid_ = -1;
};

class DemoWindow : public testing::Test {
  protected:
    static void SetUpTestSuite() { server_ = std::make_unique<Xvfb>(); }
    static void TearDownTestSuite() {
        server_.reset();
        std::filesystem::remove_all(folder());
    }

    void SetUp() override {
        if (!server_->running()) GTEST_SKIP() << server_->reason();
        ASSERT_TRUE(std::filesystem::exists(program())) << program() << " is not built: make programs";
        write_file_atomically(scene_file_, kScene);
        scene_ = read_scene(kScene, scene_file_, "scene.gl");
        std::filesystem::remove(picture_file_);
    }

    std::string on_display(const std::string& command) {
        return "LIBGL_ALWAYS_SOFTWARE=1 DISPLAY=" + server_->display() + " " + command;
    }
    Ran xdotool(const std::string& commands) { return run(on_display("xdotool " + commands)); }

    // The picture that the demo wrote, once it is there; files are written whole.
    Image picture() {
        if (!wait_for([&] { return std::filesystem::exists(picture_file_); })) {
            ADD_FAILURE() << "no picture; the demo said: " << read_file((folder() / "demo.log").string());
            return {};
        }
        Image image = read_png(picture_file_);
        std::filesystem::remove(picture_file_);
        return image;
    }

    Scene expected_scene(const Controls& controls, int width = 640, int height = 480) {
        StateOptions options;
        options.width = width;
        options.height = height;
        return make_scene(std::make_shared<const CommandList>(apply_view(scene_, controls.view)), options);
    }

    // The same commands on OSMesa. Both libraries hold the same Mesa, so interiors are equal bit for bit. A border that
    // passes within rounding of pixel centres may go to another side: measured 0 edge pixels on these scenes, but 3 of
    // 33,000 on one whose objects stood on whole pixels (not for the depth buffer's bits; the cause is not known).
    void expect_as_on_osmesa(const Image& actual, const Controls& controls, int width = 640, int height = 480) {
        ASSERT_EQ(actual.width, width);
        ASSERT_EQ(actual.height, height);
        const Scene scene = expected_scene(controls, width, height);
        const auto context = make_offscreen_context(width, height);
        const Image expected = controls.renderer == Path::kFixed
                                   ? fixed::render(scene)
                                   : programmable::Renderer().render(scene.frame, kOptions).image;
        expect_near(actual, expected, reference::allowed_difference(scene.frame).edge, 0);
    }

    // `interior`: by how much a channel may differ there.
    void expect_near(const Image& actual, Image expected, const PixelMask& edges, double interior) {
        constexpr double kBorderline = 0.001;              // share of edge pixels
        for (Rgba& pixel : expected.pixels) pixel[3] = 1;  // a PNG has no alpha
        const ImageDifference found = difference(actual, expected, edges);
        if (found.interior.max <= interior && found.edge.differing_share() <= kBorderline) return;
        const std::string kept = kept_folder().string();
        const int factor = amplification_for(std::max(found.interior.max, found.edge.max));
        write_png(kept + "/demo-actual.png", actual);
        write_png(kept + "/demo-expected.png", expected);
        write_png(kept + "/demo-difference.png", difference_picture(actual, expected, factor));
        ADD_FAILURE() << found.interior.differing << " interior pixels differ, by " << found.interior.max
                      << " at most, at " << found.interior.worst_x << "," << found.interior.worst_y << "; "
                      << found.edge.differing << " of " << found.edge.pixels << " edge pixels: see demo-*.png in "
                      << kept;
    }

    static std::unique_ptr<Xvfb> server_;
    const std::string scene_file_ = (folder() / "scene.gl").string();
    const std::string picture_file_ = (folder() / "picture.png").string();
    CommandList scene_;
};

std::unique_ptr<Xvfb> DemoWindow::server_;

TEST_F(DemoWindow, WritesTheScreenshotOfAScript) {
    struct Script {
        std::string options, keys;
        Path renderer = Path::kFixed;
        int width = 640, height = 480;
    };
    for (const Script& script : {Script{"", ""}, Script{"--with programmable", "", Path::kProgrammable},
                                 Script{"--size 320x200", "f1++", Path::kFixed, 320, 200}, Script{"", "\tm2-"}}) {
        SCOPED_TRACE(script.options + " --keys " + script.keys);
        const Ran ran = run(on_display(program() + " " + scene_file_ + " " + script.options + " --keys '" +
                                       script.keys + "' --quit-after 2 --screenshot " + picture_file_));
        ASSERT_EQ(ran.status, 0) << ran.output;
        Controls controls = make_controls(expected_scene({}).frame);
        controls.renderer = script.renderer;
        for (const char key : script.keys) press(controls, key);
        expect_as_on_osmesa(picture(), controls, script.width, script.height);
    }
}

TEST_F(DemoWindow, DrawsTheBuiltInScenesWithBothRenderers) {
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind(".gl")));
        scene_ = *load_commands(name);
        for (const Path renderer : {Path::kFixed, Path::kProgrammable}) {
            std::string options = name;
            options += renderer == Path::kFixed ? " --with fixed" : " --with programmable";
            SCOPED_TRACE(options);
            const Ran ran =
                run(on_display(program() + " " + options + " --quit-after 1 --screenshot " + picture_file_));
            ASSERT_EQ(ran.status, 0) << ran.output;
            Controls controls = make_controls(expected_scene({}).frame);
            controls.renderer = renderer;
            expect_as_on_osmesa(picture(), controls);
        }
    }
}

TEST_F(DemoWindow, AnswersKeysAndMouse) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    RunningDemo demo(server_->display(), {scene_file_, "--screenshot", picture_file_});
    // The pointer stands in the window, which therefore has the keys: no window manager runs here.
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    xdotool("mousemove 300 200");
    Controls controls = make_controls(expected_scene({}).frame);

    const auto check = [&](const std::string& what, const std::string& commands) {
        SCOPED_TRACE(what);
        xdotool(commands + " key s");
        expect_as_on_osmesa(picture(), controls);
    };
    const auto title = [&] { return xdotool("search --name twinlight getwindowname").output; };

    check("as it starts", "");
    EXPECT_EQ(title(), "scene.gl - fixed - GL_SMOOTH - GL_LIGHT0,1 - twinlight\n");

    press(controls, '\t');
    check("Tab", "key Tab");
    EXPECT_EQ(title(), "scene.gl - programmable - GL_SMOOTH - GL_LIGHT0,1 - twinlight\n");

    press(controls, 'f');
    press(controls, '1');
    check("flat, GL_LIGHT0 off", "key f key 1");
    EXPECT_EQ(title(), "scene.gl - programmable - GL_FLAT - GL_LIGHT1 - twinlight\n");

    press(controls, '\t');
    press(controls, '1');
    press(controls, '2');
    press(controls, 'f');
    check("fixed again, smooth, GL_LIGHT1 off", "key Tab key 1 key 2 key f");

    drag(controls, 60, 40);
    check("drag", "mousedown 1 mousemove_relative 40 30 mousemove_relative 20 10 mouseup 1");

    zoom(controls, 2);
    check("wheel up, twice", "click 4 click 4");

    press(controls, 'm');
    press(controls, '?');  // and the overlay of the keys does not stand in the picture
    check("wireframe", "key m key F1");
    EXPECT_NE(read_file((folder() / "demo.log").string()).find("GL_FLAT and GL_SMOOTH"), std::string::npos);

    press(controls, 'r');
    check("reset", "key r");

    xdotool("key Escape");
    EXPECT_EQ(demo.ended(), 0);
}

TEST_F(DemoWindow, ShowsTheDifferenceOfTheTwo) {
    ASSERT_EQ(run(on_display(program() + " " + scene_file_ + " --keys d --quit-after 1 --screenshot " + picture_file_))
                  .status,
              0);
    const Image actual = picture();
    const Scene scene = expected_scene({});
    const auto context = make_offscreen_context(640, 480);
    const Image a = fixed::render(scene);
    const Image b = programmable::Renderer().render(scene.frame, kOptions).image;
    const PixelMask no_edges(a.pixels.size());
    const int factor = amplification_for(difference(a, b, no_edges).interior.max);
    // Where one code differs between the two libraries, the amplified difference does by `factor` codes.
    expect_near(actual, difference_picture(a, b, factor), reference::allowed_difference(scene.frame).edge,
                factor / 255.0);
}

TEST_F(DemoWindow, KeepsTheProportionsOfThePictureInAnyWindow) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    RunningDemo demo(server_->display(), {scene_file_, "--screenshot", picture_file_, "--size", "320x240"});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight windowsize --sync 700 300").status, 0);
    xdotool("mousemove 300 200");
    // The window's size reaches the demo as an event of its own: the first picture may still be of the old one.
    Image image;
    ASSERT_TRUE(wait_for([&] {
        xdotool("key s");
        image = picture();
        return image.width != 320;
    }));
    expect_as_on_osmesa(image, make_controls(expected_scene({}).frame), 400, 300);
    xdotool("key q");
    EXPECT_EQ(demo.ended(), 0);
}

// ---- Bad input: one line that says what to do, and exit status 2 ----

void expect_refusal(const Ran& ran, const std::string& says) {
    EXPECT_EQ(ran.status, 2) << ran.output;
    EXPECT_EQ(std::count(ran.output.begin(), ran.output.end(), '\n'), 1) << ran.output;
    EXPECT_NE(ran.output.find(says), std::string::npos) << ran.output;
}

TEST_F(DemoWindow, RefusesBadInputInOneLine) {
    expect_refusal(run("env -u DISPLAY " + program() + " " + scene_file_), "DISPLAY is not set");
    expect_refusal(run("DISPLAY=:nowhere " + program() + " " + scene_file_), "DISPLAY is :nowhere");
    const std::string bad_file = (folder() / "bad.gl").string();
    write_file_atomically(bad_file, "glEnable(GL_LIGHT0);\nglBegine(GL_POINTS);\n");
    const Ran misspelt = run(on_display(program() + " " + bad_file));
    EXPECT_EQ(misspelt.status, 2);
    EXPECT_TRUE(
        misspelt.output.ends_with("bad.gl:2:1: error: unknown command 'glBegine'; did you mean glBegin?\n"
                                  "glBegine(GL_POINTS);\n^\n"))
        << misspelt.output;
    write_file_atomically(bad_file, "glBegin(GL_POINTS);\nglVertex2i(0, 0);\n");
    expect_refusal(run(on_display(program() + " " + bad_file)), "bad.gl:");
    expect_refusal(run(on_display(program() + " " + (folder() / "none.gl").string())), "none.gl");
    expect_refusal(run(on_display(program() + " bicycle")), "bicycle: ");
    const std::string nowhere = (folder() / "none" / "picture.png").string();
    expect_refusal(run(on_display(program() + " " + scene_file_ + " --quit-after 1 --screenshot " + nowhere)), nowhere);
    expect_refusal(run(program() + " --size 0x5"), "--size");
    expect_refusal(run(program() + " --with reference"), "--with");
    expect_refusal(run(program() + " --quit-after 0"), "--quit-after: '0' is not a whole number from 1 to 1000000");
    expect_refusal(run(program() + " --screenshoot a.png"), "did you mean '--screenshot'?");
    expect_refusal(run(program() + " \"$(printf 'a\\033[31mb\\nc.gl')\""), "a\\x1b[31mb\\x0ac.gl: ");
}

TEST_F(DemoWindow, TellsItsOptionsAndKeysWithoutADisplay) {
    const Ran ran = run("env -u DISPLAY " + program() + " --help");
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.output.find("--screenshot"), std::string::npos);
    EXPECT_NE(ran.output.find(keys_help().substr(0, keys_help().find('\n'))), std::string::npos);
    EXPECT_EQ(run("env -u DISPLAY " + program() + " --version").status, 0);
}

}  // namespace
}  // namespace twinlight::demo

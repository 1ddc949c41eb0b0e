// twinlight-demo as a user meets it: the real program on libGL under Xvfb, with keys and mouse from xdotool. Its screenshots
// are cut into the panes' pictures, which must be those of OSMesa for the commands that a Session has after the same keys.
// The program is a process of its own, so the two GL libraries never meet.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../unit/effort.h"
#include "../unit/in_chinese.h"
#include "../unit/pictures.h"
#include "../unit/run_program.h"
#include "app/session/camera.h"
#include "app/session/keys.h"
#include "app/session/layout.h"
#include "app/session/session.h"
#include "app/session/sides.h"
#include "base/image/difference.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"
#include "demo_window.h"
#include "render/context/context.h"
#include "render/fixed/fixed.h"
#include "render/programmable/programmable.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/scenes/caption.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"
#include "window_release.h"
#include "xvfb.h"

namespace twinlight::session::demo_test {
namespace {

using demo_window::folder, demo_window::program, demo_window::Ran, demo_window::run, demo_window::RunningDemo,
    demo_window::wait_for;

// The panels, views and dialogs.
constexpr const char* kViewsWithTexts[] = {"lab --panel commands",
                                           "lab --view grid --panel lights",
                                           "report --view grid --probe 300,200",
                                           "lab --view world --panel shaders",
                                           "report --view single --panel overlays",
                                           "report --panel accuracy",
                                           "lab --panel save",
                                           "--lesson second-light",
                                           "tests/window/mistakes.gl --panel lint",
                                           "--tutor spot",
                                           "materials --keys '?'",
                                           "report --keys '<Ctrl+O>'"};

// Two lights, one of them the camera's, a flat and a smooth object with highlights, so that every key changes something.
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

// The window of most tests: 800 x 600 is the smallest that the layout is made for.
constexpr int kWidth = 800, kHeight = 600;

// Pictures of failures stay here.
std::filesystem::path kept_folder() {
    std::filesystem::path kept = build_folder() + "/failed";
    std::filesystem::create_directories(kept);
    return kept;
}

class DemoWindow : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        std::filesystem::create_directories(folder());
        server_ = std::make_unique<Xvfb>();
        if (server_->running()) is_other_release_ = has_another_release(server_->display());
    }
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
        for (const char* kept : {"state", "config"}) std::filesystem::remove_all(folder() / kept);  // of a test before
    }

    std::string on_display(const std::string& command) {
        return "LC_ALL=C LIBGL_ALWAYS_SOFTWARE=1 DISPLAY=" + server_->display() + " " + command;
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

    // The program with these options, to its last frame. Letters have the size for 96 dots per inch.
    Ran run_demo(const std::string& options) {
        return run(on_display(program() + " --scale 1 --size " + std::to_string(kWidth) + "x" +
                              std::to_string(kHeight) + " " + options + " --quit-after 2 --screenshot " +
                              picture_file_));
    }

    // What --times says about the last frame. The linter needs some frames.
    nlohmann::json last_frame(const std::string& options) {
        const std::string times = (folder() / "times.json").string();
        const Ran ran = run(on_display(program() + " " + options + " --times " + times + " --quit-after " +
                                       (options.find("lint") == options.npos ? "4" : "100")));
        EXPECT_EQ(ran.status, 0) << ran.output;
        return nlohmann::json::parse(read_file(times));
    }

    // A session with the window's scene after these keys, as the window has it.
    Session session_after(const std::string& keys, View view = View::kSingle) const {
        Session session(std::make_shared<const CommandList>(scene_));
        session.view = view;
        const WindowSize size = natural_size(scene_);
        refresh(session, size.width, size.height);
        for (const char key : keys) {
            press(session, key);
            refresh(session, size.width, size.height);
        }
        return session;
    }

    // Each pane's picture in a screenshot against OSMesa's of the session's commands. Where both libraries hold the same Mesa,
    // the inside of surfaces is equal bit for bit. A border that passes within rounding of pixel centres may go to
    // another side. The reference is the same program twice: equal.
    void expect_panes(const Image& screenshot, Session session, int width = kWidth, int height = kHeight) {
        ASSERT_EQ(screenshot.width, width);
        ASSERT_EQ(screenshot.height, height);
        const Layout places = layout(session, width, height, 1);
        refresh(session, places.picture.width, places.picture.height);
        // The context is as large as the picture, because the driver interpolates from the top down.
        const auto context = make_offscreen_context(places.picture.width, places.picture.height);
        const PixelMask edges = reference::allowed_difference(session.scene.frame, {}).edge;
        for (const Cell& cell : places.cells) {
            if (cell.pane >= kPanes) continue;
            const Pane& pane = session.panes[cell.pane];
            SCOPED_TRACE(title_of(session, pane));
            // The window bakes numbers into shaders, which lets the driver fold them: lighting per pixel may then round to
            // another of the 255 steps.
            const bool may_round = pane.renderer == Path::kProgrammable;
            expect_near(part_of(screenshot, cell.picture), picture_of(session, pane), edges, may_round ? 1 / 255.0 : 0);
        }
    }

    static Image picture_of(const Session& session, const Pane& pane) {
        const Look look = look_of(session, pane);
        switch (pane.renderer) {
            case Path::kFixed: return fixed::render(session.scene, {look.shading});
            case Path::kProgrammable: return programmable::Renderer().render(session.scene.frame, {{look}});
            case Path::kReference: break;
        }
        reference::Options options;
        static_cast<Look&>(options) = look;
        return reference::render(session.scene.frame, options);
    }

    static Image part_of(const Image& image, const Rectangle& box) {
        Image part(box.width, box.height);
        for (int y = 0; y < box.height; ++y)
            for (int x = 0; x < box.width; ++x) part.at(x, y) = image.at(box.x + x, box.y + y);
        return part;
    }

    // `interior`: by how much a channel may differ there.
    void expect_near(const Image& actual, Image expected, const PixelMask& edges, double interior) {
        const double borderline = is_other_release_ ? kBorderlineOfAnotherRelease : 0.001;  // share of pixels
        if (is_other_release_) interior = kOfAnotherRelease;
        for (Rgba& pixel : expected.pixels) pixel[3] = 1;  // a PNG has no alpha
        const ImageDifference found = difference(actual, expected, edges);
        if (found.interior.max <= interior && found.interior.differing_share() <= borderline &&
            found.edge.differing_share() <= borderline)
            return;
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
    static inline bool is_other_release_ = false;  // in windows than in OSMesa
    const std::string scene_file_ = (folder() / "scene.gl").string();
    const std::string picture_file_ = (folder() / "picture.png").string();
    CommandList scene_;
};

std::unique_ptr<Xvfb> DemoWindow::server_;

TEST_F(DemoWindow, DrawsEveryPaneAsItsRendererDoes) {
    for (const std::string keys : {"", "f", "1", "2", "l", "v", "x", "t", "g", "gg", "\t", "\tg", "-", "w", "fz"}) {
        SCOPED_TRACE("--keys " + keys);
        const Ran ran = run_demo(scene_file_ + " --view grid --keys '" + keys + "'");
        ASSERT_EQ(ran.status, 0) << ran.output;
        expect_panes(picture(), session_after(keys, View::kGrid));
    }
}

// What a student sees first: the fixed function at the left of the line, shaders that light every pixel at its right.
TEST_F(DemoWindow, TheSliderShowsTwoPicturesAndASwitchForWhatDiffers) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    Session session = session_after("", View::kSlider);
    const Layout places = layout(session, kWidth, kHeight, 1);
    refresh(session, places.picture.width, places.picture.height);
    const auto context = make_offscreen_context(places.picture.width, places.picture.height);
    const PixelMask edges = reference::allowed_difference(session.scene.frame, {}).edge;
    // Without the line and its handle.
    const Rectangle picture_box = places.cells.front().picture;
    const int width = picture_box.width / 2 - 20;
    const auto expect_half = [&](const Image& screenshot, std::size_t pane, int from, double interior) {
        PixelMask mask;
        for (int y = 0; y < picture_box.height; ++y)
            for (int x = 0; x < width; ++x)
                mask.push_back(edges[static_cast<std::size_t>(y * picture_box.width + from + x)]);
        const Rectangle half{from, 0, width, picture_box.height};
        expect_near(part_of(part_of(screenshot, picture_box), half),
                    part_of(picture_of(session, session.panes[pane]), half), mask, interior);
    };
    const auto expect_halves = [&](const Image& screenshot) {
        expect_half(screenshot, 0, 0, 0);
        expect_half(screenshot, 1, picture_box.width - width, 1 / 255.0);
    };
    const RunningDemo demo(server_->display(),
                           {scene_file_, "--scale", "1", "--size", "800x600", "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    xdotool("mousemove 600 300 key p");
    expect_halves(picture());
    Image right = picture_of(session, session.panes[1]);
    EXPECT_GT(difference(picture_of(session, session.panes[0]), right, edges).interior.max, 0.1) << "equal halves";
    // The second switch adds the lecture's variants, the first takes lighting per pixel away.
    for (const int row : {1, 0}) {
        SCOPED_TRACE(row);
        const int y = places.sides.y + (2 * row + 1) * places.sides.height / 4;
        xdotool(fmt::format("mousemove {} {} click 1 mousemove 600 300 key p", places.sides.x + 18, y));
        switch_side(session, side_rows(session)[static_cast<std::size_t>(row)]);
        expect_halves(picture());
        const Image switched = picture_of(session, session.panes[1]);
        EXPECT_GT(difference(right, switched, edges).interior.max, 0.05) << "the switch changes nothing";
        right = switched;
    }
}

// In the lab, the pictures differ by 5/255, which OpenGL leaves open. Until the reference has shown that, the difference's footer
// has no verdict, and above all no alarm.
TEST_F(DemoWindow, TheDifferenceHasTheVerdictOfCompare) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    scene_ = *load_commands("lab");
    const Rectangle footer = layout(session_after("", View::kGrid), kWidth, kHeight, 1).cells[kDifferencePane].footer;
    const RunningDemo demo(server_->display(), {"lab", "--view", "grid", "--scale", "1", "--size", "800x600",
                                                "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    // Whether its letters are greener, or redder, than they are grey.
    const auto letters = [&](std::size_t channel, std::size_t other) {
        xdotool("mousemove 600 300 key p");
        const Image bar = part_of(picture(), footer);
        return std::ranges::any_of(bar.pixels, [&](const Rgba& p) { return p[channel] - p[other] > 0.15F; });
    };
    EXPECT_TRUE(wait_for([&] {
        EXPECT_FALSE(letters(0, 2)) << "an alarm";
        return letters(1, 0);
    })) << "no verdict";
    xdotool("key w");
    EXPECT_TRUE(wait_for([&] {
        EXPECT_FALSE(letters(0, 2)) << "an alarm after a change";
        return letters(1, 0);
    })) << "no verdict after a change";
}

// Those with golden pictures: starting the window for every scene takes long.
TEST_F(DemoWindow, DrawsBuiltInScenes) {
    for (const EmbeddedFile& file : kSceneFiles) {
        const std::string name(file.name.substr(0, file.name.rfind(".gl")));
        if (!std::filesystem::exists("golden/scenes/" + name)) continue;
        SCOPED_TRACE(name);
        // Without its labels, which the window shows over the pictures.
        std::string text(file.text);
        for (std::size_t at = 0; (at = text.find("#pragma twinlight label", at)) != text.npos;)
            text.erase(at, text.find('\n', at) - at);
        write_file_atomically(scene_file_, text);
        scene_ = *load_commands(scene_file_);
        const Ran ran = run_demo(scene_file_ + " --view grid");
        ASSERT_EQ(ran.status, 0) << ran.output;
        expect_panes(picture(), session_after("", View::kGrid));
    }
}

// In no panel or view, with small letters and large ones, in English and in Chinese. What a list cuts above and below does not count.
TEST_F(DemoWindow, NeitherCutsNorCoversATextAtFiveSizes) {
    for (const std::string size : {"800x600", "1024x768 --scale 1.5", "1366x768 --scale 2", "1280x800", "1920x1080"})
        for (const std::string view : kViewsWithTexts)
            for (const std::string language : {"en", "zh"}) {
                // In Chinese, the two sizes with the least room; all of them with ALL_CASES.
                if (language == "zh" && size != "800x600" && !size.ends_with("2") && !tries_all()) continue;
                SCOPED_TRACE(view + " --language " + language + " --size " + size);
                const auto last = last_frame(view + " --language " + language + " --size " + size);
                EXPECT_TRUE(last.at("cut_letters").empty()) << "letters are cut at " << last.at("cut_letters").dump();
                EXPECT_TRUE(last.at("overlapping_letters").empty())
                    << "letters overlap at " << last.at("overlapping_letters").dump();
            }
}

TEST_F(DemoWindow, HasNoEnglishSentenceInChinese) {
    EXPECT_NE(english_words_in("GL_LIGHT0: it is on"), "");
    EXPECT_EQ(english_words_in("GL_LIGHT0 打开了"), "");
    // This scene is not built in, so its comment stays English.
    const std::string kOwnComment = caption_of(read_file("tests/window/mistakes.gl")).title;
    std::vector<std::string> views(std::begin(kViewsWithTexts), std::end(kViewsWithTexts));
    for (const char* view : {"report --keys '<Ctrl+S>'", "report --keys '<Ctrl+F>'", "report --keys '1<Esc>'",
                             "report --panel lesson", "spotlight --view single --panel lights", "terms --panel probe",
                             "normals --keys 'n1m'", "interpolation --keys '.'", "report --view grid --keys 'fz'"})
        views.emplace_back(view);
    for (const std::string& view : views) {
        SCOPED_TRACE(view);
        const auto texts = last_frame(view + " --language zh --size 1280x800").at("texts");
        EXPECT_GT(texts.size(), 10U);
        for (const std::string text : texts) EXPECT_TRUE(text == kOwnComment || english_words_in(text).empty()) << text;
    }
}

TEST_F(DemoWindow, ShowsTheNextStepFromTheSameCamera) {
    const std::string text = std::string(kScene) +
                             "#pragma twinlight step(\"Both\")\nglutSolidCube(1);\n"
                             "#pragma twinlight step(\"Only one light\")\nglDisable(GL_LIGHT1);\nglutSolidCube(1.2);\n";
    const auto read = [&](const char* step) {
        return read_scene(text, scene_file_, "scene.gl", no_images, {.step = step});
    };
    write_file_atomically(scene_file_, text);
    scene_ = read("1");
    const CommandList moved = commands(session_after("w"));
    scene_ = session::with_camera_of(read("2"), read("1"), moved);
    for (const std::string options : {" --keys 'w.'", " --keys 'w,'", " --keys ',,w.'"}) {
        SCOPED_TRACE(options);
        const Ran ran = run_demo(scene_file_ + " --view grid" + options);
        ASSERT_EQ(ran.status, 0) << ran.output;
        expect_panes(picture(), session_after("", View::kGrid));
    }
    scene_ = read("2");
    ASSERT_EQ(run_demo(scene_file_ + " --view grid --step 'Only one light'").status, 0);
    expect_panes(picture(), session_after("", View::kGrid));
}

TEST_F(DemoWindow, EachOfTheLabsLightsIsVisible) {
    scene_ = *load_commands("lab");
    const Session all = session_after("\t\t");  // the fixed function
    for (char key = '1'; key <= '8'; ++key) {
        SCOPED_TRACE(key);
        const Session one_less = session_after(std::string("\t\t") + key);
        {
            const auto context = make_offscreen_context(640, 480);
            const Image with = fixed::render(all.scene), without = fixed::render(one_less.scene);
            EXPECT_GT(difference(with, without, PixelMask(with.pixels.size())).interior.max, 8 / 255.0);
        }
        const Ran ran = run_demo(std::string("lab --view single --keys '\t\t") + key + "'");
        ASSERT_EQ(ran.status, 0) << ran.output;
        expect_panes(picture(), one_less);
    }
}

TEST_F(DemoWindow, FlatIsFlatInEveryPane) {
    scene_ = *load_commands("report");
    Session session = session_after("f", View::kGrid);
    for (const Pane& pane : session.panes) EXPECT_TRUE(title_of(session, pane).ends_with(", flat"));
    const Ran ran = run_demo("report --view grid --keys f");
    ASSERT_EQ(ran.status, 0) << ran.output;
    const Image screenshot = picture();
    expect_panes(screenshot, session);
    // And the three are within the bar of 1/255.
    const Layout places = layout(session, kWidth, kHeight, 1);
    refresh(session, places.picture.width, places.picture.height);
    const AllowedDifference allowed =
        reference::allowed_difference(session.scene.frame, {{.shading = {}, .lecture_variants = false}});
    const Image fixed_picture = part_of(screenshot, places.cells[0].picture);
    for (const std::size_t cell : {1u, 2u}) {
        const ImageDifference found =
            difference(fixed_picture, part_of(screenshot, places.cells[cell].picture), allowed);
        EXPECT_LE(found.beyond_allowed.max, 1 / 255.0);
        EXPECT_LT(found.beyond_allowed.differing_share(), 0.001);
    }
}

TEST_F(DemoWindow, AnswersKeysAndMouse) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    RunningDemo demo(server_->display(), {scene_file_, "--view", "single", "--scale", "1", "--size", "800x600",
                                          "--screenshot", picture_file_});
    // The pointer is in the window, which therefore has the keys: no window manager runs here.
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    xdotool("mousemove 600 300");
    Session session = session_after("");
    const auto mirror = [&] { refresh(session, 640, 480); };

    const auto check = [&](const std::string& what, const std::string& commands) {
        SCOPED_TRACE(what);
        mirror();
        xdotool(commands + " key p");
        expect_panes(picture(), session);
    };
    const auto pressed = [&](const std::string& keys) {
        for (const char key : keys) {
            press(session, key);
            mirror();
        }
    };

    check("as it starts", "");
    EXPECT_EQ(xdotool("search --name twinlight getwindowname").output, "scene.gl - twinlight\n");

    pressed("\t\t");
    check("Tab twice: the fixed function", "key Tab key Tab");
    pressed("f1");
    check("flat, GL_LIGHT0 off", "key f key 1");
    pressed("12f");
    check("smooth, GL_LIGHT1 off", "key 1 key 2 key f");

    orbit(session, start_drag(session), 60, 40);
    check("drag", "mousedown 1 mousemove_relative 40 30 mousemove_relative 20 10 mouseup 1");
    session.history.end_group();
    zoom(session, 1);
    zoom(session, 1);
    check("wheel up, twice", "click 4 click 4");
    look(session, start_drag(session), -30, 20);
    check("drag with the right button",
          "mousedown 3 mousemove_relative -- -20 10 mousemove_relative -- -10 10 mouseup 3");
    session.history.end_group();
    pressed("wwad");
    check("walk", "key w key w key a key d");
    pressed("++");
    check("finer meshes", "key plus key plus");
    pressed("z");
    check("undo", "key z");
    pressed("r");
    check("reset", "key r");
    // From the single picture to the world, to the line between two pictures, to the grid. Its reference may not be there yet.
    xdotool("key shift+Tab key shift+Tab key shift+Tab key p");
    const Image grid = picture();
    const Session four = session_after("\t\t", View::kGrid);
    const Layout places = layout(four, kWidth, kHeight, 1);
    Session small = four;
    refresh(small, places.picture.width, places.picture.height);
    const auto context = make_offscreen_context(places.picture.width, places.picture.height);
    expect_near(part_of(grid, places.cells[0].picture), picture_of(small, small.panes[0]),
                reference::allowed_difference(small.scene.frame, {}).edge, 0);

    xdotool("key Escape");
    EXPECT_EQ(demo.ended(), 0);
}

TEST_F(DemoWindow, ReadsTheFileAgainWhenItIsSaved) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    RunningDemo demo(server_->display(), {scene_file_, "--view", "single", "--scale", "1", "--size", "800x600",
                                          "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    xdotool("mousemove 600 300");
    const auto shot = [&] {
        xdotool("key p");
        return picture();
    };
    const Image before = shot();
    const auto differs = [&](const Image& image, const Image& from) {
        return difference(image, from, PixelMask(image.pixels.size())).interior.max > 0;
    };

    // A mistake is shown in the status line, and the picture stays.
    const Rectangle picture_box = layout(session_after(""), kWidth, kHeight, 1).cells.front().picture;
    write_file_atomically(scene_file_, std::string(kScene) + "glBegine(GL_POINTS);\n");
    Image wrong;
    ASSERT_TRUE(wait_for([&] { return differs(wrong = shot(), before); }));
    EXPECT_FALSE(differs(part_of(wrong, picture_box), part_of(before, picture_box)));

    const std::string corrected = std::string(kScene) + "glTranslatef(0, -1, 0); glutSolidCube(0.5);\n";
    write_file_atomically(scene_file_, corrected);
    scene_ = read_scene(corrected, scene_file_, "scene.gl");
    Image right;
    ASSERT_TRUE(wait_for([&] { return differs(part_of(right = shot(), picture_box), part_of(before, picture_box)); }));
    expect_panes(right, session_after(""));
}

TEST_F(DemoWindow, FollowsTheWindowsSize) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    RunningDemo demo(server_->display(), {scene_file_, "--view", "single", "--scale", "1", "--size", "800x600",
                                          "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight windowsize --sync 1100 700").status, 0);
    xdotool("mousemove 700 300");
    // The window's size reaches the program as an event of its own: the first picture may still be of the old one.
    Image image;
    ASSERT_TRUE(wait_for([&] {
        xdotool("key p");
        image = picture();
        return image.width != kWidth;
    }));
    expect_panes(image, session_after(""), 1100, 700);
    xdotool("key Escape");
    EXPECT_EQ(demo.ended(), 0);
}

// Finds the first line of the calls with numbers, gluPerspective's, by the numbers' colour, and drags its first one.
TEST_F(DemoWindow, ADraggedNumberChangesTheCallThePictureAndTheSavedFile) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    const std::string exported = (folder() / "scene.c").string();
    std::filesystem::remove(exported);
    RunningDemo demo(server_->display(), {scene_file_, "--view", "single", "--scale", "1", "--size", "800x600",
                                          "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    xdotool("mousemove 600 300 key p");
    const Image before = picture();
    // Numbers are sand, names blue, signs grey; the tab's line is orange.
    const auto is_of_number = [](const Rgba& pixel) {
        return pixel[0] > 0.5F && pixel[0] - pixel[2] > 0.1F && pixel[0] - pixel[1] < 0.1F;
    };
    int x = kWidth, y = 0;
    for (int row = 0; row < kHeight && (y == 0 || row < y + 12); ++row) {
        for (int column = 0; column < kWidth; ++column) {
            if (!is_of_number(before.at(column, row))) continue;
            if (y == 0) y = row;
            x = std::min(x, column);
        }
    }
    ASSERT_LT(x, kWidth) << "no number in the panel";
    // ImGui sees the mouse once a frame.
    for (const std::string& step :
         {fmt::format("mousemove {} {}", x + 2, y), std::string("mousedown 1"), std::string("mousemove_relative 15 0"),
          std::string("mousemove_relative 15 0"), std::string("mouseup 1")}) {
        xdotool(step);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    xdotool("mousemove 600 300 key e key p");
    const Image after = picture();
    ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(exported); }));
    const auto saved = load_commands(exported);
    const auto call = std::ranges::find(saved->commands, CommandId::gluPerspective, &Command::id);
    ASSERT_NE(call, saved->commands.end());
    EXPECT_GT(call->number(0), 46);
    scene_ = *saved;
    expect_panes(after, session_after(""));
    // One step of undo.
    xdotool("key z key p");
    scene_ = read_scene(kScene, scene_file_, "scene.gl");
    expect_panes(picture(), session_after(""));
}

// The first number of the first of the six lines is dragged, which moves the light; z undoes that. Tab draws with shaders.
TEST_F(DemoWindow, TheTutorsNumbersAreDragged) {
    if (run("command -v xdotool").status != 0) GTEST_SKIP() << "xdotool is missing (Debian's package xdotool)";
    const auto exported = [&] {
        const std::string file = (folder() / "tutor-spot.c").string();
        std::filesystem::remove(file);
        xdotool("key e");
        EXPECT_TRUE(wait_for([&] { return std::filesystem::exists(file); }));
        return *load_commands(file);
    };
    const auto light_x = [](const CommandList& list) {
        return std::ranges::find(list.commands, CommandId::glLightfv, &Command::id)->number(2);
    };
    const RunningDemo demo(server_->display(),
                           {"--tutor", "spot", "--scale", "1", "--size", "800x600", "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    const auto expect_picture = [&](const CommandList& list) {
        scene_ = list;
        xdotool("mousemove 790 10 key p");
        Session session = session_after("", View::kTutor);
        session.active = 0;
        expect_panes(picture(), session);
    };
    xdotool("mousemove 790 10");
    const CommandList start = exported();
    expect_picture(start);
    EXPECT_EQ(light_x(start), -1.5);
    for (const std::string& step :
         {std::string("mousemove 505 342"), std::string("mousedown 1"), std::string("mousemove_relative 40 0"),
          std::string("mousemove_relative 40 0"), std::string("mouseup 1")}) {
        xdotool(step);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    xdotool("mousemove 790 10");
    const CommandList dragged = exported();
    EXPECT_GT(light_x(dragged), -1.5);
    expect_picture(dragged);
    xdotool("key z");
    EXPECT_EQ(light_x(exported()), -1.5);
    xdotool("key y key Tab key p");
    scene_ = dragged;
    Session session = session_after("", View::kTutor);
    session.active = 0;
    session.panes[0].renderer = Path::kProgrammable;
    expect_panes(picture(), session);
}

// Two lines above the picture, from the scene's first comment; nothing for a scene without one.
TEST_F(DemoWindow, SaysWhatTheSceneShowsAndWhatToNotice) {
    EXPECT_EQ(layout(session_after(""), kWidth, kHeight, 1).caption.height, 0);
    scene_ = *load_commands("report");
    const Rectangle box = layout(session_after(""), kWidth, kHeight, 1).caption;
    ASSERT_EQ(run_demo("report --view single").status, 0);
    const Image caption = part_of(picture(), box);
    const auto brightest = [&](int from, int to) {
        float most = 0;
        for (int y = from; y < to; ++y)
            for (int x = 0; x < box.width; ++x) most = std::max(most, caption.at(x, y)[1]);
        return most;
    };
    EXPECT_GT(brightest(0, box.height / 2), 0.8F);
    EXPECT_GT(brightest(box.height / 2, box.height), 0.5F);
    EXPECT_LT(brightest(box.height - 3, box.height), 0.2F) << "letters are cut";
}

// The probe's normal is a green arrow, in every view.
TEST_F(DemoWindow, TheProbesVectorsAreInEveryView) {
    for (const ViewName& view : kViews) {
        if (view.value == View::kTutor) continue;  // it follows the pointer
        SCOPED_TRACE(view.key);
        const auto green = [&](const std::string& options) {
            const Ran ran = run_demo(scene_file_ + " --panel save --view " + view.key + options);
            EXPECT_EQ(ran.status, 0) << ran.output;
            const Image image = picture();
            return std::ranges::count_if(image.pixels, [](const Rgba& pixel) {
                return channel_code(pixel[0]) == 89 && channel_code(pixel[1]) == 230 && channel_code(pixel[2]) == 128;
            });
        };
        const auto without = green("");
        // On the sphere, left of its middle.
        const WindowSize size = layout(session_after("", view.value), kWidth, kHeight, 1).picture;
        EXPECT_GT(green(fmt::format(" --probe {},{}", size.width / 4, size.height * 2 / 5)), without + 10);
    }
}

// The lesson's check, by its button: wrong at the start; right after x, which turns GL_NORMALIZE on.
TEST_F(DemoWindow, ChecksTheAnswerToALesson) {
    const RunningDemo demo(server_->display(), {"--scale", "1", "--size", "1000x800", "--lesson", "scaled-normals",
                                                "--language", "en", "--screenshot", picture_file_});
    ASSERT_EQ(xdotool("search --sync --onlyvisible --name twinlight").status, 0);
    const auto has = [](const Image& image, int x, int y, std::array<int, 3> color, int tolerance = 0) {
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(channel_code(image.at(x, y)[c]) - color[c]) > tolerance) return false;
        return true;
    };
    constexpr int kOfLetters = 30;  // thin strokes mix with the background
    constexpr std::array<int, 3> kButton{52, 57, 68}, kOrange{240, 178, 72}, kGreen{126, 200, 130}, kRed{240, 110, 96};
    constexpr int kLeft = 16, kPanel = 300;  // a column through the buttons; the panel is wider than this
    xdotool("mousemove 900 400 key p");
    const Image start = picture();
    // Below the tabs, of which the one that is shown has an orange line.
    int button = 0;
    for (int y = 0; y < start.height / 4; ++y)
        for (int x = 0; x < kPanel; ++x)
            if (has(start, x, y, kOrange)) button = y + 2;
    while (button < start.height && !has(start, kLeft, button, kButton)) ++button;
    ASSERT_LT(button, start.height) << "no button in the panel";
    const auto check_shows = [&](const std::array<int, 3>& color) {
        return wait_for([&] {
            // ImGui sees the mouse once a frame.
            for (const std::string& step : {fmt::format("mousemove {} {}", kLeft + 20, button + 10),
                                            std::string("mousedown 1"), std::string("mouseup 1")}) {
                xdotool(step);
                std::this_thread::sleep_for(std::chrono::milliseconds(200));
            }
            xdotool("mousemove 900 400 key p");
            const Image now = picture();
            for (int y = button; y < now.height; ++y)
                for (int x = 0; x < kPanel; ++x)
                    if (has(now, x, y, color, kOfLetters)) return true;
            return false;
        });
    };
    EXPECT_TRUE(check_shows(kRed));
    xdotool("key x");
    EXPECT_TRUE(check_shows(kGreen));
}

// Valgrind sees each block that is not freed; those that only the driver, X or freeglut asked for are theirs.
TEST_F(DemoWindow, FreesEverythingWhenItCloses) {
    if (run("command -v valgrind").status != 0) GTEST_SKIP() << "valgrind is not installed";
    const std::string log = (folder() / "valgrind.log").string();
    const Ran ran = run(
        on_display("valgrind --leak-check=full --show-leak-kinds=definite,possible --num-callers=40 --log-file=" + log +
                   " " + program() + " " + scene_file_ +
                   " --view grid --panel probe --keys 'm1w' --scale 1 --size 800x600 --quit-after 3"));
    ASSERT_EQ(ran.status, 0) << ran.output;
    // The reports are separated by empty lines. The innermost function that is not the allocator's says whose a block is.
    std::istringstream lines(read_file(log));
    std::string line;
    bool is_leak = false, is_innermost = false;
    while (std::getline(lines, line)) {
        if (line.find(" lost in loss record") != std::string::npos) {
            is_leak = is_innermost = true;
        } else if (is_leak && is_innermost && line.find("vgpreload_memcheck") == std::string::npos) {
            is_innermost = false;
            EXPECT_EQ(line.find("twinlight"), std::string::npos) << line;
        }
        if (line.find("==    ") == std::string::npos && line.find(" lost in") == std::string::npos) is_leak = false;
    }
}

// When nothing moves, the window waits for events. Measured: 0 of the system's ticks (1/100 s) in 4 s.
TEST_F(DemoWindow, UsesNoProcessorTimeWhenNothingMoves) {
    std::vector<std::unique_ptr<RunningDemo>> demos;
    for (const ViewName& view : kViews)
        demos.push_back(std::make_unique<RunningDemo>(
            server_->display(), std::vector<std::string>{"report", "--view", view.key, "--scale", "1"}));
    for (std::size_t i = 0; i < demos.size(); ++i) EXPECT_TRUE(demos[i]->comes_to_rest()) << kViews[i].key;
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
    expect_refusal(run(program() + " --view cube"), "--view");
    expect_refusal(run(program() + " --quit-after 0"), "--quit-after: '0' is not a whole number from 1 to 1000000");
    expect_refusal(run(program() + " --keys '<F12>'"), "--keys: '<F12>' is no key of the window");
    expect_refusal(run(program() + " --lesson shinines"), "there is no lesson 'shinines'; did you mean 'shininess'?");
    expect_refusal(run(program() + " report --lesson shininess"), "give either SCENE or --lesson");
    expect_refusal(run(program() + " report --tutor light"), "give either SCENE or --tutor");
    expect_refusal(run(program() + " --tutor fog"),
                   "--tutor: 'fog' is not one of light, material, normals, spot, attenuation");
    expect_refusal(run(program() + " --language fr"), "--language: 'fr' is not one of en, zh");
    expect_refusal(run(program() + " --screenshoot a.png"), "did you mean '--screenshot'?");
    expect_refusal(run(program() + " \"$(printf 'a\\033[31mb\\nc.gl')\""), "a\\x1b[31mb\\x0ac.gl: ");
}

TEST_F(DemoWindow, ShowsItsOptionsAndKeysWithoutADisplay) {
    const Ran ran = run("env -u DISPLAY " + program() + " --help");
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.output.find("--screenshot"), std::string::npos);
    EXPECT_NE(ran.output.find(keys_help().substr(0, keys_help().find('\n'))), std::string::npos);
    const Ran version = run("env -u DISPLAY " + program() + " --version");
    EXPECT_EQ(version.status, 0);
    EXPECT_NE(version.output.find("\ndriver     none: GLX: cannot connect to an X server (DISPLAY)\n"),
              std::string::npos)
        << version.output;
}

}  // namespace
}  // namespace twinlight::session::demo_test

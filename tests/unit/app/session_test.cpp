// The window's state without a window: undo, the size of pictures, the layout, the keys.
#include "app/session/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "app/session/history.h"
#include "app/session/keys.h"
#include "app/session/layout.h"
#include "app/session/sides.h"
#include "scene/command/text.h"
#include "scene/scenes/images.h"
#include "scene/scenes/load.h"

namespace twinlight::session::session_test {
namespace {

std::shared_ptr<const CommandList> scene(const std::string& text) {
    return std::make_shared<const CommandList>(read_scene(text, "test.gl", "test"));
}

const std::string kPoint = "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n";

Session session_of(const std::string& text) {
    Session session(scene(text));
    refresh(session, 640, 480);
    return session;
}

std::string text_of(const Session& session) { return print_scene(commands(session)); }

// ---- Undo ----

TEST(SessionHistory, UndoesAndRedoesEachEdit) {
    const auto first = scene(kPoint), second = scene("glEnable(GL_LIGHTING);" + kPoint);
    History history(first);
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.undo(), "");
    history.edit(*second, "light it");
    EXPECT_EQ(history.now()->commands, second->commands);
    EXPECT_EQ(history.undo(), "light it");
    EXPECT_EQ(history.now()->commands, first->commands);
    EXPECT_EQ(history.redo(), "light it");
    EXPECT_EQ(history.now()->commands, second->commands);
    EXPECT_FALSE(history.can_redo());
}

TEST(SessionHistory, ADragIsOneStep) {
    History history(scene(kPoint));
    for (const int angle : {10, 20, 30})
        history.edit(*scene("glRotatef(" + std::to_string(angle) + ", 0, 1, 0);" + kPoint), "turn", "camera");
    history.end_group();
    history.edit(*scene("glRotatef(40, 0, 1, 0);" + kPoint), "turn", "camera");
    EXPECT_EQ(history.undo(), "turn");
    EXPECT_EQ(history.now()->commands, scene("glRotatef(30, 0, 1, 0);" + kPoint)->commands);
    EXPECT_EQ(history.undo(), "turn");
    EXPECT_EQ(history.now()->commands, scene(kPoint)->commands);
}

TEST(SessionHistory, AnEditAfterUndoForgetsWhatWasUndone) {
    History history(scene(kPoint));
    history.edit(*scene("glEnable(GL_LIGHT1);" + kPoint), "one");
    history.undo();
    history.edit(*scene("glEnable(GL_LIGHT2);" + kPoint), "two");
    EXPECT_FALSE(history.can_redo());
    history.undo();
    EXPECT_EQ(history.now()->commands, scene(kPoint)->commands);
}

TEST(SessionHistory, AnEditThatChangesNothingIsNoStep) {
    History history(scene(kPoint));
    const int revision = history.revision();
    history.edit(*scene(kPoint), "nothing");
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.revision(), revision);
}

// ---- Pictures of another size ----

TEST(SessionScaled, ViewportsThatTouchStillTouch) {
    const auto halves = scene("glViewport(0, 0, 321, 480);" + kPoint + "glViewport(321, 0, 319, 480);" + kPoint);
    const CommandList smaller = scaled(*halves, {640, 480}, {427, 320});
    const auto& left = smaller.commands[0].arguments;
    const auto right = std::ranges::find_if(smaller.commands.begin() + 1, smaller.commands.end(),
                                            [](const Command& command) { return command.id == CommandId::glViewport; });
    EXPECT_EQ(left[0], 0);
    EXPECT_EQ(left[2], 214);  // 321 * 427 / 640 = 214.17
    EXPECT_EQ(right->arguments[0], left[2]);
    EXPECT_EQ(right->arguments[0] + right->arguments[2], 427);
    EXPECT_EQ(left[3], 320);
}

// The viewports of a built-in scene at 1280 x 800: x, y, width, height.
std::vector<std::vector<double>> viewports_at_1280x800(const std::string& name) {
    std::vector<std::vector<double>> viewports;
    for (const Command& command : scaled(*load_commands(name), {640, 480}, {1280, 800}).commands)
        if (command.id == CommandId::glViewport) viewports.push_back(command.arguments);
    return viewports;
}

TEST(SessionScaled, ImagesKeepTheirSize) {
    using Boxes = std::vector<std::vector<double>>;
    EXPECT_EQ(viewports_at_1280x800("monitor"), (Boxes{{0, 0, 256, 192}, {0, 0, 1280, 800}}));
    EXPECT_EQ(viewports_at_1280x800("shadow-map").front(), (std::vector<double>{0, 0, 256, 256}));
    EXPECT_EQ(viewports_at_1280x800("environment").front(), (std::vector<double>{0, 0, 64, 64}));
}

TEST(SessionScaled, CopiedPixelsFollowTheWindow) {
    const auto given = scene("glWindowPos2i(340, 200); glCopyPixels(141, 322, 40, 30, GL_COLOR);" + kPoint);
    const CommandList larger = scaled(*given, {640, 480}, {1280, 960});
    EXPECT_EQ(larger.commands[0].arguments[0], 680);
    EXPECT_EQ(larger.commands[0].arguments[1], 400);
    EXPECT_EQ(std::vector<double>(larger.commands[1].arguments.begin(), larger.commands[1].arguments.begin() + 4),
              (std::vector<double>{282, 644, 80, 60}));
}

TEST(SessionScaled, TheNaturalSizeChangesNothing) {
    const auto given = scene("glViewport(3, 5, 100, 50); glScissor(1, 2, 3, 4);" + kPoint);
    EXPECT_EQ(scaled(*given, {640, 480}, {640, 480}).commands, given->commands);
}

TEST(SessionRefresh, ReportsAnErrorAndKeepsTheLastScene) {
    Session session = session_of(kPoint);
    EXPECT_EQ(session.error, "");
    const int revision = session.revision;
    CommandList wrong = commands(session);
    wrong.commands.pop_back();  // glEnd
    edit(session, wrong, "remove glEnd");
    EXPECT_FALSE(refresh(session, 640, 480));
    EXPECT_NE(session.error.find("glBegin"), std::string::npos) << session.error;
    EXPECT_EQ(session.revision, revision);
    EXPECT_EQ(session.scene.frame.draws().size(), 1u);
    session.history.undo();
    EXPECT_TRUE(refresh(session, 640, 480));
    EXPECT_EQ(session.error, "");
}

// ---- Shading ----

TEST(SessionPane, GlFlatMakesEveryPaneFlat) {
    Session session = session_of("glEnable(GL_LIGHTING);" + kPoint);
    const Pane per_pixel{Path::kProgrammable, Shading::kPhong};
    EXPECT_EQ(shading_of(session, per_pixel), Shading::kPhong);
    EXPECT_TRUE(look_of(session, per_pixel).lecture_variants);
    press(session, 'f');
    refresh(session, 640, 480);
    EXPECT_EQ(shading_of(session, per_pixel), std::nullopt);
    EXPECT_FALSE(look_of(session, per_pixel).lecture_variants);
    EXPECT_EQ(title_of(session, per_pixel), "Shaders, flat");
}

TEST(SessionPane, TheFixedFunctionHasNoLightingPerPixel) {
    Session session = session_of(kPoint);
    EXPECT_EQ(shading_of(session, {Path::kFixed, Shading::kPhong}), std::nullopt);
    EXPECT_EQ(shading_of(session, {Path::kFixed, Shading::kFlat}), Shading::kFlat);
    session.active = 0;
    std::set<std::string> titles;
    for (int i = 0; i < 4; ++i) {
        press(session, 'g');
        titles.insert(title_of(session, session.panes[0]));
    }
    EXPECT_EQ(titles, (std::set<std::string>{"Fixed function, Gouraud", "Fixed function, flat"}));
}

// ---- Keys ----

TEST(SessionKeys, EachHasOneMeaning) {
    std::set<int> seen;
    for (const Key& key : keys())
        for (int code = key.first; code <= key.last; ++code) EXPECT_TRUE(seen.insert(code).second) << code;
    Session session = session_of(kPoint);
    EXPECT_FALSE(press(session, '9'));
}

TEST(SessionKeys, HaveNames) {
    std::string names;
    for (const int code : {int{'f'}, int{' '}, int{'\t'}, kEscape, kShiftTab, kSpecialKey + 11, kCtrl + 'o',
                           kCtrl + '+', kCtrlShift + 's', kSpecialKey + 100, kSpecialKey + 103})
        names += name_of_key(code) + " ";
    EXPECT_EQ(names, "f Space Tab Esc Shift+Tab F11 Ctrl+O Ctrl++ Ctrl+Shift+S Left Down ");
    for (const Key& key : keys())
        for (int code = key.first; code <= key.last; ++code) EXPECT_EQ(find_key(name_of_key(code)), code);
    EXPECT_FALSE(find_key("F12"));
}

TEST(SessionKeys, ThatEditSayWhatTheyDidAndCanBeUndone) {
    const auto report = load_commands("report");
    for (const char key : std::string("12345678flvtx+-wasd")) {
        SCOPED_TRACE(key);
        Session session(report);
        refresh(session, 640, 480);
        EXPECT_TRUE(press(session, key));
        EXPECT_NE(commands(session).commands, report->commands);
        refresh(session, 640, 480);
        EXPECT_EQ(session.error, "");
        const bool walks = std::string("wasd").find(key) != std::string::npos;
        EXPECT_EQ(session.message.empty(), walks);
        press(session, 'z');
        EXPECT_EQ(commands(session).commands, report->commands);
        press(session, 'y');
        EXPECT_NE(commands(session).commands, report->commands);
        press(session, 'r');
        EXPECT_EQ(commands(session).commands, report->commands);
    }
}

TEST(SessionKeys, TheSavedSceneIsTheSceneShown) {
    Session session(load_commands("report"));
    refresh(session, 640, 480);
    for (const char key : std::string("1fv-w")) {
        press(session, key);
        refresh(session, 640, 480);
    }
    const DragStart start = start_drag(session);
    orbit(session, start, 31, -17);
    const CommandList again = read_scene(text_of(session), "saved.gl", "saved", images_built_in);
    EXPECT_EQ(again.commands, commands(session).commands);
}

TEST(SessionKeys, ALightThatIsBlackSaysSo) {
    Session session(load_commands("report"));
    refresh(session, 640, 480);
    press(session, '3');  // GL_LIGHT2 has GL's initial colours: black
    EXPECT_NE(session.message.find("black"), std::string::npos) << session.message;
}

TEST(SessionKeys, TheArrowsUseTheDirectionsOfADrag) {
    Session arrow = session_of("gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);" + kPoint), dragged = arrow;
    press(arrow, kSpecialKey + 102);  // right
    orbit(dragged, start_drag(dragged), 10, 0);
    EXPECT_EQ(commands(arrow).commands, commands(dragged).commands);
    EXPECT_NE(commands(arrow).commands, arrow.opened->commands);
}

TEST(SessionKeys, AKeyPressedTwiceLeavesNoTrace) {
    for (const std::string& text :
         {kPoint, "glEnable(GL_LIGHTING);\nglShadeModel(GL_FLAT);\nglEnable(GL_LIGHT2);" + kPoint}) {
        Session session = session_of(text);
        for (const char key : std::string("12345678flvtx")) {
            press(session, key);
            EXPECT_TRUE(is_edited(session)) << key;
            press(session, key);
            EXPECT_FALSE(is_edited(session)) << key;
        }
        // Also if other keys come between.
        for (const char key : std::string("1l2f12lf")) press(session, key);
        EXPECT_FALSE(is_edited(session));
    }
}

// ---- Animation ----

TEST(SessionAnimation, AFullTurnOfTheCameraReturnsItInOneStepOfUndo) {
    Session session = session_of("gluLookAt(0, 3, 4, 0, 0, 0, 0, 1, 0);" + kPoint);
    for (int i = 0; i < 120; ++i) animate(session, 0.1);  // 12 s at 30 degrees a second
    const auto& look_at = commands(session).commands.front().arguments;
    EXPECT_NEAR(look_at[0], 0, 1e-4);
    EXPECT_NEAR(look_at[1], 3, 1e-4);
    EXPECT_NEAR(look_at[2], 4, 1e-4);
    press(session, 'z');
    EXPECT_EQ(commands(session).commands, session.opened->commands);
}

TEST(SessionAnimation, TurnsTheSelectedLightAroundTheMiddle) {
    Session session = session_of(
        "gluLookAt(0, 3, 6, 0, 0, 0, 0, 1, 0); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);"
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 1, 0, 1}); glutSolidCube(1);");
    session.selected_light = 0;
    for (int i = 0; i < 30; ++i) animate(session, 0.1);  // a quarter turn
    const auto& position = commands(session).commands[3].arguments;
    ASSERT_EQ(position.size(), 6u);
    // The middle of the cube and the light is on the light's side of 0, so its place is not known without the world's
    // middle; but its height stays, and so does the camera.
    EXPECT_NEAR(position[3], 1, 0.01);
    EXPECT_GT(std::abs(position[4]), 0.5);
    EXPECT_EQ(commands(session).commands[0], session.opened->commands[0]);
    for (int i = 0; i < 90; ++i) animate(session, 0.1);
    EXPECT_NEAR(commands(session).commands[3].arguments[2], 2, 0.01);
    EXPECT_NEAR(commands(session).commands[3].arguments[4], 0, 0.01);
}

// ---- What differs between the slider's sides ----

const std::string kReflected = "#pragma twinlight specular(reflection)\nglEnable(GL_LIGHTING);" + kPoint;

TEST(SessionSides, AtTheStartOnlyThePlaceOfLightingDiffers) {
    Session session = session_of(kReflected);
    refresh(session, 640, 480);
    const std::vector<SideRow> rows = side_rows(session);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].text, "Where light is computed: at vertices | at pixels");
    EXPECT_TRUE(rows[0].differs);
    EXPECT_EQ(rows[1].text, "The lecture's variants: reflected ray");
    EXPECT_FALSE(rows[1].differs);
}

TEST(SessionSides, ASwitchChangesOneThingOnly) {
    Session session = session_of(kReflected);
    refresh(session, 640, 480);
    const auto differ = [&] { return std::pair(side_rows(session)[0].differs, side_rows(session)[1].differs); };
    const auto press_row = [&](std::size_t row) { switch_side(session, side_rows(session)[row]); };
    press_row(1);
    EXPECT_EQ(differ(), std::pair(true, true));
    press_row(0);
    EXPECT_EQ(differ(), std::pair(false, true));
    press_row(1);
    EXPECT_EQ(differ(), std::pair(false, false));
    EXPECT_EQ(side_rows(session)[0].text, "Where light is computed: at vertices on both sides");
    press_row(0);
    EXPECT_EQ(differ(), std::pair(true, false));
    // With the shaders at the left, they change as well.
    session.slider = {1, 0};
    press_row(0);
    EXPECT_EQ(differ(), std::pair(false, false));
}

TEST(SessionSides, TheFixedFunctionOnBothSidesHasNoSwitch) {
    Session session = session_of(kReflected);
    session.panes[1] = Pane{Path::kFixed};
    EXPECT_TRUE(side_rows(session).empty());
}

// ---- Layout ----

bool overlap(const Rectangle& a, const Rectangle& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

TEST(SessionLayout, NothingOverlapsInAnyWindow) {
    Session session = session_of(kReflected);
    refresh(session, 640, 480);
    for (const ViewName& view : kViews) {
        session.view = view.value;
        for (const auto& [width, height] : {std::pair{800, 600}, {1280, 800}, {1920, 1080}, {3840, 2160}}) {
            for (const double scale : {1.0, 1.5, 2.0}) {
                const Layout places = layout(session, width, height, scale);
                std::vector<Rectangle> boxes{places.panel, places.status, places.sides, places.code, places.caption};
                for (const Cell& cell : places.cells) {
                    boxes.insert(boxes.end(), {cell.header, cell.picture, cell.footer});
                    EXPECT_EQ(cell.picture.width, places.picture.width);
                    EXPECT_EQ(cell.picture.height, places.picture.height);
                }
                for (std::size_t i = 0; i < boxes.size(); ++i) {
                    EXPECT_GE(boxes[i].x, 0);
                    EXPECT_GE(boxes[i].y, 0);
                    EXPECT_LE(boxes[i].x + boxes[i].width, width);
                    EXPECT_LE(boxes[i].y + boxes[i].height, height);
                    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << i << ", " << j;
                }
                // The proportions are those of 640 x 480, to a pixel.
                EXPECT_NEAR(places.picture.width * 3.0, places.picture.height * 4.0, 4);
            }
        }
    }
}

TEST(SessionLayout, ThePanelCanBeMadeWiderAndNarrower) {
    Session session = session_of(kPoint);
    EXPECT_EQ(layout(session, 1000, 600, 1).panel.width, 420);
    for (const auto& [x, width] : {std::pair{600, 600}, {300, 300}, {950, 700}, {10, 240}}) {
        widen_panel(session, x, 1000, 1);
        EXPECT_EQ(layout(session, 1000, 600, 1).panel.width, width);
    }
}

TEST(SessionLayout, FindsThePixelUnderTheMouse) {
    Session session = session_of(kPoint);
    session.view = View::kGrid;
    const Layout places = layout(session, 1280, 800, 1);
    ASSERT_EQ(places.cells.size(), 4u);
    const Rectangle& third = places.cells[2].picture;
    const auto found = hit(places, third.x + 7, third.y + 9);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->pane, 2u);
    EXPECT_EQ(found->x, 7);
    EXPECT_EQ(found->y, 9);
    EXPECT_FALSE(hit(places, 1, 1));
    EXPECT_EQ(places.cells[3].pane, kDifferencePane);
}

}  // namespace
}  // namespace twinlight::session::session_test

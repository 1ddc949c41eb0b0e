// The camera's moves: commands in, commands out, and what State makes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/session/camera.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_camera_test {
namespace {

// Cameras here are at most 10 from their centre, so arguments are rounded to 0.00001. That moves the eye by at most
// 0.9e-5, and turns what is as far away as the centre by as much again.
constexpr double kRounding = 2e-5;
// Matrices are products of about ten rotations and translations of size 10 in double precision.
constexpr double kArithmetic = 1e-13;

const glm::dvec3 kPivot(0, 0, -5);

CommandList scene(const std::string& text) { return read_scene(text, "test.gl", "test"); }

Frame frame_of(const CommandList& commands) { return make_frame(commands, StateOptions{}); }

std::vector<Draw> draws_of(const CommandList& commands) {
    std::vector<Draw> draws;
    const Frame frame = frame_of(commands);
    for (const Draw* draw : frame.draws()) draws.push_back(*draw);
    return draws;
}

CameraMove turned(double yaw_deg, double pitch_deg, double zoom = 1) {
    CameraMove move;
    move.yaw_deg = yaw_deg;
    move.pitch_deg = pitch_deg;
    move.zoom = zoom;
    return move;
}

CommandList moved(const std::string& text, const CameraMove& move, const glm::dvec3& pivot_eye = kPivot) {
    return with_camera_moved(scene(text), move, pivot_eye);
}

// The arguments of the n-th gluLookAt.
std::vector<double> look_at(const CommandList& commands, int n = 0) {
    for (const Command& command : commands.commands)
        if (command.id == CommandId::gluLookAt && n-- == 0) return command.arguments;
    return {};
}

auto cameras_in(const CommandList& commands) {
    return std::ranges::count(commands.commands, CommandId::gluLookAt, &Command::id);
}

void expect_point(const glm::dvec4& actual, const glm::dvec3& expected, double tolerance = kRounding) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

using Numbers = std::vector<double>;

const std::string kPoint = "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n";
const std::string kLookAt = "gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);\n";

TEST(SessionCamera, NoMoveChangesNothing) {
    const CommandList original = scene("glShadeModel(GL_FLAT); glEnable(GL_LIGHT3);" + kLookAt + kPoint);
    EXPECT_EQ(with_camera_moved(original, {}, kPivot).commands, original.commands);
    EXPECT_EQ(with_camera_moved(original, turned(1, 2), kPivot).name, "test");
    // Nor does one that ends where it started, of 360 degrees.
    EXPECT_EQ(with_camera_moved(original, turned(360, 0), kPivot).commands, original.commands);
}

TEST(SessionCamera, PrintsAsASceneThatReadsBack) {
    for (const std::string& text : {kLookAt + kPoint, "glTranslatef(1, 0, -5);" + kPoint}) {
        const CommandList seen = moved(text, turned(31, -17, 1.7), {2, 3, -5});
        EXPECT_EQ(scene(print_scene(seen)).commands, seen.commands);
    }
}

// ---- Around the centre ----

TEST(SessionCamera, YawBringsTheFrontToTheRightAndPitchBringsItDown) {
    const glm::dvec4 front_world(0, 0, 1, 1);  // one unit toward the camera: (0,0,-4) in eye space
    expect_point(draws_of(moved(kLookAt + kPoint, turned(90, 0)))[0].eye_from_object * front_world, {1, 0, -5});
    const double cosine = 0.5, sine = std::sqrt(0.75);
    expect_point(draws_of(moved(kLookAt + kPoint, turned(0, 60)))[0].eye_from_object * front_world,
                 {0, -sine, -5 + cosine});
}

TEST(SessionCamera, KeepsTheCentreInTheMiddle) {
    // Eye and centre are 7 apart: (2,3,6).
    for (const double zoom : {0.5, 1.0, 4.0}) {
        const CommandList seen = moved("gluLookAt(3, 5, 7,  1, 2, 1,  0, 1, 0);" + kPoint, turned(77, -10, zoom));
        // 14 from the centre, rounding is to 0.0001.
        expect_point(draws_of(seen)[0].eye_from_object * glm::dvec4(1, 2, 1, 1), {0, 0, -7 / zoom}, 10 * kRounding);
    }
}

TEST(SessionCamera, TurnsTheEyeOfGluLookAt) {
    // The scene turns by +60 degrees about y, so the eye turns by -60, to 5 / 2 (-sin 60, 0, cos 60).
    EXPECT_EQ(look_at(moved(kLookAt + kPoint, turned(60, 0, 2))), (Numbers{-2.16506, 0, 1.25, 0, 0, 0, 0, 1, 0}));
    // About z, where z is up: from above y = -4 to above x = -4, and by the same height.
    EXPECT_EQ(look_at(moved("gluLookAt(1, -4, 5,  1, 0, 2,  0, 0, 1);" + kPoint, turned(90, 0))),
              (Numbers{-3, 0, 5, 1, 0, 2, 0, 0, 1}));
}

TEST(SessionCamera, GoesBackTheWayItCame) {
    CommandList commands = scene("gluLookAt(3, 5, 7,  1, 2, 1,  0, 1, 0);" + kPoint);
    const std::vector<Command> start = commands.commands;
    for (int i = 0; i < 100; ++i) commands = with_camera_moved(commands, turned(0.5, 0.25, 1.01), kPivot);
    for (int i = 0; i < 100; ++i) commands = with_camera_moved(commands, turned(-0.5, -0.25, 1 / 1.01), kPivot);
    const Numbers arguments = look_at(commands);
    // 200 steps, each rounded by at most half of 0.00001.
    for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(arguments[i], start[0].arguments[i], 200 * 0.5e-5);
}

TEST(SessionCamera, KeepsTheHorizonLevel) {
    // Whatever the path, the image of the up vector has no part to the right.
    CommandList commands = scene("gluLookAt(0, 3.6, 9,  0, 0.95, 0,  0, 1, 0);" + kPoint);
    for (const CameraMove& move : {turned(30, 20), turned(-100, 15), turned(10, -70), turned(200, 5)}) {
        commands = with_camera_moved(commands, move, kPivot);
        const glm::dvec4 up_eye = draws_of(commands)[0].eye_from_object * glm::dvec4(0, 1, 0, 0);
        EXPECT_NEAR(up_eye.x, 0, kArithmetic);
        EXPECT_GT(up_eye.y, 0);
    }
}

TEST(SessionCamera, StopsBelowTheZenith) {
    // 4 (0, sin 89, cos 89)
    EXPECT_EQ(look_at(moved("gluLookAt(0, 0, 4,  0, 0, 0,  0, 1, 0);" + kPoint, turned(0, 500))),
              (Numbers{0, 3.99939, 0.06981, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(look_at(moved("gluLookAt(0, 0, 4,  0, 0, 0,  0, 1, 0);" + kPoint, turned(0, -500))),
              (Numbers{0, -3.99939, 0.06981, 0, 0, 0, 0, 1, 0}));
}

TEST(SessionCamera, AboveTheFloorItStaysAbove) {
    const std::string above = "gluLookAt(0, 3, 4,  0, 0, 0,  0, 1, 0);" + kPoint;
    // One degree: 5 (0, sin 1, cos 1).
    CommandList commands = moved(above, turned(0, -80));
    EXPECT_EQ(look_at(commands), (Numbers{0, 0.08726, 4.99924, 0, 0, 0, 0, 1, 0}));
    // Where it already stands, it stays; the next step of the drag does not pass either.
    commands = with_camera_moved(commands, turned(0, -5), kPivot);
    EXPECT_NEAR(look_at(commands)[1], 0.08726, kRounding);
    // Unless asked: 36.87 - 80 degrees.
    CameraMove under = turned(0, -80);
    under.may_go_under = true;
    EXPECT_NEAR(look_at(moved(above, under))[1], 5 * std::sin(std::atan2(3, 4) - 80 * M_PI / 180), kRounding);
    // One that starts on or below the plane of the centre may go anywhere.
    EXPECT_LT(look_at(moved(kLookAt + kPoint, turned(0, -30)))[1], 0);
}

TEST(SessionCamera, ACameraWithoutADirectionStays) {
    for (const char* look_at_text :
         {"gluLookAt(1, 2, 3,  1, 2, 3,  0, 1, 0);", "gluLookAt(1, 2, 3,  0, 0, 0,  0, 0, 0);"}) {
        const CommandList original = scene(look_at_text + kPoint);
        EXPECT_EQ(with_camera_moved(original, turned(10, 10, 2), kPivot).commands, original.commands);
    }
    // Straight down, it gets a side.
    const Numbers down = look_at(moved("gluLookAt(0, 5, 0,  0, 0, 0,  0, 1, 0);" + kPoint, turned(0, -10)));
    EXPECT_NEAR(down[1], 5 * std::sin(80 * M_PI / 180), kRounding);
}

// ---- Walking and looking ----

TEST(SessionCamera, WalksAlongTheFloor) {
    CameraMove move;
    move.forward = 0.5;  // of the distance 5, along -z: the camera looks down, but walks level
    move.right = 0.2;
    move.up = 0.1;
    EXPECT_EQ(look_at(moved("gluLookAt(0, 3, 4,  0, 0, 0,  0, 1, 0);" + kPoint, move)),
              (Numbers{1, 3.5, 1.5, 1, 0.5, -2.5, 0, 1, 0}));
}

TEST(SessionCamera, LooksAboutTheEye) {
    CameraMove move;
    move.look_yaw_deg = 90;  // from -z to the right, +x
    EXPECT_EQ(look_at(moved(kLookAt + kPoint, move)), (Numbers{0, 0, 5, 5, 0, 5, 0, 1, 0}));
    move.look_yaw_deg = 0;
    move.look_pitch_deg = 30;
    EXPECT_EQ(look_at(moved(kLookAt + kPoint, move)), (Numbers{0, 0, 5, 0, 2.5, 0.66987, 0, 1, 0}));
    move.look_pitch_deg = 200;  // 89 degrees
    EXPECT_EQ(look_at(moved(kLookAt + kPoint, move)), (Numbers{0, 0, 5, 0, 4.99924, 4.91274, 0, 1, 0}));
}

// ---- Which gluLookAt ----

TEST(SessionCamera, ALightSetBeforeGluLookAtStaysAtTheCamera) {
    const std::string position = ", GL_POSITION, (GLfloat[]){0, 0, 1, 1});\n";
    const CommandList seen =
        moved("glLightfv(GL_LIGHT0" + position + kLookAt + "glLightfv(GL_LIGHT1" + position + kPoint, turned(90, 0));
    const LightingState lighting = draws_of(seen)[0].lighting;
    expect_point(lighting.lights[0].position_eye, {0, 0, 1});   // the headlight: as the scene says
    expect_point(lighting.lights[1].position_eye, {1, 0, -5});  // the world's: from (0,0,-4) around (0,0,-5)
}

TEST(SessionCamera, EveryGluLookAtOfAFreshMatrixMoves) {
    const CommandList again =
        moved(kLookAt + kPoint + "glLoadIdentity();" + kLookAt + "glTranslatef(1, 0, 0);" + kPoint, turned(90, 0));
    EXPECT_EQ(look_at(again, 0), look_at(again, 1));
    expect_point(draws_of(again)[1].eye_from_object * glm::dvec4(0, 0, 1, 1), {1, 0, -6});

    const CommandList pushed =
        moved("glPushMatrix();" + kLookAt + kPoint + "glPopMatrix();" + kLookAt + kPoint, turned(90, 0));
    EXPECT_EQ(look_at(pushed, 0), (Numbers{-5, 0, 0, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(look_at(pushed, 0), look_at(pushed, 1));
}

TEST(SessionCamera, AGluLookAtThatPlacesAModelStays) {
    const CommandList seen = moved(
        kLookAt + "glPushMatrix(); gluLookAt(1, 1, 1, 0, 0, 0, 0, 1, 0);" + kPoint + "glPopMatrix();", turned(90, 0));
    EXPECT_EQ(look_at(seen, 0), (Numbers{-5, 0, 0, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(look_at(seen, 1), (Numbers{1, 1, 1, 0, 0, 0, 0, 1, 0}));
}

TEST(SessionCamera, WhatIsDrawnAfterGlLoadIdentityAloneStaysAtTheCamera) {
    // A crosshair.
    const CommandList seen =
        moved(kLookAt + kPoint + "glLoadIdentity(); glTranslatef(0, 0, -2);" + kPoint, turned(90, 0));
    expect_point(draws_of(seen)[1].eye_from_object * glm::dvec4(0, 0, 0, 1), {0, 0, -2}, 0);
}

TEST(SessionCamera, AGluLookAtInTheProjectionMovesThere) {
    const std::string text = "glMatrixMode(GL_PROJECTION);" + kLookAt + "glMatrixMode(GL_MODELVIEW);" + kPoint;
    const Draw draw = draws_of(moved(text, turned(90, 0)))[0];
    expect_point(draw.clip_from_eye * glm::dvec4(0, 0, 1, 1), {1, 0, -5});
    EXPECT_EQ(draw.eye_from_object, glm::dmat4(1));
    // Only if the modelview has none.
    const CommandList both = moved(
        "glMatrixMode(GL_PROJECTION);" + kLookAt + "glMatrixMode(GL_MODELVIEW);" + kLookAt + kPoint, turned(90, 0));
    EXPECT_EQ(look_at(both, 0), (Numbers{0, 0, 5, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(look_at(both, 1), (Numbers{-5, 0, 0, 0, 0, 0, 0, 1, 0}));
}

// ---- A scene without gluLookAt ----

TEST(SessionCamera, ASceneWithoutGluLookAtGetsOneAroundItsPivot) {
    const glm::dvec4 origin(0, 0, 0, 1);
    const auto eye = [&](const std::string& text, std::size_t draw) {
        return draws_of(moved(text, turned(90, 0), {0, 0, -3}))[draw].eye_from_object * origin;
    };
    // The point is one unit in front of the pivot, and comes to its right.
    expect_point(eye("glTranslatef(0, 0, -2);" + kPoint, 0), {1, 0, -3});
    const std::string matrix = "glLoadMatrixf((GLfloat[]){1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-2,1});";
    expect_point(eye(matrix + kPoint, 0), {1, 0, -3});
    const std::string transposed = "glLoadTransposeMatrixd((GLdouble[]){1,0,0,0, 0,1,0,0, 0,0,1,-2, 0,0,0,1});";
    expect_point(eye(transposed + kPoint, 0), {1, 0, -3});
    // Drawn without any transformation, at the eye itself.
    expect_point(eye(kPoint, 0), {3, 0, -3});
    // In every fresh matrix, and once in each.
    const std::string piece = "glPushMatrix(); glTranslatef(0, 0, -2); " + kPoint + "glPopMatrix();";
    expect_point(eye(piece + piece, 1), {1, 0, -3});
    expect_point(eye(piece + "glLoadIdentity();" + piece, 1), {1, 0, -3});
    // Where the projection is still current when the drawing begins.
    expect_point(eye("glTranslatef(0, 0, -2); glMatrixMode(GL_PROJECTION);" + kPoint, 0), {1, 0, -3});
    expect_point(eye("glMatrixMode(GL_PROJECTION); glLoadIdentity();" + kPoint, 0), {3, 0, -3});
    // Once before a list's call, not inside the list.
    const std::string list = "glNewList(1, GL_COMPILE); glTranslatef(0, 0, -1);" + kPoint + "glEndList();";
    expect_point(eye(list + "glCallList(1); glCallList(1);", 1), {1, 0, -3});
    EXPECT_EQ(cameras_in(moved(list + "glCallList(1); glCallList(1);", turned(90, 0))), 1);
}

// glRasterPos is transformed, so what it draws moves with the camera, even before the first shape.
TEST(SessionCamera, TheInsertedCameraMovesPixelsToo) {
    const std::string label = "glRasterPos3f(1, 0, -5); glBitmap(8, 1, 0, 0, 0, 0, (GLubyte[]){255}); ";
    const CommandList commands = moved(label + "glutSolidCube(1);", turned(10, 0));
    EXPECT_EQ(cameras_in(commands), 1);
    const auto at = [&](auto is) { return std::ranges::find_if(commands.commands, is) - commands.commands.begin(); };
    EXPECT_LT(at([](const Command& c) { return c.id == CommandId::gluLookAt; }),
              at([](const Command& c) { return c.name().starts_with("glRasterPos"); }));
}

TEST(SessionCamera, TheInsertedCameraStartsWhereTheSceneHasIt) {
    // A pivot beside the axis, behind the eye, and at it: a move of nearly nothing shows nearly the same.
    const std::string text = "glTranslatef(4, 1, -2);" + kPoint;
    const glm::dvec4 origin(0, 0, 0, 1);
    for (const glm::dvec3& pivot_eye : {glm::dvec3(0, 0, -3), glm::dvec3(2, -1, -3), glm::dvec3(0.1, 0, -3),
                                        glm::dvec3(1, 1, 2), glm::dvec3(0, 0, 0)}) {
        expect_point(draws_of(moved(text, turned(1e-9, 0), pivot_eye))[0].eye_from_object * origin, {4, 1, -2});
    }
    // And a whole turn about the pivot keeps the pivot where it is.
    const glm::dvec3 pivot_eye(2, -1, -3);
    const CommandList seen = moved("glTranslatef(2, -1, -3);" + kPoint, turned(137, 40), pivot_eye);
    expect_point(draws_of(seen)[0].eye_from_object * origin, pivot_eye);
}

TEST(SessionCamera, TheInsertedCameraMovesOn) {
    const CommandList once = moved("glTranslatef(0, 0, -2);" + kPoint, turned(40, 0), {0, 0, -3});
    const CommandList twice = with_camera_moved(once, turned(50, 0), {7, 7, -7});  // the pivot no longer matters
    EXPECT_EQ(cameras_in(twice), 1);
    expect_point(draws_of(twice)[0].eye_from_object * glm::dvec4(0, 0, 0, 1), {1, 0, -3});
}

TEST(SessionCamera, TheProjectionStaysAsItIs) {
    const std::string projection = "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1.5, 1, 10);";
    const std::string rest = "glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -5);" + kPoint;
    EXPECT_EQ(draws_of(moved(projection + rest, turned(50, 20)))[0].clip_from_eye,
              draws_of(scene(projection + rest))[0].clip_from_eye);
}

TEST(SessionCamera, TheMiddleIsThatOfAllPointsInEyeSpace) {
    const CommandList original = scene(
        "glTranslatef(0, 0, -10);\n"
        "glBegin(GL_POINTS); glVertex3f(1, 2, 3); glVertex3f(-3, 2, 1); glVertex4f(4, 0, 0, 2); glEnd();");
    // x from -3 to 2; y from 0 to 2; z from -10 to -7 (the last point is (2,0,0) before glTranslate).
    expect_point(glm::dvec4(middle_of(frame_of(original)), 1), {-0.5, 1, -8.5}, kArithmetic);
    EXPECT_EQ(middle_of(Frame{}), glm::dvec3(0, 0, -5));
}

}  // namespace
}  // namespace twinlight::session::session_camera_test

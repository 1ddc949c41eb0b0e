// The window's view and controls, without a window: commands in, commands out, and what State makes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/demo/controls.h"
#include "app/demo/view.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::demo {
namespace {

// Matrices here are products of about ten rotations and translations of size 10 in double precision.
constexpr double kArithmetic = 1e-13;

CommandList scene(const std::string& text) { return read_scene(text, "test.gl", "test"); }

Frame frame_of(const CommandList& commands) { return make_frame(commands, StateOptions{}); }

std::vector<Draw> draws_of(const CommandList& commands) {
    std::vector<Draw> draws;
    for (const auto& item : frame_of(commands).items) {
        if (const Draw* draw = std::get_if<Draw>(&item)) draws.push_back(*draw);
    }
    return draws;
}

View turned(double yaw_deg, double pitch_deg, double zoom = 1) {
    View view;
    view.yaw_deg = yaw_deg;
    view.pitch_deg = pitch_deg;
    view.zoom = zoom;
    return view;
}

// How often the view's orbit stands in the list.
auto orbits_in(const CommandList& commands) {
    return std::count_if(commands.commands.begin(), commands.commands.end(),
                         [](const Command& c) { return c.id == CommandId::glMultMatrixd; });
}

double distance(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
    }
    return most;
}

void expect_point(const glm::dvec4& actual, const glm::dvec3& expected) {
    EXPECT_NEAR(actual.x, expected.x, kArithmetic);
    EXPECT_NEAR(actual.y, expected.y, kArithmetic);
    EXPECT_NEAR(actual.z, expected.z, kArithmetic);
}

const std::string kPoint = "glBegin(GL_POINTS); glVertex3f(0, 0, 0); glEnd();\n";
const std::string kLookAt = "gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);\n";

TEST(DemoView, ThePlainViewChangesNothing) {
    const CommandList original = scene("glShadeModel(GL_FLAT); glEnable(GL_LIGHT3);" + kLookAt + kPoint);
    EXPECT_EQ(apply_view(original, View{}).commands, original.commands);
    EXPECT_EQ(apply_view(original, View{}).name, "test");
}

TEST(DemoView, PrintsAsASceneThatReadsBack) {
    View view = turned(31, -17, 1.7);
    view.shade_model = kGL_FLAT;
    view.wireframe = true;
    view.light_inverted[2] = true;
    const CommandList seen = apply_view(scene(kLookAt + kPoint), view);
    EXPECT_EQ(scene(print_scene(seen)).commands, seen.commands);
}

// ---- The orbit ----

TEST(DemoView, YawBringsTheFrontToTheRightAndPitchBringsItDown) {
    const CommandList original = scene(kLookAt + kPoint);
    const glm::dvec4 front_world(0, 0, 1, 1);  // one unit toward the camera: (0,0,-4) in eye space
    expect_point(draws_of(apply_view(original, turned(90, 0)))[0].eye_from_object * front_world, {1, 0, -5});
    expect_point(draws_of(apply_view(original, turned(0, 90)))[0].eye_from_object * front_world, {0, -1, -5});
}

TEST(DemoView, KeepsTheCentreOfGluLookAtInTheMiddle) {
    // Eye and centre are 7 apart: (2,3,6).
    const CommandList original = scene("gluLookAt(3, 5, 7,  1, 2, 1,  0, 1, 0);" + kPoint);
    for (const double zoom : {0.5, 1.0, 4.0}) {
        const glm::dmat4 eye_from_world = draws_of(apply_view(original, turned(77, -20, zoom)))[0].eye_from_object;
        expect_point(eye_from_world * glm::dvec4(1, 2, 1, 1), {0, 0, -7 / zoom});
    }
}

TEST(DemoView, OrbitingIsMovingTheEyeOfGluLookAt) {
    // The world turns by +60 degrees about y, so the eye moves by -60, to 5 / 2 (-sin 60, 0, cos 60).
    const double x = -2.5 * std::sqrt(3) / 2, z = 2.5 / 2;
    const std::string light = "GLfloat p[] = {1, 2, 3, 1}; glLightfv(GL_LIGHT0, GL_POSITION, p);";
    const CommandList orbited = apply_view(scene(kLookAt + light + kPoint), turned(60, 0, 2));
    std::string text = "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);" + light + kPoint;
    CommandList moved = scene(text);
    moved.commands[0].arguments[0] = x;
    moved.commands[0].arguments[2] = z;
    const Draw a = draws_of(orbited)[0], b = draws_of(moved)[0];
    EXPECT_LT(distance(a.eye_from_object, b.eye_from_object), kArithmetic);
    expect_point(a.lighting.lights[0].position_eye, glm::dvec3(b.lighting.lights[0].position_eye));
}

TEST(DemoView, ALightSetBeforeGluLookAtStaysAtTheCamera) {
    const std::string position = ", GL_POSITION, (GLfloat[]){0, 0, 1, 1});\n";
    const CommandList original =
        scene("glLightfv(GL_LIGHT0" + position + kLookAt + "glLightfv(GL_LIGHT1" + position + kPoint);
    const LightingState lighting = draws_of(apply_view(original, turned(90, 0)))[0].lighting;
    expect_point(lighting.lights[0].position_eye, {0, 0, 1});   // the headlight: as the scene says
    expect_point(lighting.lights[1].position_eye, {1, 0, -5});  // the world's: from (0,0,-4) around (0,0,-5)
}

TEST(DemoView, EveryGluLookAtOfAFreshMatrixGetsTheOrbit) {
    const CommandList again = apply_view(
        scene(kLookAt + kPoint + "glLoadIdentity();" + kLookAt + "glTranslatef(1, 0, 0);" + kPoint), turned(90, 0));
    EXPECT_EQ(orbits_in(again), 2);
    expect_point(draws_of(again)[1].eye_from_object * glm::dvec4(0, 0, 1, 1), {1, 0, -6});

    const CommandList pushed =
        apply_view(scene("glPushMatrix();" + kLookAt + kPoint + "glPopMatrix();" + kLookAt + kPoint), turned(90, 0));
    EXPECT_EQ(orbits_in(pushed), 2);
    const std::vector<Draw> draws = draws_of(pushed);
    EXPECT_EQ(distance(draws[0].eye_from_object, draws[1].eye_from_object), 0);
}

TEST(DemoView, AMatrixThatHasTheOrbitDoesNotGetItTwice) {
    const std::string model_look_at = "glPushMatrix(); gluLookAt(1, 1, 1, 0, 0, 0, 0, 1, 0);";
    EXPECT_EQ(orbits_in(apply_view(scene(kLookAt + model_look_at + kPoint + "glPopMatrix();"), turned(90, 0))), 1);
}

TEST(DemoView, WhatIsDrawnAfterGlLoadIdentityAloneStaysAtTheCamera) {
    // A crosshair: moving the eye of gluLookAt would not move it either.
    const CommandList seen =
        apply_view(scene(kLookAt + kPoint + "glLoadIdentity(); glTranslatef(0, 0, -2);" + kPoint), turned(90, 0));
    expect_point(draws_of(seen)[1].eye_from_object * glm::dvec4(0, 0, 0, 1), {0, 0, -2});
}

TEST(DemoView, AGluLookAtInTheProjectionIsOrbitedThere) {
    const std::string text = "glMatrixMode(GL_PROJECTION);" + kLookAt + "glMatrixMode(GL_MODELVIEW);" + kPoint;
    const Draw draw = draws_of(apply_view(scene(text), turned(90, 0)))[0];
    expect_point(draw.clip_from_eye * glm::dvec4(0, 0, 1, 1), {1, 0, -5});
    EXPECT_EQ(draw.eye_from_object, glm::dmat4(1));
}

TEST(DemoView, ASceneWithoutGluLookAtTurnsAboutItsPivot) {
    View view = turned(90, 0);
    view.pivot_eye = {0, 0, -3};
    const glm::dvec4 origin(0, 0, 0, 1);
    const auto eye = [&](const std::string& text, std::size_t draw) {
        return draws_of(apply_view(scene(text), view))[draw].eye_from_object * origin;
    };
    // The point stands one unit in front of the pivot, and comes to its right.
    expect_point(eye("glTranslatef(0, 0, -2);" + kPoint, 0), {1, 0, -3});
    const std::string matrix = "glLoadMatrixf((GLfloat[]){1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-2,1});";
    expect_point(eye(matrix + kPoint, 0), {1, 0, -3});
    // Drawn without any transformation, at the eye itself.
    expect_point(eye(kPoint, 0), {3, 0, -3});
    // In every fresh matrix, and once in each.
    const std::string piece = "glPushMatrix(); glTranslatef(0, 0, -2); " + kPoint + "glPopMatrix();";
    expect_point(eye(piece + piece, 1), {1, 0, -3});
    expect_point(eye(piece + "glLoadIdentity();" + piece, 1), {1, 0, -3});
    // Where the projection is still current when the drawing begins.
    expect_point(eye("glTranslatef(0, 0, -2); glMatrixMode(GL_PROJECTION);" + kPoint, 0), {1, 0, -3});
    expect_point(eye("glMatrixMode(GL_PROJECTION); glLoadIdentity();" + kPoint, 0), {3, 0, -3});
}

TEST(DemoView, TheProjectionStaysAsItIs) {
    const std::string projection = "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1.5, 1, 10);";
    const std::string rest = "glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -5);" + kPoint;
    const CommandList original = scene(projection + rest);
    EXPECT_EQ(draws_of(apply_view(original, turned(50, 20)))[0].clip_from_eye, draws_of(original)[0].clip_from_eye);
}

TEST(DemoView, TheMiddleIsThatOfAllPointsInEyeSpace) {
    const CommandList original = scene(
        "glTranslatef(0, 0, -10);\n"
        "glBegin(GL_POINTS); glVertex3f(1, 2, 3); glVertex3f(-3, 2, 1); glVertex4f(4, 0, 0, 2); glEnd();");
    // x from -3 to 2; y from 0 to 2; z from -10 to -7 (the last point is (2,0,0) before glTranslate).
    const glm::dvec3 middle = middle_of(frame_of(original));
    expect_point(glm::dvec4(middle, 1), {-0.5, 1, -8.5});
    EXPECT_EQ(middle_of(Frame{}), View{}.pivot_eye);
}

// ---- Shade model, lights, wireframe ----

TEST(DemoView, TheShadeModelIsThatOfTheView) {
    const CommandList original =
        scene(kPoint + "glShadeModel(GL_FLAT);" + kPoint + "glShadeModel(GL_SMOOTH);" + kPoint);
    for (const Enum mode : {kGL_FLAT, kGL_SMOOTH}) {
        View view;
        view.shade_model = mode;
        for (const Draw& draw : draws_of(apply_view(original, view))) EXPECT_EQ(draw.lighting.shade_model, mode);
    }
}

TEST(DemoView, AnInvertedLightIsOnWhereTheSceneSaysOff) {
    const CommandList original =
        scene(kPoint + "glEnable(GL_LIGHT2);" + kPoint + "glDisable(GL_LIGHT2); glEnable(GL_LIGHT3);" + kPoint);
    View view;
    view.light_inverted[2] = true;
    const std::vector<Draw> before = draws_of(original), after = draws_of(apply_view(original, view));
    ASSERT_EQ(after.size(), 3u);
    for (std::size_t d = 0; d < after.size(); ++d) {
        for (std::size_t i = 0; i < kMaxLights; ++i) {
            const bool was_on = before[d].lighting.lights[i].enabled;
            EXPECT_EQ(after[d].lighting.lights[i].enabled, i == 2 ? !was_on : was_on) << "draw " << d << " light " << i;
        }
    }
}

TEST(DemoView, WireframeDrawsTheEdgesOfAllFaces) {
    View view;
    view.wireframe = true;
    const CommandList original = scene(kPoint + "glPolygonMode(GL_BACK, GL_FILL);" + kPoint);
    for (const Draw& draw : draws_of(apply_view(original, view))) {
        EXPECT_EQ(draw.raster.polygon_mode_front, kGL_LINE);
        EXPECT_EQ(draw.raster.polygon_mode_back, kGL_LINE);
    }
}

// ---- Controls ----

TEST(DemoKeys, EveryCodeHasOneRowAndEveryRowIsInTheHelp) {
    const std::string help = keys_help();
    for (const Key& key : keys()) {
        EXPECT_LE(key.first, key.last);
        EXPECT_NE(help.find(key.what), std::string::npos) << key.what;
        for (const Key& other : keys()) {
            if (&other == &key) continue;
            EXPECT_TRUE(key.last < other.first || other.last < key.first) << key.label;
        }
    }
}

TEST(DemoKeys, ChangeWhatTheHelpSays) {
    Controls controls = make_controls(frame_of(scene(kPoint)));
    EXPECT_TRUE(press(controls, '\t'));
    EXPECT_EQ(controls.renderer, Path::kProgrammable);
    press(controls, 'd');
    EXPECT_TRUE(controls.difference);
    press(controls, '\t');  // asks for a renderer, so the difference goes
    EXPECT_EQ(controls.renderer, Path::kFixed);
    EXPECT_FALSE(controls.difference);
    press(controls, 'f');
    EXPECT_EQ(controls.view.shade_model, kGL_FLAT);
    press(controls, 'f');
    EXPECT_EQ(controls.view.shade_model, kGL_SMOOTH);
    press(controls, '1');
    press(controls, '8');
    press(controls, '8');
    EXPECT_TRUE(controls.view.light_inverted[0]);
    EXPECT_FALSE(controls.view.light_inverted[7]);
    press(controls, 'm');
    EXPECT_TRUE(controls.view.wireframe);
    drag(controls, 10, 20);
    EXPECT_EQ(controls.view.pitch_deg, 2 * controls.view.yaw_deg);
    press(controls, 'r');
    EXPECT_EQ(controls.view, controls.initial_view);
    press(controls, 's');
    EXPECT_TRUE(controls.save_requested);
    press(controls, '?');
    EXPECT_TRUE(controls.keys_shown);
    press(controls, 27);
    EXPECT_TRUE(controls.quit_requested);
    EXPECT_FALSE(press(controls, '9'));
    EXPECT_FALSE(press(controls, 0));
}

TEST(DemoKeys, AFlatSceneBecomesSmoothFirst) {
    Controls controls = make_controls(frame_of(scene("glShadeModel(GL_FLAT);" + kPoint)));
    press(controls, 'f');
    EXPECT_EQ(controls.view.shade_model, kGL_SMOOTH);
}

TEST(DemoKeys, ZoomingBackGivesTheSameView) {
    Controls controls;
    zoom(controls, 1);
    EXPECT_GT(controls.view.zoom, 1);
    zoom(controls, -1);
    EXPECT_EQ(controls.view.zoom, 1);
    zoom(controls, 1000);
    EXPECT_EQ(controls.view.zoom, 20);
    zoom(controls, -2000);
    EXPECT_EQ(controls.view.zoom, 1.0 / 20);
}

TEST(DemoSummary, NamesSceneRendererShadingAndLights) {
    const CommandList original = scene("glEnable(GL_LIGHTING); glEnable(GL_LIGHT1); glEnable(GL_LIGHT4);" + kPoint);
    Controls controls;
    EXPECT_EQ(summary("lab", controls, frame_of(original)), "lab - fixed - GL_SMOOTH - GL_LIGHT1,4");
    press(controls, '\t');
    press(controls, 'm');
    EXPECT_EQ(summary("lab", controls, frame_of(scene("glEnable(GL_LIGHT0);" + kPoint))),
              "lab - programmable - GL_SMOOTH wireframe - no light");
    press(controls, 'd');
    EXPECT_EQ(summary("lab", controls, frame_of(original), 64),
              "lab - |fixed - programmable| times 64 - GL_SMOOTH wireframe - GL_LIGHT1,4");
}

TEST(DemoSummary, SaysWhichPictureIsPartial) {
    Frame frame = frame_of(scene(kPoint));
    frame.unsupported = {{"glEnable(GL_FOG)", 1, {}, MissingFrom::kFrame}};
    Controls controls;
    EXPECT_EQ(summary("fog", controls, frame), "fog - fixed - GL_SMOOTH - no light");
    press(controls, '\t');
    EXPECT_EQ(summary("fog", controls, frame), "fog - programmable (partial) - GL_SMOOTH - no light");
}

TEST(DemoFit, KeepsTheProportionsAndTheMiddle) {
    const auto expect = [](Viewport actual, Viewport expected) {
        EXPECT_EQ(actual.x, expected.x);
        EXPECT_EQ(actual.y, expected.y);
        EXPECT_EQ(actual.width, expected.width);
        EXPECT_EQ(actual.height, expected.height);
    };
    expect(fit(640, 480, 640, 480), {0, 0, 640, 480});
    expect(fit(640, 480, 1000, 480), {180, 0, 640, 480});
    expect(fit(640, 480, 640, 1000), {0, 260, 640, 480});
    expect(fit(640, 480, 320, 320), {0, 40, 320, 240});
    expect(fit(640, 480, 1, 1), {0, 0, 1, 1});
}

}  // namespace
}  // namespace twinlight::demo

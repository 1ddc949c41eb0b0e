// The world view: where the camera and the lights are, what the frame looks like from outside, and how lights are dragged.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "app/session/world.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_world_test {
namespace {

constexpr int kWidth = 400, kHeight = 300;
// Products of about five matrices of size 100 in double precision, one of them inverted.
constexpr double kArithmetic = 1e-9;

const std::string kProjection =
    "glMatrixMode(GL_PROJECTION); gluPerspective(90, 1, 1, 10); glMatrixMode(GL_MODELVIEW);\n";
const std::string kLookAt = "gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);\n";
const std::string kLit = "glEnable(GL_LIGHTING);\n";
// The box around it and the camera: x and y from -2 to 2, z from 0 to 5.
const std::string kSquare = "glRectf(-2, -2, 2, 2);\n";

struct Seen {
    CommandList commands;
    Frame frame;
    World world;
    WorldProjection projection;

    explicit Seen(const std::string& text, const OutsideCamera& camera = {})
        : Seen(read_scene(text, "test.gl", "test"), camera) {}
    Seen(const CommandList& list, const OutsideCamera& camera, const std::optional<Surroundings>& around = {})
        : commands(list),
          frame(make_frame(list, StateOptions{})),
          world(world_of(list, frame, around)),
          projection(projection_of(world, camera, kWidth, kHeight)) {}

    // After a drag, seen from the same place.
    Seen dragged(const Handle& handle, const glm::dvec2& by_pixels) const {
        Seen after(with_handle_moved(commands, frame, world, projection, handle, by_pixels), {}, world.around);
        after.projection = projection;
        return after;
    }
    glm::dvec2 place(const Handle& handle) const { return glm::dvec2(*projection.place_of(place_of(world, handle))); }
};

std::string light(int number, const std::string& pname, const std::string& values) {
    return "glLightfv(GL_LIGHT" + std::to_string(number) + ", " + pname + ", (GLfloat[]){" + values + "});\n";
}
std::string on(int number) { return "glEnable(GL_LIGHT" + std::to_string(number) + ");\n"; }

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance = kArithmetic) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

// ---- The camera ----

TEST(SessionWorld, FindsTheCamera) {
    const Seen seen(kProjection + kLookAt + kSquare);
    ASSERT_TRUE(seen.world.camera_world);
    expect_near(*seen.world.camera_world, {0, 0, 5});
    expect_near(glm::dvec3(glm::inverse(seen.world.eye_from_world)[3]), {0, 0, 5});
    expect_near(seen.world.around.middle_world, {0, 0, 2.5});
    EXPECT_NEAR(seen.world.around.radius, std::sqrt(4 + 4 + 6.25), kArithmetic);
    expect_near(seen.world.around.front_dir_world, {0, 0, 1});

    // In the projection, world coordinates are eye coordinates.
    const Seen projected(
        "glMatrixMode(GL_PROJECTION); gluPerspective(90, 1, 1, 10); gluLookAt(0, 0, 5, 0, 0, 0, 1, 0, 0);"
        "glMatrixMode(GL_MODELVIEW);" +
        kSquare);
    ASSERT_TRUE(projected.world.camera_world);
    expect_near(*projected.world.camera_world, {0, 0, 5});
    EXPECT_EQ(projected.world.eye_from_world, glm::dmat4(1));
    expect_near(projected.world.up_dir_world, {1, 0, 0});

    EXPECT_FALSE(Seen("glOrtho(-3, 3, -3, 3, -1, 1);" + kSquare).world.camera_world);
}

TEST(SessionWorld, TheFrustumEndsAtTheDeepestVisiblePoint) {
    // The square is 5 away: (f + n - 2fn/5) / (f - n) = (11 - 4) / 9. The hidden point is beyond the picture's left border.
    const Seen seen(kProjection + kLookAt + kSquare + "glBegin(GL_POINTS); glVertex3f(-20, 0, -4); glEnd();");
    EXPECT_NEAR(seen.world.frustum_depth, 7.0 / 9, kArithmetic);
    // A line's end in clip coordinates, and where it is on the picture.
    const auto lines = world_lines(seen.world, seen.projection);
    const auto shows = [&](const glm::dvec3& point_world) {
        const glm::dvec4 clip = seen.projection.clip_from_world * glm::dvec4(point_world, 1);
        return std::ranges::any_of(lines, [&](const OverlayVertex& vertex) {
            return glm::distance(glm::dvec4(vertex.position_clip), clip) < 1e-5;  // stored as floats
        });
    };
    EXPECT_TRUE(shows({0, 0, 5}));   // the eye
    EXPECT_TRUE(shows({1, 1, 4}));   // a corner of the near plane: 1 from the eye, 90 degrees wide
    EXPECT_TRUE(shows({-5, 5, 0}));  // one of the far end
    EXPECT_FALSE(shows({-10, 10, -5}));
}

TEST(SessionWorld, LeavesOutWhatAnotherProjectionDraws) {
    const Seen seen(
        kProjection + kLookAt + kSquare + kSquare +
        "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluOrtho2D(0, 640, 0, 480); glRectf(0, 0, 640, 480);");
    EXPECT_NEAR(seen.world.around.radius, std::sqrt(4 + 4 + 6.25), kArithmetic);
    EXPECT_EQ(as_seen_from_outside(seen.frame, seen.world, seen.projection).draws().size(), 2u);
}

// ---- From outside ----

TEST(SessionWorld, TheSurroundingsFitIntoThePicture) {
    const Seen seen(kProjection + kLookAt + kSquare);
    for (const OutsideCamera& camera :
         {OutsideCamera{40, 25, 1}, OutsideCamera{-120, -30, 1}, OutsideCamera{10, 89, 1}}) {
        for (const auto& [width, height] : {std::pair{400, 300}, {300, 400}, {900, 100}}) {
            const WorldProjection projection = projection_of(seen.world, camera, width, height);
            const auto middle = projection.place_of(seen.world.around.middle_world);
            ASSERT_TRUE(middle);
            EXPECT_NEAR(middle->x, width / 2.0, kArithmetic);
            EXPECT_NEAR(middle->y, height / 2.0, kArithmetic);
            for (const glm::dvec3& dir : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}}) {
                for (const double side : {-1.0, 1.0}) {
                    const auto place =
                        projection.place_of(seen.world.around.middle_world + side * seen.world.around.radius * dir);
                    ASSERT_TRUE(place);
                    EXPECT_TRUE(place->x >= 0 && place->x <= width && place->y >= 0 && place->y <= height);
                    EXPECT_TRUE(place->z > 0 && place->z < 1);
                }
            }
        }
    }
}

TEST(SessionWorld, TheOutsideCameraStartsOnTheSideOfTheLights) {
    for (const double x : {-3.0, 3.0}) {
        const Seen seen(kProjection + kLookAt + kLit + on(0) + on(1) +
                        light(0, "GL_POSITION", std::to_string(x) + ", 1, 1, 1") +
                        light(0, "GL_DIFFUSE", "1, 1, 1, 1") +
                        light(1, "GL_POSITION", std::to_string(-5 * x) + ", 1, 1, 1") + kSquare);
        // GL_LIGHT1 is black at first, so it does not count.
        EXPECT_GT(first_camera(seen.world).yaw_deg * x, 0);
    }
}

TEST(SessionWorld, TheOutsideCameraTurnsLikeATurntable) {
    // From the front, world x is to the right; a drag to the right brings the front to the right.
    const Seen seen(kProjection + kLookAt + kSquare, {0, 0});
    const auto x = [&](const WorldProjection& projection, const glm::dvec3& point) {
        return projection.place_of(point)->x;
    };
    EXPECT_GT(x(seen.projection, {1, 0, 2.5}), kWidth / 2.0);
    OutsideCamera camera{0, 0};
    orbit(camera, 30, 0);
    EXPECT_GT(x(projection_of(seen.world, camera, kWidth, kHeight), {0, 0, 4}), kWidth / 2.0);
    orbit(camera, 0, 1000);
    EXPECT_EQ(camera.pitch_deg, 89);
    orbit(camera, 0, -1000);
    EXPECT_EQ(camera.pitch_deg, 0);
    zoom(camera, 1000);
    EXPECT_EQ(camera.zoom, 20);
}

TEST(SessionWorld, TheFrameFromOutsideKeepsItsLighting) {
    const Seen seen(kProjection + "glScissor(1, 2, 3, 4); glEnable(GL_SCISSOR_TEST);" + kLookAt + kLit + on(0) +
                    light(0, "GL_POSITION", "1, 2, 3, 1") + "glTranslatef(1, 0, 0);" + kSquare);
    const Frame outside = as_seen_from_outside(seen.frame, seen.world, seen.projection);
    const Draw &before = *seen.frame.draws()[0], &after = *outside.draws()[0];
    EXPECT_EQ(after.eye_from_object, before.eye_from_object);
    EXPECT_EQ(after.lighting.lights[0].position_eye, before.lighting.lights[0].position_eye);
    EXPECT_FALSE(after.fragment.scissor.enabled);
    EXPECT_EQ(after.raster.viewport.width, kWidth);
    // The vertex (2, 2) is at (3, 2, 0) in the world.
    const glm::dvec4 clip = after.clip_from_eye * after.eye_from_object * glm::dvec4(2, 2, 0, 1);
    const auto place = seen.projection.place_of({3, 2, 0});
    EXPECT_NEAR((clip.x / clip.w + 1) / 2 * kWidth, place->x, kArithmetic);
    EXPECT_NEAR((1 - clip.y / clip.w) / 2 * kHeight, place->y, kArithmetic);
    expect_near(seen.projection.point_at(*place), {3, 2, 0});
}

// ---- Lights ----

TEST(SessionWorld, EveryLightThatIsOnHasAMarker) {
    const Seen seen(kProjection + kLit + on(0) + on(1) + on(2) + on(4) + on(5) + light(1, "GL_POSITION", "0, 0, 0, 1") +
                    light(1, "GL_DIFFUSE", "0.2, 0.4, 0.1, 1") +  // at the camera
                    "glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30);" + kLookAt + light(2, "GL_POSITION", "2, 4, 6, 2") +
                    light(2, "GL_SPECULAR", "3, 0, 1.5, 1") + light(4, "GL_POSITION", "0, 2, 0, 0") +
                    light(4, "GL_DIFFUSE", "1, 1, 1, 1") + kSquare +
                    "glDisable(GL_LIGHT5); glDisable(GL_LIGHTING); glEnable(GL_LIGHT6);" + kSquare);
    const auto& lights = seen.world.lights;
    ASSERT_EQ(lights.size(), 5u);
    EXPECT_EQ(lights[0].number, 0);  // initially (0,0,1,0) in eye coordinates
    EXPECT_TRUE(lights[0].is_directional);
    EXPECT_EQ(lights[0].color, glm::dvec3(1));
    const Surroundings& around = seen.world.around;
    expect_near(lights[0].place_world, around.middle_world + 0.8 * around.radius * glm::dvec3(0, 0, 1));

    EXPECT_FALSE(lights[1].is_directional);
    expect_near(lights[1].place_world, {0, 0, 5});
    expect_near(lights[1].color, {0.5, 1, 0.25}, 1e-6);  // its numbers are floats
    EXPECT_EQ(lights[1].cutoff_deg, 30);
    expect_near(lights[1].spot_dir_world, {0, 0, -1});

    expect_near(lights[2].place_world, {1, 2, 3});
    expect_near(lights[2].color, {1, 0, 0.5});
    EXPECT_FALSE(lights[2].cutoff_deg);

    EXPECT_EQ(lights[3].number, 4);
    expect_near(lights[3].place_world, around.middle_world + 0.8 * around.radius * glm::dvec3(0, 1, 0));
    EXPECT_EQ(lights[4].number, 5);
    EXPECT_TRUE(lights[4].is_black);
}

TEST(SessionWorld, ALightThatIsSetTwiceHasTwoMarkers) {
    const Seen seen(kLit + on(0) + light(0, "GL_POSITION", "1, 0, 0, 1") + kSquare + kSquare +
                    light(0, "GL_POSITION", "2, 0, 0, 1") + kSquare);
    ASSERT_EQ(seen.world.lights.size(), 2u);
    expect_near(seen.world.lights[1].place_world, {2, 0, 0});
}

TEST(SessionWorld, TheNearestHandleIsFound) {
    const Seen seen(kLit + kLookAt + on(0) + on(1) + light(0, "GL_POSITION", "1, 0, 0, 1") +
                    light(1, "GL_POSITION", "-1, 0, 0, 1") + "glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30);" + kSquare);
    const Handle left{1, false}, tip{1, true}, right{0, false};
    for (const Handle& handle : {left, tip, right})
        EXPECT_EQ(handle_at(seen.world, seen.projection, seen.place(handle) + glm::dvec2(3, -2)), handle);
    EXPECT_EQ(handle_at(seen.world, seen.projection, seen.place(left) + glm::dvec2(13, 0), 5), std::nullopt);
    // GL_LIGHT2 and GL_LIGHT3 are where lights are initially; the first is black.
    const Seen initial(kLit + on(2) + on(3) + light(3, "GL_DIFFUSE", "1, 1, 1, 1") + kSquare);
    const auto found = handle_at(initial.world, initial.projection, initial.place({0, false}));
    ASSERT_TRUE(found);
    EXPECT_EQ(initial.world.lights[found->light].number, 3);
}

// ---- Dragging ----

// The world's radius is about 5, so values are rounded to 0.01, and a pixel is about 0.05.
constexpr double kPixelRounding = 0.3;

TEST(SessionWorld, ADraggedLightFollowsTheMouse) {
    const std::string before = kProjection + kLit + on(0);
    const std::string place = light(0, "GL_POSITION", "1, 1, 1, 1");
    for (const std::string& text :
         {before + kLookAt + place + kSquare,                                   // in world coordinates
          before + light(0, "GL_POSITION", "1, 1, -4, 1") + kLookAt + kSquare,  // in eye coordinates
          before + kLookAt + light(0, "GL_POSITION", "2, 2, 2, 2") + kSquare,   // not with w = 1
          before + kLookAt + "glPushMatrix(); glRotatef(70, 1, 2, 3); glScalef(2, 2, 2);" + place + "glPopMatrix();" +
              kSquare,
          before + kLookAt + "glLightiv(GL_LIGHT0, GL_POSITION, (GLint[]){1, 1, 1, 1});" + kSquare}) {
        const Seen seen(text);
        const Handle handle{};
        const Seen after = seen.dragged(handle, {40, -25});
        ASSERT_EQ(after.commands.commands.size(), seen.commands.commands.size()) << text;
        EXPECT_NEAR(after.place(handle).x, seen.place(handle).x + 40, kPixelRounding) << text;
        EXPECT_NEAR(after.place(handle).y, seen.place(handle).y - 25, kPixelRounding) << text;
        // One call has changed, and it reads back.
        int changed = 0;
        for (std::size_t i = 0; i < seen.commands.commands.size(); ++i)
            changed += seen.commands.commands[i] == after.commands.commands[i] ? 0 : 1;
        EXPECT_EQ(changed, 1) << text;
        const auto call = command_of(seen.commands, seen.frame, seen.world, handle);
        ASSERT_TRUE(call) << text;
        EXPECT_FALSE(seen.commands.commands[*call] == after.commands.commands[*call]) << text;
        EXPECT_EQ(read_scene(print_scene(after.commands), "test.gl", "test").commands, after.commands.commands);
    }
}

TEST(SessionWorld, ADraggedLightGetsRoundNumbers) {
    const Seen seen(kProjection + kLit + on(0) + kLookAt + light(0, "GL_POSITION", "1, 1, 1, 1") + kSquare);
    const Seen after = seen.dragged({}, {7, 3});
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = after.frame.typed_lights.back().position.value[static_cast<int>(i)];
        EXPECT_EQ(value, static_cast<float>(std::round(value * 100) / 100));
    }
}

TEST(SessionWorld, ADraggedDirectionKeepsItsLength) {
    // Seen from the front. The arrow starts right of the middle, at 0.8 radii.
    const Seen seen(kProjection + kLit + on(0) + kLookAt + light(0, "GL_POSITION", "3, 0, 0, 0") + kSquare, {0, 0});
    const double radius = 0.8 * seen.world.around.radius;
    const glm::dvec3 start = seen.world.around.middle_world + glm::dvec3(radius, 0, 0);
    const glm::dvec2 up = glm::dvec2(*seen.projection.place_of(start + glm::dvec3(0, radius, 0))) -
                          glm::dvec2(*seen.projection.place_of(start));
    const Seen after = seen.dragged({}, up);  // to 45 degrees
    const glm::dvec4 value = after.frame.typed_lights.back().position.value;
    EXPECT_EQ(value.w, 0);
    expect_near(glm::dvec3(value), {2.12, 2.12, 0}, 1e-6);  // 3 sqrt(1/2), in steps of 0.01, as floats
}

TEST(SessionWorld, TheTipOfASpotlightTurnsItsCone) {
    const Seen seen(kProjection + kLit + on(0) + kLookAt + light(0, "GL_POSITION", "0, 1, 0, 1") +
                        light(0, "GL_SPOT_DIRECTION", "0, -1, 0") + "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 20);" +
                        kSquare,
                    {0, 0});
    const Handle tip{0, true};
    const glm::dvec3 from = place_of(seen.world, tip);
    expect_near(from, {0, 1 - arrow_length(seen.world), 0});
    const glm::dvec2 right =
        glm::dvec2(*seen.projection.place_of(from + glm::dvec3(arrow_length(seen.world), 0, 0))) - seen.place(tip);
    const Seen after = seen.dragged(tip, right);
    expect_near(after.frame.typed_lights.back().spot_direction.value, {0.71, -0.71, 0}, 1e-6);
    expect_near(after.world.lights[0].place_world, {0, 1, 0});
    // The rim: 20 degrees from the axis.
    for (const glm::dvec3& point : cone_rim(seen.world.lights[0], 2)) {
        EXPECT_NEAR(glm::distance(point, glm::dvec3(0, 1, 0)), 2, kArithmetic);
        EXPECT_NEAR(point.y, 1 - 2 * std::cos(20 * M_PI / 180), kArithmetic);
    }
}

TEST(SessionWorld, ALightThatWasNeverSetGetsACall) {
    const Seen seen(kProjection + kLookAt + kLit + on(0) + kSquare);
    EXPECT_EQ(command_of(seen.commands, seen.frame, seen.world, {}), std::nullopt);
    const Seen after = seen.dragged({}, {30, 10});
    ASSERT_EQ(after.commands.commands.size(), seen.commands.commands.size() + 1);
    EXPECT_EQ(after.commands.commands[0].id, CommandId::glLightfv);
    EXPECT_NE(after.world.lights[0].place_world, seen.world.lights[0].place_world);
}

TEST(SessionWorld, OfALoopOnlyTheCallThatSetTheLightChanges) {
    CommandList loop =
        read_scene(kLit + on(0) + on(1) + light(0, "GL_POSITION", "0, 0, 0, 1") +
                       light(1, "GL_POSITION", "1, 0, 0, 1") + light(1, "GL_POSITION", "2, 0, 0, 1") + kSquare,
                   "test.gl", "test");
    Place place;  // a loop's calls have one place
    for (Command& command : loop.commands) {
        if (command.id != CommandId::glLightfv) continue;
        if (place == Place{}) place = command.place;
        command.place = place;
    }
    const Seen seen(loop, {});
    ASSERT_EQ(seen.world.lights.size(), 2u);
    const Seen after = seen.dragged({1, false}, {0, -20});
    int changed = 0;
    for (std::size_t i = 0; i < loop.commands.size(); ++i)
        changed += loop.commands[i] == after.commands.commands[i] ? 0 : 1;
    EXPECT_EQ(changed, 1);
    expect_near(after.world.lights[0].place_world, {0, 0, 0});
    EXPECT_NE(after.world.lights[1].place_world, seen.world.lights[1].place_world);
}

// A lamp's own cube is where the lamp is; another object stays.
TEST(SessionWorld, WhatIsDrawnAtALampMovesWithIt) {
    const Seen seen(kProjection + kLookAt + kLit + on(0) + light(0, "GL_POSITION", "1.2, 0.5, 0.3, 1") + kSquare +
                    "glPushMatrix(); glTranslatef(1.2, 0.5, 0.3); glutSolidCube(0.1); glPopMatrix();"
                    "glTranslatef(1.2, 0.5, 0); glutSolidCube(0.2);");
    const Seen after = seen.dragged({0, false}, {20, 10});
    std::vector<const Command*> translations;
    for (const Command& command : after.commands.commands)
        if (command.id == CommandId::glTranslatef) translations.push_back(&command);
    ASSERT_EQ(translations.size(), 2u);
    const glm::dvec4& lamp = after.frame.typed_lights[after.world.lights[0].typed].position.value;
    EXPECT_NE(lamp.x, 1.2F);
    for (const int i : {0, 1, 2}) EXPECT_EQ(translations[0]->number(static_cast<std::size_t>(i)), lamp[i]);
    EXPECT_EQ(translations[1]->number(0), 1.2F);
}

}  // namespace
}  // namespace twinlight::session::session_world_test

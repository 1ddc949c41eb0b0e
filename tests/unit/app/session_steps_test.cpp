// The keys , and . in the window: the steps of a scene.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/session/camera.h"
#include "app/session/keys.h"
#include "app/session/steps.h"
#include "scene/command/text.h"

namespace twinlight::session::session_steps_test {
namespace {

const std::string kCamera = "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\n";
const std::string kSteps = R"(
#pragma twinlight step("Diffuse only")
glEnable(GL_LIGHT0);
#pragma twinlight step("With ambient")
glEnable(GL_LIGHT1);
#pragma twinlight step("With specular")
glEnable(GL_LIGHT2);
#pragma twinlight step()
glutSolidCube(1);
)";

std::shared_ptr<const CommandList> step_of(const std::string& text, const std::string& step) {
    return std::make_shared<const CommandList>(read_scene(text, "test.gl", "test", no_images, {.step = step}));
}

Session session_of(const std::string& text) {
    Session session(step_of(text, "1"));
    refresh(session, 640, 480);
    return session;
}

void show(Session& session, const std::string& text, int away) {
    show_step(session, step_of(text, neighbour_step(commands(session), away)));
    refresh(session, 640, 480);
}

bool enables(const Session& session, Enum light) {
    for (const Command& command : commands(session).commands)
        if (command.id == CommandId::glEnable && command.enumerant(0) == light) return true;
    return false;
}

TEST(SessionSteps, TheKeysAskForTheStepBeforeOrAfter) {
    Session session = session_of(kSteps);
    EXPECT_TRUE(press(session, '.'));
    EXPECT_EQ(session.step_requested, 1);
    EXPECT_TRUE(press(session, ','));
    EXPECT_EQ(session.step_requested, -1);
}

TEST(SessionSteps, FollowEachOtherInACircle) {
    Session session = session_of(kSteps);
    EXPECT_EQ(step_caption(commands(session)), "step 1 of 3: Diffuse only");
    EXPECT_EQ(neighbour_step(commands(session), -1), "3");
    show(session, kSteps, 1);
    EXPECT_EQ(step_caption(commands(session)), "step 2 of 3: With ambient");
    EXPECT_EQ(session.error, "");
    EXPECT_TRUE(enables(session, kGL_LIGHT1));
    EXPECT_FALSE(enables(session, kGL_LIGHT0));
    show(session, kSteps, 1);
    show(session, kSteps, 1);
    EXPECT_EQ(step_caption(commands(session)), "step 1 of 3: Diffuse only");
    EXPECT_EQ(step_caption(read_scene("glFlush();", "test.gl", "test")), "");
}

// In a scene with a camera and in one without.
TEST(SessionSteps, KeepTheCamera) {
    for (const std::string& text : {kCamera + kSteps, kSteps}) {
        Session session = session_of(text);
        orbit(session, start_drag(session), 40, 10);
        refresh(session, 640, 480);
        const glm::dmat4 moved = session.scene.frame.draws().back()->eye_from_object;
        show(session, text, 1);
        EXPECT_EQ(session.scene.frame.draws().back()->eye_from_object, moved);
        EXPECT_EQ(session.message, "") << "moving the camera is no change of the scene";
        press(session, 'r');
        refresh(session, 640, 480);
        EXPECT_NE(session.scene.frame.draws().back()->eye_from_object, moved);
        EXPECT_EQ(commands(session).commands, step_of(text, "2")->commands);
    }
}

TEST(SessionSteps, WithACameraOfTheirOwnKeepThatUntilItIsMoved) {
    const std::string text =
        "#pragma twinlight step(\"near\")\ngluLookAt(0, 0, 3, 0, 0, 0, 0, 1, 0);\n"
        "#pragma twinlight step(\"far\")\ngluLookAt(0, 0, 9, 0, 0, 0, 0, 1, 0);\n"
        "#pragma twinlight step()\nglutSolidCube(1);\n";
    Session session = session_of(text);
    show(session, text, 1);
    EXPECT_EQ(commands(session).commands[0].number(2), 9);
    zoom(session, 1);
    const std::vector<double> moved = commands(session).commands[0].arguments;
    show(session, text, 1);
    EXPECT_EQ(commands(session).commands[0].arguments, moved);
}

TEST(SessionSteps, CanBeUndoneWithTheChangesBeforeThem) {
    Session session = session_of(kCamera + kSteps);
    press(session, '8');
    ASSERT_TRUE(enables(session, kGL_LIGHT7));
    show(session, kCamera + kSteps, 1);
    EXPECT_FALSE(enables(session, kGL_LIGHT7));
    EXPECT_EQ(session.message, "the step as the file has it; z brings your changes back");
    press(session, 'z');
    EXPECT_EQ(step_caption(commands(session)), "step 1 of 3: Diffuse only");
    EXPECT_TRUE(enables(session, kGL_LIGHT7));
    press(session, 'r');
    EXPECT_EQ(commands(session).commands, step_of(kCamera + kSteps, "1")->commands) << "the step's own file";
    press(session, 'z');
    press(session, 'y');
    EXPECT_EQ(commands(session).step, 1U);
}

// Steps may differ in what the window does not show, so equal commands are still another step.
TEST(SessionSteps, WithEqualCommandsAreDifferent) {
    const std::string text = "#pragma twinlight step(\"a\")\n#pragma twinlight step(\"b\")\n";
    Session session = session_of(text);
    show(session, text, 1);
    EXPECT_EQ(step_caption(commands(session)), "step 2 of 2: b");
}

}  // namespace
}  // namespace twinlight::session::session_steps_test

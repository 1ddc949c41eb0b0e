// The window's edits: commands in, commands out, and what State makes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "app/session/edits.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session::session_edits_test {
namespace {

CommandList scene(const std::string& text) { return read_scene(text, "test.gl", "test"); }
Frame frame_of(const CommandList& commands) { return make_frame(commands, StateOptions{}); }
Draw first_draw(const CommandList& commands) { return *frame_of(commands).draws().at(0); }

std::vector<std::string> lines(const CommandList& commands) {
    std::vector<std::string> result;
    for (const Command& command : commands.commands) result.push_back(print_command(command));
    return result;
}

const std::string kTriangle = "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();\n";

// ---- Toggles ----

TEST(SessionEdits, TogglingALightFlipsEachOfItsSwitches) {
    const CommandList commands = scene("glEnable(GL_LIGHT1); glEnable(GL_LIGHT2); glDisable(GL_LIGHT1);" + kTriangle);
    const CommandList toggled = toggle_light(commands, 1);
    EXPECT_EQ(lines(toggled)[0], "glDisable(GL_LIGHT1);");
    EXPECT_EQ(lines(toggled)[1], "glEnable(GL_LIGHT2);");
    EXPECT_EQ(lines(toggled)[2], "glEnable(GL_LIGHT1);");
    EXPECT_TRUE(first_draw(toggled).lighting.lights[1].enabled);
    EXPECT_EQ(toggle_light(toggled, 1).commands, commands.commands);
}

TEST(SessionEdits, TogglingALightThatTheSceneNeverSwitchesEnablesItAtTheStart) {
    const CommandList commands = scene(kTriangle);
    const CommandList on = toggle_light(commands, 7);
    EXPECT_EQ(lines(on)[0], "glEnable(GL_LIGHT7);");
    EXPECT_TRUE(first_draw(on).lighting.lights[7].enabled);
    const CommandList off = toggle_light(on, 7);
    EXPECT_EQ(off.commands, commands.commands);
}

TEST(SessionEdits, ACapabilityThatIsInitiallyOnIsDisabledFirst) {
    EXPECT_EQ(lines(toggle_capability(scene(kTriangle), kGL_DITHER))[0], "glDisable(GL_DITHER);");
    EXPECT_EQ(lines(toggle_capability(scene(kTriangle), kGL_NORMALIZE))[0], "glEnable(GL_NORMALIZE);");
}

TEST(SessionEdits, TogglingTheLightModelFlipsEveryFormOfTheCall) {
    const CommandList commands = scene(
        "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);"
        "glLightModelfv(GL_LIGHT_MODEL_LOCAL_VIEWER, (GLfloat[]){0});" +
        kTriangle);
    const CommandList toggled = toggle_light_model(commands, kGL_LIGHT_MODEL_LOCAL_VIEWER);
    EXPECT_EQ(lines(toggled)[0], "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 0);");
    EXPECT_EQ(lines(toggled)[1], "glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1);");
    EXPECT_TRUE(first_draw(toggled).lighting.light_model.local_viewer);
    EXPECT_TRUE(
        first_draw(toggle_light_model(scene(kTriangle), kGL_LIGHT_MODEL_TWO_SIDE)).lighting.light_model.two_side);
}

// Every Draw of the scene is flat, or every one is smooth.
void expect_shade_model(const CommandList& commands, Enum mode) {
    for (const Draw* draw : frame_of(commands).draws()) EXPECT_EQ(draw->lighting.shade_model, mode);
}

TEST(SessionEdits, TogglingTheShadeModelChangesTheWholeScene) {
    for (const std::string& text :
         {kTriangle, "glShadeModel(GL_SMOOTH);" + kTriangle, kTriangle + "glShadeModel(GL_FLAT);" + kTriangle,
          kTriangle + "glShadeModel(GL_SMOOTH);" + kTriangle}) {
        SCOPED_TRACE(text);
        const CommandList flat = toggle_shade_model(scene(text));
        expect_shade_model(flat, kGL_FLAT);
        expect_shade_model(toggle_shade_model(flat), kGL_SMOOTH);
    }
    expect_shade_model(toggle_shade_model(scene("glShadeModel(GL_FLAT);" + kTriangle)), kGL_SMOOTH);
}

// ---- Tessellation ----

TEST(SessionEdits, TwoStepsDoubleSlicesAndStacks) {
    const CommandList commands = scene(
        "glutSolidSphere(1, 16, 8); glutSolidTorus(0.2, 1, 12, 24); glutSolidCube(1);\n"
        "#pragma twinlight shape(cylinder, 0.8, 2, 48)\n#pragma twinlight shape(cube, 1.3)\n"
        "GLUquadric* q = gluNewQuadric(); gluCylinder(q, 1, 1, 2, 20, 1);");
    const std::vector<std::string> finer = lines(change_tessellation(commands, 2));
    EXPECT_EQ(finer[0], "glutSolidSphere(1, 32, 16);");
    EXPECT_EQ(finer[1], "glutSolidTorus(0.2, 1, 24, 48);");
    EXPECT_EQ(finer[2], "glutSolidCube(1);");
    EXPECT_EQ(finer[3], "#pragma twinlight shape(cylinder, 0.8, 2, 96)");
    EXPECT_EQ(finer[4], "#pragma twinlight shape(cube, 1.3)");
    EXPECT_EQ(finer[6], "gluCylinder(quadric1, 1, 1, 2, 40, 2);");
}

TEST(SessionEdits, TessellationStaysAtThreeOrMoreAndWithinTheLimit) {
    CommandList commands = scene("glutSolidSphere(1, 16, 8); glutSolidCone(1, 1, 16, 1); glutSolidSphere(1, 0, 8);");
    for (int i = 0; i < 20; ++i) commands = change_tessellation(commands, -1);
    EXPECT_EQ(lines(commands)[0], "glutSolidSphere(1, 3, 3);");
    EXPECT_EQ(lines(commands)[1], "glutSolidCone(1, 1, 3, 1);");  // one stack is what the scene asked for
    EXPECT_EQ(lines(commands)[2].substr(0, 21), "glutSolidSphere(1, 0,");
    EXPECT_NE(change_tessellation(commands, 1).commands, commands.commands);
    for (int i = 0; i < 60; ++i) commands = change_tessellation(commands, 1);
    EXPECT_LE(commands.commands[0].number(1) * commands.commands[0].number(2), kMostShapeFacets);
    EXPECT_NO_THROW(frame_of(commands));
}

TEST(SessionEdits, NamesTheTessellation) {
    EXPECT_EQ(tessellation(scene("glutSolidSphere(1, 48, 24);")), "48 x 24");
    EXPECT_EQ(tessellation(scene("glutSolidSphere(1, 48, 24); glutSolidSphere(1, 8, 4);")), "8 x 4 to 48 x 24");
    EXPECT_EQ(tessellation(scene("#pragma twinlight shape(cone, 0.95, 2.1, 48)\n")), "48");
    EXPECT_EQ(tessellation(scene(kTriangle)), "");
}

// ---- Single commands ----

TEST(SessionEdits, SetsOneArgumentInItsOwnType) {
    const CommandList commands = scene("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45); glutSolidSphere(1, 16, 8);");
    EXPECT_EQ(lines(with_argument(commands, 0, 2, 0.1))[0], "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 0.1);");
    EXPECT_EQ(with_argument(commands, 0, 2, 0.1).commands[0].number(2), static_cast<double>(0.1f));
    EXPECT_EQ(lines(with_argument(commands, 1, 1, 17.6))[1], "glutSolidSphere(1, 18, 8);");
    EXPECT_EQ(with_argument(commands, 9, 0, 1).commands, commands.commands);
    EXPECT_EQ(with_argument(commands, 0, 9, 1).commands, commands.commands);
}

TEST(SessionEdits, AnotherPnameGetsItsInitialValues) {
    const CommandList commands = scene("glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){0.5, 0.5, 0.5, 1});" + kTriangle);
    // Both are colours, so the values stay.
    EXPECT_EQ(lines(with_argument(commands, 0, 1, kGL_SPECULAR))[0],
              "glLightfv(GL_LIGHT0, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1});");
    EXPECT_EQ(lines(with_argument(commands, 0, 1, kGL_SPOT_CUTOFF))[0],
              "glLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, (GLfloat[]){180});");
    EXPECT_EQ(lines(with_argument(commands, 0, 1, kGL_POSITION))[0],
              "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});");
    const CommandList scalar = scene("glMaterialf(GL_FRONT, GL_SHININESS, 20);" + kTriangle);
    EXPECT_EQ(with_argument(scalar, 0, 0, kGL_BACK).commands[0].number(2), 20);
}

TEST(SessionEdits, InsertsDeletesAndMoves) {
    const CommandList commands =
        scene("glEnable(GL_LIGHT0); glEnable(GL_LIGHT1); glEnable(GL_LIGHT2); glEnable(GL_LIGHT3);");
    const auto order = [](const CommandList& list) {
        std::string text;
        for (const Command& command : list.commands) text += std::to_string(command.enumerant(0) - kGL_LIGHT0);
        return text;
    };
    EXPECT_EQ(order(with_moved(commands, 0, 2)), "1203");
    EXPECT_EQ(order(with_moved(commands, 3, 0)), "3012");
    EXPECT_EQ(order(with_moved(commands, 0, 2, 2)), "2301");
    EXPECT_EQ(order(with_moved(commands, 2, 1, 2)), "0231");
    EXPECT_EQ(order(with_moved(commands, 1, 4)), "0123");
    EXPECT_EQ(order(with_moved(commands, 1, 3, 2)), "0123");
    EXPECT_EQ(order(without_command(commands, 1, 2)), "03");
    EXPECT_EQ(order(without_command(commands, 3, 9)), "012");
    EXPECT_EQ(order(without_command(commands, 4)), "0123");
    EXPECT_EQ(order(with_inserted(commands, 4, new_command(CommandId::glEnable, {kGL_LIGHT7}))), "01237");
}

TEST(SessionEdits, DuplicatesACallOrAGroupWithItsMemory) {
    const CommandList commands = scene("glEnable(GL_LIGHT0);" + kTriangle + "glEnable(GL_LIGHT1);");
    const CommandList call = with_duplicate(commands, 0);
    ASSERT_EQ(call.commands.size(), 8u);
    EXPECT_EQ(call.commands[1], commands.commands[0]);
    EXPECT_EQ(call.commands[2], commands.commands[1]);
    // glBegin, three vertices and glEnd, then the same again, then the rest.
    const CommandList group = with_duplicate(commands, 1);
    ASSERT_EQ(group.commands.size(), 12u);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(group.commands[1 + i], commands.commands[1 + i % 5]) << i;
    EXPECT_EQ(group.commands[11], commands.commands[6]);
    EXPECT_EQ(with_duplicate(commands, 7).commands, commands.commands);

    const CommandList image = scene(
        "GLubyte texel[] = {255, 0, 0, 255};"
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);\n" +
        kTriangle);
    ASSERT_TRUE(image.commands[0].memory);
    EXPECT_EQ(with_duplicate(image, 0).commands[1].memory, image.commands[0].memory);
}

TEST(SessionEdits, FindsTheGroupAndTheCommandOfEachDraw) {
    const CommandList commands = scene("glEnable(GL_LIGHT0);" + kTriangle + "glutSolidCube(1);");
    EXPECT_EQ(end_of_group(commands, 0), 0u);
    EXPECT_EQ(end_of_group(commands, 1), 5u);  // glBegin, three vertices, glEnd
    EXPECT_EQ(commands_of_draws(commands), (std::vector<std::size_t>{1, 6}));
    const CommandList listed = scene("GLuint l = glGenLists(1); glNewList(l, GL_COMPILE);" + kTriangle +
                                     "glEndList(); glCallList(l); glCallList(l);");
    const std::vector<std::size_t> draws = commands_of_draws(listed);
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(print_command(listed.commands[draws[0]]), "glCallList(1);");
    EXPECT_EQ(draws[1], draws[0] + 1);
}

TEST(SessionEdits, MovingUpAndDownGoesPastGroups) {
    const CommandList commands = scene("glEnable(GL_LIGHT0);" + kTriangle + "glEnable(GL_LIGHT1); glutSolidCube(1);");
    EXPECT_EQ(index_below(commands, 0), 5u);  // behind glBegin, three vertices and glEnd
    EXPECT_EQ(index_above(commands, 6), 1u);
    EXPECT_EQ(index_below(commands, 1), 2u);  // the group, past one command
    EXPECT_EQ(index_above(commands, 1), 0u);
    EXPECT_EQ(index_above(commands, 3), 2u);  // a vertex, within its group
    EXPECT_EQ(index_above(commands, 0), 0u);
    EXPECT_EQ(index_below(commands, 7), 7u);
    EXPECT_EQ(lines(with_moved(commands, 6, index_above(commands, 6)))[1], "glEnable(GL_LIGHT1);");
    EXPECT_EQ(lines(with_moved(commands, 0, index_below(commands, 0)))[5], "glEnable(GL_LIGHT0);");
}

// ---- Sentences ----

std::string light_words(const std::string& setup, int light) {
    return what_light_shows(frame_of(scene(setup + "glutSolidSphere(1, 16, 8);")), light);
}

TEST(SessionEdits, SaysWhatALightShows) {
    EXPECT_EQ(light_words("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);", 0), "GL_LIGHT0 is on");
    EXPECT_EQ(light_words("glEnable(GL_LIGHTING);", 0), "GL_LIGHT0 is off");
    EXPECT_EQ(light_words("glEnable(GL_LIGHT0);", 0), "GL_LIGHT0 is on, but GL_LIGHTING is off");
    EXPECT_EQ(light_words("glEnable(GL_LIGHTING); glEnable(GL_LIGHT1);", 1),
              "GL_LIGHT1 is on, but its colours are black (only GL_LIGHT0 starts white); set its GL_DIFFUSE");
    EXPECT_EQ(light_words("glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);"
                          "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0, 0, 0, 1});",
                          0),
              "GL_LIGHT0 is on, but its colours times the material's are 0");
}

TEST(SessionEdits, SaysWhatAKeyWithoutEffectShows) {
    const auto capability = [](const std::string& text, Enum cap) {
        const CommandList commands = scene(text);
        return what_capability_shows(commands, frame_of(commands), cap);
    };
    const std::string sphere = "glutSolidSphere(1, 16, 8);", lit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);";
    EXPECT_EQ(capability(lit + sphere, kGL_LIGHTING), "GL_LIGHTING is on");
    EXPECT_EQ(capability(sphere, kGL_LIGHTING), "GL_LIGHTING is off: every vertex has the colour that glColor gave it");
    EXPECT_EQ(capability(lit + "glEnable(GL_NORMALIZE);" + sphere, kGL_NORMALIZE),
              "GL_NORMALIZE is on; all normals have length 1 anyway");
    EXPECT_EQ(capability(lit + "glScalef(2, 2, 2); glEnable(GL_NORMALIZE);" + sphere, kGL_NORMALIZE),
              "GL_NORMALIZE is on");
    EXPECT_EQ(capability(sphere + "glEnable(GL_FOG);", kGL_FOG), "GL_FOG is off");  // enabled after the only Draw

    const auto model = [](const std::string& text, Enum pname) {
        return what_light_model_shows(frame_of(scene(text)), pname);
    };
    const std::string viewer = "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);";
    const std::string shiny = "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){1, 1, 1, 1});";
    EXPECT_EQ(model(viewer + sphere, kGL_LIGHT_MODEL_LOCAL_VIEWER),
              "GL_LIGHT_MODEL_LOCAL_VIEWER is on, but nothing is lit");
    EXPECT_EQ(model(viewer + lit + sphere, kGL_LIGHT_MODEL_LOCAL_VIEWER),
              "GL_LIGHT_MODEL_LOCAL_VIEWER is on, but nothing has a highlight");
    EXPECT_EQ(model(viewer + lit + shiny + sphere, kGL_LIGHT_MODEL_LOCAL_VIEWER), "GL_LIGHT_MODEL_LOCAL_VIEWER is on");
    EXPECT_EQ(model(lit + "glEnable(GL_CULL_FACE);" + sphere, kGL_LIGHT_MODEL_TWO_SIDE),
              "GL_LIGHT_MODEL_TWO_SIDE is off, but all back faces are culled");
}

// In `lab` GL_LIGHT0 is the sun, 1 to 6 the points and 7 the spot at the camera: each can be switched and is seen.
TEST(SessionEdits, EveryLightOfTheLabCanBeSwitched) {
    const CommandList lab = *load_commands("lab");
    for (int light = 0; light < kMaxLights; ++light) {
        EXPECT_EQ(what_light_shows(frame_of(lab), light), light_name(light) + " is on");
        EXPECT_EQ(what_light_shows(frame_of(toggle_light(lab, light)), light), light_name(light) + " is off");
    }
}

}  // namespace
}  // namespace twinlight::session::session_edits_test

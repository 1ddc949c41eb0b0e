// What the window knows about the arguments of commands. The expected values are GL's tables; State raises the errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/session/arguments.h"
#include "app/session/edits.h"
#include "scene/command/print_parts.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session::session_arguments_test {
namespace {

Command command(const std::string& text) { return read_scene(text, "test.gl", "test").commands.at(0); }

std::vector<std::string> names(const std::string& text, std::size_t argument) {
    std::vector<std::string> result;
    for (const Choice& choice : legal_choices(command(text), argument)) result.push_back(choice.name);
    return result;
}

TEST(SessionArguments, NamesTheElementsOfColoursAndVectors) {
    const auto name = [](const std::string& text, std::size_t i) { return argument_info(command(text), i).name; };
    const std::string diffuse = "glLightfv(GL_LIGHT0, GL_DIFFUSE, (GLfloat[]){1, 1, 1, 1});";
    EXPECT_EQ(name(diffuse, 0), "light");
    EXPECT_EQ(name(diffuse, 1), "pname");
    EXPECT_EQ(name(diffuse, 2), "red");
    EXPECT_EQ(name(diffuse, 5), "alpha");
    EXPECT_EQ(name("glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 1, 1, 1});", 5), "w");
    EXPECT_EQ(name("glLightfv(GL_LIGHT0, GL_SPOT_CUTOFF, (GLfloat[]){20});", 2), "GL_SPOT_CUTOFF");
    EXPECT_EQ(name("glMaterialf(GL_FRONT, GL_SHININESS, 20);", 2), "GL_SHININESS");
    EXPECT_EQ(name("glColor3fv((GLfloat[]){1, 1, 1});", 2), "blue");
    EXPECT_EQ(name("glVertex3fv((GLfloat[]){1, 1, 1});", 2), "z");
    EXPECT_EQ(name("glMultMatrixd((GLdouble[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});", 4), "m[4]");
    EXPECT_TRUE(argument_info(command(diffuse), 2).is_color);
    EXPECT_FALSE(argument_info(command(diffuse), 0).is_color);
}

TEST(SessionArguments, InitialValuesAreGls) {
    const auto initial = [](const std::string& text, std::size_t i) { return argument_info(command(text), i).initial; };
    const std::string white = "(GLfloat[]){1, 1, 1, 1});";
    EXPECT_EQ(initial("glLightfv(GL_LIGHT0, GL_DIFFUSE, " + white, 2), 1);
    EXPECT_EQ(initial("glLightfv(GL_LIGHT1, GL_DIFFUSE, " + white, 2), 0);
    EXPECT_EQ(initial("glLightfv(GL_LIGHT1, GL_DIFFUSE, " + white, 5), 1);
    EXPECT_EQ(initial("glLightfv(GL_LIGHT1, GL_POSITION, " + white, 4), 1);
    EXPECT_EQ(initial("glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 20);", 2), 180);
    EXPECT_EQ(initial("glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 20);", 1), std::nullopt);
    EXPECT_EQ(initial("glMaterialfv(GL_FRONT, GL_AMBIENT, " + white, 2), 0.2);
    EXPECT_EQ(initial("glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, " + white, 2), std::nullopt);
    EXPECT_EQ(initial("glShadeModel(GL_FLAT);", 0), kGL_SMOOTH);
    EXPECT_EQ(initial("glColor3ub(0, 0, 0);", 1), 255);
    EXPECT_EQ(initial("glNormal3b(0, 0, 0);", 2), 127);
    EXPECT_EQ(initial("glFogi(GL_FOG_MODE, GL_LINEAR);", 1), kGL_EXP);
    EXPECT_EQ(initial("glTranslatef(1, 0, 0);", 0), std::nullopt);
    const Command reset = with_initial_values(command("glLightfv(GL_LIGHT0, GL_POSITION, " + white));
    EXPECT_EQ(print_command(reset), "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});");
}

// A fresh State that gets these values stays as it was, so the table here is that of State.
TEST(SessionArguments, SettingInitialValuesChangesNothing) {
    const char* const kPnames[] = {"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR", "GL_POSITION"};
    for (const char* pname : kPnames) {
        for (const char* light : {"GL_LIGHT0", "GL_LIGHT5"}) {
            const std::string text = std::string("glLightfv(") + light + ", " + pname + ", (GLfloat[]){9, 9, 9, 9});";
            State state;
            state.apply(with_initial_values(command(text)));
            const Enum name = command(text).enumerant(0);
            EXPECT_EQ(state.get_light(name, command(text).enumerant(1)),
                      State().get_light(name, command(text).enumerant(1)));
        }
    }
    State state;
    for (const char* text :
         {"glColor4f(9, 9, 9, 9);", "glNormal3f(9, 9, 9);", "glLineWidth(9);", "glPointSize(9);",
          "glDepthFunc(GL_NEVER);", "glCullFace(GL_FRONT);", "glFrontFace(GL_CW);", "glBlendFunc(GL_ZERO, GL_ZERO);",
          "glAlphaFunc(GL_NEVER, 1);", "glClearColor(1, 1, 1, 1);"}) {
        SCOPED_TRACE(text);
        Command reset = with_initial_values(command(text));
        EXPECT_NE(reset, command(text));
        state.apply(reset);
    }
    const Attributes initial = State().attributes();
    EXPECT_EQ(state.attributes().current.color, initial.current.color);
    EXPECT_EQ(state.attributes().current.normal_object, initial.current.normal_object);
    EXPECT_EQ(state.raster().line_width, initial.raster.line_width);
    EXPECT_EQ(state.raster().point_size, initial.raster.point_size);
    EXPECT_EQ(state.raster().depth_func, initial.raster.depth_func);
    EXPECT_EQ(state.raster().cull_face, initial.raster.cull_face);
    EXPECT_EQ(state.raster().front_face, initial.raster.front_face);
    EXPECT_EQ(state.attributes().fragment.blend_src, initial.fragment.blend_src);
    EXPECT_EQ(state.attributes().fragment.blend_dst, initial.fragment.blend_dst);
    EXPECT_EQ(state.attributes().fragment.alpha_func, initial.fragment.alpha_func);
    EXPECT_EQ(state.attributes().clear.clear_color, initial.clear.clear_color);
}

TEST(SessionArguments, ChoicesAreTheLegalNames) {
    EXPECT_EQ(names("glShadeModel(GL_FLAT);", 0), (std::vector<std::string>{"GL_FLAT", "GL_SMOOTH"}));
    EXPECT_EQ(names("glMaterialf(GL_FRONT, GL_SHININESS, 1);", 0),
              (std::vector<std::string>{"GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK"}));
    EXPECT_EQ(names("glMaterialf(GL_FRONT, GL_SHININESS, 1);", 1), (std::vector<std::string>{"GL_SHININESS"}));
    EXPECT_EQ(names("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 1);", 1).size(), 5u);  // the scalars of table 2.10
    EXPECT_EQ(names("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 1);", 0).size(), 8u);
    EXPECT_EQ(names("glBegin(GL_QUADS);", 0).size(), 10u);
    EXPECT_EQ(names("glBegin(GL_QUADS);", 0)[4], "GL_TRIANGLES");
    EXPECT_EQ(names("glFogi(GL_FOG_MODE, GL_LINEAR);", 1),
              (std::vector<std::string>{"GL_LINEAR", "GL_EXP", "GL_EXP2"}));
    EXPECT_EQ(names("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);", 1), (std::vector<std::string>{"0", "1"}));
    EXPECT_EQ(names("glDepthMask(GL_TRUE);", 0), (std::vector<std::string>{"GL_FALSE", "GL_TRUE"}));
    EXPECT_EQ(names("glClear(GL_COLOR_BUFFER_BIT);", 0).size(), 4u);
    EXPECT_EQ(names("#pragma twinlight specular(reflection)\n", 0),
              (std::vector<std::string>{"half_vector", "reflection"}));
    const std::vector<std::string> capabilities = names("glEnable(GL_LIGHTING);", 0);
    for (const char* name : {"GL_LIGHTING", "GL_LIGHT7", "GL_NORMALIZE", "GL_STENCIL_TEST"})
        EXPECT_TRUE(std::ranges::find(capabilities, name) != capabilities.end()) << name;
    EXPECT_TRUE(names("glTranslatef(1, 0, 0);", 0).empty());
}

TEST(SessionArguments, DraggingStaysLegal) {
    const auto nearest = [](const std::string& text, std::size_t i, double value) {
        return nearest_legal(command(text), i, value);
    };
    const std::string cutoff = "glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45);";
    EXPECT_EQ(nearest(cutoff, 2, 60), 60);
    EXPECT_EQ(nearest(cutoff, 2, 100), 90);
    EXPECT_EQ(nearest(cutoff, 2, 150), 180);
    EXPECT_EQ(nearest(cutoff, 2, 200), 180);
    EXPECT_EQ(nearest(cutoff, 2, -5), 0);
    EXPECT_EQ(nearest("glMaterialf(GL_FRONT, GL_SHININESS, 1);", 2, 200), 128);
    EXPECT_EQ(nearest("glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);", 2, -1), 0);
    EXPECT_EQ(nearest("glClearColor(0, 0, 0, 0);", 0, 2), 1);
    EXPECT_EQ(nearest("glColor3ub(0, 0, 0);", 0, 300), 255);
    EXPECT_EQ(nearest("glTranslatef(0, 0, 0);", 0, -300), -300);
    EXPECT_EQ(nearest("glutSolidSphere(1, 16, 8);", 1, -4), 1);
    // Every limit that is said not to be a clamp is one at which State raises an error just beyond.
    for (const std::string& text :
         {cutoff, std::string("glMaterialf(GL_FRONT, GL_SHININESS, 1);"),
          std::string("glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 1);"), std::string("glFogf(GL_FOG_DENSITY, 1);")}) {
        const Command given = command(text);
        const std::size_t last = given.arguments.size() - 1;
        const ArgumentInfo info = argument_info(given, last);
        EXPECT_EQ(error_of(changed_argument(given, last, info.smallest)), "") << text;
        EXPECT_NE(error_of(changed_argument(given, last, info.smallest - 1)), "") << text;
        if (std::isfinite(info.largest)) {
            EXPECT_NE(error_of(changed_argument(given, last, info.largest + 1)), "") << text;
        }
    }
}

TEST(SessionArguments, AnIllegalValueHasGlsError) {
    EXPECT_EQ(error_of(command("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);")),
              "GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180 (GL_INVALID_VALUE)");
    EXPECT_EQ(error_of(command("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 90);")), "");
    EXPECT_EQ(error_of(command("glVertex2f(0, 0);")), "");  // its place is wrong, not its value
}

TEST(SessionArguments, TheHelpSaysMeaningInitialValueAndSection) {
    EXPECT_EQ(argument_help(command("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45);"), 2),
              "half angle of the cone in degrees, 0 to 90, or 180 for no cone; initially 180; 2.14.1");
    EXPECT_EQ(argument_help(command("glShadeModel(GL_FLAT);"), 0),
              "one colour for each polygon (GL_FLAT), or interpolated ones (GL_SMOOTH); initially GL_SMOOTH; 2.14.7");
    EXPECT_EQ(argument_help(command("glEnable(GL_NORMALIZE);"), 0),
              "normals get length 1 after the modelview matrix; 2.11.3");
    EXPECT_EQ(argument_help(command("glDisable(GL_LIGHT3);"), 0), "a light; it shows only with GL_LIGHTING; 2.14.1");
    EXPECT_EQ(argument_help(command("glIndexMask(1);"), 0), "glIndexMask(mask)");  // no row: the usage
}

// The built-in scenes are what users open first: each number and name in them has its own line of help.
TEST(SessionArguments, EveryArgumentOfTheBuiltInScenesHasHelp) {
    for (const char* name : {"report", "lab", "spectral"}) {
        const auto scene = load_commands(name);
        for (const Command& given : scene->commands) {
            for (std::size_t i = 0; i < given.arguments.size(); ++i) {
                if (argument_info(given, i).editing == Editing::kFixed) continue;
                EXPECT_NE(argument_help(given, i), given.sig().usage()) << print_command(given);
            }
        }
    }
}

// ---- The parts of a printed command ----

TEST(PrintParts, AreTheTextOfTheCommand) {
    int commands = 0;
    for (const char* name : {"commands", "report", "lab", "legacy", "spectral"}) {
        const auto scene = load_commands(name);
        for (const Command& given : scene->commands) {
            if (given.memory && given.id != CommandId::pragma_texture) continue;
            std::string text;
            for (const PrintedPart& part : print_parts(given, 1000)) text += part.text;
            EXPECT_EQ(text, print_command(given));
            ++commands;
        }
    }
    EXPECT_GT(commands, 1000);
}

TEST(PrintParts, NameTheirArguments) {
    const Command given = command("glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){1, 2, 3});");
    std::vector<std::string> arguments;
    for (const PrintedPart& part : print_parts(given)) {
        if (!part.argument) continue;
        EXPECT_EQ(*part.argument, arguments.size());
        arguments.push_back(part.text);
    }
    EXPECT_EQ(arguments, (std::vector<std::string>{"GL_LIGHT0", "GL_SPOT_DIRECTION", "1", "2", "3"}));
    std::string folded;
    for (const PrintedPart& part : print_parts(given, 2)) folded += part.text;
    EXPECT_EQ(folded, "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[3]){...});");
}

// ---- What was changed ----

TEST(SessionArguments, ChangedArgumentsAreThoseThatDifferFromTheFile) {
    const CommandList opened =
        read_scene("glEnable(GL_LIGHT0);\nglColor3f(1, 0.5, 0);\nglutSolidCube(1);\n", "test.gl", "test");
    CommandList now = with_argument(opened, 1, 1, 0.25);
    now = with_moved(now, 1, 0);
    now = with_inserted(now, 0, new_command(CommandId::glEnable, {kGL_LIGHTING}));
    const auto matches = opened_commands(opened, now);
    ASSERT_EQ(matches.size(), 4u);
    EXPECT_EQ(matches[0], std::nullopt);
    EXPECT_EQ(matches[1], 1u);
    EXPECT_EQ(matches[2], 0u);
    EXPECT_EQ(matches[3], 2u);
    EXPECT_TRUE(is_changed(&opened.commands[1], now.commands[1], 1));
    EXPECT_FALSE(is_changed(&opened.commands[1], now.commands[1], 0));
    EXPECT_TRUE(is_changed(nullptr, now.commands[0], 0));
}

}  // namespace
}  // namespace twinlight::session::session_arguments_test

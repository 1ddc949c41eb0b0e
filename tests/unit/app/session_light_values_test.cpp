// The lights panel's values: what lights a drawing command, and which command set it. State is asked for the values; the
// expected origins are read off the scenes here.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/session/edits.h"
#include "app/session/light_values.h"
#include "app/session/presets.h"
#include "scene/command/text.h"
#include "scene/scenes/load.h"
#include "scene/state/state.h"

namespace twinlight::session::session_light_values_test {
namespace {

CommandList scene(const std::string& text) { return read_scene(text, "test.gl", "test"); }
const std::string kCube = "glutSolidCube(1);\n";

// The values of the last drawing command.
LightingValues values_of(const CommandList& commands) {
    const auto values = lighting_values(commands, drawing_commands(commands).back().command);
    return values.value();
}

std::string call(const CommandList& commands, const SetBy& by) {
    return by.command ? print_command(commands.commands.at(*by.command)) : "none";
}

const SetBy& front_of(const LightingValues& values, Enum pname) { return values.front.set_by_of(pname); }

TEST(SessionLightValues, NamesTheDrawingCommands) {
    const CommandList commands = scene(
        "glEnable(GL_LIGHTING);\nglutSolidCylinder(1, 1, 8, 8);\nglDisable(GL_LIGHTING);\n"
        "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();\n"
        "#pragma twinlight shape(cube, 1)\n");
    const std::vector<DrawingCommand> drawing = drawing_commands(commands);
    ASSERT_EQ(drawing.size(), 3u);
    EXPECT_EQ(drawing[0].name, "glutSolidCylinder, line 2");
    EXPECT_TRUE(drawing[0].is_lit);
    EXPECT_EQ(drawing[1].name, "glBegin(GL_TRIANGLES), line 4");
    EXPECT_FALSE(drawing[1].is_lit);
    EXPECT_EQ(drawing[2].name, "shape(cube), line 5");
    const Frame frame = make_frame(commands, StateOptions{});
    EXPECT_EQ(drawing[2].first_draw + drawing[2].draw_count, frame.draws().size());
    EXPECT_EQ(drawing[1].first_draw, drawing[0].draw_count);
    // A command belongs to what it prepares; a vertex to its glBegin.
    const auto of = [&](std::size_t command) { return drawing_command_of(drawing, command); };
    EXPECT_EQ(of(0), 0u);
    EXPECT_EQ(of(1), 0u);
    EXPECT_EQ(of(2), 1u);
    EXPECT_EQ(of(drawing[1].command), 1u);
    EXPECT_EQ(of(drawing[2].command), 2u);
    EXPECT_EQ(of(99), 2u);
}

TEST(SessionLightValues, ShowsTypedAndStoredPositions) {
    const CommandList commands = scene(
        "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0);\n"
        "glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){1, 2, 3, 1});\n"
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT2);\n" +
        kCube);
    const LightingValues values = values_of(commands);
    EXPECT_EQ(values.lights[2].typed.position.value, glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(values.lights[2].stored.position_eye, glm::dvec4(1, 2, -2, 1));  // 5 nearer to the eye
    EXPECT_EQ(call(commands, values.lights[2].enabled), "glEnable(GL_LIGHT2);");
    EXPECT_EQ(values.lights[2].set_by_of(kGL_POSITION).source, Source::kCommand);
    EXPECT_EQ(values.lights[2].set_by_of(kGL_SPOT_DIRECTION).source, Source::kInitial);
    EXPECT_EQ(values.lights[2].typed.spot_direction.value, glm::dvec3(0, 0, -1));
}

TEST(SessionLightValues, FindsTheCallOfEachMaterialProperty) {
    const CommandList commands = scene(
        "glEnable(GL_LIGHTING); glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});\n"
        "glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0, 1, 0, 1});\n" +
        kCube);
    const LightingValues values = values_of(commands);
    EXPECT_EQ(call(commands, front_of(values, kGL_DIFFUSE)),
              "glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});");
    EXPECT_EQ(call(commands, values.back.set_by_of(kGL_DIFFUSE)),
              "glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0, 1, 0, 1});");
    EXPECT_EQ(front_of(values, kGL_AMBIENT).source, Source::kInitial);
    EXPECT_EQ(values.back.material.ambient, glm::dvec4(0, 1, 0, 1));
}

TEST(SessionLightValues, SaysWhichSourceOfTheColourRules) {
    const std::string color = "glEnable(GL_LIGHTING);\nglColor3f(1, 0, 0);\n";
    const std::string material = "glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){0, 0, 1, 1});\n";
    const auto source = [&](const std::string& text) {
        return front_of(values_of(scene(text + kCube)), kGL_DIFFUSE).source;
    };
    const auto words = [&](const std::string& text) { return color_material_words(values_of(scene(text + kCube))); };

    EXPECT_EQ(source(color + material), Source::kCommand);
    EXPECT_EQ(words(color + material), "glColor has no effect here, because GL_COLOR_MATERIAL is off");
    EXPECT_EQ(source(color + "glEnable(GL_COLOR_MATERIAL);" + material), Source::kColor);
    EXPECT_EQ(words(color + "glEnable(GL_COLOR_MATERIAL);" + material),
              "GL_AMBIENT and GL_DIFFUSE of both faces follow glColor; glMaterial cannot change them");
    EXPECT_EQ(
        source(color + "glColorMaterial(GL_FRONT_AND_BACK, GL_SPECULAR); glEnable(GL_COLOR_MATERIAL);" + material),
        Source::kCommand);
    EXPECT_EQ(words(color + "glColorMaterial(GL_FRONT, GL_SPECULAR); glEnable(GL_COLOR_MATERIAL);"),
              "GL_SPECULAR of the front follows glColor; glMaterial cannot change it");
    // 2.14.3: after glDisable the material keeps the last colour.
    EXPECT_EQ(source(color + "glEnable(GL_COLOR_MATERIAL); glDisable(GL_COLOR_MATERIAL);"), Source::kOldColor);
    EXPECT_EQ(words(kCube), "not lit: the colour is that of glColor");
    EXPECT_EQ(words("glEnable(GL_LIGHTING);"), "off: glMaterial rules");

    const LightingValues values = values_of(scene(color + "glEnable(GL_COLOR_MATERIAL);" + kCube));
    EXPECT_EQ(values.front.material.diffuse, glm::dvec4(1, 0, 0, 1));
}

TEST(SessionLightValues, FollowsAttributeStacksAndDisplayLists) {
    const CommandList pushed = scene(
        "glEnable(GL_LIGHTING); glMaterialf(GL_FRONT, GL_SHININESS, 10); glPushAttrib(GL_LIGHTING_BIT);\n"
        "glMaterialf(GL_FRONT, GL_SHININESS, 20); glEnable(GL_LIGHT3); glPopAttrib();\n" +
        kCube);
    const LightingValues values = values_of(pushed);
    EXPECT_EQ(call(pushed, front_of(values, kGL_SHININESS)), "glMaterialf(GL_FRONT, GL_SHININESS, 10);");
    EXPECT_EQ(values.lights[3].enabled.source, Source::kInitial);

    const CommandList listed = scene(
        "GLuint l = glGenLists(1); glNewList(l, GL_COMPILE); glMaterialf(GL_FRONT, GL_SHININESS, 30); glEndList();\n"
        "glEnable(GL_LIGHTING); glCallList(l);\n" +
        kCube);
    const SetBy by = front_of(values_of(listed), kGL_SHININESS);
    EXPECT_EQ(by.source, Source::kOther);
    EXPECT_EQ(call(listed, by), "glCallList(1);");
}

// ---- Edits ----

TEST(SessionLightValues, SettingALightParameterEditsItsCallOrInsertsOne) {
    const CommandList commands = scene(
        "glRotatef(90, 1, 0, 0);\nglLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 1, 0, 1});\n"
        "glEnable(GL_LIGHT0); glEnable(GL_LIGHTING); glLoadIdentity();\n" +
        kCube);
    const CommandList moved = with_light_parameter(commands, values_of(commands), 0, kGL_POSITION, {2, 3, 4, 1});
    EXPECT_EQ(print_command(moved.commands[1]), "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});");
    EXPECT_EQ(moved.commands.size(), commands.commands.size());
    // A new call comes after the light's other calls, with the same matrix.
    const CommandList spot = with_light_parameter(commands, values_of(commands), 0, kGL_SPOT_DIRECTION, {0, -1, 0});
    EXPECT_EQ(print_command(spot.commands[2]), "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, -1, 0});");
    const CommandList cutoff = with_light_parameter(commands, values_of(commands), 5, kGL_SPOT_CUTOFF, {30});
    EXPECT_EQ(values_of(cutoff).lights[5].stored.spot_cutoff_deg, 30);
}

TEST(SessionLightValues, SettingAMaterialEditsItsCallOrInsertsOne) {
    const CommandList commands = scene(
        "glEnable(GL_LIGHTING); glMaterialiv(GL_FRONT, GL_SPECULAR, (GLint[]){0, 0, 0, 0});\n"
        "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){1, 1, 1, 1});\n" +
        kCube);
    const LightingValues values = values_of(commands);
    const CommandList specular = with_material_parameter(commands, values, kGL_FRONT, kGL_SPECULAR, {1, 0.5, 0, 1});
    EXPECT_EQ(specular.commands.size(), commands.commands.size());
    EXPECT_EQ(values_of(specular).front.material.specular, glm::dvec4(1, 0.5, 0, 1));
    const CommandList both =
        with_material_parameter(commands, values, kGL_FRONT, kGL_AMBIENT_AND_DIFFUSE, {0, 1, 0, 1});
    EXPECT_EQ(values_of(both).front.material.ambient, glm::dvec4(0, 1, 0, 1));
    EXPECT_EQ(both.commands.size(), commands.commands.size());
    const CommandList ambient = with_material_parameter(commands, values, kGL_FRONT, kGL_AMBIENT, {0, 0, 1, 1});
    EXPECT_EQ(values_of(ambient).front.material.ambient, glm::dvec4(0, 0, 1, 1));
    EXPECT_EQ(values_of(ambient).front.material.diffuse, glm::dvec4(1, 1, 1, 1));
    const CommandList shininess = with_material_parameter(commands, values, kGL_FRONT_AND_BACK, kGL_SHININESS, {50});
    EXPECT_EQ(values_of(shininess).back.material.shininess, 50);
}

TEST(SessionLightValues, SettingTheLightModelEditsItsCallOrInsertsOne) {
    const CommandList commands = scene(
        "glEnable(GL_LIGHTING); glEnable(GL_COLOR_MATERIAL);\n"
        "glLightModeliv(GL_LIGHT_MODEL_AMBIENT, (GLint[]){0, 0, 0, 0});\n" +
        kCube);
    const LightingValues values = values_of(commands);
    const CommandList ambient = with_light_model(commands, values, kGL_LIGHT_MODEL_AMBIENT, {0.5, 0.25, 0, 1});
    EXPECT_EQ(ambient.commands.size(), commands.commands.size());
    EXPECT_EQ(values_of(ambient).state.light_model.ambient, glm::dvec4(0.5, 0.25, 0, 1));
    const CommandList separate =
        with_light_model(commands, values, kGL_LIGHT_MODEL_COLOR_CONTROL, {kGL_SEPARATE_SPECULAR_COLOR});
    EXPECT_EQ(print_command(separate.commands[0]),
              "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);");
    // glColorMaterial before glEnable, so that no property takes the colour in between (2.14.3).
    const CommandList tracked = with_color_material(commands, values, kGL_FRONT, kGL_SPECULAR);
    EXPECT_EQ(print_command(tracked.commands[1]), "glColorMaterial(GL_FRONT, GL_SPECULAR);");
    const CommandList again = with_color_material(tracked, values_of(tracked), kGL_BACK, kGL_EMISSION);
    EXPECT_EQ(again.commands.size(), tracked.commands.size());
    EXPECT_EQ(values_of(again).state.color_material.mode, kGL_EMISSION);
}

// ---- Presets ----

TEST(SessionPresets, AreTheTwentyFourOfTeapots) {
    EXPECT_EQ(material_presets().size(), 24u);
    std::set<std::string_view> names;
    for (const MaterialPreset& preset : material_presets()) {
        names.insert(preset.name);
        EXPECT_GE(preset.shininess, 0);
        EXPECT_LE(preset.shininess, 128);
    }
    EXPECT_EQ(names.size(), 24u);
}

bool has_material(const Material& material, const MaterialPreset& preset) {
    const auto equal = [](const glm::dvec4& a, const std::array<double, 3>& b) {
        return glm::vec4(a) == glm::vec4(glm::dvec4(b[0], b[1], b[2], 1));
    };
    return equal(material.ambient, preset.ambient) && equal(material.diffuse, preset.diffuse) &&
           equal(material.specular, preset.specular) &&
           static_cast<float>(material.shininess) == static_cast<float>(preset.shininess);
}

// As floats: State has GL's initial 0.2 and 0.8 as doubles, and glMaterialfv restores them as floats.
bool same_material(const Material& a, const Material& b) {
    return glm::vec4(a.ambient) == glm::vec4(b.ambient) && glm::vec4(a.diffuse) == glm::vec4(b.diffuse) &&
           glm::vec4(a.specular) == glm::vec4(b.specular) && glm::vec4(a.emission) == glm::vec4(b.emission) &&
           static_cast<float>(a.shininess) == static_cast<float>(b.shininess);
}

// Each lit drawing command of the scenes gets gold; all others keep their materials.
void expect_local(const CommandList& commands) {
    const MaterialPreset& gold = material_presets()[10];
    ASSERT_EQ(gold.name, "gold");
    const Frame before = make_frame(commands, StateOptions{});
    for (const DrawingCommand& drawing : drawing_commands(commands)) {
        if (!drawing.is_lit) continue;
        SCOPED_TRACE(drawing.name);
        const Frame after = make_frame(with_preset(commands, drawing.command, gold), StateOptions{});
        ASSERT_EQ(after.draws().size(), before.draws().size());
        for (std::size_t i = 0; i < after.draws().size(); ++i) {
            const bool is_here = i >= drawing.first_draw && i < drawing.first_draw + drawing.draw_count;
            const LightingState &now = after.draws()[i]->lighting, &was = before.draws()[i]->lighting;
            EXPECT_EQ(is_here, has_material(now.front, gold)) << i;
            EXPECT_EQ(is_here, has_material(now.back, gold)) << i;
            if (is_here) continue;
            EXPECT_TRUE(same_material(now.front, was.front)) << i;
            EXPECT_TRUE(same_material(now.back, was.back)) << i;
        }
    }
}

TEST(SessionPresets, ChangeOneDrawingCommandAndNoOther) {
    expect_local(*load_commands("report"));
    expect_local(*load_commands("lab"));
    expect_local(
        scene("glEnable(GL_LIGHTING); glMaterialf(GL_FRONT, GL_SHININESS, 10); glPushAttrib(GL_LIGHTING_BIT);\n" +
              kCube + "glPopAttrib(); glMaterialfv(GL_BACK, GL_SPECULAR, (GLfloat[]){1, 0, 0, 1});\n" + kCube + kCube +
              "glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){1, 0, 0, 1});\n" + kCube));
}

TEST(SessionPresets, ReplaceTheCallsThatServedOnlyThisCommand) {
    const CommandList commands =
        scene("glEnable(GL_LIGHTING);\nglMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0, 0, 1});\n" + kCube);
    const CommandList once = with_preset(commands, 2, material_presets()[0]);
    EXPECT_EQ(once.commands.size(), 6u);  // four calls instead of one
    const CommandList twice = with_preset(once, drawing_commands(once).front().command, material_presets()[1]);
    EXPECT_EQ(twice.commands.size(), 6u);
}

}  // namespace
}  // namespace twinlight::session::session_light_values_test

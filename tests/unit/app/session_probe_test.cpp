// The window's probe: the sums that it shows add up to the colours that it shows.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <string>

#include "app/session/probe.h"
#include "render/reference/reference.h"
#include "scene/command/text.h"
#include "scene/state/state.h"

namespace twinlight::session::session_probe_test {
namespace {

// Rounding of some twenty operations on numbers below 10.
constexpr double kRounding = 1e-14;

Scene scene_of(const std::string& text) {
    StateOptions options;
    options.width = options.height = 64;
    return make_scene(std::make_shared<CommandList>(read_scene(text, "test.gl", "test")), options);
}

// Faces the viewer and fills the picture. Its light shines along the normals.
const std::string kState =
    "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0);\n"
    "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});\n"
    "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5, 0.25, 1}); glNormal3f(0, 0, 1);\n";
const std::string kSquare = "glRectf(-1, -1, 1, 1);\n";

void expect_color(const reference::Vec& actual, double red, double green, double blue) {
    EXPECT_NEAR(actual.x, red, kRounding);
    EXPECT_NEAR(actual.y, green, kRounding);
    EXPECT_NEAR(actual.z, blue, kRounding);
}

std::vector<SumRow> rows_at(const Scene& scene, std::optional<int> light, const Probe& probe = {.x = 32, .y = 32}) {
    const ProbeAnswer answer = answer_probe(scene, {}, probe);
    EXPECT_EQ(answer.trouble, "");
    const std::vector<ProbePoint> points = points_of(scene, answer, main_fragment(fragments_of(scene, answer)));
    EXPECT_FALSE(points.empty());
    return points.empty() ? std::vector<SumRow>{} : sum_rows(points[0].derivation, light);
}

// Ambient: the initial material's 0.2 times the scene's 0.2. Diffuse: the material's, as n.VP is 1 and the light white.
TEST(SessionProbe, AddsUpTheEquation) {
    const std::vector<SumRow> rows = rows_at(scene_of(kState + kSquare), {});
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0].what, "emission");
    expect_color(rows[0].color, 0, 0, 0);
    EXPECT_EQ(rows[1].what, "ambient");
    EXPECT_NEAR(rows[1].color.x, 0.04, 1e-8);  // GL keeps 0.2 as a float
    EXPECT_EQ(rows[2].what, "GL_LIGHT0");
    expect_color(rows[2].color, 1, 0.5, 0.25);
    EXPECT_EQ(rows[3].what, "c_pri");
    EXPECT_EQ(rows[3].sign, "=");
    expect_color(rows[3].color, 1 + rows[1].color.x, 0.5 + rows[1].color.y, 0.25 + rows[1].color.z);
    EXPECT_EQ(rows[4].what, "clamped");
    expect_color(rows[4].color, 1, 0.5 + rows[1].color.y, 0.25 + rows[1].color.z);
    EXPECT_NE(rows[4].how.find("changes it"), std::string::npos);
}

TEST(SessionProbe, ShowsTheTermsOfOneLight) {
    const Scene scene =
        scene_of(kState + "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.25, 0, 1});\n" + kSquare);
    const std::vector<SumRow> rows = rows_at(scene, 0);
    ASSERT_EQ(rows.size(), 4u);
    expect_color(rows[0].color, 0, 0, 0);       // GL_LIGHT0's ambient colour is black
    expect_color(rows[1].color, 1, 0.5, 0.25);  // n.VP is 1
    expect_color(rows[2].color, 0.5, 0.25, 0);  // n.h is 1, and a shininess of 0 makes the power 1
    expect_color(rows[3].color, 1.5, 0.75, 0.25);
    EXPECT_TRUE(rows_at(scene, 3).empty());  // is off
}

TEST(SessionProbe, SumsTheSecondaryColourByItself) {
    const Scene scene = scene_of(kState +
                                 "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.25, 0, 1});\n"
                                 "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n" +
                                 kSquare);
    const std::vector<SumRow> rows = rows_at(scene, {});
    ASSERT_EQ(rows.size(), 8u);
    expect_color(rows[2].color, 1, 0.5, 0.25);
    expect_color(rows[5].color, 0.5, 0.25, 0);
    EXPECT_EQ(rows[6].what, "c_sec");
    expect_color(rows[6].color, 0.5, 0.25, 0);
}

// GL's own model ignores the scene's variants, and the derivation of it names GL's terms.
TEST(SessionProbe, FollowsTheVariantsOnlyWhereThePaneDoes) {
    const Scene scene =
        scene_of("#pragma twinlight ambient(unattenuated)\n#pragma twinlight specular(reflection)\n" + kState +
                 "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.25, 0, 1});\n" + kSquare);
    const auto equation = [&](bool lecture_variants) {
        const ProbeAnswer answer = answer_probe(scene, {{}, lecture_variants}, {.x = 32, .y = 32});
        const auto points = points_of(scene, answer, 0);
        std::string text = equation_of(points.at(0).derivation);
        for (const explain::Line& line : lines_of(points[0].derivation, 0)) text += " " + line.what;
        return text;
    };
    EXPECT_NE(equation(true).find("sum of ( a_cm a_cli + att spot ["), std::string::npos) << equation(true);
    EXPECT_NE(equation(true).find("r.v"), std::string::npos) << equation(true);
    EXPECT_NE(equation(false).find("sum of att spot [ a_cm a_cli"), std::string::npos) << equation(false);
    EXPECT_EQ(equation(false).find("r.v"), std::string::npos) << equation(false);
}

// No symbol of the specification is left, and the equation is that of docs/lecture.md.
TEST(SessionProbe, SpeaksInTheLecturesSymbols) {
    const std::string specular = "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.25, 0, 1});\n";
    for (const std::string variant : {"half_vector", "reflection"}) {
        const Scene scene = scene_of("#pragma twinlight specular(" + variant + ")\n" + kState + specular + kSquare);
        const ProbeAnswer answer = answer_probe(scene, {{}, true}, {.x = 32, .y = 32});
        const explain::Derivation at = points_of(scene, answer, 0).at(0).derivation;
        const std::string highlight = variant == "reflection" ? "(r·v)^n" : "(n·h)^n";
        EXPECT_EQ(equation_of(at, Symbols::kLecture),
                  "I = e + k_a I_a + sum of att spot [ k_a I_ai + k_d I_di (n·l) + k_s I_si " + highlight + " ]");
        EXPECT_EQ(sum_rows(at, 0, Symbols::kLecture)[1].how, "att spot k_d I_di (n·l)");
        EXPECT_EQ(sum_rows(at, {}, Symbols::kLecture)[1].how, "k_a I_a");
        for (const std::optional<int> light : {std::optional(0), std::optional<int>()})
            for (const explain::Line& line : lines_of(at, light, Symbols::kLecture))
                for (const std::string& text : {line.what, line.value, line.how})
                    for (const char* symbol : {"VP", "_cm", "_cl", "_cs", "n.h", "r.v", "^s", "c_pri"})
                        EXPECT_EQ(text.find(symbol), std::string::npos) << text;
    }
}

// What is not clamped after lighting is the pixel that the reference draws.
TEST(SessionProbe, AMeanOfVerticesIsThePixel) {
    const Scene scene = scene_of(
        "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_COLOR_MATERIAL);\n"
        "glBegin(GL_TRIANGLES); glNormal3f(0, 0, 1); glColor3f(0.5f, 0, 0); glVertex2f(-1, -1);\n"
        "glColor3f(0, 0.5f, 0); glVertex2f(3, -1); glColor3f(0, 0, 0.5f); glVertex2f(-1, 3); glEnd();\n");
    const Probe probe{.x = 10, .y = 40};
    const ProbeAnswer answer = answer_probe(scene, {}, probe);
    const std::vector<ProbePoint> points = points_of(scene, answer, 0);
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1].name, "vertex 2");
    const std::vector<SumRow> rows = mean_rows(points);
    ASSERT_EQ(rows.size(), 4u);
    const Rgba pixel = reference::render(scene.frame, {}).at(probe.x, probe.y);
    // The picture keeps floats.
    EXPECT_NEAR(rows[3].color.x, pixel[0], 1e-7);
    EXPECT_NEAR(rows[3].color.y, pixel[1], 1e-7);
    EXPECT_NEAR(rows[3].color.z, pixel[2], 1e-7);
    const std::vector<SumRow> after = fragment_rows(scene, answer, 0);
    ASSERT_EQ(after.size(), 2u);
    EXPECT_NEAR(after[1].color.y, pixel[1], 1e-7);
    EXPECT_TRUE(mean_rows({points[0]}).empty());
}

TEST(SessionProbe, ListsTheDrawsThatCoverAPixel) {
    const Scene scene =
        scene_of("glEnable(GL_DEPTH_TEST);\n" + kState + kSquare + kSquare + "glDisable(GL_DEPTH_TEST);\n" + kSquare);
    const auto rows = fragments_of(scene, answer_probe(scene, {}, {.x = 1, .y = 1}));
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].fate, "a later draw covers it");
    EXPECT_EQ(rows[1].fate, "discarded by a test");  // GL_LESS at equal depth
    EXPECT_EQ(rows[2].fate, "seen");
    EXPECT_EQ(main_fragment(rows), 2u);
    EXPECT_NE(rows[2].name.find("draw 3, test.gl:8:1, front face"), std::string::npos) << rows[2].name;
}

TEST(SessionProbe, LightsBothFacesOfAVertex) {
    const Scene scene = scene_of(kState + "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);\n" + kSquare);
    const ProbeAnswer answer = answer_probe(scene, {}, {.is_vertex = true, .draw = 1, .vertex = 2});
    ASSERT_EQ(fragments_of(scene, answer).size(), 2u);
    const auto front = points_of(scene, answer, 0), back = points_of(scene, answer, 1);
    ASSERT_EQ(front.size(), 1u);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(front[0].name, "vertex 2");
    EXPECT_NEAR(sum_rows(front[0].derivation, 0)[1].color.x, 1, kRounding);
    EXPECT_EQ(sum_rows(back[0].derivation, 0)[1].color.x, 0);  // the light is behind it
    EXPECT_TRUE(fragment_rows(scene, answer, 0).empty());
}

TEST(SessionProbe, SaysWhatCannotBeExplained) {
    const Scene scene = scene_of(kSquare);
    const auto trouble = [&](const Probe& probe) { return answer_probe(scene, {}, probe).trouble; };
    EXPECT_EQ(trouble({.x = 64, .y = 0}), "Pixel 64, 0 is outside the picture of 64 x 64 pixels.");
    EXPECT_EQ(trouble({.is_vertex = true, .draw = 2}), "There is no draw 2; the scene has draws 1 to 1.");
    EXPECT_EQ(trouble({.is_vertex = true, .draw = 1, .vertex = 5}), "Draw 1 has no vertex 5; it has vertices 1 to 4.");
    EXPECT_NE(trouble({.is_vertex = true}).find("GL_LIGHTING is disabled"), std::string::npos);
    EXPECT_TRUE(fragments_of(scene, answer_probe(scene, {}, {.x = 64})).empty());
}

// The lines of one light are those of the whole derivation; the others are not.
TEST(SessionProbe, SortsTheLinesByLight) {
    const Scene scene = scene_of(kState + "glEnable(GL_LIGHT1);\n" + kSquare);
    const ProbeAnswer answer = answer_probe(scene, {}, {.is_vertex = true});
    const auto points = points_of(scene, answer, 0);
    const auto of_light = lines_of(points.at(0).derivation, 1), of_place = lines_of(points.at(0).derivation, {});
    EXPECT_FALSE(of_light.empty());
    for (const explain::Line& line : of_light) EXPECT_EQ(line.light, 1);
    EXPECT_FALSE(of_place.empty());
    for (const explain::Line& line : of_place) EXPECT_EQ(line.light, std::nullopt);
    EXPECT_EQ(equation_of(points[0].derivation),
              "c = e_cm + a_cm a_cs + sum of att spot [ a_cm a_cli + n.VP d_cm d_cli + f(n.h)^s s_cm s_cli ]");
    EXPECT_NE(probe_text(scene, answer, {}).find("GL_LIGHT1: directional (w = 0)"), std::string::npos);
}

// The surface faces the viewer and the light, so all vectors are (0, 0, 1); they start at the probed pixel.
TEST(SessionProbe, ItsArrowsStartAtThePixel) {
    const Scene scene = scene_of("glRotatef(90, 0, 1, 0);" + kState + "glLoadIdentity();" + kSquare);
    const ProbeAnswer answer = answer_probe(scene, {Shading::kPhong}, {.x = 20, .y = 40});
    const std::vector<ProbePoint> points = points_of(scene, answer, main_fragment(fragments_of(scene, answer)));
    ASSERT_EQ(points.size(), 1u);
    const ProbeArrows arrows = arrows_of(points[0].derivation, {}, 7);
    EXPECT_EQ(arrows.revision, 7);
    const auto at = arrows.place_of(arrows.place_eye);
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x, 20.5, 1e-9);
    EXPECT_NEAR(at->y, 40.5, 1e-9);
    // The light was placed after a turn by 90 degrees: it is at the left or the right.
    const std::map<std::string, glm::dvec3> expected = {
        {"n", {0, 0, 1}}, {"V", {0, 0, 1}}, {"L0", {1, 0, 0}}, {"h0", {std::sqrt(0.5), 0, std::sqrt(0.5)}}};
    ASSERT_EQ(arrows.arrows.size(), expected.size());
    for (const ProbeArrow& arrow : arrows.arrows)
        EXPECT_NEAR(glm::distance(arrow.dir_eye, expected.at(arrow.name)), 0, 1e-7) << arrow.name;
    // One across is kArrowPixels long in the picture.
    const auto tip = arrows.place_of(arrows.tip_eye(arrows.arrows[2]));
    ASSERT_TRUE(tip);
    EXPECT_NEAR(glm::distance(*tip, *at), kArrowPixels, 1e-6);
}

}  // namespace
}  // namespace twinlight::session::session_probe_test

// golden/known_differences is the one list of the driver's departures: every name that a test leaves out stands there,
// and every name there is shown by a test, so that the list is neither short nor stale.
#include "known_differences.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "fragment_departures.h"
#include "judge/check/case.h"
#include "judge/compare/departures.h"
#include "render/context/context.h"
#include "render/context/driver_name.h"
#include "render/context/gl.h"
#include "render/fixed/fixed.h"
#include "scene/command/text.h"
#include "scene/state/answers.h"
#include "scene/state/state.h"

namespace twinlight::known_differences_test {

namespace {

// The same commands carried out by both.
struct Both {
    explicit Both(std::string_view text) : state({.width = 16, .height = 16}) {
        for (const Command& command : read_scene(text, "case.gl", "case").commands) {
            state.apply(command);
            driver.execute(command);
        }
    }
    std::unique_ptr<OffscreenContext> context = make_offscreen_context(16, 16);
    fixed::Driver driver{16, 16};
    State state;
};

// ---- The departures of the driver's state machine ----

struct Departure {
    const char* name;
    bool (*shows)();  // whether the current driver departs
};

// The code of the one error; GL_NO_ERROR of none or several.
Enum only_error(const State& state) { return state.errors().size() == 1 ? state.errors()[0].code : kGL_NO_ERROR; }

bool single_value_for_a_vector() {
    const Both both("glLightf(GL_LIGHT0, GL_AMBIENT, 1);");
    EXPECT_EQ(only_error(both.state), kGL_INVALID_ENUM);
    return glGetError() == GL_NO_ERROR;
}

bool alpha_of_glcolor3() {
    const Both both(
        "glBegin(GL_POINTS); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0); glEnd();\n"
        "glBegin(GL_POINTS); glColor3f(1, 1, 1); glColor4f(1, 1, 1, 0.25); glVertex2f(0, 0);\n"
        "glColor3f(0.5, 0.5, 0.5); glEnd();");
    EXPECT_EQ(both.state.attributes().current.color, glm::dvec4(0.5, 0.5, 0.5, 1));
    std::array<GLfloat, 4> color{};
    glGetFloatv(GL_CURRENT_COLOR, color.data());
    return color[3] == 0.25F;
}

bool components_of_tex_coord() {
    const Both both(
        "glBegin(GL_POINTS); glTexCoord4f(1, 1, 1, 0.25); glVertex2f(0, 0); glEnd();\n"
        "glBegin(GL_POINTS); glTexCoord2f(1, 1); glTexCoord4f(1, 1, 1, 0.25); glVertex2f(0, 0);\n"
        "glTexCoord2f(0.5, 0.5); glEnd();");
    EXPECT_EQ(answer(both.state, kGL_CURRENT_TEXTURE_COORDS), (std::vector<double>{0.5, 0.5, 0, 1}));
    std::array<GLfloat, 4> coords{};
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, coords.data());
    return coords[3] == 0.25F;
}

bool unit_that_is_none() {
    const Both both("glMultiTexCoord2f(GL_FOG, 0.5, 0.5);");
    EXPECT_EQ(only_error(both.state), kGL_INVALID_ENUM);
    return glGetError() == GL_NO_ERROR;
}

bool mode_without_buffer() {
    const Both both("glRenderMode(GL_SELECT);");
    EXPECT_EQ(only_error(both.state), kGL_INVALID_OPERATION);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(answer(both.state, kGL_RENDER_MODE)[0], kGL_RENDER);
    GLint mode = 0;
    glGetIntegerv(GL_RENDER_MODE, &mode);
    return mode == GL_SELECT;
}

bool transposed_texture_matrix() {
    const Both both("glMatrixMode(GL_TEXTURE); glActiveTexture(GL_TEXTURE1); glTranslatef(0.5, 0, 0);");
    EXPECT_EQ(answer(both.state, kGL_TRANSPOSE_TEXTURE_MATRIX)[3], 0.5);
    std::array<GLfloat, 16> matrix{};
    glGetFloatv(GL_TRANSPOSE_TEXTURE_MATRIX, matrix.data());
    return matrix[3] == 0;
}

bool material_before_pop() {
    const Both both(
        "glPushAttrib(GL_LIGHTING_BIT); glShadeModel(GL_FLAT); glMaterialf(GL_FRONT, GL_SHININESS, 5);"
        "glPopAttrib();");
    EXPECT_EQ(both.state.get_material(kGL_FRONT, kGL_SHININESS)[0], 0);
    GLfloat shininess = 0;
    glGetMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
    return shininess == 5;
}

bool color_sum_after_pop() {
    const Both both("glPushAttrib(GL_FOG_BIT | GL_ENABLE_BIT); glEnable(GL_COLOR_SUM); glPopAttrib();");
    EXPECT_EQ(answer(both.state, kGL_COLOR_SUM)[0], 0);
    return glIsEnabled(GL_COLOR_SUM) == GL_TRUE;
}

bool fog_coord_source_after_pop() {
    const Both both("glPushAttrib(GL_FOG_BIT); glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD); glPopAttrib();");
    EXPECT_EQ(answer(both.state, kGL_FOG_COORD_SRC)[0], kGL_FRAGMENT_DEPTH);
    GLint source = 0;
    glGetIntegerv(GL_FOG_COORD_SRC, &source);
    return source == GL_FOG_COORD;
}

bool lights_after_pop() {
    const Both both("glPushAttrib(GL_ENABLE_BIT); glEnable(GL_LIGHT0); glPopAttrib();");
    EXPECT_EQ(answer(both.state, kGL_LIGHT0)[0], 0);
    return glIsEnabled(GL_LIGHT0) == GL_TRUE;
}

bool change_within_inner_push() {
    const Both both(
        "glPushAttrib(GL_VIEWPORT_BIT); glPushAttrib(GL_FOG_BIT); glDepthRange(0.25, 0.5); glPopAttrib(); "
        "glPopAttrib();");
    EXPECT_EQ(answer(both.state, kGL_DEPTH_RANGE), (std::vector<double>{0, 1}));
    std::array<GLdouble, 2> range{};
    glGetDoublev(GL_DEPTH_RANGE, range.data());
    return range[0] == 0.25;
}

bool mipmap_hint_after_pop() {
    const Both both("glPushAttrib(GL_HINT_BIT); glHint(GL_GENERATE_MIPMAP_HINT, GL_NICEST); glPopAttrib();");
    EXPECT_EQ(answer(both.state, kGL_GENERATE_MIPMAP_HINT)[0], kGL_DONT_CARE);
    GLint hint = 0;
    glGetIntegerv(GL_GENERATE_MIPMAP_HINT, &hint);
    return hint == GL_NICEST;
}

bool client_state_by_enable() {
    const Both both("glEnable(GL_NORMAL_ARRAY);");
    EXPECT_EQ(only_error(both.state), kGL_INVALID_ENUM);
    return glGetError() == GL_NO_ERROR;
}

bool generate_mipmap_after_pop() {
    const Both both(
        "glPushAttrib(GL_TEXTURE_BIT); glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE); glPopAttrib();");
    EXPECT_EQ(tex_parameter_answer(both.state, kGL_TEXTURE_2D, kGL_GENERATE_MIPMAP)[0], 0);
    GLint generate = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, &generate);
    return generate == GL_TRUE;
}

bool color_material_after_pop() {
    const Both both(
        "glEnable(GL_COLOR_MATERIAL); glColor3f(0.25, 0.25, 0.25);\n"
        "glPushAttrib(GL_CURRENT_BIT); glColor3f(0.75, 0.75, 0.75); GLfloat got[4];\n"
        "glGetMaterialfv(GL_FRONT, GL_AMBIENT, got); glPopAttrib(); glColor3f(0.25, 0.25, 0.25);");
    EXPECT_EQ(both.state.get_material(kGL_FRONT, kGL_AMBIENT)[0], 0.25);
    std::array<GLfloat, 4> ambient{};
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, ambient.data());
    return ambient[0] == 0.75F;
}

bool texture_matrix_after_pop() {
    const Both both(
        "glActiveTexture(GL_TEXTURE7); glPushAttrib(GL_TEXTURE_BIT); glActiveTexture(GL_TEXTURE1);\n"
        "glMatrixMode(GL_TEXTURE); glPopAttrib(); glTranslatef(0.5, 0, 0);");
    EXPECT_EQ(answer(both.state, kGL_TEXTURE_MATRIX)[12], 0.5);
    std::array<GLfloat, 16> matrix{};
    glGetFloatv(GL_TEXTURE_MATRIX, matrix.data());
    return matrix[12] == 0;
}

bool color_lost_before_a_new_color_material() {
    const Both both(
        "glColor4f(0.1, 0.1, 0.1, 1);\n"
        "glColorMaterial(GL_FRONT, GL_AMBIENT); glEnable(GL_COLOR_MATERIAL); glColor4f(0, 0, 0, 1);\n"
        "GLfloat got[4]; glGetMaterialfv(GL_FRONT, GL_AMBIENT, got);\n"
        "glColor4f(0.5, 0.5, 0.5, 1); glColor4f(1, 1, 1, 1); glColorMaterial(GL_FRONT, GL_DIFFUSE);");
    EXPECT_EQ(both.state.get_material(kGL_FRONT, kGL_AMBIENT), (std::vector<double>{1, 1, 1, 1}));
    std::array<GLfloat, 4> ambient{};
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, ambient.data());
    return ambient[0] == 0;
}

bool error_of_sprite_origin() {
    const Both both("glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LINEAR);");
    EXPECT_EQ(only_error(both.state), kGL_INVALID_ENUM);
    return glGetError() == GL_INVALID_VALUE;
}

std::array<GLubyte, 4> pixel(int x, int y) {
    std::array<GLubyte, 4> color{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    return color;
}

// Fog that ends at a distance of 1, half way: 128 of 255 by the text, 0 without the division.
bool fog_of_w() {
    const Both both(
        "glEnable(GL_FOG); glFogi(GL_FOG_MODE, GL_LINEAR); glBegin(GL_QUADS); glVertex4f(-2, -2, -1, 2);\n"
        "glVertex4f(2, -2, -1, 2); glVertex4f(2, 2, -1, 2); glVertex4f(-2, 2, -1, 2); glEnd();");
    EXPECT_EQ(pixel(8, 8)[3], 255);
    return pixel(8, 8)[0] == 0;
}

// The square has the colour from before the evaluator: blue 255 by the text.
bool current_values_after_evaluator() {
    const Both both(
        "glColor4f(0.25, 0.5, 1, 1);\n"
        "glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 1, (GLfloat[]){-0.5, 0, 0}); glEnable(GL_MAP1_VERTEX_3);\n"
        "glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 1, (GLfloat[]){0, 1, 0, 1}); glEnable(GL_MAP1_COLOR_4);\n"
        "glBegin(GL_POINTS); glEvalCoord1f(0.5); glEnd();\n"
        "glBegin(GL_QUADS); glVertex2f(-1, -1); glVertex2f(1, -1); glVertex2f(1, 1); glVertex2f(-1, 1); glEnd();");
    EXPECT_EQ(both.state.attributes().current.color, glm::dvec4(0.25, 0.5, 1, 1));
    return pixel(8, 8)[2] == 0;
}

constexpr Departure kDepartures[] = {
    {"current values after glEvalCoord", current_values_after_evaluator},
    {"fog of a vertex whose w is not 1", fog_of_w},
    {"a single value for a vector parameter", single_value_for_a_vector},
    {"what an inner glPushAttrib does not save", change_within_inner_push},
    {"glMultiTexCoord of an unknown unit", unit_that_is_none},
    {"glRenderMode without a buffer", mode_without_buffer},
    {"the error of a wrong origin of point sprites", error_of_sprite_origin},
    {"glColor3 after glColor4", alpha_of_glcolor3},
    {"glTexCoord1 to 3 after glTexCoord4", components_of_tex_coord},
    {"the transposed texture matrix of another unit", transposed_texture_matrix},
    {"glMaterial right before glPopAttrib", material_before_pop},
    {"GL_COLOR_SUM after glPopAttrib", color_sum_after_pop},
    {"GL_FOG_COORD_SRC after glPopAttrib", fog_coord_source_after_pop},
    {"lights after glPopAttrib of GL_ENABLE_BIT", lights_after_pop},
    {"GL_GENERATE_MIPMAP_HINT after glPopAttrib", mipmap_hint_after_pop},
    {"glEnable of a vertex array", client_state_by_enable},
    {"GL_GENERATE_MIPMAP after glPopAttrib", generate_mipmap_after_pop},
    {"colour material after glPopAttrib", color_material_after_pop},
    {"the texture matrix after glPopAttrib", texture_matrix_after_pop},
    {"glColor before a new glColorMaterial", color_lost_before_a_new_color_material},
};

TEST(Departures, OfTheStateMachineAreStillThere) {
    for (const Departure& departure : kDepartures) expect_as_listed(departure.name, departure.shows());
}

// The table and the list name the same releases.
TEST(Departures, AreOfTheReleasesOfTheList) {
    for (const compare::Departure& departure : compare::departures()) {
        for (const compare::SeenOn& seen : departure.seen_on) {
            for (const std::string_view release : compare::kMeasuredReleases) {
                if ((seen.driver == "NVIDIA") != release.starts_with("NVIDIA")) continue;
                const Driver driver = parse_driver_name(fmt::format("{}, 4.5 {}.1, OSMesa", seen.driver, release));
                EXPECT_NE(departure.is_known_on(driver), is_right(departure.name, driver))
                    << departure.name << " on " << seen.driver << ", " << release;
            }
        }
    }
}

// A release that was not measured counts as one that was. So the limits of ranges are measured releases.
TEST(Departures, ChangeWithMeasuredReleases) {
    const auto expect_measured = [](std::string_view maker, std::string_view number) {
        const std::string release = fmt::format("{} {}", maker, number);
        EXPECT_TRUE(number.empty() ||
                    std::ranges::find(compare::kMeasuredReleases, release) != std::end(compare::kMeasuredReleases))
            << release;
    };
    for (const auto& [name, releases] : known_differences())
        for (const std::string& number : {releases.from, releases.before}) expect_measured("Mesa", number);
    for (const compare::Departure& departure : compare::departures())
        for (const compare::SeenOn& seen : departure.seen_on)
            for (const std::string_view number : {seen.releases.from, seen.releases.before})
                expect_measured(seen.driver == "NVIDIA" ? "NVIDIA" : "Mesa", number);
}

// The fuzzer's tests show that each of those it leaves out still differs, fragment_departures_test.cpp its scenes,
// hard_cases_test.cpp those of golden/hard.
TEST(Departures, AreTheOnesOfTheList) {
    std::set<std::string> shown;
    for (const Departure& departure : kDepartures) shown.insert(departure.name);
    const Driver llvmpipe = parse_driver_name("llvmpipe, 4.5 Mesa 22.3.6, OSMesa");
    const Driver nvidia = parse_driver_name("NVIDIA H200/PCIe/SSE2, 4.6.0 NVIDIA 580.159.04, EGL");
    for (const compare::Departure& departure : compare::departures())
        if (departure.is_known_on(llvmpipe) || departure.is_known_on(nvidia)) shown.emplace(departure.name);
    for (const FragmentCase& fragment_case : fragment_cases()) shown.emplace(fragment_case.name);
    for (const check::Case& hard_case : check::load_cases())
        for (const check::Differs& differs : hard_case.differs) shown.insert(differs.name);
    std::set<std::string> listed;
    for (const auto& [name, releases] : known_differences()) listed.insert(name);
    EXPECT_EQ(shown, listed);
}

}  // namespace

}  // namespace twinlight::known_differences_test

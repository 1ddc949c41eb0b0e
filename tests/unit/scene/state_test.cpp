// The rules of the state machine, calculated by hand. tests/property compares them with the driver.
#include "scene/state/state.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "scene/command/text.h"

namespace twinlight::state_test {

namespace {

State after(std::string_view text, StateOptions options = {}) {
    State state(options);
    for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
    return state;
}

Frame frame_of(std::string_view text) { return make_frame(read_scene(text, "scene.gl", "scene"), {}); }

std::string error_of(std::string_view text) {
    try {
        frame_of(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "no error";
}

const Draw& first_draw(const Frame& frame) {
    for (const auto& item : frame.items) {
        if (const Draw* draw = std::get_if<Draw>(&item)) return *draw;
    }
    throw std::logic_error("nothing drawn");
}

constexpr double kExact = 1e-15;  // a few roundings of numbers of size 1

void expect_near(const glm::dvec4& a, const glm::dvec4& b, double tolerance = kExact) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

// ---- Lights (2.14.1, 2.14.2) ----

TEST(LightState, StartsAsTheTableSays) {
    const State state;
    for (int i = 0; i < kMaxLights; ++i) {
        const LightSource& light = state.lighting().lights[static_cast<std::size_t>(i)];
        const glm::dvec4 intensity = i == 0 ? glm::dvec4(1) : glm::dvec4(0, 0, 0, 1);
        EXPECT_EQ(light.diffuse, intensity);
        EXPECT_EQ(light.specular, intensity);
        EXPECT_EQ(light.ambient, glm::dvec4(0, 0, 0, 1));
        EXPECT_EQ(light.position_eye, glm::dvec4(0, 0, 1, 0));
        EXPECT_EQ(light.spot_cutoff_deg, 180);
        EXPECT_FALSE(light.enabled);
    }
}

TEST(LightState, PositionIsTransformedByTheModelviewOfTheCall) {
    const State state = after(
        "glTranslated(1, 2, 3);\n"
        "glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){1, 1, 1, 1});\n"
        "glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){1, 1, 1, 0});\n"
        "glLoadIdentity(); glTranslated(100, 0, 0);");
    EXPECT_EQ(state.lighting().lights[1].position_eye, glm::dvec4(2, 3, 4, 1));
    EXPECT_EQ(state.lighting().lights[2].position_eye, glm::dvec4(1, 1, 1, 0));  // a direction is not moved
}

TEST(LightState, SpotDirectionIsTurnedButNotMovedNorMadeUnit) {
    const State state = after(
        "glTranslated(5, 5, 5); glRotated(90, 0, 1, 0); glScaled(2, 2, 2);\n"
        "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){0, 0, -1});");
    // A rotation by 90 degrees about y takes -z to -x.
    EXPECT_NEAR(state.lighting().lights[0].spot_direction_eye.x, -2, kExact);
    EXPECT_NEAR(state.lighting().lights[0].spot_direction_eye.z, 0, kExact);
}

TEST(LightState, IntegersAreMappedForColoursAndTakenAsTheyAreForPositions) {
    const State state = after(
        "glLightiv(GL_LIGHT0, GL_DIFFUSE, (GLint[]){2147483647, 0, -2147483648, 1073741824});\n"
        "glLightiv(GL_LIGHT0, GL_POSITION, (GLint[]){3, -4, 5, 1});\n"
        "glLighti(GL_LIGHT0, GL_SPOT_CUTOFF, 30);");
    const LightSource& light = state.lighting().lights[0];
    // (2c+1)/(2^32-1), table 2.9.
    expect_near(light.diffuse, {1, 1 / 4294967295.0, -1, 2147483649.0 / 4294967295.0});
    EXPECT_EQ(light.position_eye, glm::dvec4(3, -4, 5, 1));
    EXPECT_EQ(light.spot_cutoff_deg, 30);
}

TEST(LightState, TheLaterRuleForIntegersIsAnOption) {
    const State state = after("glColor4b(127, 0, -128, -127);", {.signed_rule = SignedRule::kGl42});
    EXPECT_EQ(state.attributes().current.color, glm::dvec4(1, 0, -1, -1));
}

// ---- Errors: a refused command changes nothing ----

struct Refused {
    const char* text;
    Enum code;
    const char* message;
};

class RefusedCommands : public testing::TestWithParam<Refused> {};

TEST_P(RefusedCommands, RaiseTheErrorAndSayWhy) {
    const State state = after(GetParam().text);
    ASSERT_EQ(state.errors().size(), 1u);
    EXPECT_EQ(state.errors()[0].code, GetParam().code);
    EXPECT_NE(state.errors()[0].message.find(GetParam().message), std::string::npos) << state.errors()[0].message;
}

INSTANTIATE_TEST_SUITE_P(
    State, RefusedCommands,
    testing::Values(
        Refused{"glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);", kGL_INVALID_VALUE,
                "GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180"},
        Refused{"glEnable(GL_LIGHT0 + 8);", kGL_INVALID_ENUM, "glEnable is given GL_LIGHT0 + 8; GL has GL_LIGHT0 to"},
        Refused{"glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1);", kGL_INVALID_VALUE, "[0, 90] or 180"},
        Refused{"glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 128.5);", kGL_INVALID_VALUE, "in [0, 128]"},
        Refused{"glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -0.5);", kGL_INVALID_VALUE, "must be 0 or more"},
        Refused{"glLightf(GL_LIGHT0, GL_AMBIENT, 1);", kGL_INVALID_ENUM, "use glLightfv"},
        Refused{"glMaterialf(GL_FRONT, GL_DIFFUSE, 1);", kGL_INVALID_ENUM, "use glMaterialfv"},
        Refused{"glMaterialf(GL_FRONT, GL_SHININESS, 1000);", kGL_INVALID_VALUE,
                "in [0, 128]; for a larger Ns of an OBJ file, use 128"},
        Refused{"glMaterialf(GL_LIGHT0, GL_SHININESS, 1);", kGL_INVALID_ENUM, "expected GL_FRONT, GL_BACK"},
        Refused{"glLightf(GL_FRONT, GL_SPOT_CUTOFF, 1);", kGL_INVALID_ENUM, "GL_LIGHT0 to GL_LIGHT7"},
        Refused{"glLightf(GL_LIGHT0, GL_SHININESS, 1);", kGL_INVALID_ENUM, "GL_SHININESS; expected GL_AMBIENT"},
        Refused{"glLightModeli(GL_LIGHT_MODEL_AMBIENT, 1);", kGL_INVALID_ENUM, "use glLightModeliv"},
        Refused{"glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, 1);", kGL_INVALID_ENUM, "GL_SINGLE_COLOR"},
        Refused{"glShadeModel(GL_LINE);", kGL_INVALID_ENUM, "expected GL_FLAT, GL_SMOOTH"},
        Refused{"glColorMaterial(GL_FRONT, GL_SHININESS);", kGL_INVALID_ENUM, "glColorMaterial is given GL_SHININESS"},
        Refused{"glEnable(GL_FRONT);", kGL_INVALID_ENUM, "is not a capability"},
        Refused{"glBegin(10);", kGL_INVALID_ENUM, "expected a primitive type"},
        Refused{"glEnd();", kGL_INVALID_OPERATION, "glEnd without a glBegin"},
        Refused{"glBegin(GL_LINES); glBegin(GL_LINES); glEnd();", kGL_INVALID_OPERATION,
                "glBegin inside another glBegin"},
        Refused{"glBegin(GL_LINES); glEnable(GL_LIGHTING); glEnd();", kGL_INVALID_OPERATION,
                "is not allowed between glBegin and glEnd; the glBegin is at scene.gl:1:1"},
        Refused{"glBegin(GL_LINES); glutSolidCube(1); glEnd();", kGL_INVALID_OPERATION, "is not allowed between"},
        Refused{"glPopMatrix();", kGL_STACK_UNDERFLOW, "GL_MODELVIEW"},
        Refused{"glFrustum(-1, 1, -1, 1, 0, 1);", kGL_INVALID_VALUE, "near > 0"},
        Refused{"glOrtho(1, 1, -1, 1, 0, 1);", kGL_INVALID_VALUE, "left != right"},
        Refused{"glViewport(0, 0, -1, 5);", kGL_INVALID_VALUE, "-1 x 5"},
        Refused{"glClear(3);", kGL_INVALID_VALUE, "name no buffer"},
        Refused{"glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, (GLfloat[4]){0});", kGL_INVALID_ENUM,
                "GL_FRONT, GL_BACK"},
        Refused{"glScaled(INFINITY, 1, 1);", kGL_INVALID_VALUE, "needs finite numbers"},
        Refused{"glMaterialf(GL_FRONT, GL_SHININESS, NAN);", kGL_INVALID_VALUE, "needs finite numbers"},
        Refused{"#pragma twinlight specular(cube)", kGL_INVALID_ENUM, "half_vector or reflection"},
        Refused{"#pragma twinlight light(3, GL_DIFFUSE, 1, 1, 1, 1)", kGL_INVALID_ENUM,
                "the number must be from 8 to 65535"},
        Refused{"#pragma twinlight light(8, GL_DIFFUSE, 1)", kGL_INVALID_VALUE, "GL_DIFFUSE needs 4 values, not 1"},
        Refused{"#pragma twinlight light(8, GL_SPOT_CUTOFF, 100)", kGL_INVALID_VALUE, "[0, 90] or 180"},
        Refused{"#pragma twinlight spot_cone(GL_LIGHT0, -5, 10)", kGL_INVALID_VALUE, "[0, 180]"}));

TEST(StateErrors, ChangeNothing) {
    const State state = after("glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 100);");
    EXPECT_EQ(state.lighting().lights[0].spot_cutoff_deg, 45);
}

TEST(StateErrors, AStackHolds32Matrices) {
    std::string text;
    for (int i = 0; i < 31; ++i) text += "glPushMatrix();";
    EXPECT_TRUE(after(text).errors().empty());
    const State state = after(text + "glPushMatrix();");
    ASSERT_EQ(state.errors().size(), 1u);
    EXPECT_EQ(state.errors()[0].code, kGL_STACK_OVERFLOW);
}

// ---- Materials and colour material (2.14.2, 2.14.3) ----

TEST(MaterialState, OfVerticesEndsWithTheirPrimitive) {
    const Frame frame = frame_of(
        "glBegin(GL_POINTS); glVertex2f(0, 0); glMaterialf(GL_FRONT, GL_SHININESS, 7); glVertex2f(0, 0); glEnd();"
        "glRectf(0, 0, 1, 1); glutSolidCube(1);");
    const Draw& points = std::get<Draw>(frame.items.front());
    EXPECT_EQ(points.materials.size(), 2u);
    for (std::size_t i = 1; i < frame.items.size(); ++i) {
        const Draw& draw = std::get<Draw>(frame.items[i]);
        EXPECT_TRUE(draw.materials.empty());
        EXPECT_EQ(draw.lighting.front.shininess, 7);
        for (const Vertex& vertex : draw.vertices) EXPECT_EQ(vertex.material, 0u);
    }
}

TEST(MaterialState, BothFacesAndBothColoursAreSetTogether) {
    const State state = after("glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){1, 0.5, 0.25, 1});");
    for (const Material* material : {&state.lighting().front, &state.lighting().back}) {
        EXPECT_EQ(material->ambient, glm::dvec4(1, 0.5, 0.25, 1));
        EXPECT_EQ(material->diffuse, glm::dvec4(1, 0.5, 0.25, 1));
        EXPECT_EQ(material->specular, glm::dvec4(0, 0, 0, 1));
    }
}

TEST(MaterialState, FollowsTheColourFromTheMomentOfEnable) {
    const State state =
        after("glColor3f(1, 0, 0); glColorMaterial(GL_FRONT, GL_EMISSION); glEnable(GL_COLOR_MATERIAL);");
    EXPECT_EQ(state.lighting().front.emission, glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(state.lighting().back.emission, glm::dvec4(0, 0, 0, 1));
}

TEST(MaterialState, KeepsTheColourWhenTrackingEnds) {
    const State state =
        after("glEnable(GL_COLOR_MATERIAL); glColor3f(1, 0, 0); glDisable(GL_COLOR_MATERIAL); glColor3f(0, 1, 0);");
    EXPECT_EQ(state.lighting().front.diffuse, glm::dvec4(1, 0, 0, 1));
}

TEST(MaterialState, IsNotChangedByGlMaterialWhileItTracks) {
    const State state = after(
        "glEnable(GL_COLOR_MATERIAL); glColor3f(1, 0, 0);\n"
        "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (GLfloat[]){0, 0, 1, 1});\n"
        "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0, 0, 1, 1});");
    EXPECT_EQ(state.lighting().front.diffuse, glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(state.lighting().front.specular, glm::dvec4(0, 0, 1, 1));
}

TEST(MaterialState, BetweenBeginAndTheFirstVertexBelongsToTheDraw) {
    const Frame frame =
        frame_of("glBegin(GL_POINTS); glMaterialf(GL_FRONT, GL_SHININESS, 7); glVertex2f(0, 0); glEnd();");
    EXPECT_EQ(first_draw(frame).lighting.front.shininess, 7);
    EXPECT_TRUE(frame.unsupported.empty());
}

TEST(MaterialState, BetweenVerticesIsTheNextVertices) {
    const Frame frame = frame_of(
        "glMaterialf(GL_FRONT, GL_SHININESS, 3);\n"
        "glBegin(GL_LINES); glVertex2f(0, 0); glMaterialf(GL_FRONT, GL_SHININESS, 5);\n"
        "glMaterialf(GL_FRONT, GL_SHININESS, 7); glVertex2f(0, 1); glVertex2f(1, 1); glEnd();");
    const Draw& draw = first_draw(frame);
    ASSERT_EQ(draw.materials.size(), 2u);  // a material that no vertex used is not kept
    EXPECT_EQ(draw.materials[0].front.shininess, 3);
    EXPECT_EQ(draw.materials[1].front.shininess, 7);
    EXPECT_EQ(draw.vertices[0].material, 0u);
    EXPECT_EQ(draw.vertices[1].material, 1u);
    EXPECT_EQ(draw.vertices[2].material, 1u);
}

TEST(MaterialState, BeforeTheFirstVertexIsTheDraws) {
    const Draw draw = first_draw(frame_of(
        "glBegin(GL_LINES); glMaterialf(GL_FRONT, GL_SHININESS, 7); glVertex2f(0, 0); glVertex2f(0, 1); glEnd();"));
    EXPECT_TRUE(draw.materials.empty());
    EXPECT_EQ(draw.lighting.front.shininess, 7);
}

// ---- Vertices ----

TEST(Vertices, CarryTheCurrentNormalAndColour) {
    const Frame frame = frame_of(
        "glBegin(GL_TRIANGLES);\n"
        "glNormal3b(127, 0, -128); glColor3ub(255, 0, 51); glVertex2s(1, 2);\n"
        "glColor4us(65535, 0, 0, 0); glVertex3i(1, 2, 3); glVertex4d(1, 2, 3, 4); glEnd();");
    const Draw& draw = first_draw(frame);
    ASSERT_EQ(draw.vertices.size(), 3u);
    EXPECT_EQ(draw.vertices[0].position_object, glm::dvec4(1, 2, 0, 1));
    // (2c+1)/255, table 2.9: no signed byte gives 0.
    EXPECT_NEAR(draw.vertices[0].normal_object.x, 1, kExact);
    EXPECT_NEAR(draw.vertices[0].normal_object.y, 1 / 255.0, kExact);
    EXPECT_NEAR(draw.vertices[0].normal_object.z, -1, kExact);
    expect_near(draw.vertices[0].color, {1, 0, 0.2, 1});
    EXPECT_EQ(draw.vertices[1].position_object, glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(draw.vertices[1].color, glm::dvec4(1, 0, 0, 0));
    EXPECT_EQ(draw.vertices[2].position_object, glm::dvec4(1, 2, 3, 4));
}

TEST(Vertices, ThreeComponentColoursHaveAlpha1) {
    EXPECT_EQ(after("glColor4f(0, 0, 0, 0); glColor3f(0, 0, 0);").attributes().current.color.a, 1);
}

// ---- Matrices (2.11.2) ----

TEST(Matrices, MultiplyFromTheRight) {
    const State state = after("glTranslated(1, 0, 0); glScaled(2, 2, 2);");
    EXPECT_EQ(state.modelview() * glm::dvec4(1, 1, 1, 1), glm::dvec4(3, 2, 2, 1));
}

// Radians in double would leave 6e-17 at 90 degrees, and take digits from every sine and cosine near 0.
TEST(Matrices, RotateByAnglesWhoseSinesAndCosinesKeepAllDigits) {
    const auto turn = [](double angle_deg) {
        const glm::dmat4 m = after(fmt::format("glRotated({}, 0, 0, 1);", angle_deg)).modelview();
        return glm::dvec2(m[0][0], m[0][1]);
    };
    const std::array<glm::dvec2, 4> right_angles = {glm::dvec2(1, 0), {0, 1}, {-1, 0}, {0, -1}};
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(turn(90.0 * static_cast<double>(i)), right_angles.at(i % 4)) << i;
    constexpr double kTwoUnits = 0x1p-51;
    for (double beyond_deg = 1; beyond_deg > 1e-9; beyond_deg /= 8) {
        const long double radians = beyond_deg * std::numbers::pi_v<long double> / 180;
        const auto sine = static_cast<double>(std::sin(radians));
        EXPECT_NEAR(-turn(90 + beyond_deg).x / sine, 1, kTwoUnits) << beyond_deg;
        EXPECT_NEAR(-turn(180 + beyond_deg).y / sine, 1, kTwoUnits) << beyond_deg;
        EXPECT_NEAR(turn(-90 + beyond_deg).x / sine, 1, kTwoUnits) << beyond_deg;
        // Only 1 - cosine is in this element.
        const glm::dmat4 tilted = after(fmt::format("glRotated({}, 3, 4, 0);", beyond_deg)).modelview();
        const long double half_sine = std::sin(radians / 2);
        const auto one_minus_cosine = static_cast<double>(2 * half_sine * half_sine);
        EXPECT_NEAR(tilted[0][1] / (0.48 * one_minus_cosine), 1, 2 * kTwoUnits) << beyond_deg;
    }
}

TEST(Matrices, RotateAboutTheAxisByTheRightHandRule) {
    expect_near(after("glRotated(90, 0, 0, 5);").modelview() * glm::dvec4(1, 0, 0, 1), {0, 1, 0, 1});
}

TEST(Matrices, ComeColumnByColumn) {
    const State state = after("glLoadMatrixd((GLdouble[]){1,0,0,0, 0,1,0,0, 0,0,1,0, 7,8,9,1});");
    EXPECT_EQ(state.modelview() * glm::dvec4(0, 0, 0, 1), glm::dvec4(7, 8, 9, 1));
}

TEST(Matrices, PerspectiveTakesTheFrustumsCornersToTheCubes) {
    const State state = after("glMatrixMode(GL_PROJECTION); gluPerspective(90, 2, 1, 10);");
    // At 90 degrees the near plane at distance 1 reaches from -1 to 1 in y and, with aspect 2, from -2 to 2 in x.
    const glm::dvec4 near_corner = state.projection() * glm::dvec4(2, 1, -1, 1);
    expect_near(near_corner / near_corner.w, {1, 1, -1, 1}, 4 * kExact);
    const glm::dvec4 far_corner = state.projection() * glm::dvec4(-20, -10, -10, 1);
    expect_near(far_corner / far_corner.w, {-1, -1, 1, 1}, 4 * kExact);
}

TEST(Matrices, FrustumIsPerspectiveForASymmetricView) {
    const State a = after("glMatrixMode(GL_PROJECTION); glFrustum(-2, 2, -1, 1, 1, 10);");
    const State b = after("glMatrixMode(GL_PROJECTION); gluPerspective(90, 2, 1, 10);");
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(glm::value_ptr(a.projection())[i], glm::value_ptr(b.projection())[i], 8 * kExact);
    }
}

TEST(Matrices, OrthoTakesTheBoxToTheCube) {
    const State state = after("glMatrixMode(GL_PROJECTION); glOrtho(2, 6, -1, 1, 0, 10);");
    expect_near(state.projection() * glm::dvec4(2, -1, 0, 1), {-1, -1, -1, 1});
    expect_near(state.projection() * glm::dvec4(6, 1, -10, 1), {1, 1, 1, 1});
}

TEST(Matrices, LookAtTakesTheEyeToTheOriginAndTheCentreToTheNegativeZAxis) {
    const State state = after("gluLookAt(1, 2, 3,  1, 2, -1,  0, 1, 0);");
    expect_near(state.modelview() * glm::dvec4(1, 2, 3, 1), {0, 0, 0, 1});
    expect_near(state.modelview() * glm::dvec4(1, 2, -1, 1), {0, 0, -4, 1});
    expect_near(state.modelview() * glm::dvec4(1, 3, 3, 1), {0, 1, 0, 1});
}

// RULING: like infinity in a command.
TEST(Matrices, WhoseProductNoFloatHoldsAreRefused) {
    for (const char* overflow :
         {"glScalef(1e38, 1e38, 1e38);", "glTranslatef(0, 1e30, 0);", "glMultMatrixf((GLfloat[16]){1e30});",
          "glFrustum(0, 1e-300, -1, 1, 1, 2);", "glOrtho(0, 1e-300, -1, 1, -1, 1);"}) {
        const std::string text = "glMatrixMode(GL_MODELVIEW); glScalef(1e20, 1e20, 1e20);";
        const State state = after(text + overflow);
        ASSERT_EQ(state.errors().size(), 1u) << overflow;
        EXPECT_EQ(state.errors()[0].code, kGL_INVALID_VALUE);
        EXPECT_EQ(state.modelview(), after(text).modelview()) << overflow;
    }
    EXPECT_TRUE(after("glScalef(3e38, 1, 1); glScalef(1, 3e38, 3e38);").errors().empty());
    EXPECT_EQ(error_of("glScalef(1e38, 1, 1); glScalef(1e4, 1, 1);"),
              "scene.gl:1:23: glScalef makes an element of the GL_MODELVIEW matrix 1e+42; the largest float is 3.4e+38 "
              "(GL_INVALID_VALUE)");
}

TEST(State, TakesDoublesThatNoFloatHoldsForInfinity) {
    const State state = after("glScaled(1e300, 1, 1); glTranslated(0, -1e39, 0);");
    ASSERT_EQ(state.errors().size(), 2u);
    EXPECT_EQ(state.errors()[0].message, "glScaled is given 1e+300; the largest float is 3.4e+38");
    EXPECT_EQ(state.modelview(), glm::dmat4(1));
    const Frame frame = frame_of("glBegin(GL_POINTS); glVertex3d(1e39, 0, 0); glEnd();");
    EXPECT_EQ(first_draw(frame).vertices[0].position_object, glm::dvec4(0));
}

TEST(Matrices, PushAndPopKeepEachModeToItself) {
    const State state = after(
        "glTranslated(1, 0, 0); glPushMatrix(); glMatrixMode(GL_PROJECTION); glTranslated(0, 5, 0);\n"
        "glMatrixMode(GL_MODELVIEW); glLoadIdentity(); glPopMatrix();");
    EXPECT_EQ(glm::dvec3(state.modelview()[3]), glm::dvec3(1, 0, 0));
    EXPECT_EQ(glm::dvec3(state.projection()[3]), glm::dvec3(0, 5, 0));
}

// ---- Frames ----

TEST(Frames, KeepTheStateOfEachDraw) {
    const Frame frame = frame_of(
        "glClear(GL_COLOR_BUFFER_BIT); glShadeModel(GL_FLAT); glutSolidCube(1);\n"
        "glShadeModel(GL_SMOOTH); glTranslated(3, 0, 0); glutSolidCube(1);");
    ASSERT_EQ(frame.items.size(), 3u);
    EXPECT_TRUE(std::get<Clear>(frame.items[0]).color);
    EXPECT_FALSE(std::get<Clear>(frame.items[0]).depth);
    EXPECT_EQ(std::get<Draw>(frame.items[1]).lighting.shade_model, kGL_FLAT);
    EXPECT_EQ(std::get<Draw>(frame.items[2]).lighting.shade_model, kGL_SMOOTH);
    EXPECT_EQ(std::get<Draw>(frame.items[1]).eye_from_object[3].x, 0);
    EXPECT_EQ(std::get<Draw>(frame.items[2]).eye_from_object[3].x, 3);
}

TEST(Frames, NameWhatTheRenderersDoNotDoYetWithCountAndPlace) {
    const Frame frame = frame_of("\n  glEnable(GL_POLYGON_SMOOTH); glutSolidCube(1); glutSolidCube(2);");
    ASSERT_EQ(frame.unsupported.size(), 1u);
    EXPECT_EQ(frame.unsupported[0].name, "glEnable(GL_POLYGON_SMOOTH)");
    EXPECT_EQ(frame.unsupported[0].first.str(), "scene.gl:2:3");
    EXPECT_GE(frame.unsupported[0].count, 2);
    EXPECT_EQ(frame.unsupported[0].missing_from, MissingFrom::kFrame);
}

TEST(Frames, AreRefusedWhenSomethingIsLeftOpen) {
    EXPECT_EQ(error_of("glBegin(GL_LINES);"), "scene.gl:1:1: this glBegin has no glEnd; add it after the last vertex");
    EXPECT_EQ(error_of("glutSolidCube(1);\n glPushMatrix();"),
              "scene.gl:2:2: this glPushMatrix has no glPopMatrix; each push needs a pop");
}

TEST(Frames, AreRefusedWhenNothingIsDrawn) {
    EXPECT_NE(error_of("").find("draws nothing"), std::string::npos);
    EXPECT_NE(error_of("glEnable(GL_LIGHTING);").find("draws nothing"), std::string::npos);
    EXPECT_NE(error_of("glCopyPixels(0, 0, 0, 4, GL_STENCIL);").find("draws nothing"), std::string::npos);
}

TEST(Frames, AreRefusedAtTheFirstError) {
    EXPECT_EQ(error_of("glutSolidCube(1);\nglLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120);"),
              "scene.gl:2:1: GL_SPOT_CUTOFF is 120; it must be in [0, 90] or 180 (GL_INVALID_VALUE)");
}

// Programs that normalise the normals of degenerate triangles send NaN; freeglut's teapot does too.
// ---- What glLight was given ----

const TypedLight& typed_light(const Frame& frame, std::size_t light) {
    return frame.typed_lights.at(first_draw(frame).lighting.lights.at(light).typed);
}
constexpr const char* kTriangle =
    "glBegin(GL_TRIANGLES); glVertex2f(0, 0); glVertex2f(1, 0); glVertex2f(0, 1); glEnd();";

TEST(TypedLights, AreTheValuesBesideThoseInEyeCoordinates) {
    const Frame frame = frame_of(std::string("glTranslatef(0, 0, -5);\n"
                                             "glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){1, 2, 3, 1});\n"
                                             "glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, (GLfloat[]){0, 1, 0});\n") +
                                 kTriangle);
    const TypedLight& typed = typed_light(frame, 1);
    EXPECT_EQ(typed.position.value, glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(typed.position.place.str(), "scene.gl:2:1");
    EXPECT_EQ(typed.spot_direction.value, glm::dvec3(0, 1, 0));
    EXPECT_EQ(typed.spot_direction.place.str(), "scene.gl:3:1");
    EXPECT_EQ(typed.position.eye_from_typed * typed.position.value, glm::dvec4(1, 2, -2, 1));
    EXPECT_EQ(first_draw(frame).lighting.lights[1].position_eye, glm::dvec4(1, 2, -2, 1));
    EXPECT_TRUE(typed_light(frame, 0).position.is_initial());
    EXPECT_EQ(typed_light(frame, 0).position.value, glm::dvec4(0, 0, 1, 0));
}

TEST(TypedLights, FollowTheAttributeStack) {
    const std::string inner = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){9, 9, 9, 1});";
    const std::string outer = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 1});";
    EXPECT_EQ(typed_light(frame_of(outer + "glPushAttrib(GL_LIGHTING_BIT);" + inner + "glPopAttrib();" + kTriangle), 0)
                  .position.value,
              glm::dvec4(1, 2, 3, 1));
    EXPECT_EQ(typed_light(frame_of(outer + inner + kTriangle), 0).position.value, glm::dvec4(9, 9, 9, 1));
}

// A program of many pictures keeps only what its lights still have.
TEST(TypedLights, OfEarlierPicturesAreForgotten) {
    State state = after("glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){5, 6, 7, 1});");
    for (int picture = 0; picture < 50; ++picture) {
        const std::string text =
            "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){" + std::to_string(picture) + ", 0, 0, 1});" + kTriangle;
        for (const Command& command : read_scene(text, "scene.gl", "scene").commands) state.apply(command);
        const Frame frame = state.take_frame();
        EXPECT_LE(frame.typed_lights.size(), 4U);
        EXPECT_EQ(typed_light(frame, 0).position.value, glm::dvec4(picture, 0, 0, 1));
        EXPECT_EQ(typed_light(frame, 2).position.value, glm::dvec4(5, 6, 7, 1));
    }
}

TEST(State, HasLightsThatGlDoesNotHave) {
    const Frame frame = frame_of(
        "glPushAttrib(GL_LIGHTING_BIT);\n#pragma twinlight light(9, GL_DIFFUSE, 1, 0.5, 0, 1)\nglPopAttrib();\n"
        "glTranslatef(1, 2, 3); glEnable(GL_LIGHTING);\n#pragma twinlight light(10, GL_POSITION, 4, 4, 4, 1)\n"
        "glutSolidCube(1);");
    const LightingState& lighting = first_draw(frame).lighting;
    ASSERT_EQ(lighting.lights.size(), 11u);
    EXPECT_FALSE(lighting.lights[9].enabled);  // popped, as GL's lights are
    EXPECT_EQ(lighting.lights[9].diffuse, LightSource{}.diffuse);
    EXPECT_TRUE(lighting.lights[10].enabled);
    EXPECT_EQ(lighting.lights[10].position_eye, glm::dvec4(5, 6, 7, 1));
}

TEST(State, TakesVerticesThatAreNotNumbers) {
    const Frame frame = frame_of(
        "glBegin(GL_POINTS); glNormal3f(NAN, 1, 0); glColor4f(1, NAN, INFINITY, 0.5); glTexCoord2f(NAN, 0.5);\n"
        "glVertex2f(0, 0); glVertex2f(NAN, 0); glEnd();\n"
        "GLfloat normals[] = {NAN, NAN, NAN}; GLfloat corner[] = {0.25, 0.5};\n"
        "glEnableClientState(GL_VERTEX_ARRAY); glEnableClientState(GL_NORMAL_ARRAY);\n"
        "glVertexPointer(2, GL_FLOAT, 0, corner); glNormalPointer(GL_FLOAT, 0, normals); glDrawArrays(GL_POINTS, 0, "
        "1);");
    const Vertex& v = first_draw(frame).vertices[0];
    EXPECT_EQ(v.normal_object, glm::dvec3(0));
    EXPECT_EQ(v.color, glm::dvec4(1, 0, 0, 0.5));
    EXPECT_EQ(v.tex_coord, glm::dvec4(0, 0.5, 0, 1));
    EXPECT_EQ(v.position_object, glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(first_draw(frame).vertices[1].position_object, glm::dvec4(0));
    const Vertex& of_array = std::get<Draw>(frame.items.back()).vertices[0];
    EXPECT_EQ(of_array.normal_object, glm::dvec3(0));
    EXPECT_EQ(of_array.position_object, glm::dvec4(0.25, 0.5, 0, 1));
}

// 4.2.1: without a colour buffer, only depth is drawn and cleared.
TEST(State, DrawsNoColorWithoutABuffer) {
    const Frame frame = frame_of(
        "glClearColor(1, 0, 0, 1); glPushAttrib(GL_COLOR_BUFFER_BIT); glDrawBuffer(GL_NONE);\n"
        "glClear(GL_COLOR_BUFFER_BIT); glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); glRectf(0, 0, 1, 1);\n"
        "glPopAttrib(); glRectf(0, 0, 1, 1);");
    EXPECT_TRUE(frame.unsupported.empty());
    ASSERT_EQ(frame.items.size(), 3u);
    EXPECT_FALSE(std::get<Clear>(frame.items[0]).color);
    EXPECT_TRUE(std::get<Clear>(frame.items[0]).depth);
    EXPECT_EQ(std::get<Draw>(frame.items[1]).fragment.color_mask, (std::array{false, false, false, false}));
    EXPECT_EQ(std::get<Draw>(frame.items[2]).fragment.color_mask, (std::array{true, true, true, true}));
}

}  // namespace

}  // namespace twinlight::state_test

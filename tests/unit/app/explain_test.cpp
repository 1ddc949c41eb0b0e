// `twinlight explain --pixel` and `--vertex`: the printed numbers, multiplied and added here, give the printed colours;
// both forms agree; every line of the text appears where the scene calls for it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <sstream>

#include "../pictures.h"
#include "../run_program.h"
#include "base/image/file.h"
#include "base/image/png.h"
#include "base/text/json.h"

namespace twinlight::explain_test {
namespace {

using nlohmann::json;

// Numbers in JSON have all their digits; what is left is the rounding of some twenty operations.
constexpr double kRounding = 1e-12;
constexpr double kRoundingDeg = 1e-5;  // acos near 1 turns 1e-16 into 1e-8 radians

constexpr const char* kCamera =
    "glMatrixMode(GL_PROJECTION); gluPerspective(45, 1, 0.1, 100); glMatrixMode(GL_MODELVIEW);\n";
constexpr const char* kLook = "gluLookAt(0, 0, 5,  0, 0, 0,  0, 1, 0);\n";
constexpr const char* kLight = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){2, 3, 4, 1});\n";
constexpr const char* kMaterial =
    "glMaterialfv(GL_FRONT, GL_DIFFUSE, (GLfloat[]){1, 0.5, 0.31, 1});\n"
    "glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1}); glMaterialf(GL_FRONT, GL_SHININESS, 4);\n"
    "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_DEPTH_TEST);\n";
constexpr const char* kBall = "glutSolidSphere(1, 16, 8);\n";

std::string ball(const std::string& state) { return std::string(kCamera) + kLook + kLight + kMaterial + state + kBall; }

class Explain : public testing::Test {
  protected:
    std::string scene(const std::string& text) {
        write_file_atomically(in_ / "scene.gl", text);
        return in_ / "scene.gl";
    }
    ProgramResult run(const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"explain", name, "--size", "64x64"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program("twinlight", arguments);
    }
    json parsed(const std::string& name, std::vector<std::string> more) {
        more.emplace_back("--json");
        const ProgramResult result = run(name, more);
        EXPECT_EQ(result.status, 0) << result.err;
        return json::parse(result.out, nullptr, false);
    }
    // The text of a ball with this state, at a pixel near its middle.
    std::string text(const std::string& state, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments = {"--pixel", "33,30"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run(scene(ball(state)), arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }

    const TemporaryFolder in_;
};

glm::dvec3 vec(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }
glm::dvec4 vec4(const json& j) { return {vec(j), j[3].get<double>()}; }
glm::dvec4 times(const json& rows, const glm::dvec4& v) {
    glm::dvec4 product;
    for (int row = 0; row < 4; ++row) product[row] = glm::dot(vec4(rows[static_cast<std::size_t>(row)]), v);
    return product;
}
double degrees(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance, const std::string& what) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(actual[i], expected[i], tolerance * std::max(1.0, std::abs(expected[i]))) << what << ", " << i;
}

// A product such as "att spot n.VP d_cm d_cli" of printed numbers.
glm::dvec3 product(const std::string& formula, const char* color, const json& material, const json& light) {
    glm::dvec3 product(1);
    std::istringstream words(formula);
    for (std::string word; words >> word;) {
        if (word.ends_with("_cm"))
            product *= vec(material[color]);
        else if (word.ends_with("_cli"))
            product *= vec(light["colors"][color]);
        else
            product *= light[word == "att"    ? "attenuation"
                             : word == "spot" ? "spot"
                             : word == "n.VP" ? "n_dot_vp"
                                              : "highlight"]
                           .get<double>();
    }
    return product;
}

// Computes everything about a point from the numbers that it starts with.
void expect_the_arithmetic(const json& point, int& lights) {
    const json& material = point["material"];
    const glm::dvec3 n = vec(point["normal_eye"]), at_eye = vec(point["position_eye"]),
                     to_viewer = vec(point["to_viewer"]);
    EXPECT_NEAR(point["normal_length"].get<double>(), glm::length(n), kRounding);
    if (point.contains("vertex")) {
        const glm::dvec4 eye = times(point["modelview"], vec4(point["position_object"]));
        expect_near(at_eye, glm::dvec3(eye) / eye.w, kRounding, "position_eye");
        glm::dvec3 normal = vec(point["normal_transformed"]);
        EXPECT_NEAR(point["normal_transformed_length"].get<double>(), glm::length(normal), kRounding);
        normal = point["normalize"] ? glm::normalize(normal) : normal * point["rescale_factor"].get<double>();
        expect_near(n, point["face"] == "front" ? normal : -normal, kRounding, "normal_eye");
    }
    const glm::dvec3 scene_ambient = vec(material["ambient"]) * vec(point["scene_ambient_color"]);
    expect_near(vec(point["scene_ambient"]), scene_ambient, kRounding, "scene_ambient");
    glm::dvec3 primary = vec(material["emission"]) + scene_ambient, secondary(0);
    for (const json& light : point["lights"]) {
        SCOPED_TRACE(light["name"].get<std::string>());
        ++lights;
        const json& typed = light["position_typed"];
        const glm::dvec4 position = times(typed["modelview"], vec4(typed["value"]));
        const glm::dvec4 position_eye = vec4(light["position_eye"]);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(position_eye[i], position[i], kRounding * 100);
        const bool directional = light["directional"];
        EXPECT_EQ(directional, position_eye.w == 0);
        const glm::dvec3 away =
            directional ? glm::dvec3(position_eye) : glm::dvec3(position_eye) / position_eye.w - at_eye;
        const glm::dvec3 to_light = glm::normalize(away);
        expect_near(vec(light["to_light"]), to_light, kRounding, "to_light");
        double attenuation = 1;
        if (!directional) {
            const double d = glm::length(away);
            const glm::dvec3 k = vec(light["attenuation_factors"]);
            EXPECT_NEAR(light["distance"].get<double>(), d, kRounding * d);
            EXPECT_NEAR(light["attenuation_denominator"].get<double>(), k.x + k.y * d + k.z * d * d, kRounding * 100);
            attenuation = 1 / (k.x + k.y * d + k.z * d * d);
        }
        EXPECT_NEAR(light["attenuation"].get<double>(), attenuation, kRounding);
        const double cosine = glm::dot(n, to_light), length = glm::length(n);
        EXPECT_NEAR(light["n_dot_vp_unclamped"].get<double>(), cosine, kRounding);
        EXPECT_NEAR(light["n_dot_vp"].get<double>(), std::max(cosine, 0.0), kRounding);
        EXPECT_NEAR(light["normal_to_light_deg"].get<double>(), degrees(cosine / length), kRoundingDeg);

        const bool reflection = point["formulas"]["specular"].get<std::string>().find("r.v") != std::string::npos;
        const glm::dvec3 h = reflection ? 2 * cosine * n - to_light : glm::normalize(to_light + to_viewer);
        expect_near(vec(light["half_vector"]), h, kRounding, "half_vector");
        const double base = reflection ? glm::dot(h, to_viewer) : glm::dot(n, h);
        EXPECT_NEAR(light["n_dot_h_unclamped"].get<double>(), base, kRounding);
        const double shininess = material["shininess"];
        const bool shines = cosine > 0 || reflection;
        EXPECT_NEAR(light["highlight"].get<double>(), shines ? std::pow(std::max(base, 0.0), shininess) : 0,
                    kRounding * 128);
        if (light.contains("spot_exponent")) {
            const glm::dvec3 axis = glm::normalize(vec(light["spot_direction_eye"]));
            const double cosine_to_axis = glm::dot(-to_light, axis);
            EXPECT_NEAR(light["axis_deg"].get<double>(), degrees(cosine_to_axis), kRoundingDeg);
            const bool inside = degrees(cosine_to_axis) <= light["spot_cutoff_deg"].get<double>();
            double falloff = inside ? std::pow(cosine_to_axis, light["spot_exponent"].get<double>()) : 0;
            if (light.contains("smooth_cone_deg")) {  // the lecture's
                const auto cosine_of = [&](int i) {
                    return std::cos(light["smooth_cone_deg"][static_cast<std::size_t>(i)].get<double>() *
                                    std::numbers::pi / 180);
                };
                falloff = std::clamp((cosine_to_axis - cosine_of(1)) / (cosine_of(0) - cosine_of(1)), 0.0, 1.0);
            }
            EXPECT_NEAR(light["spot"].get<double>(), falloff, kRounding * 128);
        } else {
            EXPECT_EQ(light["spot"], 1);
        }
        for (const char* term : {"ambient", "diffuse", "specular"}) {
            const glm::dvec3 expected = product(point["formulas"][term], term, material, light);
            expect_near(vec(light[term]), expected, kRounding, term);
            (term == std::string_view("specular") && point["separate_specular"] ? secondary : primary) += expected;
        }
    }
    expect_near(vec(point["primary_unclamped"]), primary, kRounding, "primary_unclamped");
    expect_near(vec(point["primary"]), glm::clamp(primary, 0.0, 1.0), kRounding, "primary");
    expect_near(vec(point["secondary_unclamped"]), secondary, kRounding, "secondary_unclamped");
    expect_near(vec(point["secondary"]), glm::clamp(secondary, 0.0, 1.0), kRounding, "secondary");
}

// The fragment's colour from its points, without texture, fog and transfer curve.
void expect_the_mean(const json& fragment) {
    glm::dvec3 primary(0), secondary(0);
    double weights = 0;
    for (const json& point : fragment["points"]) {
        const double weight = point["weight"];
        weights += weight;
        primary += weight * vec(point["primary"]);
        secondary += weight * vec(point["secondary"]);
    }
    EXPECT_NEAR(weights, 1, kRounding);
    expect_near(vec(fragment["color"]), glm::clamp(primary + secondary, 0.0, 1.0), kRounding * 10, "color");
}

const char* kSpot =
    "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){-2, -3, -4}); glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 20);"
    "glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 3);\n";

TEST_F(Explain, PrintsNumbersThatMultiplyToTheColor) {
    int lights = 0, fragments = 0;
    for (const std::string& state : {
             std::string(""),
             std::string(
                 "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1); glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, "
                 "0.02);\n"),
             std::string("glScalef(1.3, 1.3, 1.3);\n"),
             std::string("glScalef(1.3, 1, 0.7); glEnable(GL_NORMALIZE);\n"),
             std::string("glScalef(1.3, 1.3, 1.3); glEnable(GL_RESCALE_NORMAL);\n"),
             std::string(kSpot),
             std::string("glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, "
                         "GL_SEPARATE_SPECULAR_COLOR);\n"),
             std::string("glShadeModel(GL_FLAT); glEnable(GL_COLOR_MATERIAL); glColor3f(0.2, 0.9, 0.4);\n"),
             std::string("glEnable(GL_LIGHT3); glLightfv(GL_LIGHT3, GL_AMBIENT, (GLfloat[]){0.1, 0.2, 0.3, 1});"
                         "glLightfv(GL_LIGHT3, GL_POSITION, (GLfloat[]){-1, 1, 1, 0});\n"),
             std::string("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glFrontFace(GL_CW);\n"),
             std::string("glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){0.9, 0.1, 0, 1});\n"),
         })
        for (const char* shading : {"", "phong"}) {
            SCOPED_TRACE(state + shading);
            std::vector<std::string> options = {"--pixel", "33,30"};
            if (*shading) options.insert(options.end(), {"--shading", shading});
            const json pixel = parsed(scene(ball(state)), options);
            const json* seen = nullptr;
            for (const json& fragment : pixel["fragments"]) {
                ++fragments;
                for (const json& point : fragment["points"]) expect_the_arithmetic(point, lights);
                expect_the_mean(fragment);
                if (fragment["passes"]) seen = &fragment;
            }
            ASSERT_TRUE(seen);
            for (const auto& [renderer, color] : pixel["pictures"].items())
                expect_near(vec(color), vec((*seen)["color"]), 1.01 / 255, renderer);
            EXPECT_EQ(pixel["pictures"].size(), *shading ? 2U : 3U);
        }
    EXPECT_GT(fragments, 30);
    EXPECT_GT(lights, 60);
}

TEST_F(Explain, PrintsNumbersThatMultiplyInTheBuiltInScenes) {
    int lights = 0;
    for (const char* name : {"lab", "report", "commands"})
        for (const char* at : {"32,32", "20,40", "44,30", "30,22"}) {
            SCOPED_TRACE(std::string(name) + " " + at);
            const json pixel = parsed(name, {"--pixel", at});
            for (const json& fragment : pixel["fragments"]) {
                if (!fragment["lit"]) continue;
                for (const json& point : fragment["points"]) expect_the_arithmetic(point, lights);
            }
        }
    EXPECT_GT(lights, 50);
}

// The vertex form repeats the pixel form's point, number by number.
TEST_F(Explain, SaysTheSameOfAVertexAsOfAPixel) {
    for (const std::string& state : {std::string(""), std::string("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);\n"),
                                     std::string("glEnable(GL_COLOR_MATERIAL); glColor3f(0.2, 0.9, 0.4);\n")}) {
        const std::string file = scene(ball(state));
        const json pixel = parsed(file, {"--pixel", "33,30"});
        for (const json& fragment : pixel["fragments"]) {
            json point = fragment["points"][0];
            const json vertex = parsed(
                file, {"--vertex", fmt::format("{},{}", fragment["draw"].get<int>(), point["vertex"].get<int>())});
            EXPECT_EQ(vertex["place"], fragment["place"]);
            bool found = false;
            for (json face : vertex["faces"]) {
                // A point has the same colour by all renderers: up to the rounding to 8 bits by two of them.
                const glm::dvec3 color = glm::clamp(vec(face["primary"]) + vec(face["secondary"]), 0.0, 1.0);
                for (const char* renderer : {"fixed", "shaders"})
                    expect_near(vec(face["pictures"][renderer]), color, 1.01 / 255, renderer);
                expect_near(vec(face["pictures"]["reference"]), color, 1e-6, "reference");  // floats
                if (face["face"] != point["face"]) continue;
                found = true;
                for (const char* name : {"weight", "rulings", "pictures"}) face.erase(name), point.erase(name);
                EXPECT_EQ(face, point);
            }
            EXPECT_TRUE(found);
        }
    }
}

// ---- Mistakes that beginners make ----

TEST_F(Explain, ShowsALightThatWasSetBeforeTheCamera) {
    const std::string wrong = std::string(kCamera) + kLight + kLook + kMaterial + kBall;
    const auto light_of = [&](const std::string& text) {
        return parsed(scene(text), {"--vertex", "1,5"})["faces"][0]["lights"][0];
    };
    const json before = light_of(wrong), after = light_of(ball(""));
    EXPECT_EQ(before["position_typed"]["value"], json({2.0, 3.0, 4.0, 1.0}));
    EXPECT_EQ(after["position_typed"]["value"], json({2.0, 3.0, 4.0, 1.0}));
    EXPECT_EQ(before["position_eye"], json({2.0, 3.0, 4.0, 1.0}));
    EXPECT_EQ(after["position_eye"], json({2.0, 3.0, -1.0, 1.0}));  // five units nearer: gluLookAt
    EXPECT_NE(before["position_typed"]["place"].get<std::string>().find(":2:1"), std::string::npos);
    EXPECT_NE(run(scene(wrong), {"--vertex", "1,5"}).out.find("it moves with the camera"), std::string::npos);
    EXPECT_EQ(run(scene(ball("")), {"--vertex", "1,5"}).out.find("it moves with the camera"), std::string::npos);
}

TEST_F(Explain, ShowsTheLengthOfNormalsThatAScaleShortened) {
    const json scaled = parsed(scene(ball("glScalef(3, 3, 3);\n")), {"--vertex", "1,5"})["faces"][0];
    EXPECT_NEAR(scaled["normal_length"].get<double>(), 1.0 / 3, kRounding);
    const std::string dark = "the length of n is 0.33333, not 1";
    EXPECT_NE(text("glScalef(3, 3, 3);\n").find(dark), std::string::npos);
    EXPECT_EQ(text("glScalef(3, 3, 3); glEnable(GL_NORMALIZE);\n").find("note: the length"), std::string::npos);
    EXPECT_EQ(text("").find("note: the length"), std::string::npos);
    EXPECT_NE(text("glScalef(0.5, 0.5, 0.5);\n").find("the light is too bright"), std::string::npos);
}

TEST_F(Explain, ANormalOfZeroHasNoSide) {
    const std::string zero =
        "glNormal3f(0, 0, 0); glBegin(GL_TRIANGLES); glVertex3f(-9, -9, 0); glVertex3f(9, -9, 0);"
        "glVertex3f(0, 9, 0); glEnd();\n";
    const std::string first = run(scene(ball(zero)), {"--vertex", "1,1"}).out;
    EXPECT_NE(first.find("note: n is zero"), std::string::npos) << first;
    EXPECT_NE(first.find("n.VP         0                               n is zero"), std::string::npos) << first;
    EXPECT_EQ(first.find("behind the surface"), std::string::npos);
}

TEST_F(Explain, ShowsALightBehindTheSurfaceAndASpotThatMisses) {
    const char* behind = "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, -9, 1});\n";
    EXPECT_NE(text(behind).find("the light is behind the surface here"), std::string::npos);
    EXPECT_EQ(text("").find("the light is behind the surface here"), std::string::npos);
    const std::string misses = std::string(kSpot) + "glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (GLfloat[]){1, 0, 0});\n";
    EXPECT_NE(text(misses).find("outside the cutoff of 20"), std::string::npos);
    EXPECT_NE(text(misses).find("the cone misses this point"), std::string::npos);
    EXPECT_EQ(text(kSpot).find("the cone misses this point"), std::string::npos);
}

// ---- Lines ----

TEST_F(Explain, SaysWhereAPixelRectangleHasItsColorFrom) {
    const auto of = [&](const std::string& command) {
        return run(scene("glClear(GL_COLOR_BUFFER_BIT); glColor3f(1, 0, 0); glWindowPos2i(8, 8); glPixelZoom(9, 9);\n" +
                         command),
                   {"--pixel", "10,53"})
            .out;
    };
    EXPECT_NE(of("glDrawPixels(1, 1, GL_RGB, GL_FLOAT, (GLfloat[]){0, 1, 0});\n").find("the pixel's own"),
              std::string::npos);
    EXPECT_NE(of("glCopyPixels(0, 0, 1, 1, GL_COLOR);\n").find("a pixel of the picture before it"), std::string::npos);
    EXPECT_NE(of("glDrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, (GLfloat[]){0.5});\n").find("the raster position's"),
              std::string::npos);
    EXPECT_NE(of("glDrawPixels(1, 1, GL_STENCIL_INDEX, GL_INT, (GLint[]){1});\n").find("a stencil value is written"),
              std::string::npos);
}

// "Reference" is OpenGL's own model, as in a comparison. Pictures that light each pixel are with the scene's variants.
TEST_F(Explain, FollowsTheScenesVariantsIfAsked) {
    const std::string state = "#pragma twinlight specular(reflection)\n", line = "VP reflected about n (not in GL)",
                      words = "with the scene's variants";
    EXPECT_EQ(text(state).find(line), std::string::npos);
    EXPECT_EQ(text(state).find(words), std::string::npos);
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--variants"}, {"--shading", "phong"}, {"--shading", "exact"}})
        EXPECT_NE(text(state, options).find(line), std::string::npos);
    EXPECT_NE(text(state, {"--variants"}).find(words), std::string::npos);
}

TEST_F(Explain, HasALineForEveryEffect) {
    const std::string without = text("");
    const auto expect_line = [&](const std::string& state, const std::string& line) {
        EXPECT_EQ(without.find(line), std::string::npos) << line;
        const std::string with = text(state, {"--variants"});
        EXPECT_NE(with.find(line), std::string::npos) << line << "\n" << with;
    };
    expect_line("glEnable(GL_NORMALIZE);\n", "GL_NORMALIZE divides it by its length");
    expect_line("glEnable(GL_RESCALE_NORMAL);\n", "GL_RESCALE_NORMAL multiplies it by 1");
    expect_line("glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);\n", "GL_LIGHT_MODEL_LOCAL_VIEWER is on");
    expect_line("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n", "c_sec");
    expect_line("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n", "secondary colour");
    expect_line("glEnable(GL_COLOR_MATERIAL);\n", "GL_COLOR_MATERIAL takes GL_AMBIENT_AND_DIFFUSE");
    expect_line("glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 2);\n", "1 / (k0 + k1 d + k2 d d)");
    expect_line("glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});\n", "directional (w = 0)");
    expect_line(
        "glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){0, 0, 1, 0});"
        "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);\n",
        "its attenuation factors do nothing");
    expect_line(kSpot, "inside the cutoff of 20: (cos)^exponent");
    expect_line("#pragma twinlight spot_cone(GL_LIGHT0, 10, 50)\n", "full light to 10, none from 50 degrees");
    expect_line("#pragma twinlight specular(reflection)\n", "VP reflected about n (not in GL)");
    expect_line("#pragma twinlight ambient(unattenuated)\n", "sum of ( a_cm a_cli + att spot [");
    expect_line("#pragma twinlight spectrum(9)\n", "multiplied as spectra");
    expect_line("glShadeModel(GL_FLAT);\n", "its provoking vertex, number");
    expect_line("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); glFrontFace(GL_CW);\n", "reversed for the back face");
    expect_line("glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){1, 1, 1, 1});\n", "a_cm a_cli\n");
    expect_line("glMaterialfv(GL_FRONT, GL_EMISSION, (GLfloat[]){1, 1, 1, 1});\n", "e_cm      ");
    expect_line("glDisable(GL_LIGHT0);\n", "no light is enabled");
    expect_line("glDisable(GL_LIGHTING);\n", "GL_LIGHTING is disabled: the colour is glColor's");
    expect_line("glEnable(GL_LIGHT5);\n", "the light's diffuse is black");
    expect_line("glMaterialfv(GL_FRONT, GL_SPECULAR, (GLfloat[]){0, 0, 0, 1});\n", "the material's specular is black");
    expect_line("glEnable(GL_FOG);\n", "after clamping, fog (3.10)");
    expect_line("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);\n", "colour sum (3.9)");
    expect_line("glEnable(GL_LIGHT5);\n", "GL's initial value");
    EXPECT_NE(without.find("this changes it"), std::string::npos);  // the highlight is brighter than 1
    EXPECT_EQ(text("glDisable(GL_LIGHT0);\n").find("this changes it"), std::string::npos);
    EXPECT_NE(text("", {"--shading", "phong"}).find("scaled to length 1"), std::string::npos);
    EXPECT_NE(text("", {"--shading", "exact"}).find("this point of the curved surface"), std::string::npos);
    // Factors that the scene leaves at 1 appear only with --all.
    EXPECT_EQ(without.find("GL_SPOT_CUTOFF is 180"), std::string::npos);
    const std::string all = text("", {"--all"});
    EXPECT_NE(all.find("GL_SPOT_CUTOFF is 180"), std::string::npos);
    EXPECT_NE(all.find("att spot n.VP d_cm d_cli"), std::string::npos);
    EXPECT_NE(without.find("    n.VP d_cm d_cli"), std::string::npos);
    EXPECT_NE(without.find("For the other vertices: --vertex 1,"), std::string::npos);
}

TEST_F(Explain, StartsWithASummaryOfTenLinesAtMost) {
    for (const std::string& name : {std::string("lab"), std::string("report"), std::string("commands"),
                                    scene(ball("glEnable(GL_LIGHT3); glEnable(GL_LIGHT4);\n"))}) {
        const ProgramResult result = run(name, {});
        EXPECT_EQ(result.status, 0);
        const std::string summary = result.out.substr(0, result.out.find("\n\n"));
        EXPECT_LE(std::ranges::count(summary, '\n') + 1, 10) << summary;
        for (const char* line : {"draw", "lights that matter:", "shading:", "skipped:"})
            EXPECT_NE(summary.find(line), std::string::npos) << line;
    }
    const std::string file = scene(ball("glEnable(GL_LIGHT3);\n"));
    const std::string brief = run(file, {}).out, all = run(file, {"--all"}).out;
    EXPECT_NE(brief.find("lights that matter:     GL_LIGHT0\n"), std::string::npos) << brief;
    EXPECT_NE(brief.find("enabled, but skipped:   GL_LIGHT3 ("), std::string::npos) << brief;
    for (const char* off : {"GL_COLOR_MATERIAL is disabled", "GL_FOG is disabled", "GL_LIGHT4 to GL_LIGHT7",
                            "GL_LIGHT0's cone", "GL_LIGHT0's attenuation", "two-sided lighting"}) {
        EXPECT_EQ(brief.find(off), std::string::npos) << off;
        EXPECT_NE(all.find(off), std::string::npos) << off;
    }
}

TEST_F(Explain, RefusesVerticesThatDoNotExist) {
    const std::string file = scene(ball(""));
    const auto expect_refused = [&](const std::string& name, const std::vector<std::string>& options,
                                    const std::string& expected) {
        const ProgramResult result = run(name, options);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(expected), std::string::npos) << result.err;
    };
    expect_refused(file, {"--vertex", "a"}, "--vertex is 'a'; it must be DRAW,N");
    expect_refused(file, {"--vertex", "1"}, "it must be DRAW,N");
    expect_refused(file, {"--vertex", "0,1"}, "there is no draw 0; the scene has draws 1 to ");
    expect_refused(file, {"--vertex", "999,1"}, "there is no draw 999");
    expect_refused(file, {"--vertex", "1,0"}, "draw 1 has no vertex 0; it has vertices 1 to ");
    expect_refused(file, {"--vertex", "1,1", "--pixel", "1,1"}, "give one of them");
    expect_refused(file, {"--vertex", "1,1", "--shading", "flat"}, "leave it out");
    expect_refused(scene(ball("glDisable(GL_LIGHTING);\n")), {"--vertex", "1,1"}, "GL_LIGHTING is disabled");
}

}  // namespace
}  // namespace twinlight::explain_test

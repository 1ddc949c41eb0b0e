// The programmable renderer: the text of its programs, and pictures of hand-built draws compared with colours computed
// by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "../hand_built_draws.h"
#include "render/effect/plan.h"
#include "render/programmable/export/shader_text.h"
#include "render/programmable/text/shader_assembly.h"

namespace twinlight::programmable::programmable_test {
namespace {

// ---- The shader text ----

std::string vertex_shader(const Draw& draw) { return assemble(plan_effects(draw, {}).effects).vertex; }

TEST(ShaderText, HoldsOnlyWhatIsCalledFor) {
    LightingState lighting = dark();
    lighting.front.diffuse = {1, 1, 1, 1};
    const std::string text = vertex_shader(square(lighting));
    for (const char* absent : {"#if", "EFFECT_", "power", "attenuation", "spot(", "u_light0_spot", "u_eye_from_object;",
                               "half_dir", "_specular", "u_back", "a_color", "light1", "EXPONENT", "POSITION", "unit("})
        EXPECT_EQ(text.find(absent), text.npos) << absent << " in\n" << text;
    EXPECT_NE(text.find("u_light0_front_diffuse"), text.npos);
}

TEST(ShaderText, RepeatsTheLightsPieceOnceALight) {
    LightingState lighting = dark();
    lighting.front.diffuse = {1, 1, 1, 1};
    lighting.lights[3] = lighting.lights[0];
    const std::string text = vertex_shader(square(lighting));
    EXPECT_NE(text.find("u_light1_direction_eye"), text.npos);
    EXPECT_EQ(text.find("u_light2_direction_eye"), text.npos);
}

TEST(ShaderText, LightsInTheStageThatTheShadingAsksFor) {
    LightingState lighting = dark();
    lighting.front.diffuse = {1, 1, 1, 1};
    Draw draw = square(lighting);
    draw.vertices.edit()[0].normal_object = {1, 0, 0};  // equal normals would always be lit per vertex
    const ShaderSource gouraud = assemble(plan_effects(draw, {}).effects);
    const ShaderSource phong = assemble(plan_effects(draw, kPhong).effects);
    EXPECT_NE(gouraud.vertex.find("n_dot_vp"), std::string::npos);
    EXPECT_EQ(gouraud.fragment.find("n_dot_vp"), std::string::npos);
    EXPECT_EQ(phong.vertex.find("n_dot_vp"), std::string::npos);
    EXPECT_NE(phong.fragment.find("n_dot_vp"), std::string::npos);
}

TEST(ShaderText, IsGivenForAFrameWithoutAContext) {
    Frame frame;
    frame.items = {Clear{}, square(), square()};
    const std::string text = shader_source(frame, {});
    EXPECT_NE(text.find("#version 130"), text.npos);
    EXPECT_EQ(text.find("#version 130", text.rfind("#version 130") + 1), text.npos);
    EXPECT_NE(text.find("GL_LIGHT3: it is not enabled"), text.npos) << text;
}

// ---- The equation's terms ----

TEST(Programmable, ShowsTheColorWhenLightingIsOff) {
    LightingState lighting;
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices.edit()[0].color = {0.25, 0.5, 1.5, 0.75};
    expect_color(color(draw), {0.25, 0.5, 1, 0.75});
}

TEST(Programmable, AddsEmissionAndTheSceneAmbient) {
    LightingState lighting = dark();
    lighting.front.emission = {0.125, 0, 0, 1};
    lighting.front.ambient = {0.5, 0.25, 0, 1};
    lighting.front.diffuse.a = 0.25;  // the diffuse alpha is the result's alpha
    lighting.light_model.ambient = {0.5, 1, 1, 1};
    expect_color(color(point({0, 0, 0}, lighting)), {0.375, 0.25, 0, 0.25});
}

TEST(Programmable, LightsByTheCosineOfTheAngleToADirectionalLight) {
    LightingState lighting = dark();
    lighting.front.diffuse = {0.5, 1, 0, 1};
    lighting.lights[0].position_eye = {0, 7 * kHalfRoot3, 3.5, 0};  // 60 degrees
    expect_color(color(point({1, 2, 3}, lighting)), {0.25, 0.5, 0, 1});
    lighting.lights[0].position_eye.z = -1;
    expect_color(color(point({1, 2, 3}, lighting)), grey(0));
}

TEST(Programmable, LightsByTheCosineOfTheAngleToAPositionalLight) {
    LightingState lighting = dark();
    lighting.front.diffuse = {0.5, 1, 0, 1};
    lighting.lights[0].position_eye = {2, 4 + 2 * kHalfRoot3, 8, 2};  // (1, 2 + 2 sin 60, 4) - (1, 2, 3)
    lighting.lights[0].position_eye = {2, 2 * (2 + 2 * kHalfRoot3), 8, 2};
    expect_color(color(point({1, 2, 3}, lighting)), {0.25, 0.5, 0, 1});
}

TEST(Programmable, LightsTheHighlightByTheHalfVector) {
    LightingState lighting = shiny(4);
    lighting.lights[0].position_eye = {kHalfRoot3, 0, 0.5, 0};  // 60 degrees: the half vector is at 30
    const double highlight = std::pow(0.75, 2);
    expect_color(color(point({1, 2, 3}, lighting)), {highlight, highlight / 2, 0, 1});
    lighting.front.shininess = 0.5;
    expect_color(color(point({1, 2, 3}, lighting)), {std::pow(0.75, 0.25), std::pow(0.75, 0.25) / 2, 0, 1});
    lighting.front.shininess = 0;
    expect_color(color(point({1, 2, 3}, lighting)), {1, 0.5, 0, 1});
    lighting.lights[0].position_eye.z = -0.5;  // f_i is 0: the light is behind
    expect_color(color(point({1, 2, 3}, lighting)), grey(0));
}

TEST(Programmable, SquaresWholeExponentsUpTo128) {
    for (const double shininess : {1, 2, 3, 31, 64, 127, 128}) {
        LightingState lighting = shiny(shininess);
        lighting.lights[0].position_eye = {0.28, 0, 0.96, 0};  // the half vector's cosine is sqrt(0.98)
        const double highlight = std::pow(0.98, shininess / 2);
        expect_color(color(point({0, 0, 0}, lighting)), {highlight, highlight / 2, 0, 1});
    }
}

TEST(Programmable, LooksFromTheOriginWithALocalViewer) {
    LightingState lighting = shiny(2);
    lighting.light_model.local_viewer = true;
    // The light is above the vertex, the viewer at 45 degrees, the half vector at 22.5: cos^2 = (1 + cos 45) / 2.
    const double highlight = (1 + std::sqrt(0.5)) / 2;
    expect_color(color(point({-3, 0, -3}, lighting)), {highlight, highlight / 2, 0, 1});
    lighting.lights[0].position_eye = {-3, 0, 9, 1};
    expect_color(color(point({-3, 0, -3}, lighting)), {highlight, highlight / 2, 0, 1});
}

TEST(Programmable, LightsTheHighlightByReflectionWhereThePragmaSaysSo) {
    LightingState lighting = shiny(2);
    lighting.light_model.specular = Word::reflection;
    lighting.lights[0].position_eye = {0.5, 0, kHalfRoot3, 0};  // 30 degrees, and so is the reflection
    expect_color(color(point({0, 0, 0}, lighting)), {0.75, 0.375, 0, 1});
    const double half_vector = (1 + kHalfRoot3) / 2;  // cos^2 of 15 degrees
    expect_color(color(point({0, 0, 0}, lighting), kGlAlone), {half_vector, half_vector / 2, 0, 1});
    lighting.front.shininess = 0;
    expect_color(color(point({0, 0, 0}, lighting)), {1, 0.5, 0, 1});
}

TEST(Programmable, AttenuatesEveryTermOfAPositionalLight) {
    LightingState lighting = dark();
    lighting.front.ambient = {1, 0, 0, 1};
    lighting.front.diffuse = {0, 1, 0, 1};
    LightSource& light = lighting.lights[0];
    light.ambient = {0.75, 0, 0, 1};
    light.position_eye = {0, 0, 2, 1};
    light.constant_attenuation = 1;
    light.linear_attenuation = 0.5;
    light.quadratic_attenuation = 0.25;  // at distance 2: 1 / 3
    expect_color(color(point({0, 0, 0}, lighting)), {0.25, 1.0 / 3, 0, 1});
    lighting.light_model.light_ambient = Word::unattenuated;
    expect_color(color(point({0, 0, 0}, lighting)), {0.75, 1.0 / 3, 0, 1});
    expect_color(color(point({0, 0, 0}, lighting), kGlAlone), {0.25, 1.0 / 3, 0, 1});
    light.position_eye.w = 0;
    expect_color(color(point({0, 0, 0}, lighting)), {0.75, 1, 0, 1});
}

// A light 2 above the origin, shining down, 30 degrees off the cone's axis.
LightingState spotlight(double w) {
    LightingState lighting = dark();
    lighting.front.ambient = {1, 0, 0, 1};
    lighting.front.diffuse = {0, 1, 0, 1};
    lighting.lights[0].ambient = {1, 0, 0, 1};
    lighting.lights[0].position_eye = {0, 0, 2, w};
    lighting.lights[0].spot_direction_eye = {1, 0, -2 * kHalfRoot3};
    return lighting;
}

TEST(Programmable, LightsInsideTheConeOnlyAndFallsOffByTheExponent) {
    for (const double w : {1, 0}) {
        LightingState lighting = spotlight(w);
        LightSource& light = lighting.lights[0];
        light.spot_cutoff_deg = 29.9;
        expect_color(color(point({0, 0, 0}, lighting)), grey(0));
        light.spot_cutoff_deg = 30.1;
        expect_color(color(point({0, 0, 0}, lighting)), {1, 1, 0, 1});
        light.spot_exponent = 2;
        expect_color(color(point({0, 0, 0}, lighting)), {0.75, 0.75, 0, 1});
        light.spot_exponent = 1.5;
        expect_color(color(point({0, 0, 0}, lighting)), {std::pow(0.75, 0.75), std::pow(0.75, 0.75), 0, 1});
    }
}

TEST(Programmable, LightsTheAxisOfAConeOfNoWidthAndTheBorderOfOneOf90Degrees) {
    for (const double w : {1, 0}) {
        LightingState lighting = spotlight(w);
        LightSource& light = lighting.lights[0];
        light.spot_cutoff_deg = 0;
        light.position_eye = {0.3, 0.7, 2, w};
        light.spot_direction_eye = -glm::dvec3(light.position_eye);
        EXPECT_GT(color(point({0, 0, 0}, lighting)).g, 0.5);
        light.spot_cutoff_deg = 90;
        light.spot_direction_eye = {0.7, -0.3, 0};
        EXPECT_GT(color(point({0, 0, 0}, lighting)).g, 0.5);
    }
}

// 2.14.1 compares max(PV . s, 0) with cos 90.
TEST(Programmable, LightsWhatIsBehindAConeOf90DegreesIfTheExponentIs0) {
    for (const double w : {1, 0}) {
        for (const double exponent : {0.0, 1.0}) {
            LightingState lighting = spotlight(w);
            LightSource& light = lighting.lights[0];
            light.position_eye = {0.3, 0.7, 2, w};
            light.spot_direction_eye = glm::dvec3(light.position_eye);
            light.spot_cutoff_deg = 90;
            light.spot_exponent = exponent;
            const double green = color(point({0, 0, 0}, lighting)).g;
            if (exponent == 0)
                EXPECT_GT(green, 0.5);
            else
                EXPECT_EQ(green, 0);
        }
    }
}

TEST(Programmable, SoftensTheConeWhereThePragmaSaysSo) {
    for (const double w : {1, 0}) {
        LightingState lighting = spotlight(w);
        lighting.lights[0].smooth_cone = LightSource::SmoothCone{0, 60};
        const double spot = (kHalfRoot3 - 0.5) / (1 - 0.5);
        expect_color(color(point({0, 0, 0}, lighting)), {spot, spot, 0, 1});
        expect_color(color(point({0, 0, 0}, lighting), kGlAlone), {1, 1, 0, 1});
        lighting.lights[0].smooth_cone = LightSource::SmoothCone{20, 25};
        expect_color(color(point({0, 0, 0}, lighting)), grey(0));
        lighting.lights[0].smooth_cone = LightSource::SmoothCone{30, 30};  // a step that includes its border
        expect_color(color(point({0, 0, 0}, lighting)), {1, 1, 0, 1});
    }
}

TEST(Programmable, SumsEightLights) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    for (int i = 0; i < kMaxLights; ++i) {
        LightSource& light = lighting.lights[static_cast<std::size_t>(i)];
        light.enabled = true;
        light.diffuse = grey(1.0 / 16);
        light.position_eye = {0, 0, 1 + i, i % 2};
    }
    expect_color(color(point({0, 0, 0}, lighting)), grey(0.5));
}

// ---- Faces, colours, normals ----

TEST(Programmable, LightsTheBackWithItsOwnMaterialAndTheNormalReversed) {
    LightingState lighting = dark();
    lighting.light_model.two_side = true;
    lighting.front.diffuse = {1, 0, 0, 1};
    lighting.back.diffuse = {0, 1, 0, 1};
    lighting.back.specular = {0, 0, 1, 1};
    for (const Options& options : {Options{}, kPhong}) {
        Draw draw = square(lighting);
        expect_color(color(draw, options), {1, 0, 0, 1});
        draw.raster.front_face = kGL_CW;
        expect_color(color(draw, options), grey(0));  // the light is on its other side
        draw.lighting.lights[0].position_eye.z = -1;
        expect_color(color(draw, options), {0, 1, 1, 1});
        draw.lighting.light_model.two_side = false;
        expect_color(color(draw, options), grey(0));
    }
}

TEST(Programmable, AddsTheSeparateSpecularColorAfterTheClamp) {
    LightingState lighting = dark();
    lighting.front.emission = {-0.5, 0.25, 0.75, 1};
    lighting.front.specular = grey(0.5);
    expect_color(color(point({0, 0, 0}, lighting)), {0, 0.75, 1, 1});
    lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    expect_color(color(point({0, 0, 0}, lighting)), {0.5, 0.75, 1, 1});
    expect_color(color(point({0, 0, 0}, lighting), kPhong), {0.5, 0.75, 1, 1});
}

TEST(Programmable, TracksTheVertexColorByFaceAndMode) {
    struct Case {
        Enum mode;
        glm::dvec4 expected;
    };
    // The material's emission is 1/16; its ambient, diffuse and specular colours are 1/4 each, under lights of 1/2. The
    // vertex colour is 1/2 red.
    const double rest = 1.0 / 16 + 3.0 / 8;
    const Case cases[] = {{kGL_EMISSION, {0.5 + 3.0 / 8, 3.0 / 8, 3.0 / 8, 1}},
                          {kGL_AMBIENT, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 1}},
                          {kGL_DIFFUSE, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 0.75}},
                          {kGL_SPECULAR, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 1}},
                          {kGL_AMBIENT_AND_DIFFUSE, {rest + 2.0 / 8, rest - 2.0 / 8, rest - 2.0 / 8, 0.75}}};
    for (const Case& c : cases)
        for (const bool same_color : {true, false})  // one colour goes into the material, several into an attribute
            for (const bool attenuated : {false, true})
                for (const Options& options : {Options{}, kPhong}) {
                    LightingState lighting = dark();
                    lighting.front.emission = grey(1.0 / 16);
                    lighting.front.ambient = lighting.front.diffuse = lighting.front.specular = grey(0.25);
                    LightSource& light = lighting.lights[0];
                    light.ambient = light.diffuse = light.specular = grey(0.5);
                    light.position_eye = {0, 0, 1, attenuated};
                    light.constant_attenuation = attenuated ? 0.5 : 1;
                    light.linear_attenuation = attenuated ? 0.5 : 0;
                    lighting.color_material = {.enabled = true, .face = kGL_FRONT, .mode = c.mode};
                    Draw draw = point({0, 0, 0}, lighting);
                    draw.vertices.edit()[0].color = {0.5, 0, 0, 0.75};
                    draw.indices = {0};
                    draw.vertices.edit().push_back(draw.vertices[0]);
                    if (!same_color) draw.vertices.edit()[1].color = {1, 1, 1, 1};
                    // Each of the material's own terms is 1/4 * 1/2.
                    expect_color(color(draw, options), c.expected);
                    draw.lighting.color_material.face = kGL_BACK;
                    expect_color(color(draw, options), {rest, rest, rest, 1});
                }
}

TEST(Programmable, NormalizesAndRescalesUnderAScale) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    Draw draw = point({0, 0, 0}, lighting);
    draw.eye_from_object = glm::scale(glm::dmat4(1), glm::dvec3(4));
    expect_color(color(draw), grey(0.25));
    draw.lighting.rescale_normal = true;
    expect_color(color(draw), grey(1));
    draw.lighting.rescale_normal = false;
    draw.lighting.normalize = true;
    expect_color(color(draw), grey(1));
    draw.eye_from_object = glm::scale(glm::dmat4(1), glm::dvec3(1, 1, 2));
    draw.vertices.edit()[0].normal_object = {0, 3, 6};  // becomes (0, 3, 3)
    expect_color(color(draw), grey(std::sqrt(0.5)));
}

TEST(Programmable, DividesTheVertexByItsW) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    lighting.lights[0].position_eye = {0, 0, 1, 1};
    lighting.lights[0].constant_attenuation = 0;
    lighting.lights[0].linear_attenuation = 1;
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices.edit()[0].position_object = {0, 0, -2, 2};  // at distance 2
    for (const Options& options : {Options{}, kPhong}) expect_color(color(draw, options), grey(0.5));
}

}  // namespace
}  // namespace twinlight::programmable::programmable_test

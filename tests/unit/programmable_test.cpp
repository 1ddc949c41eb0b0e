// The shader path: what the text of a program holds, and pictures of hand-built frames against colours by
// hand.
#include "programmable/programmable.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "command/text.h"
#include "context/context.h"
#include "context/gl.h"
#include "effect/plan.h"
#include "fixed/fixed.h"
#include "programmable/assembly.h"
#include "state/state.h"

namespace twinlight::programmable {
namespace {

// What float arithmetic and a float colour buffer may differ from a value by hand, on colours of about 1.
constexpr double kFloatArithmetic = 20 * std::numeric_limits<float>::epsilon();
constexpr double kHalfRoot3 = 0.86602540378443865;

const RenderOptions kPhong{.shading = Shading::kPhong};
const RenderOptions kGlAlone{.shading = std::nullopt, .lecture_variants = false};

// A black material, no scene ambient, GL_LIGHT0 on: each test adds the term that it looks at.
LightingState dark() {
    LightingState lighting;
    lighting.enabled = true;
    lighting.lights[0].enabled = true;
    lighting.light_model.ambient = {0, 0, 0, 1};
    for (Material* material : {&lighting.front, &lighting.back})
        material->ambient = material->diffuse = {0, 0, 0, 1};
    return lighting;
}

// A square over the whole picture: in object and eye coordinates from (-1, -1, 0) to (1, 1, 0),
// counterclockwise, facing along z. Clip coordinates take z away, so that it is seen wherever it lies.
Draw square(const LightingState& lighting = dark()) {
    Draw draw;
    draw.mode = kGL_QUADS;
    for (const glm::dvec2 corner :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
        draw.vertices.push_back(
            {.position_object = {corner, 0, 1}, .normal_object = {0, 0, 1}, .color = {1, 1, 1, 1}});
    draw.clip_from_eye[2][2] = 0;
    draw.lighting = lighting;
    return draw;
}

// A single vertex that fills a picture of one pixel, wherever it lies.
Draw point(const glm::dvec3& position, const LightingState& lighting = dark()) {
    Draw draw;
    draw.mode = kGL_POINTS;
    draw.vertices = {
        {.position_object = glm::dvec4(position, 1), .normal_object = {0, 0, 1}, .color = {1, 1, 1, 1}}};
    draw.clip_from_eye = glm::dmat4(0);
    draw.clip_from_eye[3][3] = 1;
    draw.lighting = lighting;
    return draw;
}

Image picture(Draw draw, int size, const RenderOptions& options = {}) {
    const auto context = make_offscreen_context(size, size, ColorBuffer::kFloat);
    draw.raster.viewport = {0, 0, size, size};
    Frame frame{.width = size, .height = size, .items = {draw}, .unsupported = {}, .commands = nullptr};
    Renderer renderer;
    Image image = renderer.render(frame, options);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return image;
}

// The colour of a picture of one pixel.
glm::dvec4 color(const Draw& draw, const RenderOptions& options = {}) {
    const Rgba c = picture(draw, 1, options).at(0, 0);
    return {c[0], c[1], c[2], c[3]};
}

void expect_color(const glm::dvec4& actual, const glm::dvec4& expected) {
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(actual[i], expected[i], kFloatArithmetic)
            << fmt::format("({}, {}, {}, {})", actual.r, actual.g, actual.b, actual.a);
}

glm::dvec4 grey(double value) { return {value, value, value, 1}; }

std::string vertex_shader(const Draw& draw) { return assemble(plan_effects(draw, {}).effects).vertex; }

// ---- The text ----

TEST(ShaderText, HoldsOnlyWhatIsCalledFor) {
    LightingState lighting = dark();
    lighting.front.diffuse = {1, 1, 1, 1};
    const std::string text = vertex_shader(square(lighting));
    for (const char* absent :
         {"#if", "EFFECT_", "power", "attenuation", "spot", "u_eye_from_object;", "half_dir", "specular",
          "u_back", "a_color", "light1", "LIGHTi", "FACE", "unit("})
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
    const ShaderSource gouraud = assemble(plan_effects(square(lighting), {}).effects);
    const ShaderSource phong = assemble(plan_effects(square(lighting), kPhong).effects);
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
    draw.vertices[0].color = {0.25, 0.5, 1.5, 0.75};
    expect_color(color(draw), {0.25, 0.5, 1, 0.75});
}

TEST(Programmable, AddsEmissionAndTheSceneAmbient) {
    LightingState lighting = dark();
    lighting.front.emission = {0.125, 0, 0, 1};
    lighting.front.ambient = {0.5, 0.25, 0, 1};
    lighting.front.diffuse.a = 0.25;  // the diffuse colour's alpha is the colour's
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

LightingState shiny(double shininess) {
    LightingState lighting = dark();
    lighting.front.specular = {1, 0.5, 0, 1};
    lighting.front.shininess = shininess;
    return lighting;
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
    lighting.lights[0].position_eye.z = -0.5;  // f_i: the light is behind
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
    // The light is above the vertex, the viewer at 45 degrees, the half vector at 22.5: cos^2 = (1 + cos 45)
    // / 2.
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

// A light 2 above the origin that shines down, 30 degrees away from the cone's axis.
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
    for (const RenderOptions& options : {RenderOptions{}, kPhong}) {
        Draw draw = square(lighting);
        expect_color(color(draw, options), {1, 0, 0, 1});
        draw.raster.front_face = kGL_CW;
        expect_color(color(draw, options), grey(0));  // the light is in front of it
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
    // Of the material remains 1/16 emission; ambient 1/4, diffuse 1/4 and specular 1/4 meet lights of 1/2;
    // the colour is 1/2 red.
    const double rest = 1.0 / 16 + 3.0 / 8;
    const Case cases[] = {{kGL_EMISSION, {0.5 + 3.0 / 8, 3.0 / 8, 3.0 / 8, 1}},
                          {kGL_AMBIENT, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 1}},
                          {kGL_DIFFUSE, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 0.75}},
                          {kGL_SPECULAR, {rest + 1.0 / 8, rest - 1.0 / 8, rest - 1.0 / 8, 1}},
                          {kGL_AMBIENT_AND_DIFFUSE, {rest + 2.0 / 8, rest - 2.0 / 8, rest - 2.0 / 8, 0.75}}};
    for (const Case& c : cases)
        for (const bool same_color :
             {true, false})  // one colour becomes the material's, several an attribute
            for (const bool attenuated : {false, true})
                for (const RenderOptions& options : {RenderOptions{}, kPhong}) {
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
                    draw.vertices[0].color = {0.5, 0, 0, 0.75};
                    draw.indices = {0};
                    draw.vertices.push_back(draw.vertices[0]);
                    if (!same_color) draw.vertices[1].color = {1, 1, 1, 1};
                    // 1/4 of the material's own terms each: as 1/8 of a light of 1/2.
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
    draw.vertices[0].normal_object = {0, 3, 6};  // becomes (0, 3, 3)
    expect_color(color(draw), grey(std::sqrt(0.5)));
}

TEST(Programmable, DividesTheVertexByItsW) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    lighting.lights[0].position_eye = {0, 0, 1, 1};
    lighting.lights[0].constant_attenuation = 0;
    lighting.lights[0].linear_attenuation = 1;
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices[0].position_object = {0, 0, -2, 2};  // at distance 2
    for (const RenderOptions& options : {RenderOptions{}, kPhong})
        expect_color(color(draw, options), grey(0.5));
}

// ---- Shading ----

// Emission follows the colours: 2 on the left, 0 on the right.
Draw ramp() {
    LightingState lighting = dark();
    lighting.color_material = {.enabled = true, .face = kGL_FRONT_AND_BACK, .mode = kGL_EMISSION};
    Draw draw = square(lighting);
    for (Vertex& v : draw.vertices) v.color = v.position_object.x < 0 ? grey(2) : grey(0);
    return draw;
}

TEST(Programmable, ClampsAtTheVertexBeforeItInterpolates) {
    const Image image = picture(ramp(), 8);
    for (int x = 0; x < 8; ++x) EXPECT_NEAR(image.at(x, 4)[0], 1 - (x + 0.5) / 8, kFloatArithmetic);
}

TEST(Programmable, ClampsEachFragmentInPhongShading) {
    const Image image = picture(ramp(), 8, kPhong);
    for (int x = 0; x < 8; ++x)
        EXPECT_NEAR(image.at(x, 4)[0], std::min(1.0, 2 - (x + 0.5) / 4), kFloatArithmetic);
}

TEST(Programmable, FindsInPhongShadingTheHighlightThatGouraudMisses) {
    LightingState lighting = shiny(128);
    lighting.front.specular = grey(1);
    lighting.lights[0].position_eye = {0, 0, 0.5, 1};
    const double half_pixel = 1.0 / 9;
    const int middle = 4;  // of 9: its centre is (0, 0), right below the light
    EXPECT_NEAR(picture(square(lighting), 9).at(middle, middle)[0], 0, kFloatArithmetic);
    const Image phong = picture(square(lighting), 9, kPhong);
    EXPECT_NEAR(phong.at(middle, middle)[0], 1, kFloatArithmetic);
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(-2 * half_pixel, 0, 0.5));
    const double n_dot_h = glm::normalize(to_light + glm::dvec3(0, 0, 1)).z;
    EXPECT_NEAR(phong.at(middle + 1, middle)[0], std::pow(n_dot_h, 128), 128 * kFloatArithmetic);
}

TEST(Programmable, MakesInterpolatedNormalsUnitInPhongShading) {
    LightingState lighting = dark();
    lighting.front.diffuse = grey(1);
    Draw draw = square(lighting);
    for (Vertex& v : draw.vertices)
        v.normal_object = {v.position_object.x * kHalfRoot3, 0, 0.5};  // +-60 degrees
    EXPECT_NEAR(picture(draw, 9, kPhong).at(4, 4)[0], 1, kFloatArithmetic);
    EXPECT_NEAR(picture(draw, 9).at(4, 4)[0], 0.5, kFloatArithmetic);
}

// ---- What the driver's own fixed function draws ----

void immediate(const Draw& draw) {
    glShadeModel(draw.lighting.shade_model);
    glPolygonMode(GL_FRONT, draw.raster.polygon_mode_front);
    glPolygonMode(GL_BACK, draw.raster.polygon_mode_back);
    glBegin(draw.mode);
    for (std::size_t i = 0; i < draw.count(); ++i) {
        const Vertex& v = draw.vertices[draw.index(i)];
        glColor4d(v.color.r, v.color.g, v.color.b, v.color.a);
        glVertex4d(v.position_object.x, v.position_object.y, v.position_object.z, v.position_object.w);
    }
    glEnd();
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

// A zigzag for strips, a ring for fans and polygons; every vertex another colour.
Draw primitives(Enum mode) {
    Draw draw;
    draw.mode = mode;
    const int count = 8;
    const bool ring = mode == kGL_POLYGON || mode == kGL_TRIANGLE_FAN || mode == kGL_LINE_LOOP;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979 * (i + 0.3) / count;
        glm::dvec2 p = ring ? 0.9 * glm::dvec2(std::cos(angle), std::sin(angle))
                            : glm::dvec2(-0.9 + 0.5 * (i / 2) + 0.07 * (i % 2), i % 2 ? 0.83 : -0.77);
        if (mode == kGL_QUADS && i % 4 >= 2) p.y = -p.y;
        draw.vertices.push_back({.position_object = {p, 0, 1},
                                 .normal_object = {0, 0, 1},
                                 .color = {(i & 1) ? 1 : 0.2, (i & 2) ? 1 : 0.2, (i & 4) ? 1 : 0.2, 1}});
    }
    return draw;
}

TEST(Programmable, TakesEachPrimitivesProvokingVertexFromTheDriver) {
    const int size = 64;
    for (Enum mode = kGL_POINTS; mode <= kGL_POLYGON; ++mode)
        for (const Enum shade_model : {kGL_FLAT, kGL_SMOOTH})
            for (const Enum polygon_mode : {kGL_FILL, kGL_LINE, kGL_POINT})
                for (const bool indexed : {false, true}) {
                    Draw draw = primitives(mode);
                    draw.lighting.shade_model = shade_model;
                    draw.raster.polygon_mode_front = draw.raster.polygon_mode_back = polygon_mode;
                    if (indexed) draw.indices = {0, 1, 2, 3, 4, 5, 6, 7};
                    const Image ours = quantised(picture(draw, size));
                    const auto context = make_offscreen_context(size, size, ColorBuffer::kFloat);
                    immediate(draw);
                    const Image drivers = quantised(read_pixels(size, size));
                    EXPECT_EQ(ours.pixels, drivers.pixels) << fmt::format(
                        "mode {} shade model {:#x} polygon mode {:#x}", mode, shade_model, polygon_mode);
                }
}

TEST(Programmable, FollowsTable212sProvokingVertexOfPolygonsQuadsAndStrips) {
    struct Case {
        Enum mode;
        std::size_t provoking;  // of the first primitive
    };
    for (const Case& c : {Case{kGL_POLYGON, 0}, Case{kGL_QUADS, 3}, Case{kGL_QUAD_STRIP, 3},
                          Case{kGL_TRIANGLES, 2}, Case{kGL_TRIANGLE_STRIP, 2}, Case{kGL_TRIANGLE_FAN, 2}}) {
        Draw draw = square();
        draw.mode = c.mode;
        if (c.mode == kGL_QUAD_STRIP) std::swap(draw.vertices[2], draw.vertices[3]);
        if (c.mode == kGL_TRIANGLES) draw.vertices.pop_back();
        draw.lighting.enabled = false;
        for (Vertex& v : draw.vertices) v.color = grey(0.25);
        draw.vertices[c.provoking].color = grey(0.75);
        const Image image = picture(draw, 8, {.shading = Shading::kFlat});
        EXPECT_EQ(image.at(5, 6)[0], 0.75f)
            << "mode " << c.mode;  // near (1, -1), which is in each first primitive
    }
}

// What lights a scene's spheres differently in every way that GL has.
constexpr const char* kScene = R"(
gluPerspective(45, 1, 0.1, 100);
glMatrixMode(GL_MODELVIEW);
gluLookAt(0, 1, 6,  0, 0, 0,  0, 1, 0);
GLfloat key[] = {2, 3, 4, 1}, red[] = {1, 0.3, 0.2, 1}, shiny[] = {0.7, 0.8, 0.9, 1};
glLightfv(GL_LIGHT0, GL_POSITION, key);
glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.09);
glLightfv(GL_LIGHT0, GL_AMBIENT, (GLfloat[]){0.2, 0.1, 0.3, 1});
glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-2, 1, 3, 0});
glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){0.2, 0.3, 0.5, 1});
glLightfv(GL_LIGHT1, GL_SPECULAR, (GLfloat[]){0.5, 0.5, 0.5, 1});
glLightfv(GL_LIGHT2, GL_POSITION, (GLfloat[]){0, 3, 1, 1});
glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, (GLfloat[]){0, -3, -1});
glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 40);
glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 7);
glLightfv(GL_LIGHT2, GL_DIFFUSE, (GLfloat[]){0, 0.5, 0, 1});
glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_LIGHT1); glEnable(GL_LIGHT2);
glEnable(GL_DEPTH_TEST); glEnable(GL_NORMALIZE);
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shiny);
glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);
glutSolidSphere(1, 24, 12);
glTranslatef(1.5, 0, 0);
glScalef(0.5, 1, 0.5);
glRotatef(120, 1, 0.2, 0);
glutSolidCone(0.8, 1.2, 16, 4);
)";

TEST(Programmable, DrawsWhatTheDriversFixedFunctionDraws) {
    constexpr int kSize = 200;
    const auto scene = std::make_shared<const CommandList>(read_scene(kScene, "scene.gl", "scene"));
    StateOptions state_options;
    state_options.width = state_options.height = kSize;
    const Frame frame = make_frame(scene, state_options);
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
        const auto context = make_offscreen_context(kSize, kSize);
        const Image before = fixed::render(frame, {.shading = shading});
        Renderer renderer;
        const Image ours = renderer.render(frame, {.shading = shading});
        EXPECT_EQ(fixed::render(frame, {.shading = shading}).pixels, before.pixels)
            << "the context is as it was";
        int differing = 0;
        double largest = 0;
        for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
            double difference = 0;
            for (std::size_t c = 0; c < 4; ++c)
                difference = std::max(difference, std::abs(double(ours.pixels[i][c]) - before.pixels[i][c]));
            differing += difference > 0.5 / 255;
            largest = std::max(largest, difference);
        }
        EXPECT_LT(differing, kSize * kSize / 1000);
        RecordProperty(fmt::format("differing_{}", int(shading)), differing);
        EXPECT_LT(largest, 1.5 / 255);  // one code
    }
}

TEST(Programmable, LeavesTheContextAsItWas) {
    const auto context = make_offscreen_context(8, 8);
    Draw draw = square();
    draw.indices = {0, 1, 2, 3};
    draw.raster.depth_test = draw.raster.cull_enabled = true;
    draw.raster.polygon_mode_front = kGL_LINE;
    draw.raster.viewport = {1, 2, 3, 4};
    Renderer renderer;
    renderer.draw({.width = 8,
                   .height = 8,
                   .items = {Clear{.color = true, .clear_color = grey(0.5)}, draw},
                   .unsupported = {},
                   .commands = nullptr},
                  {});
    const auto value = [](GLenum name) {
        GLint values[4] = {};
        glGetIntegerv(name, values);
        return values[0];
    };
    for (const GLenum name : {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_ARRAY_BUFFER_BINDING,
                              GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_DEPTH_TEST, GL_CULL_FACE, GL_VIEWPORT})
        EXPECT_EQ(value(name), 0) << name;
    EXPECT_EQ(value(GL_POLYGON_MODE), GL_FILL);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// ---- Hard cases: the limit where there is one, else 0; never NaN ----

void expect_finite(const Draw& draw) {
    for (const RenderOptions& options : {RenderOptions{}, kPhong}) {
        const glm::dvec4 c = color(draw, options);
        for (int i = 0; i < 4; ++i) EXPECT_TRUE(c[i] >= 0 && c[i] <= 1) << c[i];
    }
}

LightingState everything() {
    LightingState lighting = shiny(5);
    lighting.front.diffuse = lighting.front.ambient = {0.5, 0, 0.25, 1};
    lighting.light_model.local_viewer = true;
    lighting.lights[0].ambient = grey(0.25);
    lighting.lights[0].position_eye = {1, 2, 3, 1};
    lighting.lights[0].constant_attenuation = 0;
    lighting.lights[0].quadratic_attenuation = 1;
    lighting.lights[0].spot_cutoff_deg = 45;
    lighting.lights[0].spot_exponent = 1.5;
    return lighting;
}

TEST(ProgrammableHardCases, LightAtTheVertexContributesNothing) {
    expect_finite(point({1, 2, 3}, everything()));
    expect_color(color(point({1, 2, 3}, everything())), grey(0));
}

TEST(ProgrammableHardCases, ZeroNormalIsDark) {
    LightingState lighting = dark();
    lighting.front.diffuse = lighting.front.specular = grey(1);
    for (const bool normalize : {false, true}) {
        lighting.normalize = normalize;
        Draw draw = point({0, 0, 0}, lighting);
        draw.vertices[0].normal_object = {0, 0, 0};
        expect_color(color(draw), grey(0));
        expect_color(color(draw, kPhong), grey(0));
    }
}

TEST(ProgrammableHardCases, SingularModelviewIsDark) {
    Draw draw = point({0, 0, 0}, everything());
    draw.eye_from_object = glm::scale(glm::dmat4(1), glm::dvec3(1, 1, 0));
    expect_finite(draw);
}

TEST(ProgrammableHardCases, HalfVectorOfNoLengthHasNoHighlight) {
    LightingState lighting = shiny(5);
    lighting.lights[0].position_eye = {0, 0, -1, 0};
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices[0].normal_object = {0, 0, -1};
    expect_color(color(draw), grey(0));
}

TEST(ProgrammableHardCases, EyeWOfZeroIsFarAway) {
    Draw draw = point({0, 0, 0}, everything());
    draw.vertices[0].position_object = {1, 2, -3, 0};
    draw.clip_from_eye[2][3] = -1;  // clip w is -z
    expect_finite(draw);
}

TEST(ProgrammableHardCases, LongNormalsGiveNoNaN) {
    LightingState lighting = shiny(128);
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices[0].normal_object = {0, 0, 1e25};
    expect_color(color(draw), {1, 1, 0, 1});
}

TEST(ProgrammableHardCases, VeryLongAndVeryShortVectorsHaveTheirDirection) {
    for (const double scale : {1e-25, 1e25}) {
        LightingState lighting = dark();
        lighting.front.diffuse = grey(1);
        lighting.normalize = true;
        lighting.lights[0].position_eye = glm::dvec4(0, 0.6 * scale, 0.8 * scale, 0);
        Draw draw = point({0, 0, 0}, lighting);
        draw.vertices[0].normal_object = {0, 0, scale};
        expect_color(color(draw), grey(0.8));
        expect_color(color(draw, kPhong), grey(0.8));
        draw.vertices[0].normal_object = {0, 0, 1};
        draw.eye_from_object = glm::scale(glm::dmat4(1), glm::dvec3(scale));
        expect_color(color(draw), grey(0.8));
        // A positional light, as far from the vertex as the scene is large; attenuated by 1 / (1 + d /
        // scale).
        draw.lighting.lights[0].position_eye.w = 1;
        draw.lighting.lights[0].linear_attenuation = 1 / scale;
        expect_color(color(draw), grey(0.4));
        expect_color(color(draw, kPhong), grey(0.4));
        // RESCALE_NORMAL under the same scale.
        draw.lighting.normalize = false;
        draw.lighting.rescale_normal = true;
        expect_color(color(draw), grey(0.4));
    }
}

}  // namespace
}  // namespace twinlight::programmable

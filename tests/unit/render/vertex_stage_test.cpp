// The reference's vertex stage: transformation, normals, colour material, clamping (GL 2.1 sections 2.11, 2.14), and
// its effect on pixels.
#include "render/reference/vertices/vertex_stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "../small_frames.h"
#include "render/reference/vertices/lit_vertices.h"

namespace twinlight::vertex_stage_test {
namespace {

using reference::LitVertex;

constexpr double kArithmetic = 32 * std::numeric_limits<double>::epsilon();  // a few tens of roundings near 1

// One vertex facing +z, lit by one white directional light along +z; the scene's ambient light is off.
Draw lit_vertex() {
    Draw draw = window_draw(kSize, kSize, kGL_POINTS, {vertex(0, 0)});
    draw.lighting.enabled = true;
    draw.lighting.light_model.ambient = {0, 0, 0, 1};
    draw.lighting.lights[0].enabled = true;
    draw.lighting.front.diffuse = {0.5, 0.5, 0.5, 0.25};
    return draw;
}

LitVertex light(const Draw& draw, const reference::Options& options = {}, bool clamp = false) {
    return reference::light_vertices(draw, options, clamp).at(0);
}
double red(const Draw& draw) { return light(draw).front_primary.r; }

void scale(Draw& draw, const glm::dvec3& factors) { draw.eye_from_object = glm::scale(glm::dmat4(1), factors); }

// ---- Positions ----

TEST(VertexStage, GoesFromObjectToEyeToClip) {
    Draw draw = lit_vertex();
    draw.vertices.edit()[0].position_object = {1, 2, 3, 1};
    draw.eye_from_object = glm::translate(glm::dmat4(1), glm::dvec3(10, 0, 0));
    draw.clip_from_eye = glm::scale(glm::dmat4(1), glm::dvec3(2, 2, 2));
    EXPECT_EQ(reference::vertex_stage(draw)[0].position_eye, (glm::dvec4{11, 2, 3, 1}));
    EXPECT_EQ(light(draw).position_clip, (glm::dvec4{22, 4, 6, 1}));
}

TEST(VertexStage, LightsAVertexOfW2WhereItsQuotientIs) {
    Draw draw = lit_vertex();
    LightSource& source = draw.lighting.lights[0];
    source.position_eye = {0, 3, 4, 1};
    draw.vertices.edit()[0].position_object = {0, 0, 0, 2};
    EXPECT_NEAR(red(draw), 0.8 * 0.5, kArithmetic);
    draw.vertices.edit()[0].position_object = {0, 6, 0, 2};  // (0, 3, 0): the light is straight above it
    EXPECT_NEAR(red(draw), 0.5, kArithmetic);
    draw.vertices.edit()[0].position_object = {0, -3, 0, -1};  // the same point
    EXPECT_NEAR(red(draw), 0.5, kArithmetic);
}

TEST(VertexStage, LightsAVertexOfW0AsOneFarAway) {  // RULING: the limit
    Draw draw = lit_vertex();
    draw.lighting.lights[0].position_eye = {5, 5, 5, 1};
    draw.vertices.edit()[0].position_object = {0, -3, -4, 0};  // the light is along (0, 3, 4)
    EXPECT_NEAR(red(draw), 0.8 * 0.5, kArithmetic);
    draw.lighting.lights[0].linear_attenuation = 1e-3;
    EXPECT_NEAR(red(draw), 0, 1e-90);  // 1 / (1e-3 * 1e100)
    draw.vertices.edit()[0].position_object = {0, 0, 0, 0};
    EXPECT_TRUE(std::isfinite(red(draw)));
}

// ---- Normals (2.11.3) ----

TEST(Normals, FollowTheInverseTransposeOfTheModelview) {
    Draw draw = lit_vertex();
    draw.vertices.edit()[0].normal_object = {1, 0, 1};
    scale(draw, {2, 1, 4});  // (1 / 2, 0, 1 / 4)
    EXPECT_EQ(reference::vertex_stage(draw)[0].normal_eye, (glm::dvec3{0.5, 0, 0.25}));
}

TEST(Normals, StaySquareToTheirSurface) {
    Draw draw = lit_vertex();
    draw.eye_from_object = glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(1, 2, 3));
    draw.eye_from_object[1][0] += 0.8;  // a shear
    const glm::dvec3 a(1, 2, -1), b(0, 1, 3);
    draw.vertices.edit()[0].normal_object = glm::cross(a, b);
    const glm::dvec3 normal_eye = reference::vertex_stage(draw)[0].normal_eye;
    for (const glm::dvec3& tangent : {a, b})
        EXPECT_NEAR(glm::dot(normal_eye, glm::dvec3(draw.eye_from_object * glm::dvec4(tangent, 0))), 0,
                    kArithmetic * glm::length(normal_eye) * 4);
}

TEST(Normals, AreNotMadeUnitUnlessAsked) {
    Draw draw = lit_vertex();
    scale(draw, {2, 2, 2});  // a normal of length 1 / 2
    EXPECT_EQ(red(draw), 0.25);
    draw.lighting.normalize = true;
    EXPECT_EQ(red(draw), 0.5);
}

TEST(Normals, AreRescaledByTheModelviewAlone) {
    Draw draw = lit_vertex();
    draw.lighting.rescale_normal = true;
    scale(draw, {2, 2, 2});
    EXPECT_EQ(red(draw), 0.5);
    draw.vertices.edit()[0].normal_object = {0, 0, 3};
    EXPECT_EQ(red(draw), 1.5);  // keeps its own length
    draw.lighting.normalize = true;
    EXPECT_EQ(red(draw), 0.5);
}

TEST(Normals, SurviveExtremeScales) {
    for (const double factor : {1e-100, 1e-25, 1e7, 1e25, 1e100}) {
        Draw draw = lit_vertex();
        scale(draw, glm::dvec3(factor));
        draw.lighting.normalize = true;
        EXPECT_NEAR(red(draw), 0.5, kArithmetic) << factor;
        draw.lighting.normalize = false;
        draw.lighting.rescale_normal = true;
        EXPECT_NEAR(red(draw), 0.5, kArithmetic) << factor;
    }
}

TEST(Normals, OfASingularModelviewAreReachedByNoLight) {  // RULING
    Draw draw = lit_vertex();
    draw.lighting.front.emission = {0.125, 0, 0, 1};
    for (const glm::dvec3& factors : {glm::dvec3(0), glm::dvec3(1, 0, 1)}) {
        scale(draw, factors);
        for (const bool normalize : {false, true}) {
            draw.lighting.normalize = normalize;
            draw.lighting.rescale_normal = !normalize;
            EXPECT_EQ(red(draw), 0.125);
        }
    }
}

// ---- Colours ----

TEST(Colours, WithoutLightingAreTheCurrentColour) {
    Draw draw = lit_vertex();
    draw.lighting.enabled = false;
    draw.vertices.edit()[0].color = {0.1, 0.2, 2, 0.4};
    EXPECT_EQ(light(draw).front_primary, (glm::dvec4{0.1, 0.2, 2, 0.4}));
    EXPECT_EQ(light(draw).back_primary, light(draw).front_primary);
    EXPECT_EQ(light(draw, {}, true).front_primary, (glm::dvec4{0.1, 0.2, 1, 0.4}));
}

TEST(Colours, AreClampedAfterLighting) {  // 2.14.6
    Draw draw = lit_vertex();
    draw.lighting.front.emission = {0.75, -3, 0, 1};
    EXPECT_EQ(light(draw).front_primary, (glm::dvec4{1.25, -2.5, 0.5, 0.25}));
    EXPECT_EQ(light(draw, {}, true).front_primary, (glm::dvec4{1, 0, 0.5, 0.25}));
}

TEST(Colours, OfDisabledLightsDoNotCount) {
    Draw draw = lit_vertex();
    draw.lighting.lights[0].enabled = false;
    EXPECT_EQ(red(draw), 0);
}

TEST(Colours, OfTheMagnitudeBoundThePrimaryColour) {
    Draw draw = lit_vertex();
    draw.lighting.front.emission = {-0.5, 0, 0, 1};
    EXPECT_EQ(light(draw).front_primary.r, 0);
    EXPECT_EQ(light(draw).front_magnitude, (glm::dvec4{1, 0.5, 0.5, 0.25}));
}

TEST(ColorMaterial, ReplacesWhatItTracksAndNothingElse) {
    struct Modes {
        Enum mode;
        glm::dvec4 expected;  // emission + ambient * scene ambient + diffuse * light, from the colour where tracked
    };
    const glm::dvec4 color = {0.5, 0.25, 0.125, 0.75};
    Draw draw = lit_vertex();
    draw.vertices.edit()[0].color = color;
    draw.lighting.light_model.ambient = {1, 1, 1, 1};
    draw.lighting.front.emission = {0.0625, 0.0625, 0.0625, 1};
    draw.lighting.front.ambient = {0.25, 0.25, 0.25, 1};
    draw.lighting.front.specular = {0, 0, 0, 1};
    draw.lighting.color_material.enabled = true;
    const double e = 0.0625, a = 0.25, d = 0.5, alpha = 0.25;
    for (const auto& [mode, expected] :
         {Modes{kGL_EMISSION, {0.5 + a + d, 0.25 + a + d, 0.125 + a + d, alpha}},
          Modes{kGL_AMBIENT, {e + 0.5 + d, e + 0.25 + d, e + 0.125 + d, alpha}},
          Modes{kGL_DIFFUSE, {e + a + 0.5, e + a + 0.25, e + a + 0.125, 0.75}},
          Modes{kGL_SPECULAR, {e + a + d + 0.5, e + a + d + 0.25, e + a + d + 0.125, alpha}},
          Modes{kGL_AMBIENT_AND_DIFFUSE, {e + 0.5 + 0.5, e + 0.25 + 0.25, e + 0.125 + 0.125, 0.75}}}) {
        draw.lighting.color_material.mode = mode;
        EXPECT_EQ(light(draw).front_primary, expected) << std::hex << mode;
    }
}

TEST(ColorMaterial, FollowsTheNamedFaceOnly) {
    Draw draw = lit_vertex();
    draw.vertices.edit()[0].color = kRed;
    draw.vertices.edit()[0].normal_object = {0, 0, 1};
    draw.lighting.light_model.two_side = true;
    draw.lighting.color_material = {.enabled = true, .face = kGL_BACK, .mode = kGL_EMISSION};
    EXPECT_EQ(light(draw).front_primary, (glm::dvec4{0.5, 0.5, 0.5, 0.25}));
    EXPECT_EQ(light(draw).back_primary.r, 1);
    EXPECT_EQ(light(draw).back_primary.g, 0);
}

TEST(LectureVariants, AreOffWhereGlsOwnModelIsAskedFor) {
    Draw draw = lit_vertex();
    draw.lighting.lights[0].smooth_cone = LightSource::SmoothCone{.inner_deg = 10, .outer_deg = 20};
    draw.lighting.lights[0].spot_direction_eye = {0, 0, 1};  // points away: outside the cone
    draw.lighting.lights[0].ambient = {0.5, 0.5, 0.5, 1};
    draw.lighting.front.ambient = {0.5, 0.5, 0.5, 1};
    draw.lighting.light_model.light_ambient = Word::unattenuated;
    EXPECT_EQ(light(draw, {{.shading = {}, .lecture_variants = true}}).front_primary.r, 0.25);
    EXPECT_EQ(light(draw, {{.shading = {}, .lecture_variants = false}}).front_primary.r, 0.75);
}

// ---- In the picture ----

Draw lit_quad() {
    Draw draw = quad(0, 0, 16, 16);
    draw.lighting = lit_vertex().lighting;
    return draw;
}

TEST(Pictures, AddTheSecondaryColourAfterInterpolation) {  // 3.9: both are clamped first
    Draw draw = lit_quad();
    draw.lighting.front.specular = {0.25, 4, 0, 1};
    draw.lighting.front.emission = {0, -8, 0, 1};
    draw.lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    EXPECT_EQ(pixel(draw_window({draw}), 5, 5), (glm::dvec4{0.75, 1, 0.5, 0.25}));
    draw.lighting.light_model.color_control = kGL_SINGLE_COLOR;
    EXPECT_EQ(pixel(draw_window({draw}), 5, 5), (glm::dvec4{0.75, 0, 0.5, 0.25}));
}

TEST(Pictures, InPhongLightEveryPixelByItsOwnNormal) {
    Draw draw = lit_quad();
    draw.lighting.front.diffuse = kWhite;
    for (Vertex& v : draw.vertices.edit())
        v.normal_object = v.position_object.x == 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const double s = 4.5 / 16;                  // from (1, 0, 0) to (0, 0, 1), scaled to length 1
    constexpr double kFloat = 1.0 / (1 << 23);  // an Image stores floats
    EXPECT_NEAR(pixel(draw_window({draw}), 4, 6).r, s, kFloat);
    EXPECT_NEAR(pixel(draw_window({draw}, {{.shading = Shading::kPhong}}), 4, 6).r, s / std::hypot(s, 1 - s), kFloat);
}

TEST(Pictures, InPhongShowAHighlightThatGouraudMisses) {  // LECTURES: "specular may be lost"
    Draw draw = lit_quad();
    draw.lighting.front = {.diffuse = {0, 0, 0, 1}, .specular = kWhite, .shininess = 100};
    draw.lighting.lights[0].position_eye = {8, 8, 8, 1};
    EXPECT_LT(pixel(draw_window({draw}), 8, 8).r, 0.01);
    EXPECT_GT(pixel(draw_window({draw}, {{.shading = Shading::kPhong}}), 8, 8).r, 0.9);
}

TEST(Pictures, TakeTheShadingOfTheOptionsBeforeTheDraws) {
    Draw draw =
        window_draw(kSize, kSize, kGL_TRIANGLES, {vertex(0, 0, kRed), vertex(16, 0, kGreen), vertex(0, 16, kBlue)});
    draw.lighting.shade_model = kGL_FLAT;
    EXPECT_EQ(pixel(draw_window({draw}), 2, 2), kBlue);
    EXPECT_NE(pixel(draw_window({draw}, {{.shading = Shading::kGouraud}}), 2, 2), kBlue);
    draw.lighting.shade_model = kGL_SMOOTH;
    EXPECT_NE(pixel(draw_window({draw}), 2, 2), kBlue);
    EXPECT_EQ(pixel(draw_window({draw}, {{.shading = Shading::kFlat}}), 2, 2), kBlue);
}

}  // namespace
}  // namespace twinlight::vertex_stage_test

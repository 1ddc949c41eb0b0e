// The programmable renderer where the specification is silent: the limit if there is one, else 0; never NaN.
#include <gtest/gtest.h>

#include "../hand_built_draws.h"

namespace twinlight::programmable::programmable_hard_cases_test {
namespace {

void expect_finite(const Draw& draw) {
    for (const Options& options : {Options{}, kPhong}) {
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
        draw.vertices.edit()[0].normal_object = {0, 0, 0};
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
    draw.vertices.edit()[0].normal_object = {0, 0, -1};
    expect_color(color(draw), grey(0));
}

TEST(ProgrammableHardCases, EyeWOfZeroIsFarAway) {
    Draw draw = point({0, 0, 0}, everything());
    draw.vertices.edit()[0].position_object = {1, 2, -3, 0};
    draw.clip_from_eye[2][3] = -1;  // clip w is -z
    expect_finite(draw);
}

TEST(ProgrammableHardCases, LongNormalsGiveNoNaN) {
    LightingState lighting = shiny(128);
    Draw draw = point({0, 0, 0}, lighting);
    draw.vertices.edit()[0].normal_object = {0, 0, 1e25};
    expect_color(color(draw), {1, 1, 0, 1});
}

TEST(ProgrammableHardCases, VeryLongAndVeryShortVectorsHaveTheirDirection) {
    for (const double scale : {1e-25, 1e25}) {
        LightingState lighting = dark();
        lighting.front.diffuse = grey(1);
        lighting.normalize = true;
        lighting.lights[0].position_eye = glm::dvec4(0, 0.6 * scale, 0.8 * scale, 0);
        Draw draw = point({0, 0, 0}, lighting);
        draw.vertices.edit()[0].normal_object = {0, 0, scale};
        expect_color(color(draw), grey(0.8));
        expect_color(color(draw, kPhong), grey(0.8));
        draw.vertices.edit()[0].normal_object = {0, 0, 1};
        draw.eye_from_object = glm::scale(glm::dmat4(1), glm::dvec3(scale));
        expect_color(color(draw), grey(0.8));
        // A positional light, at a distance of the scene's size, attenuated by 1 / (1 + d / scale).
        draw.lighting.lights[0].position_eye.w = 1;
        draw.lighting.lights[0].linear_attenuation = 1 / scale;
        expect_color(color(draw), grey(0.4));
        expect_color(color(draw, kPhong), grey(0.4));
        // RESCALE_NORMAL with the same scale.
        draw.lighting.normalize = false;
        draw.lighting.rescale_normal = true;
        expect_color(color(draw), grey(0.4));
    }
}

}  // namespace
}  // namespace twinlight::programmable::programmable_hard_cases_test

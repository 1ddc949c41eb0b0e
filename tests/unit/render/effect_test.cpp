// The planner: which lighting effects a Draw needs, derived by hand, and the reasons for leaving out the others.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "../planned_draws.h"

namespace twinlight::effect_test {
namespace {

TEST(Plan, CallsForTheDiffuseTermAloneInTheInitialState) {
    EffectSet expected;
    expected.lighting = true;  // 0.2 * 0.2 + 0.8 is below 1: no clamp
    expected.lights.resize(1);
    expected.lights[0] = {.directional = true, .diffuse = true};
    EXPECT_EQ(facts(lit_triangle()), expected) << describe(facts(lit_triangle()));
}

TEST(Plan, CallsForNothingButTheColorWhenLightingIsOff) {
    Draw draw = with_positional_light(with_specular_material());
    draw.lighting.enabled = false;
    EXPECT_EQ(facts(draw), EffectSet{});
    EXPECT_EQ(facts(draw, {{.shading = Shading::kPhong}}), EffectSet{});
    EXPECT_NE(reason(draw, "lighting"), "");
    draw.vertices.edit()[0].color = {2, 0, 0, 1};
    EXPECT_TRUE(facts(draw).clamp);
}

TEST(Plan, TakesTheShadingFromTheOptionsOrElseFromTheShadeModel) {
    Draw draw = lit_triangle();
    draw.vertices.edit()[1].normal_object = {1, 0, 0};
    EXPECT_EQ(facts(draw).shading, Shading::kGouraud);
    draw.lighting.shade_model = kGL_FLAT;
    EXPECT_EQ(facts(draw).shading, Shading::kFlat);
    EXPECT_EQ(facts(draw, {{.shading = Shading::kPhong}}).shading, Shading::kPhong);
    draw.mode = kGL_POINTS;
    EXPECT_EQ(facts(draw).shading, Shading::kGouraud);
}

// 2.14.1: between two directions (w = 0), VP is the unit vector of their difference.
TEST(Plan, LetsADirectionalLightsDirectionDependOnVerticesThatAreDirections) {
    Draw draw = lit_triangle();
    draw.lighting.lights[0].position_eye = {0, 0, -1, 0};  // behind the triangle
    draw.lighting.lights[0].spot_cutoff_deg = 45;          // and the light is outside its own cone
    draw.lighting.lights[0].spot_direction_eye = {0, 0, -1};
    EXPECT_TRUE(facts(draw).lights.empty());
    draw.vertices.edit()[1].position_object = {0, 0, -2, 0};  // P - V = (0, 0, 1)
    const EffectSet effects = facts(draw);
    ASSERT_EQ(effects.lights.size(), 1u);
    EXPECT_TRUE(effects.lights[0].meets_directions && effects.lights[0].cone == SpotCone::kGl && effects.vertex_w);
    EXPECT_FALSE(effects.lights[0].directional || effects.lights[0].attenuated);
    draw.vertices.edit()[1].position_object.w = 1e-30;
    EXPECT_TRUE(facts(draw).lights.empty());
    draw.vertices.edit()[1].position_object.w = 1;
    draw.eye_from_object[2] = {0, 0, 1, 0.5};  // gives it w = 0
    EXPECT_EQ(facts(draw).lights.size(), 1u);
}

// Copying the lights for each plan would take longer than planning.
TEST(Plan, SharesItsLightsWithTheDraw) {
    const Draw draw = with_positional_light(with_specular_material());
    for (const bool for_any_pose : {false, true}) {
        PlanOptions options;
        options.for_any_pose = for_any_pose;
        const Plan plan = plan_effects(draw, options);
        ASSERT_FALSE(plan.lights.empty());
        EXPECT_EQ(&plan.lighting.lights.front(), &draw.lighting.lights.front());
    }
}

TEST(Plan, SaysOfEachLightThatIsOffThatItIsNotEnabled) {
    EXPECT_EQ(reason(lit_triangle(), "GL_LIGHT7"), "it is not enabled");
    EXPECT_EQ(reason(lit_triangle(), "GL_LIGHT0"), "");
}

TEST(Plan, NumbersTheLightsThatAreCalledForWithoutGaps) {
    Draw draw = lit_triangle();
    std::swap(draw.lighting.lights[0], draw.lighting.lights[5]);
    EXPECT_EQ(facts(draw), facts(lit_triangle()));
    EXPECT_EQ(plan_effects(draw, {}).lights.at(0).number, 5);
}

TEST(Plan, LeavesOutALightWhoseProductsWithTheMaterialAreZero) {
    Draw draw = lit_triangle();
    draw.lighting.front.diffuse = {0, 0, 1, 1};
    draw.lighting.lights[0].diffuse = {1, 1, 0, 1};
    EXPECT_TRUE(facts(draw).lights.empty());
    EXPECT_EQ(reason(draw, "GL_LIGHT0"), "its colours times the material's are 0");
}

TEST(Plan, AddsALightsAmbientTermToTheScenesWhereNothingWeakensIt) {
    Draw draw = lit_triangle();
    draw.lighting.lights[0].ambient = {0.25, 0.5, 0, 1};
    EXPECT_FALSE(facts(draw).lights[0].ambient);
    EXPECT_EQ(plan_effects(draw, {}).constant_ambient, glm::dvec3(0.45, 0.7, 0.2));
    EXPECT_NE(reason(draw, "GL_LIGHT0's ambient term"), "");

    draw = with_positional_light(draw);
    draw.lighting.lights[0].linear_attenuation = 0.1;
    EXPECT_TRUE(facts(draw).lights[0].ambient);
    EXPECT_EQ(plan_effects(draw, {}).constant_ambient, glm::dvec3(0.2));

    draw.lighting.light_model.light_ambient = Word::unattenuated;
    EXPECT_FALSE(facts(draw).lights[0].ambient);
    EXPECT_EQ(plan_effects(draw, {}).constant_ambient, glm::dvec3(0.45, 0.7, 0.2));
    EXPECT_TRUE(facts(draw, kGlAlone).lights[0].ambient);
}

TEST(Plan, CallsForAttenuationOfPositionalLightsWithALinearOrQuadraticFactor) {
    Draw draw = lit_triangle();
    draw.lighting.lights[0].linear_attenuation = 0.1;
    EXPECT_FALSE(facts(draw).lights[0].attenuated);
    EXPECT_EQ(reason(draw, "GL_LIGHT0's attenuation"), "the light is directional (its position has w = 0)");
    EXPECT_TRUE(facts(with_positional_light(draw)).lights[0].attenuated);

    draw = with_positional_light();
    draw.lighting.lights[0].constant_attenuation = 4;
    EXPECT_FALSE(facts(draw).lights[0].attenuated);
    EXPECT_EQ(plan_effects(draw, {}).lights.at(0).constant_reach, 0.25);
    EXPECT_EQ(reason(draw, "GL_LIGHT0's attenuation"), "its factors are 4, 0, 0, so it is 0.25 at every vertex");

    draw.lighting.lights[0].constant_attenuation = 0;
    EXPECT_EQ(reason(draw, "GL_LIGHT0"), "its attenuation factors are 0, 0, 0, so it adds nothing");
}

TEST(Plan, CallsForTheConeOfPositionalSpotlights) {
    Draw draw = with_positional_light();
    EXPECT_EQ(reason(draw, "GL_LIGHT0's cone"), "GL_SPOT_CUTOFF is 180");
    draw.lighting.lights[0].spot_cutoff_deg = 30;  // from 5 above, the triangle is within atan(1/5)
    EXPECT_EQ(reason(draw, "GL_LIGHT0's cone"), "the whole draw is inside it, and GL_SPOT_EXPONENT is 0");
    draw.lighting.lights[0].spot_cutoff_deg = 10;
    EXPECT_EQ(facts(draw).lights[0].cone, SpotCone::kGl);
    EXPECT_EQ(facts(draw).lights[0].spot_exponent, Power::kZero);
    EXPECT_EQ(reason(draw, "GL_LIGHT0's fall-off inside the cone"), "GL_SPOT_EXPONENT is 0");
    draw.lighting.lights[0].spot_exponent = 3;
    EXPECT_EQ(facts(draw).lights[0].spot_exponent, Power::kWhole);
    draw.lighting.lights[0].spot_exponent = 2.5;
    EXPECT_EQ(facts(draw).lights[0].spot_exponent, Power::kReal);

    draw.lighting.lights[0].smooth_cone = LightSource::SmoothCone{10, 20};
    EXPECT_EQ(facts(draw).lights[0].cone, SpotCone::kSmooth);
    EXPECT_NE(facts(draw).lights[0].cone, SpotCone::kGl);
    EXPECT_EQ(facts(draw, kGlAlone).lights[0].cone, SpotCone::kGl);
}

TEST(Plan, FoldsTheConeOfADirectionalLightIntoItsProducts) {
    Draw draw = lit_triangle();  // it shines along (0, 0, -1)
    LightSource& light = draw.lighting.lights[0];
    light.spot_cutoff_deg = 60;
    light.spot_exponent = 2;
    light.spot_direction_eye = {0, std::sqrt(0.5), -std::sqrt(0.5)};  // 45 degrees
    EXPECT_NE(facts(draw).lights[0].cone, SpotCone::kGl);
    EXPECT_NEAR(plan_effects(draw, {}).lights.at(0).constant_reach, 0.5, 1e-15);
    light.spot_cutoff_deg = 44;
    EXPECT_EQ(reason(draw, "GL_LIGHT0"), "it is directional, and its direction is outside its cone");
    light.spot_cutoff_deg = 0;
    light.spot_direction_eye = {0, 0, -3};
    EXPECT_EQ(plan_effects(draw, {}).lights.at(0).constant_reach, 1);
}

TEST(Plan, CallsForTheLocalViewerOnlyIfAHighlightDependsOnIt) {
    Draw draw = lit_triangle();
    draw.lighting.light_model.local_viewer = true;
    EXPECT_FALSE(facts(draw).local_viewer);
    EXPECT_EQ(reason(draw, "specular highlights"), "no light has a specular term");
    draw = with_specular_material(draw);
    EXPECT_TRUE(facts(draw).local_viewer);
    draw.lighting.front.shininess = 0;
    EXPECT_FALSE(facts(draw).local_viewer);
    EXPECT_EQ(reason(draw, "local viewer"), "GL_SHININESS is 0, so the viewer's position does not matter");
}

TEST(Plan, KnowsWholeExponentsFromOthers) {
    Draw draw = with_specular_material();
    EXPECT_EQ(facts(draw).shininess, Power::kWhole);
    draw.lighting.front.shininess = 76.8;
    EXPECT_EQ(facts(draw).shininess, Power::kReal);
    draw.lighting.front.shininess = 0;
    EXPECT_EQ(facts(draw).shininess, Power::kZero);
}

TEST(Plan, CallsForSeparateSpecularAndReflectionOnlyWithASpecularTerm) {
    Draw draw = lit_triangle();
    draw.lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    draw.lighting.light_model.specular = Word::reflection;
    EXPECT_EQ(facts(draw), facts(lit_triangle()));
    draw = with_specular_material(draw);
    EXPECT_TRUE(facts(draw).separate_specular);
    EXPECT_EQ(facts(draw).highlight, Highlight::kReflection);
    EXPECT_EQ(facts(draw, kGlAlone).highlight, Highlight::kHalfVector);
}

TEST(Plan, CallsForTwoSidesOnlyIfABackFaceCanShow) {
    Draw draw = lit_triangle();
    draw.lighting.light_model.two_side = true;
    EXPECT_TRUE(facts(draw).two_side);
    draw.raster.cull_enabled = true;
    EXPECT_EQ(reason(draw, "two-sided lighting"), "back faces are culled");
    draw.raster.cull_face = kGL_FRONT;
    EXPECT_TRUE(facts(draw).two_side);
    draw.mode = kGL_LINE_STRIP;
    EXPECT_EQ(reason(draw, "two-sided lighting"), "points and lines have no back face");
}

TEST(Plan, LooksAtTheBackMaterialOnlyIfItShows) {
    Draw draw = lit_triangle();
    draw.lighting.back.specular = {1, 1, 1, 1};
    EXPECT_FALSE(facts(draw).lights[0].specular);
    draw.lighting.light_model.two_side = true;
    EXPECT_TRUE(facts(draw).lights[0].specular);
}

TEST(Plan, CallsForColorMaterialOnlyIfTheColorsDiffer) {
    Draw draw = with_vertex_colors();
    EXPECT_EQ(facts(draw).front, (FaceEffects{.tracks_ambient = true, .tracks_diffuse = true}));
    EXPECT_EQ(facts(draw).back, FaceEffects{});

    draw.vertices.edit()[0].color = draw.vertices.edit()[2].color = draw.vertices.edit()[1].color;
    EXPECT_EQ(facts(draw).front, FaceEffects{});
    EXPECT_EQ(plan_effects(draw, {}).lighting.front.diffuse, glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(reason(draw, "colour material"), "all vertices have the same colour, so the material is set once");
}

TEST(Plan, FollowsTheFaceAndTheModeOfColorMaterial) {
    Draw draw = with_vertex_colors();
    draw.lighting.color_material.face = kGL_BACK;
    EXPECT_EQ(reason(draw, "colour material"), "it sets only the back face's material, and no back face is visible");
    draw.lighting.light_model.two_side = true;
    draw.lighting.color_material.mode = kGL_EMISSION;
    EXPECT_EQ(facts(draw).front, FaceEffects{});
    EXPECT_EQ(facts(draw).back, FaceEffects{.tracks_emission = true});
    draw.lighting.color_material.mode = kGL_SPECULAR;
    EXPECT_EQ(facts(draw).back, FaceEffects{.tracks_specular = true});
    draw.lighting.lights[0].specular = {0, 0, 0, 1};
    EXPECT_EQ(reason(draw, "specular colour from glColor"), "no light has a specular term");
}

TEST(Plan, CallsForNormalsAndPositionsOnlyIfALightDependsOnThem) {
    Draw draw = lit_triangle();
    EXPECT_TRUE(facts(draw).needs_normal());
    EXPECT_FALSE(facts(draw).needs_position_eye());
    draw.lighting.lights[0].enabled = false;
    EXPECT_FALSE(facts(draw).needs_normal());
    EXPECT_EQ(reason(draw, "normals"), "no light has a diffuse or specular term");
    EXPECT_TRUE(facts(with_positional_light()).needs_position_eye());
}

TEST(Plan, NormalizesOnlyWhatOneFactorDoesNotMakeUnit) {
    Draw draw = lit_triangle();
    draw.lighting.normalize = true;
    const double c = std::cos(0.3), s = std::sin(0.3);
    draw.eye_from_object = glm::dmat4(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1);
    EXPECT_FALSE(facts(draw).normalize);
    EXPECT_FALSE(plan_effects(draw, {}).lighting.rescale_normal);

    for (int column = 0; column < 3; ++column) draw.eye_from_object[column] *= 2.5;
    EXPECT_FALSE(facts(draw).normalize);
    EXPECT_TRUE(plan_effects(draw, {}).lighting.rescale_normal);
    EXPECT_FALSE(plan_effects(draw, {}).lighting.normalize);

    draw.eye_from_object[1] *= 1.01;
    EXPECT_TRUE(facts(draw).normalize);

    draw.eye_from_object = glm::dmat4(1);
    draw.vertices.edit()[1].normal_object = {0, 0, 2};
    EXPECT_TRUE(facts(draw).normalize);

    // An error of a float's rounding needs a budget.
    draw.vertices.edit()[1].normal_object = {0, 0, 1 + 1e-7};
    EXPECT_TRUE(facts(draw, {{.shading = {}}, 0}).normalize);
    EXPECT_FALSE(facts(draw).normalize);
    EXPECT_GT(plan_effects(draw, {}).error_bound, 0.8e-7);
    EXPECT_TRUE(facts(draw, kPhong).normalize);
}

TEST(Plan, ClampsOnlyWhatMayLeaveZeroToOne) {
    Draw draw = lit_triangle();  // 0.2 * 0.2 and 0.8 * 1
    EXPECT_FALSE(facts(draw).clamp);
    EXPECT_NE(reason(draw, "clamping"), "");
    draw.lighting.front.emission = {0.15, 0, 0, 1};
    EXPECT_FALSE(facts(draw).clamp);
    draw.lighting.front.emission = {0, 0, 0.17, 1};
    EXPECT_TRUE(facts(draw).clamp);
    draw.lighting.front.emission = {0, 0, 0, 1};
    draw.lighting.front.diffuse.a = 1.5;
    EXPECT_TRUE(facts(draw).clamp);
    draw = lit_triangle();
    draw.lighting.lights[0].diffuse.b = -0.1;
    EXPECT_TRUE(facts(draw).clamp);
    draw = lit_triangle();
    draw.vertices.edit()[0].normal_object = {0, 0, 1.3};  // not a unit vector
    EXPECT_TRUE(facts(draw).clamp);
    draw.lighting.normalize = true;
    EXPECT_FALSE(facts(draw).clamp);
}

TEST(Plan, CallsForTheDivisionByWOnlyIfWMayDiffer) {
    Draw draw = with_positional_light();
    EXPECT_FALSE(facts(draw).vertex_w);
    draw.vertices.edit()[2].position_object.w = 2;
    EXPECT_TRUE(facts(draw).vertex_w);
    draw.lighting.lights[0].position_eye.w = 0;
    EXPECT_FALSE(facts(draw).vertex_w);
}

TEST(Plan, LightsPerFragmentOnlyWhatVaries) {
    Draw draw = lit_triangle();
    // Equal normals, a directional light, a viewer at infinity.
    EXPECT_EQ(facts(draw, kPhong).shading, Shading::kGouraud);
    EXPECT_EQ(facts(with_specular_material(draw), kPhong).shading, Shading::kGouraud);
    Draw varying = draw;
    varying.vertices.edit()[1].normal_object = {0, 0.6, 0.8};
    EXPECT_EQ(facts(varying, kPhong).shading, Shading::kPhong);
    EXPECT_EQ(facts(with_positional_light(draw), kPhong).shading, Shading::kPhong);
    EXPECT_EQ(facts(with_vertex_colors(draw), kPhong).shading, Shading::kPhong);
    varying = with_specular_material(draw);
    varying.lighting.light_model.local_viewer = true;
    EXPECT_EQ(facts(varying, kPhong).shading, Shading::kPhong);
    draw.lighting.lights[0].enabled = false;
    EXPECT_EQ(facts(draw, kPhong).shading, Shading::kGouraud);
}

TEST(Plan, CallsForMaterialsOfVerticesOnlyIfTheyDiffer) {
    Draw draw = lit_triangle();
    draw.materials.resize(3, {draw.lighting.front, draw.lighting.back});
    draw.materials[2].front.diffuse = {1, 0, 0, 1};
    EXPECT_EQ(facts(draw).front, FaceEffects{});  // no vertex has it
    draw.vertices.edit()[0].material = 2;
    EXPECT_EQ(facts(draw).front, FaceEffects{.varies_diffuse = true});
    draw.lighting.color_material.enabled = true;  // the diffuse colour now comes from glColor
    EXPECT_EQ(facts(draw).front, FaceEffects{});
    draw.lighting.color_material.enabled = false;
    draw.materials[2].front = draw.lighting.front;
    draw.materials[2].front.shininess = 9;
    EXPECT_EQ(facts(draw).front, FaceEffects{});  // there is no highlight
}

TEST(Plan, GivesAReasonForEachThingThatIsLeftOut) {
    for (const LeftOut& left_out : plan_effects(with_specular_material(with_vertex_colors()), {}).left_out) {
        EXPECT_FALSE(left_out.what.empty());
        EXPECT_FALSE(left_out.why.empty());
    }
}

TEST(EffectSet, IsDescribedOneFactALine) {
    EXPECT_EQ(describe(facts(with_positional_light(with_specular_material()))),
              "lighting\ngouraud shading\nclamp\ninteger shininess\nlight 0: positional, diffuse, specular\n");
}

}  // namespace
}  // namespace twinlight::effect_test

// The planner: which effects of textures, fog and clip planes a Draw needs, derived by hand.
#include <gtest/gtest.h>

#include <memory>

#include "../planned_draws.h"

namespace twinlight::fragment_effects_test {
namespace {

Draw textured(Enum env_mode, Enum format, Draw draw = lit_triangle()) {
    auto texture = std::make_shared<Texture>();
    texture->levels = {
        {.width = 1, .height = 1, .base_format = format, .internal_format = format, .texels = {glm::vec4(1)}}};
    texture->min_filter = kGL_LINEAR;
    draw.texture.texture = texture;
    draw.texture.env_mode = env_mode;
    return draw;
}

TEST(Plan, TakesEnvironmentsThatAreTheSameCodeForOne) {
    EXPECT_EQ(facts(textured(kGL_DECAL, kGL_RGB)), facts(textured(kGL_REPLACE, kGL_RGB)));
    EXPECT_EQ(facts(textured(kGL_BLEND, kGL_ALPHA)), facts(textured(kGL_MODULATE, kGL_ALPHA)));
    EXPECT_EQ(facts(textured(kGL_MODULATE, kGL_LUMINANCE)), facts(textured(kGL_MODULATE, kGL_RGB)));
    EXPECT_NE(facts(textured(kGL_ADD, kGL_INTENSITY)), facts(textured(kGL_ADD, kGL_LUMINANCE_ALPHA)));
    EXPECT_EQ(facts(textured(kGL_DECAL, kGL_ALPHA)), facts(lit_triangle()));
}

TEST(Plan, CallsForTheTextureMatrixAndTheDivisionByQOnlyIfTheyMatter) {
    Draw draw = textured(kGL_MODULATE, kGL_RGBA);
    EXPECT_FALSE(facts(draw).texture.matrix);
    EXPECT_FALSE(facts(draw).texture.q);
    draw.texture.texture_matrix[3][0] = 0.5;
    EXPECT_TRUE(facts(draw).texture.matrix);
    EXPECT_FALSE(facts(draw).texture.q);
    draw.vertices.edit()[0].tex_coord.q = 2;
    EXPECT_TRUE(facts(draw).texture.q);
}

TEST(Plan, ClampsInTheShaderOnlyIfALinearFilterMaySeeTheBorder) {
    Draw draw = textured(kGL_MODULATE, kGL_RGBA);
    auto texture = std::make_shared<Texture>(*draw.texture.texture);
    texture->wrap_s = kGL_CLAMP;
    draw.texture.texture = texture;
    EXPECT_TRUE(facts(draw).texture.clamp_s);
    EXPECT_FALSE(facts(draw).texture.clamp_t);
    EXPECT_FALSE(facts(draw).texture.gradients);
    texture->mag_filter = kGL_NEAREST;
    EXPECT_TRUE(facts(draw).texture.gradients);
    texture->min_filter = kGL_NEAREST;
    EXPECT_FALSE(facts(draw).texture.clamp_s);
    EXPECT_EQ(reason(draw, "GL_CLAMP"), "without a linear filter it equals GL_CLAMP_TO_EDGE");
}

TEST(Plan, LightsNothingThatTheTextureReplaces) {
    EXPECT_FALSE(facts(textured(kGL_REPLACE, kGL_RGBA)).lighting);
    const EffectSet alpha_left = facts(textured(kGL_REPLACE, kGL_RGB));
    EXPECT_TRUE(alpha_left.lighting);
    EXPECT_TRUE(alpha_left.lights.empty());
    Draw draw = textured(kGL_REPLACE, kGL_RGBA, with_specular_material());
    EXPECT_FALSE(facts(draw).lighting);
    draw.lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    EXPECT_TRUE(facts(draw).lighting);
    EXPECT_FALSE(facts(draw).lights[0].diffuse);
}

TEST(Plan, CallsForFogAndClipPlanesThatAreThere) {
    Draw draw = lit_triangle();
    draw.fog.density = 0;
    draw.fog.enabled = true;
    EXPECT_EQ(reason(draw, "fog"), "GL_FOG_DENSITY is 0");
    draw.fog.mode = kGL_LINEAR;
    EXPECT_EQ(facts(draw).fog, FogEffect::kLinear);
    EXPECT_FALSE(facts(draw).vertex_w);
    draw.vertices.edit()[0].position_object.w = 2;
    EXPECT_TRUE(facts(draw).vertex_w);
    EXPECT_EQ(facts(draw).clip_plane_count, 0);
    draw.raster.clip_planes_eye[5] = glm::dvec4(1);
    EXPECT_EQ(facts(draw).clip_plane_count, 1);
}

}  // namespace
}  // namespace twinlight::fragment_effects_test

// The programmable renderer's fragment colours: textures, the colour sum, fog, clip planes, per-vertex materials.
// Compares pictures of hand-built draws with colours computed by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../hand_built_draws.h"
#include "render/effect/plan.h"
#include "render/programmable/text/shader_assembly.h"

namespace twinlight::programmable::programmable_fragments_test {
namespace {

// ---- Textures ----

const glm::dvec4 kFragment{0.5, 0.25, 0.75, 0.8}, kEnvColor{0.5, 0.75, 1, 0.25};
const glm::dvec4 kTexel{0.4, 0.6, 0.2, 0.6};  // multiples of 1/255: exact in 8 bits

// One texel: (R, G, B, A) as State stores it for that format.
std::shared_ptr<Texture> texture_of(Enum format, std::vector<glm::vec4> texels, Enum filter = kGL_NEAREST) {
    auto texture = std::make_shared<Texture>(Texture{.target = kGL_TEXTURE_1D});
    TextureImage image{.width = static_cast<int>(texels.size()), .base_format = format, .internal_format = format};
    image.texels = std::move(texels);
    texture->levels = {image};
    texture->min_filter = texture->mag_filter = filter;
    return texture;
}

Draw textured_point(Enum mode, Enum format) {
    Draw draw = point({0, 0, 0}, {});
    draw.vertices.edit()[0].color = kFragment;
    draw.texture.env_mode = mode;
    draw.texture.env_color = kEnvColor;
    glm::vec4 texel(kTexel);
    if (format == kGL_ALPHA) texel = {0, 0, 0, kTexel.a};
    if (format == kGL_LUMINANCE) texel = {kTexel.r, kTexel.r, kTexel.r, 1};
    if (format == kGL_LUMINANCE_ALPHA) texel = {kTexel.r, kTexel.r, kTexel.r, kTexel.a};
    if (format == kGL_INTENSITY) texel = glm::vec4(kTexel.r);
    draw.texture.texture = texture_of(format, {texel});
    return draw;
}

// Tables 3.22 and 3.23, row by row, with C_s and A_s from table 3.21.
TEST(ProgrammableTextures, FollowTheTablesOfEnvironments) {
    const glm::dvec3 cf(kFragment), cc(kEnvColor), rgb(kTexel), l(kTexel.r);
    const double af = kFragment.a, ac = kEnvColor.a, a = kTexel.a, i = kTexel.r;
    const glm::dvec3 one(1);
    const struct {
        Enum mode, format;
        glm::dvec4 color;
    } rows[] = {
        {kGL_REPLACE, kGL_ALPHA, {cf, a}},
        {kGL_REPLACE, kGL_LUMINANCE, {l, af}},
        {kGL_REPLACE, kGL_LUMINANCE_ALPHA, {l, a}},
        {kGL_REPLACE, kGL_INTENSITY, {l, i}},
        {kGL_REPLACE, kGL_RGB, {rgb, af}},
        {kGL_REPLACE, kGL_RGBA, {rgb, a}},
        {kGL_MODULATE, kGL_ALPHA, {cf, af * a}},
        {kGL_MODULATE, kGL_LUMINANCE, {cf * l, af}},
        {kGL_MODULATE, kGL_LUMINANCE_ALPHA, {cf * l, af * a}},
        {kGL_MODULATE, kGL_INTENSITY, {cf * l, af * i}},
        {kGL_MODULATE, kGL_RGB, {cf * rgb, af}},
        {kGL_MODULATE, kGL_RGBA, {cf * rgb, af * a}},
        {kGL_DECAL, kGL_RGB, {rgb, af}},
        {kGL_DECAL, kGL_RGBA, {cf * (1 - a) + rgb * a, af}},
        {kGL_DECAL, kGL_LUMINANCE, {cf, af}},  // RULING: undefined, so unchanged
        {kGL_BLEND, kGL_ALPHA, {cf, af * a}},
        {kGL_BLEND, kGL_LUMINANCE, {cf * (one - l) + cc * l, af}},
        {kGL_BLEND, kGL_LUMINANCE_ALPHA, {cf * (one - l) + cc * l, af * a}},
        {kGL_BLEND, kGL_INTENSITY, {cf * (one - l) + cc * l, af * (1 - i) + ac * i}},
        {kGL_BLEND, kGL_RGB, {cf * (one - rgb) + cc * rgb, af}},
        {kGL_BLEND, kGL_RGBA, {cf * (one - rgb) + cc * rgb, af * a}},
        {kGL_ADD, kGL_ALPHA, {cf, af * a}},
        {kGL_ADD, kGL_LUMINANCE, {glm::min(cf + l, one), af}},
        {kGL_ADD, kGL_LUMINANCE_ALPHA, {glm::min(cf + l, one), af * a}},
        {kGL_ADD, kGL_INTENSITY, {glm::min(cf + l, one), std::min(af + i, 1.0)}},
        {kGL_ADD, kGL_RGB, {glm::min(cf + rgb, one), af}},
        {kGL_ADD, kGL_RGBA, {glm::min(cf + rgb, one), af * a}},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(enum_name(row.mode) + " " + enum_name(row.format));
        expect_color(color(textured_point(row.mode, row.format)), row.color);
    }
}

TEST(ProgrammableTextures, DivideByQAfterTheMatrix) {
    Draw draw = textured_point(kGL_REPLACE, kGL_RGBA);
    const glm::vec4 left(0, 0, 0, 1), right(1, 1, 1, 1);
    draw.texture.texture = texture_of(kGL_RGBA, {left, right});
    draw.vertices.edit()[0].tex_coord = {0.75, 0, 0, 1};
    expect_color(color(draw), {1, 1, 1, 1});
    draw.vertices.edit()[0].tex_coord.q = 2;
    expect_color(color(draw), {0, 0, 0, 1});
    draw.texture.texture_matrix[3][3] = 0.5;  // q is 1 again
    expect_color(color(draw), {1, 1, 1, 1});
}

// 3.8.7: at 0 and 1 a linear filter gets half of the border; a nearest filter gets the last texel.
TEST(ProgrammableTextures, ClampToHalfOfTheBorderWhereTheFilterIsLinear) {
    Draw draw = textured_point(kGL_REPLACE, kGL_RGBA);
    auto texture = texture_of(kGL_RGBA, {{0, 0, 0, 1}, {0, 0, 1, 1}}, kGL_LINEAR);
    texture->wrap_s = kGL_CLAMP;
    texture->border_color = {1, 0, 0, 1};
    draw.texture.texture = texture;
    const double kWeight = 1.0 / 255;  // the filter's weights have 8 bits, and so has the texture
    for (const double s : {0.0, -3.0}) {
        draw.vertices.edit()[0].tex_coord.s = s;
        EXPECT_NEAR(color(draw).r, 0.5, kWeight) << s;
        EXPECT_NEAR(color(draw).b, 0, kWeight) << s;
    }
    for (const double s : {1.0, 4.0}) {
        draw.vertices.edit()[0].tex_coord.s = s;
        EXPECT_NEAR(color(draw).r, 0.5, kWeight) << s;
        EXPECT_NEAR(color(draw).b, 0.5, kWeight) << s;
    }
    // A point is magnified, and only the other filter is linear.
    texture->mag_filter = kGL_NEAREST;
    for (const double s : {-3.0, 0.0}) {
        draw.vertices.edit()[0].tex_coord.s = s;
        expect_color(color(draw), {0, 0, 0, 1});
    }
    for (const double s : {1.0, 4.0}) {
        draw.vertices.edit()[0].tex_coord.s = s;
        expect_color(color(draw), {0, 0, 1, 1});
    }
}

TEST(ProgrammableTextures, AreThoseOfTheFrameThatIsDrawn) {
    const auto context = make_offscreen_context(1, 1, ColorBuffer::kFloat);
    Renderer renderer;
    for (const float red : {0.0F, 1.0F, 0.0F}) {
        Draw draw = textured_point(kGL_REPLACE, kGL_RGBA);
        draw.raster.viewport = {0, 0, 1, 1};
        draw.texture.texture = texture_of(kGL_RGBA, {{red, 0, 0, 1}});
        const Frame frame{.width = 1, .height = 1, .items = {draw}};
        EXPECT_EQ(renderer.render(frame, {}).at(0, 0)[0], red);
    }
}

TEST(ProgrammableTextures, AreNotDrawnWhereTheDriverRefusesThem) {
    const auto context = make_offscreen_context(1, 1);
    Draw draw = textured_point(kGL_REPLACE, kGL_RGBA);
    draw.texture.texture = texture_of(0x1234, {glm::vec4(1)});  // not an internal format
    const Frame frame{.width = 1, .height = 1, .items = {draw}};
    Renderer renderer;
    for (int i = 0; i < 2; ++i) EXPECT_THROW(renderer.render(frame, {}), std::runtime_error);
}

// ---- Fog and the colour sum ----

Draw fogged_point(Enum mode, double z, double w = 1) {
    Draw draw = point({0, 0, z}, {});
    draw.vertices.edit()[0].position_object.w = w;
    draw.vertices.edit()[0].color = {1, 0, 0, 0.5};
    draw.clip_from_eye[3][3] = 1 / w;
    draw.fog = {.enabled = true, .mode = mode, .density = 0.5, .start = 1, .end = 5, .color = {0, 0, 1, 1}};
    return draw;
}

TEST(ProgrammableFog, FollowsTheDistanceToTheEyesPlane) {
    const auto fogged = [](double f) { return glm::dvec4(f, 0, 1 - f, 0.5); };
    expect_color(color(fogged_point(kGL_LINEAR, -2)), fogged(0.75));
    expect_color(color(fogged_point(kGL_LINEAR, 2)), fogged(0.75));
    expect_color(color(fogged_point(kGL_LINEAR, -4, 2)), fogged(0.75));
    expect_color(color(fogged_point(kGL_LINEAR, -0.5)), fogged(1));
    expect_color(color(fogged_point(kGL_LINEAR, -7)), fogged(0));
    expect_color(color(fogged_point(kGL_EXP, -2)), fogged(std::exp(-1)));
    expect_color(color(fogged_point(kGL_EXP2, -4)), fogged(std::exp(-4)));
    // RULING: fog with end = start is a step.
    for (const double z : {-0.99, -1.01}) {
        Draw draw = fogged_point(kGL_LINEAR, z);
        draw.fog.end = draw.fog.start;
        expect_color(color(draw), fogged(z == -0.99 ? 1 : 0));
    }
}

// 3.9: added after the texture, clamped, then fogged.
TEST(ProgrammableFog, ComesAfterTheClampOfTheColorSum) {
    LightingState lighting = shiny(1);
    lighting.front.diffuse = {0.75, 0.75, 0.75, 1};
    lighting.light_model.color_control = kGL_SEPARATE_SPECULAR_COLOR;
    Draw draw = point({0, 0, -3}, lighting);
    expect_color(color(draw), {1, 1, 0.75, 1});
    draw.texture.texture = texture_of(kGL_RGB, {glm::vec4(0.2F, 0.2F, 0.2F, 1)});
    expect_color(color(draw), {1, 0.5 + 0.15, 0.15, 1});
    draw.fog = {.enabled = true, .mode = kGL_LINEAR, .start = 1, .end = 5, .color = {0, 0, 0, 0}};
    expect_color(color(draw), {0.5, 0.325, 0.075, 1});
    draw.texture.env_mode = kGL_REPLACE;  // replaces everything but the highlight
    expect_color(color(draw), {0.5, 0.35, 0.1, 1});
}

// ---- Clip planes, per-vertex materials ----

TEST(ProgrammableClipPlanes, AreNumberedWithoutGapsAndKeepWhatIsInFrontOfAll) {
    Draw draw = square({});
    draw.eye_from_object = glm::translate(glm::dmat4(1), {0.25, 0, 0});
    draw.clip_from_eye = glm::translate(draw.clip_from_eye, {-0.25, 0, 0});
    draw.raster.clip_planes_eye[1] = glm::dvec4(1, 0, 0, -0.25);  // the right half of the picture
    draw.raster.clip_planes_eye[7] = glm::dvec4(0, -1, 0, 0);     // the lower half
    const Image image = picture(draw, 4);
    for (int y = 0; y < 4; ++y)  // from the top
        for (int x = 0; x < 4; ++x) EXPECT_EQ(image.at(x, y)[0], x >= 2 && y >= 2 ? 1 : 0) << x << ", " << y;
}

TEST(ProgrammableMaterials, AreInterpolatedWhereVerticesHaveTheirOwn) {
    Draw draw = square();
    draw.materials.resize(2, {draw.lighting.front, draw.lighting.back});
    draw.materials[1].front.emission = {1, 0.5, 0, 1};
    draw.materials[1].front.diffuse.a = 0;
    for (std::size_t i : {1, 2}) draw.vertices.edit()[i].material = 1;  // on the right
    for (const Options& options : {Options{}, kPhong}) {
        const Image image = picture(draw, 4, options);
        for (int x = 0; x < 4; ++x) {
            const double share = (x + 0.5) / 4;
            const Rgba c = image.at(x, 1);
            expect_color({c[0], c[1], c[2], c[3]}, {share, share / 2, 0, 1 - share});
        }
    }
    draw.materials[1].front = draw.materials[0].front;
    EXPECT_EQ(plan_effects(draw, {}).effects.front, FaceEffects{});
}

// ---- The shader text and the context ----

TEST(ShaderText, HasOfTexturesAndFogOnlyWhatIsCalledFor) {
    for (const char* absent : {"tex_coord", "sampler", "fog", "eye_z", "gl_ClipDistance", "texel"}) {
        const ShaderSource source = assemble(plan_effects(square(), {}).effects);
        EXPECT_EQ(source.vertex.find(absent), std::string::npos) << absent;
        EXPECT_EQ(source.fragment.find(absent), std::string::npos) << absent;
    }
    // Colours that the texture replaces are not lit.
    Draw draw = square();
    draw.texture.env_mode = kGL_REPLACE;
    draw.texture.texture = texture_of(kGL_RGBA, {glm::vec4(kTexel)});
    const ShaderSource source = assemble(plan_effects(draw, kPhong).effects);
    for (const char* absent : {"light", "primary", "normal"}) {
        EXPECT_EQ(source.vertex.find(absent), std::string::npos) << source.vertex;
        EXPECT_EQ(source.fragment.find(absent), std::string::npos) << source.fragment;
    }
}

TEST(ProgrammableTextures, LeaveTheContextAsItWas) {
    const auto context = make_offscreen_context(4, 4);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    glLineWidth(3);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
    Draw draw = textured_point(kGL_MODULATE, kGL_RGBA);
    draw.raster.clip_planes_eye[0] = glm::dvec4(0, 0, 0, 1);
    Renderer().render({.width = 4, .height = 4, .items = {draw}}, {});
    EXPECT_TRUE(glIsEnabled(GL_BLEND));
    EXPECT_TRUE(glIsEnabled(GL_SCISSOR_TEST));
    EXPECT_FALSE(glIsEnabled(GL_CLIP_PLANE0));
    GLfloat width = 0;
    GLint row_length = 0, texture = 1, depth = 1;
    glGetFloatv(GL_LINE_WIDTH, &width);
    glGetIntegerv(GL_UNPACK_ROW_LENGTH, &row_length);
    glGetIntegerv(GL_TEXTURE_BINDING_1D, &texture);
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    EXPECT_EQ(width, 3);
    EXPECT_EQ(row_length, 7);
    EXPECT_EQ(texture, 0);
    EXPECT_EQ(depth, 0);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace twinlight::programmable::programmable_fragments_test

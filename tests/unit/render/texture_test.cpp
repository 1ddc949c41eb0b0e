// Texturing in the reference, compared with values computed by hand: wrap modes, filters, levels, functions, fog.
#include "render/reference/textures/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../small_frames.h"
#include "render/reference/fog.h"
#include "render/reference/fragment_operations.h"
#include "render/reference/textures/texture_bounds.h"
#include "render/reference/textures/texture_environment.h"

namespace twinlight::texture_test {
namespace {

using namespace reference;

// Four texels in a row, 0, 0.25, 0.5 and 0.75, with a border of 1.
Texture ramp() {
    Texture texture;
    texture.target = kGL_TEXTURE_1D;
    texture.levels.push_back({.width = 4, .height = 1, .base_format = kGL_RGBA});
    for (int i = 0; i < 4; ++i) texture.levels[0].texels.emplace_back(glm::vec4(static_cast<float>(i) / 4));
    texture.border_color = glm::dvec4(1);
    texture.min_filter = texture.mag_filter = kGL_NEAREST;
    return texture;
}

double sampled(const Texture& texture, Enum filter, double s) {
    return sample_image(texture, texture.levels[0], filter, {s, 0, 0}).r;
}

TEST(TextureWrap, ChoosesTheNearestTexel) {
    struct Case {
        Enum wrap;
        double at_minus_0_1, at_1_1, at_1;
    };
    Texture texture = ramp();
    for (const Case& c :
         {Case{kGL_REPEAT, 0.75, 0, 0}, Case{kGL_MIRRORED_REPEAT, 0, 0.75, 0.75}, Case{kGL_CLAMP, 0, 0.75, 0.75},
          Case{kGL_CLAMP_TO_EDGE, 0, 0.75, 0.75}, Case{kGL_CLAMP_TO_BORDER, 1, 1, 1}}) {
        texture.wrap_s = c.wrap;
        EXPECT_EQ(sampled(texture, kGL_NEAREST, -0.1), c.at_minus_0_1) << c.wrap;
        EXPECT_EQ(sampled(texture, kGL_NEAREST, 1.1), c.at_1_1) << c.wrap;
        EXPECT_EQ(sampled(texture, kGL_NEAREST, 1), c.at_1) << c.wrap;
        EXPECT_EQ(sampled(texture, kGL_NEAREST, 0.3), 0.25) << c.wrap;
    }
}

TEST(TextureWrap, MixesTheTwoTexelsAboutTheCoordinate) {
    struct Case {
        Enum wrap;
        double at_0, beyond;  // s = 0: between the first texel and the one before it; s = 5: far outside
    };
    Texture texture = ramp();
    for (const Case& c :
         {Case{kGL_REPEAT, 0.375, 0.375}, Case{kGL_MIRRORED_REPEAT, 0, 0.75}, Case{kGL_CLAMP, 0.5, 0.875},
          Case{kGL_CLAMP_TO_EDGE, 0, 0.75}, Case{kGL_CLAMP_TO_BORDER, 0.5, 1}}) {
        texture.wrap_s = c.wrap;
        EXPECT_EQ(sampled(texture, kGL_LINEAR, 0), c.at_0) << c.wrap;
        EXPECT_EQ(sampled(texture, kGL_LINEAR, 5), c.beyond) << c.wrap;
        EXPECT_EQ(sampled(texture, kGL_LINEAR, 0.5), 0.375) << c.wrap;      // half way between the second and the third
        EXPECT_EQ(sampled(texture, kGL_LINEAR, 0.4375), 0.3125) << c.wrap;  // a quarter of the third
    }
}

TEST(TextureLevels, FollowLambda) {
    Texture texture = ramp();
    texture.levels.push_back({.width = 2, .texels = {glm::vec4(2), glm::vec4(2)}});
    texture.levels.push_back({.width = 1, .texels = {glm::vec4(4)}});
    const auto at = [&](Enum min_filter, double lambda) {
        texture.min_filter = min_filter;
        return sample(texture, {0.1, 0, 0}, lambda).r;
    };
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_NEAREST, 0.5), 0);  // half way: the finer one
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_NEAREST, 0.51), 2);
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_NEAREST, 99), 4);
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_LINEAR, 0.25), 0.5);
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_LINEAR, 1.5), 3);
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_LINEAR, 99), 4);
    EXPECT_EQ(at(kGL_NEAREST_MIPMAP_LINEAR, -1), 0);
    // 3.8.9: c is 0.5 between a nearest minification and a linear magnification.
    texture.mag_filter = kGL_LINEAR;
    EXPECT_EQ(magnification_limit(texture), 0.5);
    // Sixteen texels per pixel are four halvings.
    const TexturePlace place{.per_x = {4, 0, 0}, .per_y = {1, 0, 0}};
    EXPECT_EQ(scale_factor(texture, place), 16);
    texture.max_lod = 2.5;
    TextureUnit unit{.texture = std::make_shared<const Texture>(texture), .lod_bias = -1};
    EXPECT_EQ(level_of_detail(4, unit), 1);
    EXPECT_EQ(level_of_detail(16, unit), 2.5);
    texture.min_lod = 3;  // larger than the largest: they change places
    unit.texture = std::make_shared<const Texture>(texture);
    EXPECT_EQ(level_of_detail(4, unit), 2.5);
    EXPECT_EQ(level_of_detail(100, unit), 3);
}

TEST(TextureBounds, HoldTheSampleAndTellChoicesApart) {
    Texture texture = ramp();
    TextureUnit unit;
    unit.texture = std::make_shared<Texture>(texture);
    EXPECT_FALSE(sample_bounds(unit, {0.3, 0, 0}, {1e-6, 0, 0}, 0.1).has_choice);
    EXPECT_TRUE(sample_bounds(unit, {0.25, 0, 0}, {1e-6, 0, 0}, 0.1).has_choice);  // the border of two texels
    texture.min_filter = texture.mag_filter = kGL_LINEAR;
    unit.texture = std::make_shared<Texture>(texture);
    for (double s = -1; s < 2; s += 1.0 / 64) {
        const TexelBounds bounds = sample_bounds(unit, {s, 0, 0}, {1e-6, 0, 0}, 0.1);
        EXPECT_FALSE(bounds.has_choice);
        const double exact = sampled(texture, kGL_LINEAR, s);
        EXPECT_LE(bounds.texel[0].low, exact);
        EXPECT_GE(bounds.texel[0].high, exact);
        EXPECT_LT(bounds.texel[0].width(), 3.0 / 255);
    }
}

// A place in doubt by more than a texel has each of the texels there, and not only those at the ends of what it may be.
TEST(TextureBounds, HoldAllTexelsThatAPlaceInDoubtMayHave) {
    Texture texture = ramp();
    TextureUnit unit;
    unit.texture = std::make_shared<Texture>(texture);
    for (const double error : {0.3, 1.0, 100.0}) {
        const TexelBounds bounds = sample_bounds(unit, {0.6, 0, 0}, {error, 0, 0}, 0.1);
        EXPECT_TRUE(bounds.has_choice) << error;
        EXPECT_EQ(bounds.texel[0].low, error > 0.5 ? 0 : sampled(texture, kGL_NEAREST, 0.3)) << error;
        EXPECT_GE(bounds.texel[0].high, sampled(texture, kGL_NEAREST, 0.8)) << error;
    }
}

// Drivers round the mean of two levels to 8 bits, also where each has one texel.
TEST(TextureBounds, OfTwoLevelsAreRoundedMeans) {
    Texture texture = ramp();
    texture.levels = {{.width = 2, .texels = {glm::vec4(0.25), glm::vec4(0.25)}},
                      {.width = 1, .texels = {glm::vec4(0.75)}}};
    texture.min_filter = kGL_NEAREST_MIPMAP_LINEAR;
    TextureUnit unit;
    unit.texture = std::make_shared<Texture>(texture);
    const double rho = std::exp2(0.5), exact = sample(texture, {0.3, 0, 0}, 0.5).r;
    const TexelBounds bounds = sample_bounds(unit, {0.3, 0, 0}, {1e-6, 0, 0}, rho);
    EXPECT_FALSE(bounds.has_choice);
    EXPECT_LE(bounds.texel[0].low, exact - 0.5 / 255);
    EXPECT_GE(bounds.texel[0].high, exact + 0.499 / 255);
    EXPECT_LT(bounds.texel[0].width(), 9.0 / 255) << "half of the error of lambda, and the rounding";
}

// Tables 3.22 and 3.23 for a fragment of 0.5 (alpha 0.8), a texel of 0.25 (alpha 0.5), an environment of 1.
TEST(TextureFunction, IsThatOfTheTables) {
    TextureUnit unit;
    unit.env_color = glm::dvec4(1);
    const Channels<double> fragment{0.5, 0.5, 0.5, 0.8}, texel{0.25, 0.25, 0.25, 0.5};
    const auto expect = [&](Enum mode, Enum base_format, double color, double alpha) {
        unit.env_mode = mode;
        const Channels<double> got = textured(unit, base_format, fragment, texel);
        EXPECT_DOUBLE_EQ(got[0], color) << mode << ' ' << base_format;
        EXPECT_DOUBLE_EQ(got[3], alpha) << mode << ' ' << base_format;
    };
    expect(kGL_REPLACE, kGL_ALPHA, 0.5, 0.5);
    expect(kGL_REPLACE, kGL_RGB, 0.25, 0.8);
    expect(kGL_REPLACE, kGL_RGBA, 0.25, 0.5);
    expect(kGL_MODULATE, kGL_LUMINANCE, 0.125, 0.8);
    expect(kGL_MODULATE, kGL_RGBA, 0.125, 0.4);
    expect(kGL_DECAL, kGL_RGB, 0.25, 0.8);
    expect(kGL_DECAL, kGL_RGBA, 0.375, 0.8);
    expect(kGL_BLEND, kGL_RGB, 0.625, 0.8);
    expect(kGL_BLEND, kGL_LUMINANCE_ALPHA, 0.625, 0.4);
    expect(kGL_ADD, kGL_RGBA, 0.75, 0.4);
    const Channels<double> intensity{0.25, 0.25, 0.25, 0.25};  // A_s is I_t
    unit.env_mode = kGL_BLEND;
    EXPECT_DOUBLE_EQ(textured(unit, kGL_INTENSITY, fragment, intensity)[3], 0.8 * 0.75 + 0.25);
    unit.env_mode = kGL_ADD;
    EXPECT_DOUBLE_EQ(textured(unit, kGL_INTENSITY, fragment, intensity)[3], 1);
}

TEST(Fog, IsThatOfItsThreeEquations) {
    Fog fog{.enabled = true, .mode = kGL_LINEAR, .density = 0.5, .start = 2, .end = 6};
    EXPECT_EQ(fog_factor<double>(fog, 3), 0.75);
    EXPECT_EQ(fog_factor<double>(fog, 1), 1);
    EXPECT_EQ(fog_factor<double>(fog, 7), 0);
    fog.mode = kGL_EXP;
    EXPECT_DOUBLE_EQ(fog_factor<double>(fog, 2), std::exp(-1));
    fog.mode = kGL_EXP2;
    EXPECT_DOUBLE_EQ(fog_factor<double>(fog, 4), std::exp(-4));
    fog.color = {1, 0, 0, 0};
    EXPECT_EQ(fogged(fog, 0.25, Channels<double>{0, 1, 0, 0.5}), (Channels<double>{0.75, 0.25, 0, 0.5}));
}

TEST(Ruling, LinearFogThatEndsWhereItStartsIsAStep) {
    const Fog fog{.enabled = true, .mode = kGL_LINEAR, .start = 3, .end = 3};
    EXPECT_EQ(fog_factor<double>(fog, 2.9), 1);
    EXPECT_EQ(fog_factor<double>(fog, 3), 0);
}

}  // namespace
}  // namespace twinlight::texture_test

// EffectSet: the facts that change the code which lights a Draw and colours its fragments, and nothing else.
//
// Draws with equal sets use the same code with different numbers. The sets are canonical (plan_effects() ensures it): a
// fact that has no effect has its default value. So a set can be the key of a program cache.
//
//   this fact may be set only if             this holds
//   two_side to separate_specular, lights    lighting
//   lighting                                 the texture does not replace all lit colours
//   shading kFlat                            the primitive has more than one vertex; its colours are visible
//   clamp                                    the colours are visible and may leave [0,1]
//   two_side, back                           a back face can be visible
//   local_viewer                             a light's highlight depends on the viewer
//   vertex_w                                 a light is positional, or local_viewer, or there is fog
//   normalize                                a light is diffuse or specular; no common factor makes all normals unit
//   separate_specular, highlight             a light is specular
//   shininess                                a light is specular
//   spectral_products                        tracks_* or varies_* of an ambient, diffuse or specular colour
//   spectral_groups                          no spectral_products; only if PlanOptions::fold_spectra is false
//   tracks_*, varies_*                       that property of the material is used; at most one of the two
//   lights[i].meets_directions               the light is not directional, and not attenuated
//   lights[i].attenuated                     the light is positional
//   lights[i].cone                           the light is positional; for_any_pose: any light
//   lights[i].cone kGl without an exponent   part of the Draw is outside its cone; for_any_pose: always
//   lights[i].ambient, .diffuse              the texture does not replace the primary colour's red, green and blue
//   texture.*                                texture.environment
//   texture.texels kIntensity                the environment is kBlend or kAdd; otherwise kColorAndAlpha is used
//   texture.texels kAlpha                    the environment is kModulate or kReplace; kBlend and kAdd become kModulate
//   texture.one_dimensional, .three_dimensional, .cube   at most one of them
//   texture.q, .clamp_s, .clamp_t            no cube
//   texture.compares                         texture.depth_mode
//   texture.q, .matrix, .generated           no sprite
//   texture.clamp_t                          the texture has two dimensions or three
//   texture.clamp_r                          the texture has three dimensions
//   texture.clamp_s, .clamp_t, .clamp_r      a filter is linear; otherwise GL_CLAMP equals GL_CLAMP_TO_EDGE
//   texture.gradients                        a texture.clamp_*, and the filters differ or are anisotropic
//   texture.generated[i]                     the coordinate is used: texture.uses(i)
//   texture.generated_normal                 a coordinate is generated from the normal
//   texture.generated_w                      a coordinate is generated from the direction to the vertex
//   texture.environment kDecal               the texels are kColorAndAlpha; with kColor it becomes kReplace
//   texture.environment kCombine             only in `units`
//   texture                                  no units: the Draw has one texture and no GL_COMBINE
//   fog_coords                               there is fog
//   attenuated_points                        the Draw draws points
//   secondary_color                          no lighting
//   units[i]                                 the unit changes the colour, or GL_COMBINE of another unit reads its texture
//   units[i].texture                         as texture; the environment may be kNone
//   units[i].combine                         the environment is kCombine; what its functions do not read is initial
//
// NOLINT below: clang-tidy takes a defaulted <=> for a null pointer.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "render/look.h"
#include "scene/frame/frame.h"

namespace twinlight {

// How the code computes x^n: 1 if n is 0, repeated squaring if n is another integer, else pow.
enum class Power : std::uint8_t { kZero, kWhole, kReal };
inline Power power_of(double exponent) {
    if (exponent == 0) return Power::kZero;
    return exponent == std::floor(exponent) ? Power::kWhole : Power::kReal;
}

// GL's (n.h)^s and the lecture's (r.v)^s.
enum class Highlight : std::uint8_t { kHalfVector, kReflection };

struct LightEffects {
    bool directional = false;  // w of the position is 0
    // w of the position is 0 here too, but a vertex may have w = 0, and then VP depends on the vertex (2.14.1).
    bool meets_directions = false;
    // By a linear or quadratic factor; a constant factor is part of the colour products, except for_any_pose.
    bool attenuated = false;
    SpotCone cone = SpotCone::kNone;
    Power spot_exponent = Power::kZero;  // of GL's cone
    bool ambient = false;                // an ambient term that is not the same at every vertex
    bool diffuse = false;
    bool specular = false;

    friend auto operator<=>(const LightEffects&, const LightEffects&) = default;  // NOLINT
};

struct FaceEffects {
    // Which colours of the face's material come from the vertex colour (2.14.3).
    bool tracks_emission = false;
    bool tracks_ambient = false;
    bool tracks_diffuse = false;
    bool tracks_specular = false;
    // Which properties differ between vertices: glMaterial between glBegin and glEnd (2.14.2).
    bool varies_emission = false;
    bool varies_ambient = false;
    bool varies_diffuse = false;
    bool varies_specular = false;
    bool varies_shininess = false;

    bool tracks() const { return tracks_emission || tracks_ambient || tracks_diffuse || tracks_specular; }
    bool varies() const {
        return varies_emission || varies_ambient || varies_diffuse || varies_specular || varies_shininess;
    }

    friend auto operator<=>(const FaceEffects&, const FaceEffects&) = default;  // NOLINT
};

// How the fragment's colour and the texel are combined (3.8.13).
enum class TextureEnvironment : std::uint8_t { kNone, kModulate, kDecal, kReplace, kBlend, kAdd, kCombine };

// What a texel contains, by its base internal format (table 3.22): RGB and LUMINANCE a colour, ALPHA an alpha, RGBA and
// LUMINANCE_ALPHA both. INTENSITY is both, with the same value.
enum class Texels : std::uint8_t { kColor, kAlpha, kColorAndAlpha, kIntensity };

// What a texture coordinate is computed from (2.11.4), instead of coming with the vertex. kLinear: a plane, of object or
// eye coordinates.
enum class Generated : std::uint8_t { kNot, kLinear, kSphereMap, kReflectionMap, kNormalMap };

// Whether texture coordinates are generated from the normal, and whether GL_NORMALIZE scales it to length 1 first.
enum class GeneratedNormal : std::uint8_t { kUnused, kUnchanged, kUnit };

struct TextureEffects {
    TextureEnvironment environment = TextureEnvironment::kNone;
    Texels texels = Texels::kColor;
    bool one_dimensional = false;
    bool three_dimensional = false;
    bool cube = false;    // a cube map, whose coordinates s, t and r are a direction
    bool sprite = false;  // the coordinates are those of point sprites
    // The texture has depths, which become texels of this base internal format (3.8.14); 0: it has colours.
    Enum depth_mode = 0;
    bool compares = false;  // the depths are compared with r first
    bool matrix = false;    // the texture matrix is not the identity
    bool q = false;         // a texture coordinate's q may be other than 1
    bool clamp_s = false;   // GL_CLAMP, that core GL and some drivers lack: the shader does it
    bool clamp_t = false;
    bool clamp_r = false;
    bool gradients = false;                // the filter and level come from the coordinates before clamping
    std::array<Generated, 4> generated{};  // s, t, r, q
    GeneratedNormal generated_normal = GeneratedNormal::kUnused;
    bool generated_w = false;  // w in eye coordinates may be negative

    // Whether coordinate i (0 to 3: s, t, r, q) can change a pixel.
    bool uses(std::size_t i) const {
        if (sprite) return false;
        return matrix || i == 0 || (i == 1 && !one_dimensional) || (i == 2 && needs_r()) || (i == 3 && q);
    }
    // Whether the lookup takes s, t and r.
    bool needs_r() const { return three_dimensional || cube || compares; }
    bool clamps() const { return clamp_s || clamp_t || clamp_r; }
    bool generates() const { return generated != std::array<Generated, 4>{}; }
    bool generates_all() const {
        for (std::size_t i = 0; i < 4; ++i)
            if (uses(i) && generated[i] == Generated::kNot) return false;
        return true;
    }
    bool generates_from_direction() const {
        return std::ranges::any_of(
            generated, [](Generated g) { return g == Generated::kSphereMap || g == Generated::kReflectionMap; });
    }
    bool generates_from_normal() const {
        return generates_from_direction() || std::ranges::find(generated, Generated::kNormalMap) != generated.end();
    }
    bool has_color() const { return texels != Texels::kAlpha; }
    bool has_alpha() const { return texels != Texels::kColor; }

    friend auto operator<=>(const TextureEffects&, const TextureEffects&) = default;  // NOLINT
};

// One texture unit of a Draw that combines textures (Draw::combines_textures()).
struct UnitEffects {
    std::size_t number = 0;
    TextureEffects texture;
    Combine combine;

    friend auto operator<=>(const UnitEffects&, const UnitEffects&) = default;  // NOLINT
};

enum class FogEffect : std::uint8_t { kNone, kLinear, kExp, kExp2 };

struct EffectSet {
    bool lighting = false;
    Shading shading = Shading::kGouraud;
    bool clamp = false;  // a colour may leave [0,1] (2.14.6)
    bool two_side = false;
    bool local_viewer = false;
    bool vertex_w = false;  // w in eye coordinates may be other than 1
    bool normalize = false;
    bool separate_specular = false;
    Highlight highlight = Highlight::kHalfVector;
    Power shininess = Power::kZero;
    FaceEffects front, back;
    std::vector<LightEffects> lights;  // in GL's order
    TextureEffects texture;
    std::vector<UnitEffects> units;  // in the order of their numbers
    FogEffect fog = FogEffect::kNone;
    bool fog_coords = false;         // fog takes the vertices' coordinates
    bool secondary_color = false;    // the vertices' secondary colours are added after the textures
    bool attenuated_points = false;  // their size depends on the distance (3.3)
    int clip_plane_count = 0;        // of GL_CLIP_PLANEi (2.12)
    bool at_pixels = false;          // vertices are drawn at Draw::pixels, wherever their positions are
    // Vertex colours are multiplied with lights in more than three samples: one matrix per product.
    bool spectral_products = false;
    // Every point is lit in this many groups of three spectral samples; 0: in red, green and blue.
    int spectral_groups = 0;
    bool srgb_coded = false;  // a fragment's colour is linear light; the last step encodes it as sRGB

    friend auto operator<=>(const EffectSet&, const EffectSet&) = default;  // NOLINT

    // any_light(): whether any light has this fact. needs_x() below: whether the code computes x.
    bool any_light(bool LightEffects::*fact) const {
        return std::any_of(lights.begin(), lights.end(), [fact](const LightEffects& light) { return light.*fact; });
    }
    bool needs_position_eye() const {
        return local_viewer ||
               std::any_of(lights.begin(), lights.end(), [](const LightEffects& light) { return !light.directional; });
    }
    bool needs_normal() const { return any_light(&LightEffects::diffuse) || any_light(&LightEffects::specular); }
    // Whether vertices bring normals and texture coordinates.
    bool takes_normal() const { return needs_normal() || generated_normal() != GeneratedNormal::kUnused; }
    bool takes_tex_coord() const { return has_texture() && !texture.generates_all(); }
    // Of all texture units; those that need normals take the same.
    GeneratedNormal generated_normal() const {
        GeneratedNormal normal = texture.generated_normal;
        for (const UnitEffects& unit : units) normal = std::max(normal, unit.texture.generated_normal);
        return normal;
    }
    bool generates_from_direction() const {
        return texture.generates_from_direction() || std::ranges::any_of(units, [](const UnitEffects& unit) {
                   return unit.texture.generates_from_direction();
               });
    }
    // Whether the primary colour is visible after the texture. With several units, it counts as visible.
    bool needs_primary_rgb() const { return !replaces() || !texture.has_color(); }
    bool needs_primary_alpha() const { return !replaces() || !texture.has_alpha(); }
    bool needs_primary() const { return needs_primary_rgb() || needs_primary_alpha(); }
    bool needs_color() const { return lighting ? front.tracks() || back.tracks() : needs_primary(); }
    bool has_texture() const { return texture.environment != TextureEnvironment::kNone; }
    bool has_fog() const { return fog != FogEffect::kNone; }

  private:
    bool replaces() const { return texture.environment == TextureEnvironment::kReplace; }
};

// One fact per line: "lighting", "light 0: positional, attenuated, diffuse".
std::string describe(const EffectSet& effects);

}  // namespace twinlight

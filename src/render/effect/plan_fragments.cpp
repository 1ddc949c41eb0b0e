// Plans a Draw's texture, fog and clip planes.
#include <fmt/format.h>

#include <algorithm>

#include "base/text/translation.h"
#include "render/effect/plan_parts.h"

namespace twinlight {
namespace {

// ---- The texture ----

Texels texels_of(Enum base_format) {
    switch (base_format) {
        case kGL_ALPHA: return Texels::kAlpha;
        case kGL_LUMINANCE:
        case kGL_RGB: return Texels::kColor;
        case kGL_INTENSITY: return Texels::kIntensity;
        default: return Texels::kColorAndAlpha;
    }
}

// 3.8.13, tables 3.22 and 3.23: pairs of mode and format that need the same code get the same result.
TextureEffects environment_of(Enum mode, Enum base_format) {
    using Environment = TextureEnvironment;
    const Texels texels = texels_of(base_format);
    const Texels intensity_apart = texels == Texels::kIntensity ? Texels::kColorAndAlpha : texels;
    switch (mode) {
        case kGL_MODULATE: return {.environment = Environment::kModulate, .texels = intensity_apart};
        case kGL_REPLACE: return {.environment = Environment::kReplace, .texels = intensity_apart};
        case kGL_DECAL:
            // RULING: 3.8.13 defines GL_DECAL only for RGB and RGBA; with other formats the fragment is unchanged.
            if (base_format == kGL_RGB) return {.environment = Environment::kReplace, .texels = texels};
            if (base_format == kGL_RGBA) return {.environment = Environment::kDecal, .texels = texels};
            return {};
        case kGL_BLEND:
        case kGL_ADD:
            if (texels == Texels::kAlpha) return {.environment = Environment::kModulate, .texels = texels};
            return {.environment = mode == kGL_BLEND ? Environment::kBlend : Environment::kAdd, .texels = texels};
        default: return {};
    }
}

// is_1_at_vertices: before the texture matrix.
bool q_is_1(const TextureUnit& unit, bool is_1_at_vertices) {
    constexpr int kQ = 3;
    return keeps_w(unit.texture_matrix) && is_1_at_vertices &&
           std::ranges::find(unit.generated, kQ, &GeneratedCoordinate::coordinate) == unit.generated.end();
}

// 2.11.4.
void plan_generated(const Draw& draw, const TextureUnit& unit, const VertexFacts& vertices, TextureEffects& facts,
                    Plan& plan) {
    for (const GeneratedCoordinate& one : unit.generated) {
        const auto i = static_cast<std::size_t>(one.coordinate);
        if (!facts.uses(i)) {
            plan.leave_out(tr("the generated texture coordinate {}", "strq"[i]), "the texture does not use it");
            continue;
        }
        switch (one.mode) {
            case kGL_OBJECT_LINEAR:
            case kGL_EYE_LINEAR: facts.generated[i] = Generated::kLinear; break;
            case kGL_SPHERE_MAP: facts.generated[i] = Generated::kSphereMap; break;
            case kGL_REFLECTION_MAP: facts.generated[i] = Generated::kReflectionMap; break;
            default: facts.generated[i] = Generated::kNormalMap; break;
        }
    }
    if (facts.generates_from_direction()) facts.generated_w = !keeps_w(draw.eye_from_object) || !vertices.w_is_1;
    if (!facts.generates_from_normal()) return;
    facts.generated_normal = draw.lighting.normalize ? GeneratedNormal::kUnit : GeneratedNormal::kUnchanged;
}

// What a texture's lookup needs: all of `facts` but the environment and the texels.
void plan_lookup(const Draw& draw, std::size_t number, const TextureUnit& unit, bool has_q_1,
                 const VertexFacts& vertices, TextureEffects& facts, Plan& plan) {
    const auto leave_out = [&](const char* what, const char* why, bool is_off = false) {
        if (!plan.has_reasons) return;
        plan.leave_out(draw.combines_textures() ? tr("{} of texture unit {}", tr(what), number) : what, why, is_off);
    };
    const Texture& texture = *unit.texture;
    facts.one_dimensional = texture.is_flat();
    facts.three_dimensional = texture.is_volume();
    facts.cube = texture.is_cube();
    if (texture.has_depths()) facts.depth_mode = texture.depth_mode;
    facts.compares = texture.compares();
    facts.sprite = unit.coord_replace;
    facts.matrix = !facts.sprite && unit.texture_matrix != glm::dmat4(1);
    facts.q = !facts.cube && !facts.sprite && !q_is_1(unit, has_q_1);
    if (!facts.matrix) leave_out("texture matrix", "it is the identity", true);
    if (!facts.q)
        leave_out("division by q", facts.cube     ? "a cube map has none"
                                   : facts.sprite ? "q of a point sprite is 1"
                                                  : "q is 1 at every vertex");
    if (!unit.generated.empty() && !facts.sprite) plan_generated(draw, unit, vertices, facts, plan);

    if (facts.cube) return;
    const bool clamp_t = !facts.one_dimensional && texture.wrap_t == kGL_CLAMP;
    const bool clamp_r = facts.three_dimensional && texture.wrap_r == kGL_CLAMP;
    const bool clamps = clamp_t || clamp_r || texture.wrap_s == kGL_CLAMP;
    if (clamps && !texture.filters_linearly())
        return leave_out("GL_CLAMP", "without a linear filter it equals GL_CLAMP_TO_EDGE");
    facts.clamp_s = texture.wrap_s == kGL_CLAMP;
    facts.clamp_t = clamp_t;
    facts.clamp_r = clamp_r;
    facts.gradients = clamps && (texture.min_filter != texture.mag_filter || texture.max_anisotropy > 1);
}

// Without what its functions do not read.
Combine canonical(const Combine& combine) {
    Combine result;
    const auto keep = [](Enum function, auto& sources, auto& operands, const auto& from_sources,
                         const auto& from_operands) {
        for (std::size_t i = 0; i < Combine::arguments_of(function); ++i) {
            sources[i] = from_sources[i];
            operands[i] = from_operands[i];
        }
    };
    result.rgb = combine.rgb;
    result.rgb_scale = combine.rgb_scale;
    result.alpha_scale = combine.alpha_scale;
    keep(combine.rgb, result.rgb_sources, result.rgb_operands, combine.rgb_sources, combine.rgb_operands);
    if (combine.gives_alpha()) return result;
    result.alpha = combine.alpha;
    keep(combine.alpha, result.alpha_sources, result.alpha_operands, combine.alpha_sources, combine.alpha_operands);
    return result;
}

// The units of a Draw that combines textures.
void plan_units(const Draw& draw, const VertexFacts& vertices, Plan& plan) {
    const auto is_read = [&](std::size_t number) {
        bool reads = false;
        draw.for_each_unit([&](std::size_t, const TextureUnit& unit) {
            reads = reads || (unit.env_mode == kGL_COMBINE && unit.combine.reads_unit(number));
        });
        return reads;
    };
    draw.for_each_unit([&](std::size_t number, const TextureUnit& unit) {
        UnitEffects effects{.number = number, .texture = {}, .combine = {}};
        if (unit.env_mode == kGL_COMBINE) {
            effects.texture = {.environment = TextureEnvironment::kCombine, .texels = Texels::kColorAndAlpha};
            effects.combine = canonical(unit.combine);
        } else {
            effects.texture = environment_of(unit.env_mode, unit.texture->base_format());
        }
        if (effects.texture.environment == TextureEnvironment::kNone && !is_read(number))
            return plan.leave_out(tr("texture unit {}", number),
                                  "with this texture format its environment mode changes nothing");
        bool has_q_1 = vertices.q_is_1;
        if (number > 0)
            for (std::size_t i = 0; i < draw.vertices.size(); ++i)
                has_q_1 = (i == 0 || has_q_1) && draw.tex_coord(number, i).q == 1;
        plan_lookup(draw, number, unit, has_q_1, vertices, effects.texture, plan);
        plan.effects.units.push_back(effects);
    });
}

void plan_texture(const Draw& draw, const VertexFacts& vertices, Plan& plan) {
    if (draw.combines_textures()) return plan_units(draw, vertices, plan);
    const Texture* texture = draw.texture.texture.get();
    if (!texture) return plan.leave_out("texture", "none is enabled, or the enabled one is incomplete", true);
    TextureEffects& facts = plan.effects.texture;
    facts = environment_of(draw.texture.env_mode, texture->base_format());
    if (!plan.effects.has_texture())
        return plan.leave_out("texture", "with this texture format its environment mode changes nothing");
    plan_lookup(draw, 0, draw.texture, vertices.q_is_1, vertices, facts, plan);
}

// ---- The rest ----

void plan_fog(const Draw& draw, Plan& plan) {
    if (!draw.fog.enabled) return plan.leave_out("fog", "GL_FOG is disabled", true);
    if (draw.fog.mode == kGL_LINEAR) {
        plan.effects.fog = FogEffect::kLinear;
    } else if (draw.fog.density == 0) {
        plan.leave_out("fog", "GL_FOG_DENSITY is 0");
    } else {
        plan.effects.fog = draw.fog.mode == kGL_EXP2 ? FogEffect::kExp2 : FogEffect::kExp;
    }
}

}  // namespace

void plan_fragments(const Draw& draw, const VertexFacts& vertices, Plan& plan) {
    plan_texture(draw, vertices, plan);
    plan_fog(draw, plan);
    plan.effects.fog_coords = plan.effects.has_fog() && draw.fog.by_coordinates;
    plan.effects.clip_plane_count = draw.raster.clip_plane_count();
    if (plan.effects.clip_plane_count == 0) plan.leave_out("clip planes", "none is enabled", true);
    plan.effects.attenuated_points = draw.raster.point_parameters.attenuates();
    plan.effects.secondary_color = draw.column(VertexAttribute::kSecondaryColor) != nullptr;
    if (draw.fragment.color_sum && !draw.lighting.enabled && !plan.effects.secondary_color)
        plan.leave_out("colour sum", "the secondary colour is black");
}

}  // namespace twinlight

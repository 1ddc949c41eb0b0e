// What happens to a lit colour before the per-fragment operations, with its numbers: texture, colour sum, fog.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/translation.h"
#include "judge/explain/derivation_light.h"
#include "render/reference/textures/texture_environment.h"
#include "scene/command/names.h"

namespace twinlight::explain {

namespace {

using reference::ColorSteps;
using reference::FogSteps;
using reference::TextureSteps;

Lines head(std::string what) { return {{Line::Kind::kHeadingOfColors, std::move(what)}}; }

glm::dvec4 clamped_rgba(const glm::dvec4& color) { return glm::clamp(color, 0.0, 1.0); }

// The formulas of tables 3.22 and 3.23, for the color and for alpha.
struct EnvironmentFormulas {
    const char *color, *alpha;
};
EnvironmentFormulas environment_formulas(Enum env_mode, Enum base_format) {
    const bool is_intensity = base_format == kGL_INTENSITY;
    EnvironmentFormulas f{"C_f", "A_f"};
    switch (env_mode) {
        case kGL_REPLACE: f = {"C_s", "A_s"}; break;
        case kGL_MODULATE: f = {"C_f C_s", "A_f A_s"}; break;
        case kGL_DECAL:
            if (base_format == kGL_RGB) f.color = "C_s";
            if (base_format == kGL_RGBA) f.color = "C_f (1 - A_s) + C_s A_s";
            break;
        case kGL_BLEND: f = {"C_f (1 - C_s) + C_c C_s", is_intensity ? "A_f (1 - A_s) + A_c A_s" : "A_f A_s"}; break;
        case kGL_ADD: f = {tr("C_f + C_s, at most 1"), is_intensity ? tr("A_f + A_s, at most 1") : "A_f A_s"}; break;
    }
    if (!reference::has_color(base_format)) f.color = tr("C_f: the texture has no colour");
    if (!reference::has_alpha(base_format)) f.alpha = tr("A_f: the texture has no alpha");
    return f;
}

Lines coordinates_lines(const TextureSteps& steps, const TextureUnit& unit, bool is_exact) {
    Lines lines;
    for (const GeneratedCoordinate& one : unit.generated) {
        const bool is_linear = !one.needs_normal();
        lines += line(fmt::format("{}", "strq"[one.coordinate]), enum_name(one.mode),
                      is_linear ? tr("generated at each vertex (2.11.4), with the plane {}", quadruple(one.plane))
                                : tr("generated at each vertex (2.11.4)"));
    }
    lines += line("s, t, r, q", quadruple(steps.coordinates),
                  is_exact             ? tr("of this point of the surface, times the texture matrix (2.11.2)")
                  : unit.coord_replace ? tr("across the point sprite (3.3.1)")
                                       : tr("times the texture matrix (2.11.2), interpolated (3.5.1)"));
    if (unit.texture->is_cube()) {
        const char* const faces[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
        return lines +
               line(tr("face"), faces[steps.face], tr("the largest of |s|, |t| and |r|, with its sign (3.8.7)")) +
               line("s, t", fmt::format("({:.5g}, {:.5g})", steps.str.x, steps.str.y), tr("the place on that face"));
    }
    constexpr double kRounding = 1e-9;  // of the interpolation
    if (std::abs(steps.coordinates.w - 1) > kRounding)
        lines +=
            unit.texture->is_volume()
                ? line("s/q, t/q, r/q", fmt::format("({:.5g}, {:.5g}, {:.5g})", steps.str.x, steps.str.y, steps.str.z),
                       tr("the place in the texture"))
                : line("s/q, t/q", fmt::format("({:.5g}, {:.5g})", steps.str.x, steps.str.y),
                       tr("the place in the texture"));
    if (unit.texture->compares())
        lines += line(
            "r/q", fmt::format("{:.7g}", steps.str.z),
            tr("compared with depths (3.8.14): 1 where {} passes, 0 where not", enum_name(unit.texture->compare_func)));
    return lines;
}

Lines level_of_detail_lines(const TextureSteps& steps, const TextureUnit& unit) {
    const double bias = unit.lod_bias;
    std::string how = "log2(rho)";
    if (bias != 0) how += fmt::format(" + {:.5g}, GL_TEXTURE_LOD_BIAS", bias);
    const Texture& texture = *unit.texture;
    if (steps.lambda == texture.min_lod) how += tr(", at least {:.5g}, GL_TEXTURE_MIN_LOD", texture.min_lod);
    if (steps.lambda == texture.max_lod) how += tr(", at most {:.5g}, GL_TEXTURE_MAX_LOD", texture.max_lod);
    const double limit = reference::magnification_limit(texture);
    return line("rho", fmt::format("{:.5g}", steps.rho),
                steps.of_point ? tr("always 1 for a point (3.8.8)")
                               : tr("texels per pixel, in x or y: the larger (3.8.8)")) +
           line("lambda", fmt::format("{:.5g}", steps.lambda), how) +
           line(tr("filter"), enum_name(steps.filter),
                steps.is_magnified ? tr("GL_TEXTURE_MAG_FILTER, because lambda is at most {} (3.8.9)", limit)
                                   : tr("GL_TEXTURE_MIN_FILTER, because lambda is more than {} (3.8.8)", limit));
}

Lines texels_lines(const TextureSteps& steps, const Texture& texture) {
    Lines lines;
    for (const TextureSteps::Image& image : steps.images) {
        const TextureImage& level = texture.levels[static_cast<std::size_t>(image.level)];
        lines += line(tr("level {}", image.level), tr("weight {:.5f}", image.weight),
                      texture.is_volume() ? tr("{} x {} x {} texels", level.width, level.height, level.depth)
                                          : tr("{} x {} texels", level.width, level.height));
        for (const TextureSteps::Texel& texel : image.texels)
            lines += color_line("",
                                tr("texel {}, {}{}{}{}, weight {:.5f}", texel.place.i, texel.place.j,
                                   texture.is_volume() ? fmt::format(", {}", texel.place.k) : "",
                                   texel.is_border ? tr(" (the border colour)") : "",
                                   texture.has_depths() ? tr(", depth {:.7f}", texel.depth) : "", texel.weight),
                                rgb_of(texel.color));
    }
    return lines;
}

const TextureUnit& unit_of(const TextureSteps& steps, const Draw& draw) {
    const auto further = std::ranges::find(draw.further_units, steps.unit, &FurtherUnit::number);
    return further == draw.further_units.end() ? draw.texture : further->unit;
}

// "A B" of GL_MODULATE; the arguments with their sources and operands.
std::string combine_formula(Enum function, const std::array<Enum, 3>& sources, const std::array<Enum, 3>& operands) {
    const auto argument = [&](std::size_t i) {
        const bool is_rest = operands[i] == kGL_ONE_MINUS_SRC_COLOR || operands[i] == kGL_ONE_MINUS_SRC_ALPHA;
        const bool is_alpha = operands[i] == kGL_SRC_ALPHA || operands[i] == kGL_ONE_MINUS_SRC_ALPHA;
        std::string name = enum_name(sources[i]).substr(3);
        if (is_alpha) name += ".a";
        return is_rest ? fmt::format("(1 - {})", name) : name;
    };
    switch (function) {
        case kGL_REPLACE: return argument(0);
        case kGL_MODULATE: return fmt::format("{} x {}", argument(0), argument(1));
        case kGL_ADD: return fmt::format("{} + {}", argument(0), argument(1));
        case kGL_ADD_SIGNED: return fmt::format("{} + {} - 1/2", argument(0), argument(1));
        case kGL_INTERPOLATE: return fmt::format("{0} x {2} + {1} x (1 - {2})", argument(0), argument(1), argument(2));
        case kGL_SUBTRACT: return fmt::format("{} - {}", argument(0), argument(1));
        default:
            return fmt::format("4 ({} - 1/2) . ({} - 1/2)", argument(0), argument(1));  // GL_DOT3_RGB, GL_DOT3_RGBA
    }
}

// GL_COMBINE (3.8.13, tables 3.24 and 3.25).
Lines combine_lines(const TextureSteps& steps, const TextureUnit& unit) {
    const Combine& combine = unit.combine;
    const auto formula = [](int scale, const std::string& text) {
        return tr("GL_COMBINE: {}, clamped to [0, 1]", scale == 1 ? text : fmt::format("{} ({})", scale, text));
    };
    const std::string rgb = combine_formula(combine.rgb, combine.rgb_sources, combine.rgb_operands);
    const std::string alpha =
        combine.gives_alpha() ? rgb : combine_formula(combine.alpha, combine.alpha_sources, combine.alpha_operands);
    return color_line("C_v", formula(combine.rgb_scale, rgb), rgb_of(steps.result)) +
           line("A_v", fmt::format("{:.5g}", steps.result.a), formula(combine.alpha_scale, alpha));
}

Lines texture_lines(const TextureSteps& steps, const Draw& draw, bool is_exact) {
    const TextureUnit& unit = unit_of(steps, draw);
    const Enum format = unit.texture->base_format();
    const EnvironmentFormulas formulas = environment_formulas(unit.env_mode, format);
    const std::string name = draw.combines_textures() ? tr("texture unit {} (3.8)", steps.unit) : tr("texture (3.8)");
    Lines lines = head(name) + coordinates_lines(steps, unit, is_exact) + level_of_detail_lines(steps, unit) +
                  texels_lines(steps, *unit.texture);
    lines += color_line("C_s", tr("the sum of weight times texel; A_s is {:.5g}", steps.texel.a), rgb_of(steps.texel));
    lines += color_line("C_f", tr("the colour so far; A_f is {:.5g}", steps.fragment.a), rgb_of(steps.fragment));
    if (unit.env_mode == kGL_BLEND || unit.env_mode == kGL_COMBINE)
        lines += color_line("C_c", tr("GL_TEXTURE_ENV_COLOR; A_c is {:.5g}", clamped_rgba(unit.env_color).a),
                            rgb_of(clamped_rgba(unit.env_color)));
    if (unit.env_mode == kGL_COMBINE) return lines + combine_lines(steps, unit);
    lines += color_line("C_v", tr("{} of {}: {}", enum_name(unit.env_mode), enum_name(format), formulas.color),
                        rgb_of(steps.result));
    return lines + line("A_v", fmt::format("{:.5g}", steps.result.a), formulas.alpha);
}

// f, and its equation with the numbers.
Lines factor_lines(const FogSteps& steps, const Fog& fog) {
    const double c = steps.distance;
    std::string how;
    switch (fog.mode) {
        case kGL_LINEAR: {
            const double f = (fog.end - c) / (fog.end - fog.start);
            how = fog.end == fog.start
                      ? tr("GL_LINEAR, and GL_FOG_END is GL_FOG_START")
                      : fmt::format("GL_LINEAR: (end - c) / (end - start) = ({:.5g} - {:.5g}) / ({:.5g} - {:.5g}){}",
                                    fog.end, c, fog.end, fog.start, f < 0 || f > 1 ? tr(", clamped to [0, 1]") : "");
            break;
        }
        case kGL_EXP2: how = fmt::format("GL_EXP2: e^-(density c)^2 = e^-({:.5g} x {:.5g})^2", fog.density, c); break;
        default: how = fmt::format("GL_EXP: e^-(density c) = e^-({:.5g} x {:.5g})", fog.density, c);
    }
    return line("f", fmt::format("{:.5f}", steps.factor), how);
}

Lines fog_lines(const ColorSteps& of, const FogSteps& steps, const Fog& fog) {
    return head(tr("fog (3.10)")) +
           line("c", fmt::format("{:.5g}", steps.distance),
                fog.by_coordinates ? tr("the fog coordinate (glFogCoord), interpolated")
                                   : tr("|z_e|: how far the fragment is from the plane of the eye")) +
           factor_lines(steps, fog) + color_line("C_r", tr("the colour so far"), rgb_of(of.sum)) +
           color_line("C_f", "GL_FOG_COLOR", rgb_of(clamped_rgba(fog.color))) +
           color_line("C", "f C_r + (1 - f) C_f", rgb_of(steps.result));
}

}  // namespace

Lines after_lighting_lines(const ColorSteps& steps, const Draw& draw, bool is_exact) {
    Lines lines;
    for (const TextureSteps& texture : steps.textures) lines += texture_lines(texture, draw, is_exact);
    const bool separates =
        draw.lighting.enabled && draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    if (separates || draw.column(VertexAttribute::kSecondaryColor)) {
        lines += head(tr("colour sum (3.9)")) +
                 color_line("", tr("the colour so far"),
                            rgb_of(steps.textures.empty() ? steps.primary : steps.textures.back().result)) +
                 color_line("c_sec", tr("the mean of the secondary colours"), rgb_of(steps.secondary)) +
                 color_line(tr("sum"), tr("clamped to [0, 1]"), rgb_of(steps.sum));
    }
    if (steps.fog) lines += fog_lines(steps, *steps.fog, draw.fog);
    return lines;
}

namespace {

Json rgba_json(const glm::dvec4& c) { return {c.r, c.g, c.b, c.a}; }

Json combine_json(const Combine& combine) {
    const auto names = [](const std::array<Enum, 3>& of) {
        Json list = Json::array();
        for (const Enum name : of) list.push_back(enum_name(name));
        return list;
    };
    return {{"rgb", enum_name(combine.rgb)},
            {"rgb_sources", names(combine.rgb_sources)},
            {"rgb_operands", names(combine.rgb_operands)},
            {"rgb_scale", combine.rgb_scale},
            {"alpha", enum_name(combine.alpha)},
            {"alpha_sources", names(combine.alpha_sources)},
            {"alpha_operands", names(combine.alpha_operands)},
            {"alpha_scale", combine.alpha_scale}};
}

Json texture_json(const TextureSteps& steps, const Draw& draw) {
    const TextureUnit& unit = unit_of(steps, draw);
    Json json = {{"target", enum_name(unit.texture->target)},
                 {"coordinates", rgba_json(steps.coordinates)},
                 {"st", {steps.str.x, steps.str.y}},
                 {"rho", steps.rho},
                 {"lod_bias", unit.lod_bias},
                 {"lambda", steps.lambda},
                 {"magnified", steps.is_magnified},
                 {"filter", enum_name(steps.filter)},
                 {"levels", Json::array()}};
    for (const TextureSteps::Image& image : steps.images) {
        const TextureImage& level = unit.texture->levels[static_cast<std::size_t>(image.level)];
        Json texels = Json::array();
        for (const TextureSteps::Texel& texel : image.texels) {
            texels.push_back({{"i", texel.place.i},
                              {"j", texel.place.j},
                              {"border", texel.is_border},
                              {"weight", texel.weight},
                              {"color", rgba_json(texel.color)}});
            if (unit.texture->is_volume()) texels.back()["k"] = texel.place.k;
            if (unit.texture->has_depths()) texels.back()["depth"] = texel.depth;
        }
        json["levels"].push_back({{"level", image.level},
                                  {"width", level.width},
                                  {"height", level.height},
                                  {"weight", image.weight},
                                  {"texels", texels}});
        if (unit.texture->is_volume()) json["levels"].back()["depth"] = level.depth;
    }
    if (unit.texture->is_cube()) json["face"] = steps.face;
    if (unit.texture->is_volume() || unit.texture->compares()) json["r"] = steps.str.z;
    json["texel"] = rgba_json(steps.texel);
    json["format"] = enum_name(unit.texture->levels[0].base_format);
    if (unit.texture->has_depths()) json["depth_mode"] = enum_name(unit.texture->depth_mode);
    if (unit.texture->compares()) {
        json["compare_func"] = enum_name(unit.texture->compare_func);
    }
    json["environment"] = enum_name(unit.env_mode);
    json["environment_color"] = rgba_json(clamped_rgba(unit.env_color));
    if (unit.env_mode == kGL_COMBINE) json["combine"] = combine_json(unit.combine);
    json["fragment"] = rgba_json(steps.fragment);
    json["result"] = rgba_json(steps.result);
    return json;
}

Json fog_json(const ColorSteps& of, const FogSteps& steps, const Fog& fog) {
    Json json = {{"mode", enum_name(fog.mode)}, {"distance", steps.distance}};
    if (fog.mode == kGL_LINEAR)
        json.update({{"start", fog.start}, {"end", fog.end}});
    else
        json["density"] = fog.density;
    json["factor"] = steps.factor;
    json["color"] = rgba_json(clamped_rgba(fog.color));
    json["fragment"] = rgba_json(of.sum);
    json["result"] = rgba_json(steps.result);
    return json;
}

}  // namespace

void add_after_lighting(const ColorSteps& steps, const Draw& draw, Json& json) {
    if (!steps.textures.empty() && !draw.combines_textures())
        json["texture"] = texture_json(steps.textures.front(), draw);
    for (const TextureSteps& texture : steps.textures) {
        if (!draw.combines_textures()) break;
        Json unit = texture_json(texture, draw);
        unit["unit"] = texture.unit;
        json["texture_units"].push_back(unit);
    }
    if (steps.fog) json["fog"] = fog_json(steps, *steps.fog, draw.fog);
}

}  // namespace twinlight::explain

// The derivation, line by line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "base/text/translation.h"
#include "judge/explain/derivation_light.h"
#include "scene/command/names.h"

namespace twinlight::explain {

std::string quadruple(const glm::dvec4& v) {
    return fmt::format("({:.5g}, {:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z, v.w);
}

std::string formula_text(const lighting::Formula& formula) {
    std::string text;
    for (const lighting::Factor& factor : formula) {
        if (!text.empty()) text += " ";
        text += factor.symbol;
    }
    return text;
}

Lines line(std::string what, std::string value, std::string how) {
    return {{Line::Kind::kValue, std::move(what), std::move(value), std::move(how)}};
}
Lines result_line(std::string what, std::string value, std::string how) {
    return {{Line::Kind::kValue, std::move(what), std::move(value), std::move(how), {}, {}, true}};
}
Lines color_line(std::string what, std::string how, const reference::Vec& color) {
    return {{Line::Kind::kColor, std::move(what), "", std::move(how), color, {}, true}};
}

namespace {

using lighting::Factor;
using lighting::Formula;
using lighting::LightTerms;
using reference::LitPoint;
using reference::Vec;

std::string triple(const Vec& v) {
    return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);  // + 0.0 makes -0 positive
}
std::string short_color(const Vec& c) { return fmt::format("({:.5g} {:.5g} {:.5g})", c.x, c.y, c.z); }

Lines note(std::string words) { return {{Line::Kind::kNote, "", std::move(words), "", {}, {}, true}}; }

Lines place_lines(const Derivation& at) {
    const LitPoint& point = at.point;
    Lines text;
    if (point.position_object)
        text += line(tr("object"), quadruple(*point.position_object), tr("the vertex as it was sent"));
    const double w = point.position_eye.w;
    text +=
        line(tr("eye"), w == 0 ? quadruple(point.position_eye) : triple(point.surface.position_eye),
             std::string(point.position_object ? tr("times the modelview matrix (2.11)") : tr("interpolated (3.5.1)")) +
                 (w == 1   ? ""
                  : w == 0 ? tr("; w = 0: a direction")
                           : tr(", divided by w = {:.5g}", w)));
    return text;
}

bool is_zero(const Vec& v) { return v == Vec{}; }

Lines normal_lines(const Derivation& at) {
    const LitPoint& point = at.point;
    const LightingState& state = at.draw.lighting;
    const double length = length_of(point.surface.normal_eye);
    Lines text;
    std::string how;
    if (point.normal_steps) {
        const reference::NormalSteps& steps = *point.normal_steps;
        text += line(tr("normal"), triple(steps.object), tr("length {:.5f}, as it was sent", length_of(steps.object)));
        text +=
            line("", triple(steps.transformed),
                 tr("length {:.5f}, times the inverse of the modelview matrix (2.11.3)", steps.transformed_length()));
        how = state.normalize        ? tr("GL_NORMALIZE divides it by its length")
              : state.rescale_normal ? tr("GL_RESCALE_NORMAL multiplies it by {:.5g}", steps.rescale)
                                     : tr("GL_NORMALIZE is disabled, so it stays as it is");
    } else {
        how = tr("scaled to length 1 (2.14.1 does not interpolate normals; this shading does)");
    }
    if (point.face == reference::Face::kBack) how += tr("; reversed for the back face");
    text += line("n", triple(point.surface.normal_eye), tr("length {:.5f}; {}", length, how));
    constexpr double kVisible = 1e-3;  // a change of a length that may show in 8 bits
    if (length == 0)
        text += note(tr("n is zero, so no light adds diffuse or specular light"));
    else if (std::abs(length - 1) > kVisible)
        text +=
            note(length > 1
                     ? tr("the length of n is {:.5g}, not 1. It multiplies n.VP and n.h, so the light is too bright.\n"
                          "glEnable(GL_NORMALIZE) makes it 1.",
                          length)
                     : tr("the length of n is {:.5g}, not 1. It multiplies n.VP and n.h, so the light is too dark.\n"
                          "glEnable(GL_NORMALIZE) makes it 1.",
                          length));
    return text;
}

Lines viewer_lines(const Derivation& at) {
    return line("VP_e", triple(at.point.vpe_dir),
                at.draw.lighting.light_model.local_viewer
                    ? tr("toward the viewer at (0, 0, 0): GL_LIGHT_MODEL_LOCAL_VIEWER is on")
                    : tr("toward the viewer; always this, as GL_LIGHT_MODEL_LOCAL_VIEWER is off"));
}

// The typed value beside the eye-space one, and the matrix between them.
template <class Value, class Format>
Lines typed_lines(const char* what, const Value& typed, const std::string& eye, const Format& format) {
    if (typed.is_initial()) return line(what, format(typed.value), tr("GL's initial value, in eye coordinates"));
    const bool untransformed = typed.eye_from_typed == glm::dmat4(1);
    return line(what, format(typed.value), tr("typed at {}", typed.place.str())) +
           line("", eye,
                untransformed ? tr("eye coordinates: the same, because the modelview matrix was the identity,")
                              : tr("eye coordinates: the typed value times the modelview matrix at that call")) +
           (untransformed ? line("", "", tr("so it moves with the camera")) : Lines{});
}

Lines light_heading(const LightAt& light) {
    return {{Line::Kind::kLight, light_name(light.number), "",
             fmt::format("{}{}", light.directional() ? tr("directional (w = 0)") : tr("positional"),
                         light.is_spot() ? tr(", a spot") : "")}};
}

Lines position_lines(const LightAt& light) {
    const std::string eye = quadruple(light.source.position_eye);
    if (!light.typed) return line(tr("position"), eye, tr("in eye coordinates"));
    return typed_lines(tr("position"), light.typed->position, eye, quadruple);
}

Lines attenuation_lines(const LightAt& light, bool whole) {
    const LightSource& s = light.source;
    if (light.directional()) {
        if (s.has_initial_attenuation()) return whole ? line("att", "1", tr("the light is directional")) : Lines{};
        return line("att", "1", tr("the light is directional, so its attenuation factors do nothing"));
    }
    if (s.has_initial_attenuation())
        return whole ? line("att", "1", tr("the attenuation factors are 1, 0, 0")) : Lines{};
    const double d = light.geometry.distance;
    return line("att", "1 / (k0 + k1 d + k2 d d)", tr("the attenuation")) +
           result_line("", fmt::format("{:.5f}", light.terms.attenuation),
                       fmt::format("1 / ({:.5g} + {:.5g} x {:.5f} + {:.5g} x {:.5f} x {:.5f}) = 1 / {:.5f}",
                                   s.constant_attenuation, s.linear_attenuation, d, s.quadratic_attenuation, d, d,
                                   light.geometry.denominator));
}

Lines spot_lines(const LightAt& light, bool whole) {
    const LightSource& s = light.source;
    if (!light.is_spot()) return whole ? line("spot", "1", tr("GL_SPOT_CUTOFF is 180")) : Lines{};
    const Vec direction = vec3_cast<Vec>(s.spot_direction_eye);
    Lines text = light.typed ? typed_lines(tr("axis"), light.typed->spot_direction, triple(direction),
                                           [](const glm::dvec3& v) { return triple(vec3_cast<Vec>(v)); })
                             : line(tr("axis"), triple(direction), tr("in eye coordinates"));
    const double angle = light.axis_deg, cosine = light.geometry.cosine_to_axis;
    std::string how;
    Lines missed;
    if (light.has_smooth_cone) {
        how = tr("{:.2f} degrees from the axis; full light to {:.5g}, none from {:.5g} degrees", angle,
                 s.smooth_cone->inner_deg, s.smooth_cone->outer_deg);
    } else {
        const bool inside = angle <= s.spot_cutoff_deg;
        how = inside ? tr("{:.2f} degrees from the axis, inside the cutoff of {:.5g}", angle, s.spot_cutoff_deg)
                     : tr("{:.2f} degrees from the axis, outside the cutoff of {:.5g}", angle, s.spot_cutoff_deg);
        if (!inside && light.terms.spot > 0)
            how += tr(", but 2.14.1 compares max(cos, 0) with cos 90, and 0^0 = 1");
        else if (light.terms.spot > 0)
            how += fmt::format(": (cos)^exponent = {:.5f}^{:.5g}", cosine, s.spot_exponent);
        else if (!inside)
            missed = note(tr("the cone misses this point, so the light adds nothing here"));
    }
    return text + result_line("spot", fmt::format("{:.5f}", light.terms.spot), how) + missed;
}

Lines diffuse_angle_lines(const Derivation& at, const LightAt& light) {
    const double cosine = light.geometry.cosine_to_light;
    if (is_zero(at.point.surface.normal_eye)) return result_line("n.VP", "0", tr("n is zero"));
    std::string how = tr("{:.2f} degrees between n and VP", light.normal_to_light_deg);
    Lines behind;
    if (cosine <= 0) {
        how += fmt::format(": max({:.5f}, 0)", cosine);
        behind = note(tr(at.has_reflection()
                             ? "the light is behind the surface here, so it adds no diffuse light"
                             : "the light is behind the surface here, so it adds neither diffuse nor specular light"));
    }
    return result_line("n.VP", fmt::format("{:.5f}", light.terms.n_dot_vp), how) + behind;
}

Lines highlight_lines(const Derivation& at, const LightAt& light) {
    const bool reflection = at.has_reflection();
    const char* base = reflection ? "r.v" : "n.h";
    const double cosine = light.geometry.cosine_highlight, s = at.point.material.shininess;
    Lines text = reflection ? result_line("r", triple(light.geometry.half_dir), tr("VP reflected about n (not in GL)"))
                            : result_line("h", triple(light.geometry.half_dir), tr("VP + VP_e, scaled to length 1"));
    const bool has_angle = reflection || !is_zero(at.point.surface.normal_eye);
    text += result_line(base, fmt::format("{:.5f}", std::max(cosine, 0.0)),
                        has_angle ? tr("{:.2f} degrees between {}{}", light.highlight_deg,
                                       reflection ? tr("r and VP_e") : tr("n and h"),
                                       cosine < 0 ? fmt::format(": max({:.5f}, 0)", cosine) : "")
                                  : tr("n is zero"));
    const bool facing = reflection || light.geometry.cosine_to_light > 0;
    return text + result_line(reflection ? "(r.v)^s" : "f(n.h)^s", fmt::format("{:.5f}", light.terms.highlight),
                              facing ? tr("{:.5f}^{:.5g}: s is GL_SHININESS{}", std::max(cosine, 0.0), s,
                                          reflection ? "" : tr(", f is 1 because n.VP > 0"))
                                     : tr("f is 0 because n.VP is 0"));
}

// A formula with its numbers: "0.70423 x 1.00000 x 0.86603 x (0.8 0.5 0.31) x (1 1 1)".
std::string product_text(const Formula& formula, const LightTerms<double>& terms, const Vec& material,
                         const Vec& light) {
    const auto number_of = [&](const Factor& factor) {
        switch (factor.of) {
            case Factor::Of::kAttenuation: return fmt::format("{:.5f}", terms.attenuation);
            case Factor::Of::kSpot: return fmt::format("{:.5f}", terms.spot);
            case Factor::Of::kCosine: return fmt::format("{:.5f}", terms.n_dot_vp);
            case Factor::Of::kHighlight: return fmt::format("{:.5f}", terms.highlight);
            case Factor::Of::kMaterial: return short_color(material);
            case Factor::Of::kLight: return short_color(light);
        }
        return std::string();
    };
    std::string text;
    for (const Factor& factor : formula) text += (text.empty() ? "" : " x ") + number_of(factor);
    return text;
}

Formula without(Formula formula, std::initializer_list<Factor::Of> factors) {
    std::erase_if(formula,
                  [&](const Factor& factor) { return std::ranges::find(factors, factor.of) != factors.end(); });
    return formula;
}

// The formula without the factors that are 1 because the scene does not use them.
Formula used_factors(Formula formula, const LightAt& light) {
    if (light.directional() || light.source.has_initial_attenuation())
        formula = without(std::move(formula), {Factor::Of::kAttenuation});
    return light.is_spot() ? formula : without(std::move(formula), {Factor::Of::kSpot});
}

Lines product_lines(const Derivation& at, const LightAt& light, const char* name, const Formula& formula,
                    const Vec& material, const Vec& color, const Vec& product, bool whole) {
    const Formula used = whole ? formula : used_factors(formula, light);
    const std::string how =
        at.is_spectral() ? tr("multiplied as spectra") : product_text(used, light.terms, material, color);
    return line(tr(name), formula_text(used)) + color_line("", how, product);
}

Lines light_lines(const Derivation& at, std::size_t i, bool whole) {
    const LightAt light(at, i);
    const lighting::Material<double>& material = at.point.material;
    Lines text = light_heading(light) + position_lines(light);
    text += result_line("VP", triple(light.geometry.vp_dir),
                        light.directional() ? tr("toward the light")
                                            : tr("from the vertex to the light; d = {:.5f}", light.geometry.distance));
    const bool has_specular = !is_zero(material.specular) && !is_zero(light.specular());
    text += attenuation_lines(light, whole) + spot_lines(light, whole) + diffuse_angle_lines(at, light);
    if (has_specular || whole) text += highlight_lines(at, light);
    const lighting::Formulas& formulas = at.point.formulas;
    const auto add = [&](const char* name, const Formula& formula, const Vec& of, const Vec& color,
                         const Vec& product) {
        const bool is_black = (is_zero(of) || is_zero(color)) && is_zero(product);
        if (whole || !is_black)
            text += product_lines(at, light, name, formula, of, color, product, whole);
        else if (name != std::string_view("ambient"))
            text += line(
                tr(name), "0",
                is_zero(of) ? tr("the material's {} is black", tr(name)) : tr("the light's {} is black", tr(name)));
    };
    add("ambient", formulas.ambient, material.ambient, light.ambient(), light.terms.ambient);
    add("diffuse", formulas.diffuse, material.diffuse, light.diffuse(), light.terms.diffuse);
    add("specular", formulas.specular, material.specular, light.specular(), light.terms.specular);
    const Vec sum = light.terms.ambient + light.terms.diffuse + light.terms.specular;
    text += color_line(tr("sum"), tr("of {}", light_name(light.number)), sum);
    for (Line& one : text) one.light = light.number;
    return text;
}

Lines material_note(const Derivation& at) {
    const ColorMaterial& tracking = at.draw.lighting.color_material;
    if (!tracking.enabled) return {};
    return note(tr("GL_COLOR_MATERIAL takes {} of {} from glColor (2.14.3)", enum_name(tracking.mode),
                   enum_name(tracking.face)));
}

// The equation, with the formulas of the scene's variants.
std::string equation(const Derivation& at) {
    const lighting::Formulas& formulas = at.point.formulas;
    const auto in_brackets = [](const Formula& formula) {
        return formula_text(without(formula, {Factor::Of::kAttenuation, Factor::Of::kSpot}));
    };
    const std::string rest = in_brackets(formulas.diffuse) + " + " + in_brackets(formulas.specular);
    if (at.has_unattenuated_ambient())
        return "c = e_cm + a_cm a_cs + sum of ( a_cm a_cli + att spot [ " + rest + " ] )";
    return "c = e_cm + a_cm a_cs + sum of att spot [ " + in_brackets(formulas.ambient) + " + " + rest + " ]";
}

bool is_clamped(const Vec& c) { return !(clamped_color(c) == c); }

Lines sum_lines(const Derivation& at) {
    const LitPoint& point = at.point;
    const bool separate = at.draw.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    const auto rows = [&](const char* name, const char* what, const Vec& color) {
        return color_line(name, what, color) +
               color_line(tr("clamped"),
                          tr(is_clamped(color) ? "to [0, 1] (2.14.6): this changes it" : "to [0, 1] (2.14.6)"),
                          clamped_color(color));
    };
    Lines text = {{Line::Kind::kHeading, "total"}};
    text += rows(
        "c_pri",
        separate ? tr("the scene and the lights, without specular terms") : tr("the scene and the sums of all lights"),
        point.primary);
    if (separate) text += rows("c_sec", tr("the specular terms of all lights"), point.secondary);
    return text;
}

}  // namespace

Lines derivation_lines(const Derivation& at, bool whole) {
    const LitPoint& point = at.point;
    Lines text = place_lines(at) + normal_lines(at);
    const bool has_highlights = !is_zero(point.material.specular) && std::ranges::any_of(at.lights, [&](int light) {
        return !is_zero(rgb_of(at.draw.lighting.lights[static_cast<std::size_t>(light)].specular));
    });
    if (has_highlights || whole) text += viewer_lines(at);
    text += material_note(at);
    text += {{Line::Kind::kEquation, "", equation(at)}, {Line::Kind::kHeadingOfColors, "scene"}};
    if (whole || !is_zero(point.material.emission)) text += color_line(tr("emission"), "e_cm", point.material.emission);
    text += line(tr("ambient"), "a_cm a_cs") +
            color_line("",
                       at.is_spectral() ? tr("multiplied as spectra")
                                        : short_color(point.material.ambient) + " x " +
                                              short_color(rgb_of(at.draw.lighting.light_model.ambient)),
                       point.scene_ambient);
    if (at.lights.empty()) text += note(tr("no light is enabled; glEnable(GL_LIGHT0) turns one on"));
    for (std::size_t i = 0; i < at.lights.size(); ++i) text += light_lines(at, i, whole);
    return text + sum_lines(at);
}

}  // namespace twinlight::explain

// The equation's colour with its parts: the terms of each light with the directions and cosines behind them, and the
// magnitude that errors are divided by.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "lighting/equation.h"

namespace twinlight::lighting {

template <class Real>
struct MeasuredLit : Lit<Real> {
    // The sum of the absolute values of c_pri's terms. If terms cancel, c_pri itself is too small to measure an error
    // by.
    Vec3<Real> magnitude;
};

// `breakdown` is null, or has room for one LightTerms per light.
template <class Real>
MeasuredLit<Real> measured_light(const Model<Real>& model, const Material<Real>& material,
                                 const SurfacePoint<Real>& surface, std::span<const Light<Real>> lights,
                                 LightTerms<Real>* breakdown = nullptr) {
    Vec3<Real> sum = magnitudes(material.emission) + magnitudes(number_or_zero(material.ambient * model.ambient));
    const Lit<Real> lit = light_surface(model, material, surface, lights, [&](const LightTerms<Real>& t) {
        if (breakdown) *breakdown++ = t;
        sum += magnitudes(t.ambient) + magnitudes(t.diffuse);
        if (!model.separate_specular) sum += magnitudes(t.specular);
    });
    return {lit, saturated(sum)};
}

// A factor of a term, with the symbol that people read.
struct Factor {
    enum class Of : std::uint8_t { kAttenuation, kSpot, kCosine, kHighlight, kMaterial, kLight };
    Of of;
    std::string_view symbol;
};
using Formula = std::vector<Factor>;

// The three products of light_terms(), factor by factor, for `explain --pixel`.
struct Formulas {
    Formula ambient, diffuse, specular;
};
template <class Real>
Formulas formulas(const Model<Real>& model) {
    using enum Factor::Of;
    const Factor attenuation{kAttenuation, "att"}, spot{kSpot, "spot"},
        highlight{kHighlight, model.reflection ? "(r.v)^s" : "f(n.h)^s"};
    Formulas f{.ambient = {{kMaterial, "a_cm"}, {kLight, "a_cli"}},
               .diffuse = {attenuation, spot, {kCosine, "n.VP"}, {kMaterial, "d_cm"}, {kLight, "d_cli"}},
               .specular = {attenuation, spot, highlight, {kMaterial, "s_cm"}, {kLight, "s_cli"}}};
    if (!model.ambient_unattenuated) f.ambient.insert(f.ambient.begin(), {attenuation, spot});
    return f;
}

// What light_terms() finds on its way to a light's factors.
template <class Real>
struct LightGeometry {
    Vec3<Real> vp_dir{};       // VP_i: from the vertex to the light
    Real distance{0};          // d; only of a positional light
    Real cosine_to_light{0};   // n . VP_i, not clamped; the cosine of the angle if n is a unit vector
    Vec3<Real> half_dir{};     // h_i; in the lecture's variant r
    Real cosine_highlight{0};  // n . h_i, not clamped; in the lecture's variant r . VP_e
    Real denominator{1};       // k_0 + k_1 d + k_2 d^2; 1 for a directional light
    Real cosine_to_axis{1};    // PV . s_dli, not clamped; only of a spot
};

template <class Real>
LightGeometry<Real> light_geometry(const Model<Real>& model, const SurfacePoint<Real>& surface,
                                   const Light<Real>& light) {
    const Vec3<Real> n = surface.normal_eye;
    const Vec3<Real> vpe_dir = toward_viewer(model, surface.position_eye);
    const auto [vp_dir, d] = toward_light(light, surface.position_eye);
    LightGeometry<Real> g{.vp_dir = vp_dir};
    g.cosine_to_light = dot(n, vp_dir);
    if (model.reflection) {
        g.half_dir = reflected(n, g.cosine_to_light, vp_dir);
        g.cosine_highlight = dot(g.half_dir, vpe_dir);
    } else {
        g.half_dir = unit(vp_dir + vpe_dir);
        g.cosine_highlight = cosine_to_half(model, light, n, vp_dir, vpe_dir);
    }
    if (!light.directional) {
        g.distance = d;
        g.denominator = attenuation_denominator(light, d);
    }
    if (light.is_spot || light.has_smooth_cone) g.cosine_to_axis = cosine_to_axis(light, vp_dir);
    return g;
}

}  // namespace twinlight::lighting

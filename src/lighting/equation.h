// The lighting equation: GL 2.1, section 2.14.1 (the same in the GL 4.6 compatibility profile, section 12.2.1).
//
//   c_pri = e_cm + a_cm a_cs
//         + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Here a . b means max(a . b, 0), as in the specification: positive_dot(). The function dot() does not clamp. With
// separate specular color (c_es) the last term of the bracket goes to c_sec instead of c_pri. All positions and
// directions are in eye coordinates. The specification's letters and their names in this code:
//
//   V        SurfacePoint::position_eye       n        SurfacePoint::normal_eye
//   e_cm     Material::emission               a_cs     Model::ambient
//   a_cm     Material::ambient                a_cli    Light::ambient
//   d_cm     Material::diffuse                d_cli    Light::diffuse
//   s_cm     Material::specular               s_cli    Light::specular
//   s_rm     Material::shininess              P_pli    Light::position_eye, directional
//   k_0i..2i Light::*_attenuation             s_dli    Light::spot_dir_eye
//   c_rli    its cosine: Light::cos_cutoff    s_rli    Light::spot_exponent
//   v_bs     Model::local_viewer              c_es     Model::separate_specular
//   VP       toward_light(): from V to P_pli  d        |P_pli - V|
//   VP_e     toward_viewer(): from V to P_e   P_e      the origin
//   att_i    attenuation()                    h_i      Light::half_dir_eye, cosine_to_half()
//   spot_i   spot()                           f_i      highlight()
//
// Real is the number type: float, double, long double, a batch of SIMD lanes (lanes.h), or a double that records
// rulings (marked.h). One batch holds several points, so select(mask, a, b) chooses between values; `if` and `?:` test
// only facts that are the same for all points (bool members).
//
// A RULING is our choice where the specification is silent (rulings.h). The general one: no result is NaN or infinite.
// Where the equation has a limit, the result is that limit; otherwise the term contributes 0. A power may be beyond the
// largest number: then the colour is the largest one, which 2.14.6 clamps. The functions of real.h ensure this.
// ruled(ruling, ..., value) returns `value`; only marked.h also records the ruling.
#pragma once

#include <span>

#include "base/math/vec3.h"
#include "lighting/real.h"

namespace twinlight::lighting {

template <class Real>
struct SurfacePoint {
    Vec3<Real> position_eye;  // divided by its w
    Vec3<Real> normal_eye;    // of any length: the equation does not normalise it
};

template <class Real>
struct Material {
    Vec3<Real> emission{}, ambient{}, diffuse{}, specular{};
    Real diffuse_alpha{1};
    Real shininess{0};
};

// place() and aim() of light_setup.h set the position and the cone.
template <class Real>
struct Light {
    Vec3<Real> ambient{}, diffuse{}, specular{};
    bool has_ambient = true, has_specular = true;  // false only if the product with the material is 0
    Vec3<Real> position_eye{0, 0, 1};              // divided by its w; directional: the unit vector to the light
    bool directional = true;                       // w is 0
    Vec3<Real> half_dir_eye{0, 0, 1};   // h_i of a directional light and an infinite viewer; 0 if they are opposite
    Vec3<Real> spot_dir_eye{0, 0, -1};  // unit(spot direction)
    Real spot_exponent{0};
    bool is_spot = false;  // the cutoff is not 180 degrees
    Real cos_cutoff{-1};
    Real constant_attenuation{1}, linear_attenuation{0}, quadratic_attenuation{0};  // not negative

    // Not in GL: the lecture's cone with a soft border replaces spot_i.
    bool has_smooth_cone = false;
    Real cos_inner{1}, cos_outer{1};
};

template <class Real>
struct Model {
    Vec3<Real> ambient{};
    bool local_viewer = false;
    bool separate_specular = false;

    // Not in GL: the lecture's variants.
    bool reflection = false;            // the highlight is (r . VP_e)^s instead of f_i (n . h)^s
    bool ambient_unattenuated = false;  // a_cm a_cli is not multiplied by att_i and spot_i
};

// What one light adds, term by term. A power or a term beyond the largest number is infinite.
template <class Real>
struct LightTerms {
    Real attenuation{1}, spot{1};
    Real n_dot_vp{0};                       // n . VP
    Real highlight{0};                      // f_i (n . h)^s
    Vec3<Real> ambient, diffuse, specular;  // whole terms: att_i and spot_i included
};

template <class Real>
struct Lit {
    Vec3<Real> primary;    // c_pri
    Vec3<Real> secondary;  // c_sec; its alpha is 1
    Real alpha{1};         // of c_pri
};

// ---- The factors ----

// VP and d. A directional light has no d: its length here is never used.
template <class Real>
UnitAndLength<Real> toward_light(const Light<Real>& light, Vec3<Real> position_eye) {
    const auto [dir, length] = light.directional ? UnitAndLength<Real>{light.position_eye, Limits<Real>::largest}
                                                 : unit_and_length(light.position_eye - position_eye);
    return {ruled_zero(Ruling::kLightAtVertex, dir), length};
}

// VP_e.
template <class Real>
Vec3<Real> toward_viewer(const Model<Real>& model, Vec3<Real> position_eye) {
    if (!model.local_viewer) return {0, 0, 1};
    return unit(-position_eye, Ruling::kVertexAtEye);
}

// att_i = 1 / (k_0 + k_1 d + k_2 d^2); 1 for a directional light.
// RULING: 0 if the denominator is not positive (k = 0, 0, 0; or k_0 = 0 and the light is at the vertex).
// Horner's form avoids the overflow of d^2 when k_2 is 0.
template <class Real>
Real attenuation_denominator(const Light<Real>& light, Real d) {
    return light.constant_attenuation + d * (light.linear_attenuation + light.quadratic_attenuation * d);
}
template <class Real>
Real attenuation(const Light<Real>& light, Real d) {
    if (light.directional) return Real(1);
    return inverse_or_zero(attenuation_denominator(light, d), Ruling::kAttenuation);
}

// The lecture's cone: clamp((cos t - cos outer) / (cos inner - cos outer), 0, 1).
// RULING: if the cones are equal, or the inner one is wider, the cone is a step that includes its border, like GL's
// cutoff.
template <class Real>
Real smooth_cone(const Light<Real>& light, Real cos_angle) {
    const Real span = light.cos_inner - light.cos_outer;
    const Real slope = clamp01((cos_angle - light.cos_outer) / positive_or_one(span));
    const Real step = select(cos_angle >= light.cos_outer, Real(1), Real(0));
    return select(span > Real(0), slope, ruled(Ruling::kEqualCones, step));
}

// PV . s_dli: the cosine of the angle between the cone's axis and the direction to the vertex. Not clamped to 0.
template <class Real>
Real cosine_to_axis(const Light<Real>& light, Vec3<Real> vp_dir) {
    return dot(-vp_dir, light.spot_dir_eye);
}

// spot_i = (PV . s_dli)^s_rli inside the cone, 0 outside, where PV = -VP. Applies to directional lights too.
// The cone includes its border, so the comparison allows for the rounding of a cosine (4 epsilon). The specification
// compares a cosine that is clamped to 0. So points behind a cone of 90 degrees are inside, and exponent 0 lights them
// (0^0 = 1).
template <class Real>
Real spot(const Light<Real>& light, Vec3<Real> vp_dir) {
    if (!light.is_spot && !light.has_smooth_cone) return Real(1);
    const Real cos_angle = cosine_to_axis(light, vp_dir);
    if (light.has_smooth_cone) return smooth_cone(light, cos_angle);
    const Real rounding = Real(4) * Limits<Real>::epsilon;
    const Real falloff = power(larger(cos_angle, Real(0)), light.spot_exponent);
    const Real within = ruled(Ruling::kSpotBorder, cos_angle <= light.cos_cutoff + rounding, falloff);
    const Real behind = select(light.cos_cutoff <= Real(0), falloff, Real(0));
    return select(cos_angle >= light.cos_cutoff - rounding, within, behind);
}

// n . h for h = unit(a + b), computed without h. RULING: 0 if a + b is 0.
template <class Real>
Real cosine_to_half(Vec3<Real> n, Vec3<Real> a, Vec3<Real> b) {
    return over_length(dot(n, a) + dot(n, b), length(a + b), Ruling::kOppositeHalfVector);
}

// n . h_i, not clamped to 0. h_i is halfway between VP and VP_e.
template <class Real>
Real cosine_to_half(const Model<Real>& model, const Light<Real>& light, Vec3<Real> n, Vec3<Real> vp_dir,
                    Vec3<Real> vpe_dir) {
    return light.directional && !model.local_viewer ? dot(n, light.half_dir_eye) : cosine_to_half(n, vp_dir, vpe_dir);
}

// r of the lecture's variant: VP reflected about n.
template <class Real>
Vec3<Real> reflected(Vec3<Real> n, Real n_dot_vp, Vec3<Real> vp_dir) {
    return Real(2) * n_dot_vp * n - vp_dir;
}

// f_i (n . h_i)^s_rm. f_i is 1 if n . VP > 0, otherwise 0.
// The lecture's variant is (r . VP_e)^s_rm. It has no f_i, so a light behind the surface may shine through.
template <class Real>
Real highlight(const Model<Real>& model, const Light<Real>& light, Real shininess, Vec3<Real> n, Vec3<Real> vp_dir,
               Vec3<Real> vpe_dir) {
    const Real n_dot_vp = dot(n, vp_dir);
    if (model.reflection) return power(positive_dot(reflected(n, n_dot_vp, vp_dir), vpe_dir), shininess);
    const Real n_dot_h = cosine_to_half(model, light, n, vp_dir, vpe_dir);
    return select(n_dot_vp > Real(0), power(larger(n_dot_h, Real(0)), shininess), Real(0));
}

// ---- The sum ----

// att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli + f_i (n . h_i)^s_rm s_cm s_cli ].
template <class Real, class AnyMaterial>
LightTerms<Real> light_terms(const Model<Real>& model, const AnyMaterial& material, const SurfacePoint<Real>& surface,
                             const Light<Real>& light, Vec3<Real> vpe_dir) {
    const Vec3<Real> n = surface.normal_eye;
    const auto [vp_dir, d] = toward_light(light, surface.position_eye);
    LightTerms<Real> t;
    t.attenuation = attenuation(light, d);
    t.spot = spot(light, vp_dir);
    t.n_dot_vp = positive_dot(n, vp_dir);

    const Real reach = t.attenuation * t.spot;
    const Real ambient_reach = model.ambient_unattenuated ? Real(1) : reach;
    if (light.has_ambient) t.ambient = number_or_zero(ambient_reach * (material.ambient * light.ambient));
    t.diffuse = number_or_zero(reach * t.n_dot_vp * (material.diffuse * light.diffuse));
    if (light.has_specular) {
        t.highlight = highlight(model, light, material.shininess, n, vp_dir, vpe_dir);
        t.specular = number_or_zero(reach * t.highlight * (material.specular * light.specular));
    }
    return t;
}

struct IgnoreTerms {
    template <class Terms>
    void operator()(const Terms& /*terms*/) const {}
};

// c_pri and c_sec, not yet clamped (2.14.6). Calls visit(LightTerms) for each light. AnyMaterial: a type with the
// members of Material<Real>.
template <class Real, class AnyMaterial, class Visit = IgnoreTerms>
Lit<Real> light_surface(const Model<Real>& model, const AnyMaterial& material, const SurfacePoint<Real>& surface,
                        std::span<const Light<Real>> lights, Visit&& visit = {}) {
    const Vec3<Real> vpe_dir = toward_viewer(model, surface.position_eye);
    Vec3<Real> primary = material.emission + number_or_zero(material.ambient * model.ambient), secondary;
    for (const Light<Real>& light : lights) {
        const LightTerms<Real> t = light_terms(model, material, surface, light, vpe_dir);
        primary += t.ambient + t.diffuse;
        if (model.separate_specular)
            secondary += t.specular;
        else
            primary += t.specular;
        visit(t);
    }
    return {saturated(primary), saturated(secondary), material.diffuse_alpha};
}

}  // namespace twinlight::lighting

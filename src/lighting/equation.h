// The lighting equation of GL 2.1, section 2.14.1 (GL 4.6 compatibility profile, section 12.2.1), written once.
//
// Real may be float, double, long double, a batch of SIMD lanes or a number that knows which rulings it comes from
// (marked.h): nothing below branches on a Real. Choices between values go through select(mask, a, b); `if` and `?:`
// test only facts that hold for every lane (bool members). All positions and directions are in eye coordinates.
//
// The specification's letters, and what they are called here:
//
//   V        Surface::position_eye            n        Surface::normal_eye
//   e_cm     Material::emission               a_cs     Model::ambient
//   a_cm     Material::ambient                a_cli    Light::ambient
//   d_cm     Material::diffuse                d_cli    Light::diffuse
//   s_cm     Material::specular               s_cli    Light::specular
//   s_rm     Material::shininess              P_pli    Light::position_eye, directional: place()
//   k_0i..2i Light::*_attenuation             s_dli    Light::spot_dir_eye
//   c_rli    Light::cos_cutoff                s_rli    Light::spot_exponent
//   v_bs     Model::local_viewer              c_es     Model::separate_specular
//   P_e      the origin                       VP       the unit vector from V to P_pli: vp_dir
//   att_i    attenuation()                    h_i      Light::half_dir_eye, cosine_between()
//   spot_i   spot()                           f_i      highlight()
//
// RULING (the specification leaves these open): no answer is ever NaN or infinite. A value is the limit of
// the equation where there is one; otherwise the term contributes 0. unit_and_length() and representable()
// see to it; ruled() names what a ruling gave.
#pragma once

#include <cstddef>
#include <span>

#include "base/math/vec3.h"
#include "lighting/real.h"

namespace twinlight::lighting {

template <class Real>
struct Material {
    Vec3<Real> emission{}, ambient{}, diffuse{}, specular{};
    Real diffuse_alpha{1};
    Real shininess{0};
};

template <class Real>
struct Light {
    Vec3<Real> ambient{}, diffuse{}, specular{};
    Vec3<Real> position_eye{0, 0, 1};   // divided by its w; a unit vector towards a directional light
    bool directional = true;            // w is 0
    Vec3<Real> half_dir_eye{0, 0, 1};   // h_i of a directional light for the infinite viewer; 0 where they are opposite
    Vec3<Real> spot_dir_eye{0, 0, -1};  // unit(spot direction)
    Real spot_exponent{0};
    bool is_spot = false;  // the cutoff is not 180 degrees
    Real cos_cutoff{-1};
    Real constant_attenuation{1}, linear_attenuation{0}, quadratic_attenuation{0};  // not negative

    // Not GL: the lecture's cone, in the place of spot_i.
    bool has_smooth_cone = false;
    Real cos_inner{1}, cos_outer{1};
};

template <class Real>
struct Model {
    Vec3<Real> ambient{};
    bool local_viewer = false;
    bool separate_specular = false;

    // Not GL: the lecture's variants.
    bool reflection = false;            // specular (r . v)^s, without f_i, in the place of f_i (n . h)^s
    bool ambient_unattenuated = false;  // a_cm a_cli outside att_i and spot_i
};

template <class Real>
struct Surface {
    Vec3<Real> position_eye;  // V, divided by its w
    Vec3<Real> normal_eye;    // n as it is: the equation does not normalise it
};

// What a light and a material have in common: a_cm a_cli, d_cm d_cli, s_cm s_cli.
template <class Real>
struct Products {
    Vec3<Real> ambient, diffuse, specular;
    bool has_ambient = true, has_specular = true;  // false only where they are known to be 0
};
template <class Real>
Products<Real> products(const Material<Real>& material, const Light<Real>& light) {
    return {material.ambient * light.ambient, material.diffuse * light.diffuse, material.specular * light.specular};
}

// What one light adds, term by term.
template <class Real>
struct LightTerms {
    Real attenuation{1}, spot{1};
    Real n_dot_vp{0};                       // n . VP
    Real highlight{0};                      // f_i (n . h)^s
    Vec3<Real> ambient, diffuse, specular;  // each whole, att_i and spot_i included
};

template <class Real>
struct Lit {
    Vec3<Real> primary;    // c_pri
    Vec3<Real> secondary;  // c_sec; its alpha is 1
    Real alpha{1};         // of c_pri
    Vec3<Real> magnitude;  // the sum of the magnitudes of c_pri's terms: what an error is held against
};

// The same in another number type.
template <class To, class From>
Material<To> real_cast(const Material<From>& m) {
    return {.emission = vec3_cast<Vec3<To>>(m.emission),
            .ambient = vec3_cast<Vec3<To>>(m.ambient),
            .diffuse = vec3_cast<Vec3<To>>(m.diffuse),
            .specular = vec3_cast<Vec3<To>>(m.specular),
            .diffuse_alpha = static_cast<To>(m.diffuse_alpha),
            .shininess = static_cast<To>(m.shininess)};
}
template <class To, class From>
Model<To> real_cast(const Model<From>& m) {
    return {.ambient = vec3_cast<Vec3<To>>(m.ambient),
            .local_viewer = m.local_viewer,
            .separate_specular = m.separate_specular,
            .reflection = m.reflection,
            .ambient_unattenuated = m.ambient_unattenuated};
}
template <class To, class From>
Light<To> real_cast(const Light<From>& l) {
    return {.ambient = vec3_cast<Vec3<To>>(l.ambient),
            .diffuse = vec3_cast<Vec3<To>>(l.diffuse),
            .specular = vec3_cast<Vec3<To>>(l.specular),
            .position_eye = vec3_cast<Vec3<To>>(l.position_eye),
            .directional = l.directional,
            .half_dir_eye = vec3_cast<Vec3<To>>(l.half_dir_eye),
            .spot_dir_eye = vec3_cast<Vec3<To>>(l.spot_dir_eye),
            .spot_exponent = static_cast<To>(l.spot_exponent),
            .is_spot = l.is_spot,
            .cos_cutoff = static_cast<To>(l.cos_cutoff),
            .constant_attenuation = static_cast<To>(l.constant_attenuation),
            .linear_attenuation = static_cast<To>(l.linear_attenuation),
            .quadratic_attenuation = static_cast<To>(l.quadratic_attenuation),
            .has_smooth_cone = l.has_smooth_cone,
            .cos_inner = static_cast<To>(l.cos_inner),
            .cos_outer = static_cast<To>(l.cos_outer)};
}

// The light to (position_eye, w). Not for batches.
template <class Real>
void place(Light<Real>& light, Vec3<Real> position_eye, Real w) {
    light.directional = w == Real(0);
    light.position_eye = light.directional ? unit(position_eye) : divided(position_eye, w);
    if (!light.directional) return;
    const Vec3<Real> sum = light.position_eye + Vec3<Real>{0, 0, 1};
    light.half_dir_eye = ruled(Ruling::kOppositeHalfVector, dot(sum, sum) <= Real(0), unit(sum));
}

// ---- The terms ----

// VP and |VP|.
template <class Real>
UnitAndLength<Real> toward_light(const Light<Real>& light, Vec3<Real> position_eye) {
    const UnitAndLength<Real> toward = light.directional
                                           ? UnitAndLength<Real>{light.position_eye, Limits<Real>::largest}
                                           : unit_and_length(light.position_eye - position_eye);
    return {ruled(Ruling::kLightAtVertex, dot(toward.dir, toward.dir) <= Real(0), toward.dir), toward.length};
}

// att_i. RULING: where the denominator is not positive, 0 (k = 0, 0, 0; a light with k_0 = 0 at the vertex).
// Horner's form: k_2 d^2 itself may overflow where k_2 is 0.
template <class Real>
Real attenuation(const Light<Real>& light, Real d) {
    if (light.directional) return Real(1);
    const Real denominator =
        light.constant_attenuation + d * (light.linear_attenuation + light.quadratic_attenuation * d);
    return inverse_or_zero(denominator, Ruling::kAttenuation);
}

// The lecture's cone: clamp((cos t - cos outer) / (cos inner - cos outer), 0, 1).
// RULING: equal cones (and an inner one that is wider) are a step that includes its border, as GL's cutoff.
template <class Real>
Real smooth_cone(const Light<Real>& light, Real cos_angle) {
    const Real span = light.cos_inner - light.cos_outer;
    const Real slope = clamp01((cos_angle - light.cos_outer) / positive_or_one(span));
    const Real step = select(cos_angle >= light.cos_outer, Real(1), Real(0));
    return select(span > Real(0), slope, ruled(Ruling::kEqualCones, step));
}

// spot_i; of directional lights too. The comparison includes its border: what rounding can take from a cosine
// of two unit vectors (some units in the last place) is given back. RULING: of a spot direction of length 0 the cosine is 0.
// RULING: a cone of 90 degrees ends there. The text compares a cosine that is clamped to 0, so that behind it 0^0 would be lit.
template <class Real>
Real spot(const Light<Real>& light, Vec3<Real> vp_dir) {
    if (!light.is_spot && !light.has_smooth_cone) return Real(1);
    const Vec3<Real> s_dir = light.spot_dir_eye;
    const Real cos_angle =  // PV . s_dli
        ruled(Ruling::kZeroSpotDirection, dot(s_dir, s_dir) <= Real(0), dot(-vp_dir, s_dir));
    if (light.has_smooth_cone) return smooth_cone(light, cos_angle);
    const Real rounding = Real(4) * Limits<Real>::epsilon, border = light.cos_cutoff - rounding;
    const Real falloff = power(larger(cos_angle, Real(0)), light.spot_exponent);
    const Real within = ruled(Ruling::kSpotBorder, cos_angle <= light.cos_cutoff + rounding, falloff);
    const Real literal = select(light.cos_cutoff <= Real(0), falloff, Real(0));
    return select(cos_angle >= border, within, ruled(Ruling::kBehindSpot, literal > Real(0), Real(0)));
}

// n . h for h = hat(a + b), without h itself; 0 where a + b is 0.
template <class Real>
Real cosine_between(Vec3<Real> n, Vec3<Real> a, Vec3<Real> b) {
    const Real size = length(a + b);
    return ruled(Ruling::kOppositeHalfVector, size <= Real(0), (dot(n, a) + dot(n, b)) / positive_or_one(size));
}

// f_i (n . h_i)^s_rm; h_i lies between VP and VPe, which is (0, 0, 1) for the infinite viewer: their sum, made a unit vector.
// RULING: where they are opposite there is no highlight, as n . h_i of the vector 0 is 0.
// The lecture's variant (r . VPe)^s_rm reflects VP about n and has no f_i: a light behind the surface may
// shine through.
template <class Real>
Real highlight(const Model<Real>& model, const Light<Real>& light, Real shininess, Vec3<Real> n, Vec3<Real> vp_dir,
               Vec3<Real> vpe_dir) {
    const Real n_dot_vp = dot(n, vp_dir);
    if (model.reflection) {
        const Vec3<Real> reflected = Real(2) * n_dot_vp * n - vp_dir;
        return power(positive_dot(reflected, vpe_dir), shininess);
    }
    const Real n_dot_h =
        light.directional && !model.local_viewer ? dot(n, light.half_dir_eye) : cosine_between(n, vp_dir, vpe_dir);
    return select(n_dot_vp > Real(0), power(larger(n_dot_h, Real(0)), shininess), Real(0));
}

// The sum's i-th summand: att_i spot_i [ a_cm a_cli + (n . VP) d_cm d_cli + f_i (n . h_i)^s_rm s_cm s_cli ].
template <class Real>
LightTerms<Real> light_terms(const Model<Real>& model, const Products<Real>& products, Real shininess,
                             const Surface<Real>& surface, const Light<Real>& light, Vec3<Real> vpe_dir) {
    const auto [vp_dir, distance] = toward_light(light, surface.position_eye);
    LightTerms<Real> t;
    t.attenuation = attenuation(light, distance);
    t.spot = spot(light, vp_dir);
    t.n_dot_vp = positive_dot(surface.normal_eye, vp_dir);

    const Real reach = t.attenuation * t.spot;
    if (products.has_ambient)
        t.ambient = representable((model.ambient_unattenuated ? Real(1) : reach) * products.ambient);
    t.diffuse = representable((reach * t.n_dot_vp) * products.diffuse);
    if (products.has_specular) {
        t.highlight = highlight(model, light, shininess, surface.normal_eye, vp_dir, vpe_dir);
        t.specular = representable((reach * t.highlight) * products.specular);
    }
    return t;
}

// c_pri and c_sec, before the clamp of 2.14.6, where products_of(i) gives the Products of the material and the i-th light.
// `breakdown`, where it is not null, takes one LightTerms a light.
template <class Real, class ProductsOf>
Lit<Real> light_surface_with(const ProductsOf& products_of, const Model<Real>& model, const Material<Real>& material,
                             const Surface<Real>& surface, std::span<const Light<Real>> lights,
                             LightTerms<Real>* breakdown = nullptr) {
    const Vec3<Real> eye_dir = model.local_viewer ? unit(-surface.position_eye) : Vec3<Real>{0, 0, 1};
    const Vec3<Real> vpe_dir = ruled(Ruling::kVertexAtEye, dot(eye_dir, eye_dir) <= Real(0), eye_dir);
    Lit<Real> lit;
    lit.alpha = material.diffuse_alpha;
    const Vec3<Real> scene_ambient = representable(material.ambient * model.ambient);
    lit.primary = material.emission + scene_ambient;
    lit.magnitude = magnitudes(material.emission) + magnitudes(scene_ambient);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Products<Real>& of_both = products_of(i);
        const LightTerms<Real> t = light_terms(model, of_both, material.shininess, surface, lights[i], vpe_dir);
        if (breakdown) *breakdown++ = t;
        lit.primary += t.ambient + t.diffuse;
        lit.magnitude += magnitudes(t.ambient) + magnitudes(t.diffuse);
        if (model.separate_specular) {
            lit.secondary += t.specular;
        } else {
            lit.primary += t.specular;
            lit.magnitude += magnitudes(t.specular);
        }
    }
    return {representable(lit.primary), representable(lit.secondary), lit.alpha, representable(lit.magnitude)};
}
template <class Real>
Lit<Real> light_surface(const Model<Real>& model, const Material<Real>& material, const Surface<Real>& surface,
                        std::span<const Light<Real>> lights, LightTerms<Real>* breakdown = nullptr) {
    return light_surface_with([&](std::size_t i) { return products(material, lights[i]); }, model, material, surface,
                              lights, breakdown);
}

}  // namespace twinlight::lighting

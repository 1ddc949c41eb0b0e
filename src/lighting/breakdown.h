// The equation's colour with its parts: the terms of each light, and the magnitude that errors are divided by.
#pragma once

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
    Vec3<Real> sum = magnitudes(material.emission) + magnitudes(finite_or_zero(material.ambient * model.ambient));
    const Lit<Real> lit = light_surface(model, material, surface, lights, [&](const LightTerms<Real>& t) {
        if (breakdown) *breakdown++ = t;
        sum += magnitudes(t.ambient) + magnitudes(t.diffuse);
        if (!model.separate_specular) sum += magnitudes(t.specular);
    });
    return {lit, finite_or_zero(sum)};
}

}  // namespace twinlight::lighting

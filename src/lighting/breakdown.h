// The equation's colour with its parts: the terms of each light, and the magnitude that errors are compared with.
#pragma once

#include "lighting/equation.h"

namespace twinlight::lighting {

template <class Real>
struct MeasuredLit : Lit<Real> {
    // The sum of the sizes of c_pri's terms: where terms cancel, an error relative to the rest would mean nothing.
    Vec3<Real> magnitude;
};

// `breakdown`, where it is not null, takes one LightTerms a light.
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

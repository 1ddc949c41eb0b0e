// What a light's colour and a material's come to: channel by channel, or sample by sample where the scene has spectra.
//
// The lighting equation (2.14.1) is linear in these products, so what they come to in red, green and blue is all that it needs of
// a spectrum: n samples cost as much as three as soon as a Draw is planned.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight {

struct LightColor {
    glm::dvec3 rgb{0};
    LightSource::Illuminant illuminant{};
};
inline LightColor diffuse_of(const LightSource& light) { return {glm::dvec3(light.diffuse), light.diffuse_illuminant}; }
inline LightColor specular_of(const LightSource& light) {
    return {glm::dvec3(light.specular), light.specular_illuminant};
}
inline LightColor ambient_of(const LightSource& light) { return {glm::dvec3(light.ambient), {}}; }

struct MaterialColor {
    glm::dvec3 rgb{0};
    const Spectrum* reflectance = nullptr;
};

// Of its colour, or of the spectrum that it is of.
std::vector<double> samples_of(const SpectralSamples& spectrum, const LightColor& light);
std::vector<double> samples_of(const SpectralSamples& spectrum, const MaterialColor& material);

glm::dvec3 product_of(const LightModel& model, const LightColor& light, const MaterialColor& material);

// The matrix that takes the colours of materials without a reflectance to their products with the light.
glm::dmat3 product_matrix(const LightModel& model, const LightColor& light);

}  // namespace twinlight

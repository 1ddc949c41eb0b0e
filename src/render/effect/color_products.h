// Products of a light's colour and a material's: channel by channel, or sample by sample if the scene has spectra.
//
// The lighting equation (2.14.1) is linear in these products, so it only needs their red, green and blue. Once a Draw
// is planned, n spectral samples cost no more than three.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/frame/frame.h"

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

// The samples of the illuminant or reflectance; of a spectrum made from the RGB colour if it has none.
std::vector<double> samples_of(const SpectralSamples& spectrum, const LightColor& light);
std::vector<double> samples_of(const SpectralSamples& spectrum, const MaterialColor& material);

glm::dvec3 product_of(const LightModel& model, const LightColor& light, const MaterialColor& material);

// Takes the RGB colour of a material without a reflectance to the product with the light.
glm::dmat3 product_matrix(const LightModel& model, const LightColor& light);

}  // namespace twinlight

#include "render/effect/color_products.h"

namespace twinlight {

std::vector<double> samples_of(const SpectralSamples& spectrum, const LightColor& light) {
    if (!light.illuminant.spectrum) return spectrum.of_color(vec3_cast<Vec3<double>>(light.rgb));
    std::vector<double> samples = spectrum.of_illuminant(*light.illuminant.spectrum);
    for (double& s : samples) s *= light.illuminant.scale;
    return samples;
}

std::vector<double> samples_of(const SpectralSamples& spectrum, const MaterialColor& material) {
    return material.reflectance ? spectrum.of_reflectance(*material.reflectance)
                                : spectrum.of_color(vec3_cast<Vec3<double>>(material.rgb));
}

namespace {

glm::dvec3 product_of(const SpectralSamples& spectrum, const std::vector<double>& light,
                      const MaterialColor& material) {
    return vec3_cast<glm::dvec3>(spectrum.color_of_product(light, samples_of(spectrum, material)));
}

}  // namespace

glm::dvec3 product_of(const LightModel& model, const LightColor& light, const MaterialColor& material) {
    if (!model.spectrum) return light.rgb * material.rgb;
    return product_of(*model.spectrum, samples_of(*model.spectrum, light), material);
}

glm::dmat3 product_matrix(const LightModel& model, const LightColor& light) {
    glm::dmat3 matrix(0);
    if (!model.spectrum) {
        for (int i = 0; i < 3; ++i) matrix[i][i] = light.rgb[i];
        return matrix;
    }
    const std::vector<double> samples = samples_of(*model.spectrum, light);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 primary(0);
        primary[i] = 1;
        matrix[i] = product_of(*model.spectrum, samples, {primary, nullptr});
    }
    return matrix;
}

}  // namespace twinlight

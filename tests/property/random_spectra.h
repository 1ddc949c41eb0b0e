// Spectra for random states.
#pragma once

#include <memory>
#include <span>

#include "judge/fuzz/random.h"
#include "scene/frame/frame.h"

namespace twinlight {

// A spectrum's name for every other colour of materials and lights, in a third of the scenes.
inline void randomise_spectra(fuzz::Random& random, LightingState& lighting, bool one_material) {
    if (!random.chance(0.3)) return;
    constexpr int kCounts[] = {3, 4, 9, 31};
    lighting.light_model.spectrum = std::make_shared<const SpectralSamples>(kCounts[random.below(4)]);
    const auto any = [&](std::span<const Spectrum> all) {
        return random.chance(0.5) ? &all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))]
                                  : nullptr;
    };
    for (Material* material : {&lighting.front, &lighting.back})
        if (one_material) material->reflectances = {any(reflectances()), any(reflectances()), any(reflectances())};
    for (LightSource& light : lighting.lights) {
        light.diffuse_illuminant = {any(illuminants()), random.uniform(0, 0.5)};
        light.specular_illuminant = {any(illuminants()), random.uniform(0, 0.5)};
    }
}

}  // namespace twinlight

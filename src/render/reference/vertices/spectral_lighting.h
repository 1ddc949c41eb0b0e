// The lighting equation in spectral samples: applied to groups of three samples instead of red, green and blue, at
// every lit point. The results are converted to red, green and blue.
//
// In: a LightingState with a spectrum. The reference multiplies lights and materials sample by sample, whereas shaders
// get the colours of the products. A test checks that both agree.
#pragma once

#include <memory>
#include <vector>

#include "lighting/breakdown.h"
#include "lighting/points.h"
#include "scene/frame/frame.h"
#include "scene/spectrum/samples.h"

namespace twinlight::reference {

// A material for the equation: in red, green and blue, and in groups of three samples if there is a spectrum.
struct LitMaterial : lighting::Material<double> {
    std::vector<lighting::Material<double>> samples{};
};

class SpectralLighting {
  public:
    // `model` and `lights` are in red, green and blue; `sources` are the lights they come from.
    SpectralLighting(const std::shared_ptr<const SpectralSamples>& spectrum, const lighting::Model<double>& model,
                     const std::vector<lighting::Light<double>>& lights, const std::vector<LightSource>& sources);

    // The samples of the material's reflectances, or of its colours if it has none.
    std::vector<lighting::Material<double>> samples_of(const lighting::Material<double>& material,
                                                       const Material::Reflectances& reflectances) const;

    // Like lighting::measured_light().
    lighting::MeasuredLit<double> light_surface(const LitMaterial& material,
                                                const lighting::SurfacePoint<double>& surface,
                                                lighting::LightTerms<double>* breakdown) const;
    // Like lighting::light_points(), with the same points in each group of samples.
    void light_points(const std::vector<lighting::Points>& groups, const Arithmetic& arithmetic,
                      lighting::Lit<lighting::Column>& lit) const;
    // Takes over the places and attenuations of these lights, which are the constructor's in their order.
    void place_like(const std::vector<lighting::Light<double>>& lights);
    std::size_t group_count() const { return groups_.size(); }
    Vec3<double> scene_ambient(const LitMaterial& material) const;

  private:
    struct Group {
        lighting::Model<double> model;
        std::vector<lighting::Light<double>> lights;
        Vec3<double> red, green, blue;  // how much each of the three samples adds to this channel
    };
    static Vec3<double> color(const Group& group, Vec3<double> samples);

    std::shared_ptr<const SpectralSamples> spectrum_;
    std::vector<Group> groups_;
};

}  // namespace twinlight::reference

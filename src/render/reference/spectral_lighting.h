// The lighting equation in the samples of a spectrum: the equation as it is, in groups of three samples in the place of red,
// green and blue, at every point that is lit. What comes of it is made red, green and blue.
//
// In: a LightingState with a spectrum. Every product of a light and a material is taken sample by sample here, where shaders
// get the products' colours; that both come to the same is tested.
#pragma once

#include <memory>
#include <vector>

#include "lighting/breakdown.h"
#include "lighting/points.h"
#include "scene/spectrum/samples.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

// A material as the equation takes it: in red, green and blue, and in groups of three samples where there is a spectrum.
struct LitMaterial : lighting::Material<double> {
    std::vector<lighting::Material<double>> samples{};
};

class SpectralLighting {
  public:
    // `model` and `lights` in red, green and blue; `sources` are whose these are.
    SpectralLighting(const std::shared_ptr<const SpectralSamples>& spectrum, const lighting::Model<double>& model,
                     const std::vector<lighting::Light<double>>& lights, const std::vector<LightSource>& sources);

    // Of the material's colours, or the reflectances that they are of.
    std::vector<lighting::Material<double>> samples_of(const lighting::Material<double>& material,
                                                       const Material::Reflectances& reflectances) const;

    // As lighting::measured_light().
    lighting::MeasuredLit<double> light_surface(const LitMaterial& material,
                                                const lighting::SurfacePoint<double>& surface,
                                                lighting::LightTerms<double>* breakdown) const;
    // As lighting::light_points(): of points of equal places, of each group of samples.
    void light_points(const std::vector<lighting::Points>& groups, const Arithmetic& arithmetic,
                      lighting::Lit<lighting::Column>& lit) const;
    std::size_t group_count() const { return groups_.size(); }
    Vec3<double> scene_ambient(const LitMaterial& material) const;

  private:
    struct Group {
        lighting::Model<double> model;
        std::vector<lighting::Light<double>> lights;
        Vec3<double> red, green, blue;  // what the three samples add to each for a unit
    };
    static Vec3<double> color(const Group& group, Vec3<double> samples);

    std::shared_ptr<const SpectralSamples> spectrum_;
    std::vector<Group> groups_;
};

}  // namespace twinlight::reference

#include "render/reference/vertices/spectral_lighting.h"

#include <cassert>
#include <span>

namespace twinlight::reference {

namespace {

using Vec = Vec3<double>;

// The three samples of a group; 0 after the last sample.
Vec three(std::span<const double> samples, std::size_t group) {
    const auto at = [&](std::size_t i) { return 3 * group + i < samples.size() ? samples[3 * group + i] : 0; };
    return {at(0), at(1), at(2)};
}

std::vector<double> light_samples(const SpectralSamples& spectrum, Vec rgb, const LightSource::Illuminant& illuminant) {
    if (!illuminant.spectrum) return spectrum.of_color(rgb);
    std::vector<double> samples = spectrum.of_illuminant(*illuminant.spectrum);
    for (double& s : samples) s *= illuminant.scale;
    return samples;
}

}  // namespace

SpectralLighting::SpectralLighting(const std::shared_ptr<const SpectralSamples>& spectrum,
                                   const lighting::Model<double>& model,
                                   const std::vector<lighting::Light<double>>& lights,
                                   const std::vector<LightSource>& sources)
    : spectrum_(spectrum) {
    assert(lights.size() == sources.size());
    const auto count = static_cast<std::size_t>(spectrum->count());
    groups_.assign((count + 2) / 3, Group{model, lights, {}, {}, {}});
    const auto put = [&](const std::vector<double>& samples, const auto& place) {
        for (std::size_t g = 0; g < groups_.size(); ++g) place(groups_[g]) = three(samples, g);
    };
    put(spectrum->of_color(model.ambient), [](Group& g) -> Vec& { return g.model.ambient; });
    for (std::size_t i = 0; i < lights.size(); ++i) {
        put(spectrum->of_color(lights[i].ambient), [i](Group& g) -> Vec& { return g.lights[i].ambient; });
        put(light_samples(*spectrum, lights[i].diffuse, sources[i].diffuse_illuminant),
            [i](Group& g) -> Vec& { return g.lights[i].diffuse; });
        put(light_samples(*spectrum, lights[i].specular, sources[i].specular_illuminant),
            [i](Group& g) -> Vec& { return g.lights[i].specular; });
    }
    std::vector<double> red, green, blue;
    for (std::size_t s = 0; s < count; ++s) {
        red.push_back(spectrum->weight(s).x);
        green.push_back(spectrum->weight(s).y);
        blue.push_back(spectrum->weight(s).z);
    }
    put(red, [](Group& g) -> Vec& { return g.red; });
    put(green, [](Group& g) -> Vec& { return g.green; });
    put(blue, [](Group& g) -> Vec& { return g.blue; });
}

void SpectralLighting::place_like(const std::vector<lighting::Light<double>>& lights) {
    for (Group& group : groups_)
        for (std::size_t i = 0; i < lights.size(); ++i) {
            group.lights[i].position_eye = lights[i].position_eye;
            group.lights[i].half_dir_eye = lights[i].half_dir_eye;
            group.lights[i].cos_cutoff = lights[i].cos_cutoff;
            group.lights[i].constant_attenuation = lights[i].constant_attenuation;
            group.lights[i].linear_attenuation = lights[i].linear_attenuation;
            group.lights[i].quadratic_attenuation = lights[i].quadratic_attenuation;
        }
}

std::vector<lighting::Material<double>> SpectralLighting::samples_of(const lighting::Material<double>& material,
                                                                     const Material::Reflectances& reflectances) const {
    std::vector<lighting::Material<double>> groups(groups_.size(), material);
    const auto put = [&](Vec rgb, const Spectrum* reflectance, Vec lighting::Material<double>::*property) {
        const std::vector<double> samples =
            reflectance ? spectrum_->of_reflectance(*reflectance) : spectrum_->of_color(rgb);
        for (std::size_t g = 0; g < groups.size(); ++g) groups[g].*property = three(samples, g);
    };
    using M = lighting::Material<double>;
    put(material.emission, nullptr, &M::emission);
    put(material.ambient, reflectances.ambient, &M::ambient);
    put(material.diffuse, reflectances.diffuse, &M::diffuse);
    put(material.specular, reflectances.specular, &M::specular);
    return groups;
}

Vec3<double> SpectralLighting::color(const Group& group, Vec samples) {
    return {dot(group.red, samples), dot(group.green, samples), dot(group.blue, samples)};
}

lighting::MeasuredLit<double> SpectralLighting::light_surface(const LitMaterial& material,
                                                              const lighting::SurfacePoint<double>& surface,
                                                              lighting::LightTerms<double>* breakdown) const {
    lighting::MeasuredLit<double> sum;
    sum.alpha = material.diffuse_alpha;
    std::vector<lighting::LightTerms<double>> terms(breakdown ? groups_[0].lights.size() : 0);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        const Group& g = groups_[i];
        const lighting::MeasuredLit<double> lit = lighting::measured_light<double>(
            g.model, material.samples[i], surface, g.lights, breakdown ? terms.data() : nullptr);
        sum.primary += color(g, lit.primary);
        sum.secondary += color(g, lit.secondary);
        const auto magnitude = [&](Vec weights) { return dot(lighting::magnitudes(weights), lit.magnitude); };
        sum.magnitude += Vec{magnitude(g.red), magnitude(g.green), magnitude(g.blue)};
        for (std::size_t l = 0; l < terms.size(); ++l) {
            lighting::LightTerms<double>& all = breakdown[l];
            if (i == 0) {
                all = terms[l];
                all.ambient = all.diffuse = all.specular = {};
            }
            all.ambient += color(g, terms[l].ambient);
            all.diffuse += color(g, terms[l].diffuse);
            all.specular += color(g, terms[l].specular);
        }
    }
    return sum;
}

void SpectralLighting::light_points(const std::vector<lighting::Points>& groups, const Arithmetic& arithmetic,
                                    lighting::Lit<lighting::Column>& lit) const {
    const std::size_t count = groups.front().size();
    for (Vec3<lighting::Column>* sum : {&lit.primary, &lit.secondary})
        for (lighting::Column* column : {&sum->x, &sum->y, &sum->z}) column->assign(count, 0);
    const auto add = [](Vec3<lighting::Column>& columns, std::size_t i, Vec c) {
        columns.x[i] += c.x;
        columns.y[i] += c.y;
        columns.z[i] += c.z;
    };
    lighting::Lit<lighting::Column> of_group;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        lighting::light_points(groups_[g].model, groups_[g].lights, groups[g], arithmetic, of_group);
        const Vec3<lighting::Each> primary = lighting::each(of_group.primary);
        const Vec3<lighting::Each> secondary = lighting::each(of_group.secondary);
        for (std::size_t i = 0; i < count; ++i) {
            add(lit.primary, i, color(groups_[g], at(primary, i)));
            add(lit.secondary, i, color(groups_[g], at(secondary, i)));
        }
    }
    lit.alpha = of_group.alpha;
}

Vec3<double> SpectralLighting::scene_ambient(const LitMaterial& material) const {
    Vec sum;
    for (std::size_t i = 0; i < groups_.size(); ++i)
        sum += color(groups_[i], lighting::number_or_zero(material.samples[i].ambient * groups_[i].model.ambient));
    return sum;
}

}  // namespace twinlight::reference

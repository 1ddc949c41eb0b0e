#include "render/reference/vertices/draw_lighting.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>

#include "render/lighting_of.h"

namespace twinlight::reference {

namespace {

Vec rgb(const glm::dvec4& color) { return vec3_cast<Vec>(color); }

// 2.14.3: which properties of `face` follow the current colour.
bool tracks(const ColorMaterial& color_material, Face face, Enum property) {
    const Enum other_face = face == Face::kFront ? kGL_BACK : kGL_FRONT;
    if (!color_material.enabled || color_material.face == other_face) return false;
    if (color_material.mode == kGL_AMBIENT_AND_DIFFUSE) return property == kGL_AMBIENT || property == kGL_DIFFUSE;
    return color_material.mode == property;
}

template <class Real>
std::vector<lighting::Light<Real>> lights_of(const LightingState& state, bool lecture_variants) {
    std::vector<lighting::Light<Real>> lights;
    for (const LightSource& source : state.lights)
        if (source.enabled) lights.push_back(lighting_of<Real>(source, lecture_variants));
    return lights;
}

// 2.14.1: the vector from P1 to P2, where P1 has w = 0, is the unit vector of P2 - P1 if P2 has w = 0, too. Otherwise it is that of
// -P1, wherever P2 is: at the origin here, so that nothing of P2 is left.
template <class Real>
void turn_to(lighting::Light<Real>& light, const glm::dvec3& light_eye, const glm::dvec4& position_eye) {
    if (light.directional)
        place(light, vec3_cast<Vec3<Real>>(light_eye - glm::dvec3(position_eye)), Real(0));
    else
        light.position_eye = {};
}

}  // namespace

std::vector<lighting::Light<lighting::Marked>> marked_lights(const Draw& draw, bool lecture_variants,
                                                             const glm::dvec4& position_eye) {
    using lighting::Marked;
    auto lights = lights_of<Marked>(draw.lighting, lecture_variants);
    if (position_eye.w != 0) return lights;
    auto light = lights.begin();
    for (const LightSource& source : draw.lighting.lights) {
        if (!source.enabled) continue;
        turn_to(*light, source.position_eye, position_eye);
        // RULING: the distance is infinite.
        for (Marked* k : {&light->linear_attenuation, &light->quadratic_attenuation})
            if (k->value != 0) *k = ruled(lighting::Ruling::kAtInfinity, *k);
        ++light;
    }
    return lights;
}

lighting::SurfacePoint<double> surface_of(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, Face face) {
    const Vec normal = vec3_cast<Vec>(normal_eye);
    return {lighting::divided(vec3_cast<Vec>(position_eye), position_eye.w), face == Face::kFront ? normal : -normal};
}

DrawLighting::DrawLighting(const Draw& draw, bool lecture_variants)
    : enabled_(draw.lighting.enabled),
      two_side_(draw.lighting.light_model.two_side),
      materials_(draw.materials),
      color_material_(draw.lighting.color_material) {
    const LightModel& light_model = draw.lighting.light_model;
    if (materials_.empty()) materials_.push_back({draw.lighting.front, draw.lighting.back});
    model_.ambient = rgb(light_model.ambient);
    model_.local_viewer = light_model.local_viewer;
    model_.separate_specular = light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    model_.reflection = lecture_variants && light_model.specular == Word::reflection;
    model_.ambient_unattenuated = lecture_variants && light_model.light_ambient == Word::unattenuated;
    lights_ = lights_of<double>(draw.lighting, lecture_variants);
    for (const LightSource& source : draw.lighting.lights) {
        if (!source.enabled) continue;
        positions_eye_.emplace_back(source.position_eye);
    }
    differs_at_infinity_ = !lights_.empty();
    if (!lecture_variants || !light_model.spectrum) return;
    std::vector<LightSource> enabled;
    std::ranges::copy_if(draw.lighting.lights, std::back_inserter(enabled), &LightSource::enabled);
    spectral_.emplace(light_model.spectrum, model_, lights_, enabled);
}

DrawLighting DrawLighting::at(const glm::dvec4& position_eye) const {
    DrawLighting lighting = *this;
    lighting.differs_at_infinity_ = false;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        lighting::Light<double>& light = lighting.lights_[i];
        turn_to(light, positions_eye_[i], position_eye);
        if (light.linear_attenuation != 0 || light.quadratic_attenuation != 0)
            light.constant_attenuation = light.linear_attenuation = light.quadratic_attenuation = 0;  // which gives 0
    }
    if (spectral_) lighting.spectral_->place_like(lighting.lights_);
    return lighting;
}

LitMaterial DrawLighting::material(const StageVertex& v, Face face) const {
    assert(v.material < materials_.size());
    const Materials& both = materials_[v.material];
    const Material& base = face == Face::kFront ? both.front : both.back;
    const auto value = [&](Enum property, const glm::dvec4& own) {
        return tracks(color_material_, face, property) ? v.color : own;
    };
    const glm::dvec4 diffuse = value(kGL_DIFFUSE, base.diffuse);
    LitMaterial material{{.emission = rgb(value(kGL_EMISSION, base.emission)),
                          .ambient = rgb(value(kGL_AMBIENT, base.ambient)),
                          .diffuse = rgb(diffuse),
                          .specular = rgb(value(kGL_SPECULAR, base.specular)),
                          .diffuse_alpha = diffuse.a,
                          .shininess = base.shininess}};
    if (spectral_) {
        const auto own = [&](Enum property, const Spectrum* reflectance) {
            return tracks(color_material_, face, property) ? nullptr : reflectance;
        };
        material.samples = spectral_->samples_of(material, {.ambient = own(kGL_AMBIENT, base.reflectances.ambient),
                                                            .diffuse = own(kGL_DIFFUSE, base.reflectances.diffuse),
                                                            .specular = own(kGL_SPECULAR, base.reflectances.specular)});
    }
    return material;
}

lighting::MeasuredLit<double> DrawLighting::light_surface(const LitMaterial& material,
                                                          const lighting::SurfacePoint<double>& surface,
                                                          lighting::LightTerms<double>* breakdown) const {
    if (spectral_) return spectral_->light_surface(material, surface, breakdown);
    return lighting::measured_light<double>(model_, material, surface, lights_, breakdown);
}

Vec DrawLighting::scene_ambient(const LitMaterial& material) const {
    return spectral_ ? spectral_->scene_ambient(material) : lighting::number_or_zero(material.ambient * model_.ambient);
}

bool DrawLighting::has_one_material(Face face) const {
    const Enum other_face = face == Face::kFront ? kGL_BACK : kGL_FRONT;
    return !has_vertex_materials() && (!color_material_.enabled || color_material_.face == other_face);
}

Colors DrawLighting::lit(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, const LitMaterial& material,
                         Face face) const {
    if (differs_at(position_eye)) return at(position_eye).lit(position_eye, normal_eye, material, face);
    const lighting::SurfacePoint<double> surface = surface_of(position_eye, normal_eye, face);
    const lighting::MeasuredLit<double> lit = light_surface(material, surface);
    return {.primary = glm::dvec4(vec3_cast<glm::dvec3>(lit.primary), lit.alpha),
            .secondary = glm::dvec4(vec3_cast<glm::dvec3>(lit.secondary), 1),
            .magnitude = glm::dvec4(vec3_cast<glm::dvec3>(lit.magnitude), std::abs(lit.alpha))};
}

std::optional<std::array<Colors, 2>> DrawLighting::beside_cones(const glm::dvec4& position_eye,
                                                                const glm::dvec3& normal_eye,
                                                                const LitMaterial& material, Face face) const {
    if (position_eye.w == 0) return std::nullopt;
    const Vec place = surface_of(position_eye, normal_eye, face).position_eye;
    // How far the cosine may be off: interpolated places and directions are some roundings of floats away.
    const auto rounding_beside = [&](const lighting::Light<double>& light) {
        constexpr double kRoundings = 16 * 0x1p-24;
        if (!light.is_spot || light.has_smooth_cone) return 0.0;
        const auto [vp_dir, d] = lighting::toward_light(light, place);
        const double size = light.directional ? 0 : length(place) + length(light.position_eye);
        const double rounding = kRoundings * (d > 0 ? 1 + size / d : 1);
        return std::abs(lighting::cosine_to_axis(light, vp_dir) - light.cos_cutoff) <= rounding ? rounding : 0;
    };
    if (std::ranges::none_of(lights_, [&](const auto& light) { return rounding_beside(light) > 0; }))
        return std::nullopt;
    DrawLighting inside = *this, outside = *this;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        inside.lights_[i].cos_cutoff -= 2 * rounding_beside(lights_[i]);
        outside.lights_[i].cos_cutoff += 2 * rounding_beside(lights_[i]);
    }
    if (spectral_)
        for (DrawLighting* lighting : {&inside, &outside}) lighting->spectral_->place_like(lighting->lights_);
    return std::array{inside.lit(position_eye, normal_eye, material, face),
                      outside.lit(position_eye, normal_eye, material, face)};
}

Colors DrawLighting::colors(const StageVertex& v, Face face) const {
    if (!enabled_) return {.primary = v.color, .magnitude = glm::abs(v.color)};
    return lit(v.position_eye, v.normal_eye, material(v, face), face);
}

PointBatch::PointBatch(const DrawLighting& lighting, Normals normals) : lighting_(lighting), normals_(normals) {
    lighting::Points none;
    none.makes_unit_normals = normals == Normals::kMadeUnit;
    for (Side& side : sides_) side.points.assign(lighting.spectral_ ? lighting.spectral_->group_count() : 1, none);
}

void PointBatch::add(const LitMaterial& material, Side& side) const {
    for (std::size_t g = 0; g < side.points.size(); ++g)
        side.points[g].add(lighting_.spectral_ ? material.samples[g] : material);
}

void PointBatch::add(const lighting::SurfacePoint<double>& point, Side& side) {
    for (lighting::Points& points : side.points) points.add(point);
    side.places.push_back(count_++);
}

void PointBatch::clear() {
    for (Side& side : sides_) {
        for (lighting::Points& points : side.points) points.clear();
        side.places.clear();
    }
    at_infinity_.clear();
    count_ = 0;
}

void PointBatch::light(const Side& side, const Arithmetic& arithmetic) {
    if (lighting_.spectral_)
        lighting_.spectral_->light_points(side.points, arithmetic, lit_);
    else
        lighting::light_points(lighting_.model(), lighting_.lights(), side.points.front(), arithmetic, lit_);
}

LitMaterial mixed(const glm::dvec3& weights, const std::array<LitMaterial, 3>& materials) {
    const auto add = [](lighting::Material<double>& sum, double weight, const lighting::Material<double>& m) {
        sum.emission += weight * m.emission;
        sum.ambient += weight * m.ambient;
        sum.diffuse += weight * m.diffuse;
        sum.specular += weight * m.specular;
        sum.diffuse_alpha += weight * m.diffuse_alpha;
        sum.shininess += weight * m.shininess;
    };
    const lighting::Material<double> nothing{.diffuse_alpha = 0};
    LitMaterial sum{nothing, std::vector(materials[0].samples.size(), nothing)};
    for (int i = 0; i < 3; ++i) {
        const LitMaterial& m = materials[static_cast<std::size_t>(i)];
        add(sum, weights[i], m);
        for (std::size_t g = 0; g < sum.samples.size(); ++g) add(sum.samples[g], weights[i], m.samples[g]);
    }
    return sum;
}

glm::dvec4 clamped(const glm::dvec4& color) {
    using lighting::clamp01;
    return {clamp01(color.r), clamp01(color.g), clamp01(color.b), clamp01(color.a)};
}

}  // namespace twinlight::reference

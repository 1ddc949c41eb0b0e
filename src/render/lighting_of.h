// The equation's lights from GL's state (2.14.1, table 2.10): cosines and unit vectors are computed once, here.
#pragma once

#include "base/math/vec3.h"
#include "lighting/light_setup.h"
#include "scene/frame/frame.h"

namespace twinlight {

// `lecture_variants`: with the lecture's smooth cone, if the light has one.
template <class Real = double>
lighting::Light<Real> lighting_of(const LightSource& source, bool lecture_variants = false) {
    using Vec = Vec3<Real>;
    lighting::Light<Real> light;
    light.ambient = vec3_cast<Vec>(source.ambient);
    light.diffuse = vec3_cast<Vec>(source.diffuse);
    light.specular = vec3_cast<Vec>(source.specular);
    place(light, vec3_cast<Vec>(source.position_eye), Real(source.position_eye.w));
    aim(light, vec3_cast<Vec>(source.spot_direction_eye), source.spot_cutoff_deg);
    light.spot_exponent = source.spot_exponent;
    light.constant_attenuation = source.constant_attenuation;
    light.linear_attenuation = source.linear_attenuation;
    light.quadratic_attenuation = source.quadratic_attenuation;
    if (lecture_variants && source.smooth_cone)
        soften(light, source.smooth_cone->inner_deg, source.smooth_cone->outer_deg);
    return light;
}

// How a light arrives at a point in eye coordinates.
struct Arrival {
    glm::dvec3 to_light_dir;           // VP; 0 if the light is there
    double attenuation = 1, spot = 1;  // att_i, spot_i

    double reach() const { return attenuation * spot; }
};
inline Arrival arrival_at(const glm::dvec3& point_eye, const lighting::Light<double>& light) {
    const auto [dir, distance] = lighting::toward_light(light, vec3_cast<Vec3<double>>(point_eye));
    return {vec3_cast<glm::dvec3>(dir), lighting::attenuation(light, distance), lighting::spot(light, dir)};
}
// For a single point: the conversion costs more than the rest.
inline Arrival arrival_at(const glm::dvec3& point_eye, const LightSource& source) {
    return arrival_at(point_eye, lighting_of(source));
}

}  // namespace twinlight

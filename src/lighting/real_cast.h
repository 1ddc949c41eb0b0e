// Converts the equation's structs to another number type.
#pragma once

#include "lighting/equation.h"

namespace twinlight::lighting {

template <class To, class From>
Material<To> real_cast(const Material<From>& m) {
    return {.emission = vec3_cast<Vec3<To>>(m.emission),
            .ambient = vec3_cast<Vec3<To>>(m.ambient),
            .diffuse = vec3_cast<Vec3<To>>(m.diffuse),
            .specular = vec3_cast<Vec3<To>>(m.specular),
            .diffuse_alpha = static_cast<To>(m.diffuse_alpha),
            .shininess = static_cast<To>(m.shininess)};
}
template <class To, class From>
Model<To> real_cast(const Model<From>& m) {
    return {.ambient = vec3_cast<Vec3<To>>(m.ambient),
            .local_viewer = m.local_viewer,
            .separate_specular = m.separate_specular,
            .reflection = m.reflection,
            .ambient_unattenuated = m.ambient_unattenuated};
}
template <class To, class From>
Light<To> real_cast(const Light<From>& l) {
    return {.ambient = vec3_cast<Vec3<To>>(l.ambient),
            .diffuse = vec3_cast<Vec3<To>>(l.diffuse),
            .specular = vec3_cast<Vec3<To>>(l.specular),
            .has_ambient = l.has_ambient,
            .has_specular = l.has_specular,
            .position_eye = vec3_cast<Vec3<To>>(l.position_eye),
            .directional = l.directional,
            .half_dir_eye = vec3_cast<Vec3<To>>(l.half_dir_eye),
            .spot_dir_eye = vec3_cast<Vec3<To>>(l.spot_dir_eye),
            .spot_exponent = static_cast<To>(l.spot_exponent),
            .is_spot = l.is_spot,
            .cos_cutoff = static_cast<To>(l.cos_cutoff),
            .constant_attenuation = static_cast<To>(l.constant_attenuation),
            .linear_attenuation = static_cast<To>(l.linear_attenuation),
            .quadratic_attenuation = static_cast<To>(l.quadratic_attenuation),
            .has_smooth_cone = l.has_smooth_cone,
            .cos_inner = static_cast<To>(l.cos_inner),
            .cos_outer = static_cast<To>(l.cos_outer)};
}

}  // namespace twinlight::lighting

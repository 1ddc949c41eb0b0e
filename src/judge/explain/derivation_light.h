// One light at a derived point: its state, its terms and its angles.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "judge/explain/derivation.h"

namespace twinlight::explain {

inline double length_of(const reference::Vec& v) { return lighting::unit_and_length(v).length; }

// The angle of a cosine that is multiplied by the length of a vector; 90 degrees if the length is 0.
inline double angle_deg(double cosine, double length) {
    if (!(length > 0)) return 90;
    return std::acos(std::clamp(cosine / length, -1.0, 1.0)) * 180 / std::numbers::pi;
}

inline reference::Vec rgb_of(const glm::dvec4& c) { return vec3_cast<reference::Vec>(c); }
inline reference::Vec clamped_color(const reference::Vec& c) {
    return {lighting::clamp01(c.x), lighting::clamp01(c.y), lighting::clamp01(c.z)};
}

struct LightAt {
    // The light at.lights[i].
    LightAt(const Derivation& at, std::size_t i)
        : number(at.lights[i]),
          source(at.draw.lighting.lights[static_cast<std::size_t>(number)]),
          terms(at.point.terms[i]),
          geometry(at.point.geometry[i]) {
        if (source.typed < at.frame.typed_lights.size()) typed = &at.frame.typed_lights[source.typed];
        has_smooth_cone = at.lecture_variants && source.smooth_cone;
        const double n = length_of(at.point.surface.normal_eye);
        normal_to_light_deg = angle_deg(geometry.cosine_to_light, n);
        highlight_deg = angle_deg(geometry.cosine_highlight, at.has_reflection() ? length_of(geometry.half_dir) : n);
        axis_deg = angle_deg(geometry.cosine_to_axis, 1);
    }

    bool directional() const { return source.is_directional(); }
    bool is_spot() const { return source.has_cutoff() || has_smooth_cone; }
    reference::Vec ambient() const { return rgb_of(source.ambient); }
    reference::Vec diffuse() const { return rgb_of(source.diffuse); }
    reference::Vec specular() const { return rgb_of(source.specular); }

    int number;
    const LightSource& source;
    const lighting::LightTerms<double>& terms;
    const lighting::LightGeometry<double>& geometry;
    const TypedLight* typed = nullptr;  // null in a Frame that State did not make
    bool has_smooth_cone = false;       // a variant of the lecture
    double normal_to_light_deg = 0;
    double highlight_deg = 0;  // between n and h, or between r and VP_e
    double axis_deg = 0;       // between the cone's axis and the direction to the vertex
};

}  // namespace twinlight::explain

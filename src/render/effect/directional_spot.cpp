#include "render/effect/directional_spot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace twinlight {

// spot_i of a directional light (2.14.1), the same at every vertex; the lecture's cone takes its place where
// it is set. A cosine at the border belongs to the cone: kRounding is what two roundings to double can take from it.
double directional_spot(const LightSource& light) {
    constexpr double kRounding = 1e-15;
    const auto cos_deg = [](double deg) { return deg == 90 ? 0 : std::cos(deg * std::numbers::pi / 180); };
    const auto unit = [](const glm::dvec3& v) {
        const double biggest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return biggest > 0 ? glm::normalize(v / biggest) : glm::dvec3(0);
    };
    const double cosine = glm::dot(-unit(glm::dvec3(light.position_eye)), unit(light.spot_direction_eye));
    if (light.smooth_cone) {
        const double outer = cos_deg(light.smooth_cone->outer_deg);
        const double span = cos_deg(light.smooth_cone->inner_deg) - outer;
        if (span > 0) return std::clamp((cosine - outer) / span, 0.0, 1.0);
        return cosine >= outer - kRounding ? 1 : 0;  // RULING: equal cones are a step that includes its border
    }
    if (light.spot_cutoff_deg == 180) return 1;
    if (cosine < cos_deg(light.spot_cutoff_deg) - kRounding) return 0;
    return light.spot_exponent == 0 ? 1 : std::pow(std::max(cosine, 0.0), light.spot_exponent);
}

}  // namespace twinlight

// Sets a light's position, spot direction and cone in the form that the equation needs. Not for batches.
#pragma once

#include <cmath>
#include <numbers>

#include "base/math/directions.h"
#include "lighting/equation.h"

namespace twinlight::lighting {

// The cosine of GL_SPOT_CUTOFF, rounded down, because the border is lit (2.14.1). Rounded up, spot() with long double
// would lose the border: its 4 epsilon are smaller than the rounding of a double.
inline double cos_cutoff(double cutoff_deg) {
    if (cutoff_deg == 90) return 0;
    const long double exact = std::cos(cutoff_deg * std::numbers::pi_v<long double> / 180);
    const auto nearest = static_cast<double>(exact);
    return nearest <= exact ? nearest : std::nextafter(nearest, -1.0);
}

// Moves the light to the homogeneous position (position_eye, w); it is directional if w is 0 (2.14.1).
template <class Real>
void place(Light<Real>& light, Vec3<Real> position_eye, Real w) {
    light.directional = w == Real(0);
    light.position_eye = light.directional ? unit(position_eye, Ruling::kLightAtVertex) : divided(position_eye, w);
    if (light.directional)
        light.half_dir_eye = unit(light.position_eye + Vec3<Real>{0, 0, 1}, Ruling::kOppositeHalfVector);
}

// RULING: the cosine of a spot direction of length 0 with every direction is 0.
template <class Real>
void aim(Light<Real>& light, Vec3<Real> spot_direction_eye, double cutoff_deg) {
    light.spot_dir_eye = unit(spot_direction_eye, Ruling::kZeroSpotDirection);
    light.is_spot = cutoff_deg != 180;
    light.cos_cutoff = cos_cutoff(cutoff_deg);
}

// Gives the light the lecture's cone: full light inside inner_deg, none outside outer_deg. Not in GL.
template <class Real>
void soften(Light<Real>& light, double inner_deg, double outer_deg) {
    light.has_smooth_cone = true;
    light.cos_inner = cos_deg(inner_deg);
    light.cos_outer = cos_deg(outer_deg);
}

}  // namespace twinlight::lighting

// Fog (3.10): f blends the fragment's colour with the fog's; alpha does not change.
#pragma once

#include <cmath>

#include "render/reference/textures/interval.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// c = |z_eye|, of homogeneous eye coordinates. RULING: where w is 0 it is infinite, the limit, or 0 if z is 0 too.
template <class Real>
Real fog_distance(Real z, Real w) {
    using std::abs;
    if (w != Real(0)) return abs(z / w);
    constexpr double kFarthest = 1e300;
    return ruled(lighting::Ruling::kAtInfinity, z == Real(0) ? Real(0) : Real(kFarthest));
}

// f, in [0,1], equations 3.24 to 3.26. `distance`: c, or the fog coordinate. The specification allows |z_eye|, used
// here, instead of the distance from the eye. RULING: linear fog with end = start is a step there: no fog before, full fog from there on.
template <class Real>
Real fog_factor(const Fog& fog, Real distance) {
    using lighting::select;
    using std::exp;
    const Real thickness = Real(fog.density) * distance;
    switch (fog.mode) {
        case kGL_LINEAR:
            if (fog.end == fog.start) {
                const Real step = select(distance < Real(fog.end), Real(1), Real(0));
                return ruled(lighting::Ruling::kFogWithoutDepth, step);
            }
            return clamp01((Real(fog.end) - distance) / Real(fog.end - fog.start));
        case kGL_EXP2: return clamp01(exp(-thickness * thickness));
    }
    return clamp01(exp(-thickness));  // GL_EXP
}

template <class Real>
Real blended(Real f, Real fragment, Real fog) {
    return f * fragment + (Real(1) - f) * fog;
}
// f stands once, so the interval is no wider than it has to be.
inline Interval blended(Interval f, Interval fragment, Interval fog) { return fog + f * (fragment - fog); }

// C = f C_r + (1 - f) C_f.
template <class Real>
Channels<Real> fogged(const Fog& fog, Real f, const Channels<Real>& fragment) {
    Channels<Real> result = fragment;
    for (int i = 0; i < 3; ++i) result[i] = blended(f, fragment[i], Real(clamp01(fog.color[i])));
    return result;
}

}  // namespace twinlight::reference

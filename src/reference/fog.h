// Fog (3.10): f blends the fragment's colour with the fog's; alpha stays as it is.
#pragma once

#include "reference/interval.h"
#include "state/frame.h"

namespace twinlight::reference {

// f, in [0,1], equations 3.24 to 3.26. `distance`: c, which is |z_eye| here; the text allows that in the place of the
// distance from the eye.
// RULING: linear fog that ends where it starts is the limit: none before, all fog from there on.
double fog_factor(const Fog& fog, double distance);

// C = f C_r + (1 - f) C_f.
template <class Real>
Channels<Real> fogged(const Fog& fog, Real f, const Channels<Real>& fragment) {
    Channels<Real> result = fragment;
    for (int i = 0; i < 3; ++i) result[i] = f * fragment[i] + (Real(1) - f) * Real(clamp01(fog.color[i]));
    return result;
}

}  // namespace twinlight::reference

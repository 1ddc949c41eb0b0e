// Combines a texel and a fragment's colour: the texture functions (3.8.13, tables 3.21 to 3.23).
//
// In: the fragment's colour (C_f, A_f), the filtered texel (C_s, A_s), the unit's environment. Out: (C_v, A_v) in
// [0,1]. A base internal format has a colour, an alpha or both (table 3.21); the fragment keeps what the format lacks.
// With this rule, five formulas give the tables.
#pragma once

#include "render/reference/interval.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

inline bool has_color(Enum base_format) { return base_format != kGL_ALPHA; }
inline bool has_alpha(Enum base_format) { return base_format != kGL_LUMINANCE && base_format != kGL_RGB; }

// One channel of a colour: C_v from C_f, C_s, A_s and C_c, the environment's colour.
// RULING: DECAL is defined only for RGB and RGBA; with other formats the fragment does not change.
template <class Real>
Real textured_color(Enum env_mode, Enum base_format, Real fragment, Real texel, Real texel_alpha, double env_color) {
    switch (env_mode) {
        case kGL_REPLACE: return texel;
        case kGL_MODULATE: return fragment * texel;
        case kGL_DECAL:
            if (base_format == kGL_RGB) return texel;
            if (base_format == kGL_RGBA) return fragment * (Real(1) - texel_alpha) + texel * texel_alpha;
            return ruled(lighting::Ruling::kDecal, fragment);
        case kGL_BLEND: return fragment * (Real(1) - texel) + Real(env_color) * texel;
        case kGL_ADD: return clamp01(fragment + texel);
    }
    return fragment;
}

// A_v. BLEND and ADD treat the alpha of an intensity texture like a colour.
template <class Real>
Real textured_alpha(Enum env_mode, Enum base_format, Real fragment, Real texel, double env_alpha) {
    const bool as_color = base_format == kGL_INTENSITY;
    switch (env_mode) {
        case kGL_REPLACE: return texel;
        case kGL_DECAL: return fragment;
        case kGL_BLEND: return as_color ? fragment * (Real(1) - texel) + Real(env_alpha) * texel : fragment * texel;
        case kGL_ADD: return as_color ? clamp01(fragment + texel) : fragment * texel;
    }
    return fragment * texel;  // GL_MODULATE
}

template <class Real>
Channels<Real> textured(const TextureUnit& unit, Enum base_format, const Channels<Real>& fragment,
                        const Channels<Real>& texel) {
    Channels<Real> result = fragment;
    if (has_color(base_format))
        for (int i = 0; i < 3; ++i)
            result[i] =
                textured_color(unit.env_mode, base_format, fragment[i], texel[i], texel[3], clamp01(unit.env_color[i]));
    if (has_alpha(base_format))
        result[3] = textured_alpha(unit.env_mode, base_format, fragment[3], texel[3], clamp01(unit.env_color.a));
    return result;
}

}  // namespace twinlight::reference

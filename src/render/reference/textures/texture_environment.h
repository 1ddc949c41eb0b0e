// Combines a texel and a fragment's colour: the texture functions (3.8.13, tables 3.21 to 3.25).
//
// In: the fragment's colour (C_f, A_f), the filtered texel (C_s, A_s), the unit's environment. Out: (C_v, A_v) in
// [0,1]. A base internal format has a colour, an alpha or both (table 3.21); the fragment keeps what the format lacks.
// With this rule, five formulas give the tables.
#pragma once

#include <glm/common.hpp>

#include "render/reference/textures/interval.h"
#include "scene/frame/frame.h"

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

// GL_COMBINE (tables 3.24 and 3.25). `primary`: the fragment's colour before all units; `previous`: after the unit before
// this one. texel_of(n): the texel of unit n, with 0 for what its format lacks, alpha 1.
template <class Real, class TexelOf>
Channels<Real> combined(const TextureUnit& unit, std::size_t number, const Channels<Real>& primary,
                        const Channels<Real>& previous, const TexelOf& texel_of) {
    const Combine& combine = unit.combine;
    const auto source = [&](Enum name) -> Channels<Real> {
        switch (name) {
            case kGL_TEXTURE: return texel_of(number);
            case kGL_CONSTANT: return channels<Real>(glm::clamp(unit.env_color, 0.0, 1.0));
            case kGL_PRIMARY_COLOR: return primary;
            case kGL_PREVIOUS: return previous;
            default: return texel_of(name - kGL_TEXTURE0);
        }
    };
    const auto argument = [&](Enum name, Enum operand) {
        Channels<Real> result = source(name);
        if (operand == kGL_SRC_ALPHA || operand == kGL_ONE_MINUS_SRC_ALPHA) result.fill(Real(result[3]));
        if (operand == kGL_ONE_MINUS_SRC_COLOR || operand == kGL_ONE_MINUS_SRC_ALPHA)
            for (Real& channel : result) channel = Real(1) - channel;
        return result;
    };
    using Arguments = std::array<Channels<Real>, 3>;
    const auto arguments = [&](Enum function, const std::array<Enum, 3>& sources, const std::array<Enum, 3>& operands) {
        Arguments result{};
        for (std::size_t i = 0; i < Combine::arguments_of(function); ++i) result[i] = argument(sources[i], operands[i]);
        return result;
    };
    const auto value = [](Enum function, const Arguments& arg, std::size_t i) -> Real {
        switch (function) {
            case kGL_REPLACE: return arg[0][i];
            case kGL_ADD: return arg[0][i] + arg[1][i];
            case kGL_ADD_SIGNED: return arg[0][i] + arg[1][i] - Real(0.5);
            case kGL_INTERPOLATE: return arg[0][i] * arg[2][i] + arg[1][i] * (Real(1) - arg[2][i]);
            case kGL_SUBTRACT: return arg[0][i] - arg[1][i];
            default: return arg[0][i] * arg[1][i];  // GL_MODULATE
        }
    };
    const auto scaled = [](int scale, Real v) { return clamp01(Real(scale) * v); };

    const Arguments of_rgb = arguments(combine.rgb, combine.rgb_sources, combine.rgb_operands);
    Channels<Real> result{};
    if (combine.rgb == kGL_DOT3_RGB || combine.rgb == kGL_DOT3_RGBA) {
        Real dot(0);
        for (std::size_t i = 0; i < 3; ++i) dot = dot + (of_rgb[0][i] - Real(0.5)) * (of_rgb[1][i] - Real(0.5));
        for (std::size_t i = 0; i < 3; ++i) result[i] = scaled(4 * combine.rgb_scale, dot);
        result[3] = scaled(4 * combine.alpha_scale, dot);
        if (combine.gives_alpha()) return result;
    } else {
        for (std::size_t i = 0; i < 3; ++i) result[i] = scaled(combine.rgb_scale, value(combine.rgb, of_rgb, i));
    }
    result[3] =
        scaled(combine.alpha_scale,
               value(combine.alpha, arguments(combine.alpha, combine.alpha_sources, combine.alpha_operands), 3));
    return result;
}

}  // namespace twinlight::reference

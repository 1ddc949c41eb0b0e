// The per-fragment operations but for the depth test (4.1): scissor, alpha test, blending; and the colour mask (4.2.2).
//
// The colour buffer is that of Twinlight's contexts: red, green, blue and alpha of 8 bits each, as 2.14.9 describes them:
// every write rounds a channel to the nearest k / 255, and what a later fragment reads is that.
#pragma once

#include "render/reference/coverage.h"
#include "render/reference/interval.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

inline constexpr int kColorCodes = 255;

// What the colour buffer holds of a channel.
double quantised(double channel);
glm::dvec4 quantised(const glm::dvec4& color);

// 4.1.2: of `rect`, the pixels that are drawn to.
PixelRect scissored(const Scissor& scissor, const PixelRect& rect);

// 4.1.4: fragment's and reference value are compared as the colour buffer would hold them.
bool alpha_passes(const FragmentState& state, double alpha);

// Whether the colour that is written does not depend on what it is written over, and whether there is none to write.
bool overwrites_color(const FragmentState& state);
bool writes_color(const FragmentState& state);

// Table 4.2: one channel of S or D. `i`: which channel, 3 for alpha. RULING: GL_SRC_ALPHA_SATURATE, which table 4.2 has
// of the source alone, is the same of the destination.
template <class Real>
Real blend_factor(Enum factor, std::size_t i, const Channels<Real>& source, const Channels<Real>& destination,
                  const Channels<Real>& constant) {
    const auto one_minus = [](Real value) { return Real(1) - value; };
    switch (factor) {
        case kGL_ZERO: return Real(0);
        case kGL_ONE: return Real(1);
        case kGL_SRC_COLOR: return source[i];
        case kGL_ONE_MINUS_SRC_COLOR: return one_minus(source[i]);
        case kGL_DST_COLOR: return destination[i];
        case kGL_ONE_MINUS_DST_COLOR: return one_minus(destination[i]);
        case kGL_SRC_ALPHA: return source[3];
        case kGL_ONE_MINUS_SRC_ALPHA: return one_minus(source[3]);
        case kGL_DST_ALPHA: return destination[3];
        case kGL_ONE_MINUS_DST_ALPHA: return one_minus(destination[3]);
        case kGL_CONSTANT_COLOR: return constant[i];
        case kGL_ONE_MINUS_CONSTANT_COLOR: return one_minus(constant[i]);
        case kGL_CONSTANT_ALPHA: return constant[3];
        case kGL_ONE_MINUS_CONSTANT_ALPHA: return one_minus(constant[3]);
        case kGL_SRC_ALPHA_SATURATE: return i == 3 ? Real(1) : smaller(source[3], one_minus(destination[3]));
    }
    return Real(1);
}

// Table 4.1's equation for a channel.
inline Enum blend_equation(const FragmentState& state, std::size_t i) {
    return i == 3 ? state.blend_equation_alpha : state.blend_equation;
}

// 4.1.8, table 4.1: C_s S + C_d D of one channel, or what else the equation says, before it is clamped. `constant`: the
// blend colour, in [0,1].
template <class Real>
Real blended(const FragmentState& state, std::size_t i, const Channels<Real>& source, const Channels<Real>& destination,
             const Channels<Real>& constant) {
    const Enum s = i == 3 ? state.blend_src_alpha : state.blend_src,
               d = i == 3 ? state.blend_dst_alpha : state.blend_dst;
    const Enum equation = blend_equation(state, i);
    if (equation == kGL_MIN) return smaller(source[i], destination[i]);  // without the factors
    if (equation == kGL_MAX) return larger(source[i], destination[i]);
    const Real from_source = source[i] * blend_factor(s, i, source, destination, constant),
               from_destination = destination[i] * blend_factor(d, i, source, destination, constant);
    if (equation == kGL_FUNC_SUBTRACT) return from_source - from_destination;
    if (equation == kGL_FUNC_REVERSE_SUBTRACT) return from_destination - from_source;
    return from_source + from_destination;
}

}  // namespace twinlight::reference

// The per-fragment operations (4.1): scissor, alpha test, stencil test, depth test, blending; accumulation (4.2.4); and the colour mask (4.2.2). They work
// on numbers, or on intervals of all values that correct implementations may have.
//
// The colour buffer is that of Twinlight's contexts: 8 bits each for red, green, blue and alpha (2.14.9). Every write
// rounds a channel to the nearest k / 255, and later fragments read the rounded value.
#pragma once

#include "render/reference/geometry/coverage.h"
#include "render/reference/textures/comparison.h"
#include "render/reference/textures/interval.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// ---- Which fragments are drawn ----

// 3.4.2: whether a stippled line has a fragment at the pixel: its count is within `doubt` of `count`.
Outcome stipple_outcome(const LineStipple& stipple, int count, int doubt);

// 4.1.2: the part of `rect` inside the scissor.
PixelRect scissored(const Scissor& scissor, const PixelRect& rect);

// 4.1.4: compares the fragment's alpha and the reference value with at least as many bits as the colour buffer has.
Outcome alpha_outcome(const FragmentState& state, double alpha);
Outcome alpha_outcome(const FragmentState& state, const Interval& alpha);

// 4.1.5: the stencil test, for a stored value.
bool passes_stencil(const StencilFace& face, int stored);
// The value after one of the face's operations: 4.1.5, through the mask of 4.2.2.
int stencil_after(const StencilFace& face, Enum operation, int stored);
// The stored value after glClear (4.2.3).
int cleared_stencil(const Clear& clear, int stored);

// ---- Writing colours ----

// A channel as the colour buffer stores it.
double held(double channel);
Interval held(const Interval& channel);

// overwrites_color(): the new colour does not depend on the old one. writes_color(): the colour mask lets something
// through.
bool overwrites_color(const FragmentState& state);
bool writes_color(const FragmentState& state);

// Table 4.2: one channel of S or D. `i`: the channel's number, 3 for alpha. RULING: table 4.2 allows
// GL_SRC_ALPHA_SATURATE only for the source; for the destination it is the same factor.
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

// The blend equation of a channel (table 4.1).
inline Enum blend_equation(const FragmentState& state, std::size_t i) {
    return i == 3 ? state.blend_equation_alpha : state.blend_equation;
}

// 4.1.8, table 4.1: C_s S + C_d D for one channel, or another equation, before clamping. `constant`: the blend colour,
// in [0,1].
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

// The same where the source's alpha is an interval. Both factors have the same alpha, and the sum is linear in it.
inline double blended_over_alpha(const FragmentState& state, std::size_t i, const Channels<double>& source,
                                 const Channels<double>& destination, const Channels<double>& constant) {
    return blended(state, i, source, destination, constant);
}
Interval blended_over_alpha(const FragmentState& state, std::size_t i, const Channels<Interval>& source,
                            const Channels<Interval>& destination, const Channels<Interval>& constant);

// 4.1.10: the codes of the new and the stored colour, combined bit by bit. An interval has the results of all codes in
// both, or everything if these are many.
double combined(Enum logic_op, double source, double stored);
Interval combined(Enum logic_op, const Interval& source, const Interval& stored);

// Blending in an 8-bit buffer: drivers may round the fragment's colour and the blend colour to 8 bits before
// multiplying, and both products before adding. Intervals include the results; numbers are not rounded.
inline double rounded_factor(double channel) { return channel; }
Interval rounded_factor(const Interval& channel);
inline double rounded_products(const FragmentState&, std::size_t, double sum) { return sum; }
Interval rounded_products(const FragmentState& state, std::size_t i, const Interval& sum);

// The colour after a fragment is drawn over `beneath`, a colour as the colour buffer stores it.
template <class Real>
Channels<Real> written(const FragmentState& state, const Channels<Real>& source, const Channels<Real>& beneath) {
    Channels<Real> result = beneath, fragment{}, constant{};
    if (state.blend)
        for (std::size_t i = 0; i < result.size(); ++i) {
            fragment[i] = rounded_factor(source[i]);
            constant[i] = rounded_factor(Real(clamp01(state.blend_color[static_cast<int>(i)])));
        }
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!state.color_mask[i]) continue;
        result[i] = source[i];
        if (state.logic_op)
            result[i] = combined(*state.logic_op, source[i], beneath[i]);
        else if (state.blend)
            result[i] = clamp01(rounded_products(state, i, blended_over_alpha(state, i, fragment, beneath, constant)));
    }
    return result;
}

// 4.2.4: a channel of the accumulation buffer after glAccum, except GL_RETURN. `color`: of the colour buffer, as stored.
// A result outside [-1, 1] is undefined; RULING: it is clamped.
template <class Real>
Real accumulated(const Accumulate& accumulate, const Real& stored, const Real& color) {
    const Real value(accumulate.value);
    switch (accumulate.op) {
        case kGL_ACCUM: return stored + color * value;
        case kGL_LOAD: return color * value;
        case kGL_ADD: return stored + value;
        default: return stored * value;  // GL_MULT
    }
}

// The range of the accumulation buffer, in which drivers have 16 bits or more: each operation may be off by one step.
inline double kept_accumulation(double value) { return std::clamp(value, -1.0, 1.0); }
Interval kept_accumulation(const Interval& value);
// Whether drivers may differ because the value leaves the range.
inline bool leaves_accumulation(double) { return false; }
bool leaves_accumulation(const Interval& value);

}  // namespace twinlight::reference

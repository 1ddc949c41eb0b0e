// Functions for equations over any number type: choices without branches, and arithmetic that stays finite.
//
// Real may be float, double, long double, a batch of SIMD lanes (lanes.h) or a double that records rulings (marked.h).
// The last two define their own select(), abs(), sqrt() and power() or pow(), found by argument-dependent lookup, and
// specialise Limits.
#pragma once

#include <cmath>
#include <limits>

#include "base/math/vec3.h"
#include "lighting/rulings.h"

namespace twinlight::lighting {

template <class Real>
constexpr Real power_of_two(int exponent) {
    Real result(1);
    for (int i = 0; i < exponent; ++i) result *= 2;
    return result;
}

// Specialised for batches, which std::numeric_limits does not know.
template <class Real>
struct Limits {
    static_assert(std::numeric_limits<Real>::is_specialized);
    static constexpr Real largest = std::numeric_limits<Real>::max();
    static constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    // Squares of numbers between small and big neither overflow nor lose digits. scale_up moves smaller numbers into
    // that range, scale_down larger ones.
    static constexpr Real big = power_of_two<Real>(std::numeric_limits<Real>::max_exponent / 2 - 2);
    static constexpr Real small = Real(1) / big;
    static constexpr Real scale_up = power_of_two<Real>(std::numeric_limits<Real>::max_exponent / 4 * 3);
    static constexpr Real scale_down = Real(1) / scale_up;
};

template <class Real>
Real select(bool mask, Real a, Real b) {
    return mask ? a : b;
}

// Returns `value`. Marked numbers (marked.h) also record that it results from `ruling`, in the second form only if
// `where` holds.
template <class Value>
Value ruled(Ruling /*ruling*/, Value value) {
    return value;
}
template <class Mask, class Value>
Value ruled(Ruling /*ruling*/, Mask /*where*/, Value value) {
    return value;
}

template <class Real>
Real larger(Real a, Real b) {
    return select(a > b, a, b);
}

// a . b as 2.14.1 writes it: max(a . b, 0).
template <class Real>
Real positive_dot(Vec3<Real> a, Vec3<Real> b) {
    return larger(dot(a, b), Real(0));
}

// 2.14.6.
template <class Real>
Real clamp01(Real x) {
    return select(x > Real(0), select(x < Real(1), x, Real(1)), Real(0));
}

// Infinity stands for a number beyond the largest one, whose colour 2.14.6 clamps as any other.
//
// NaN contributes 0. It comes from such a number times 0, which is 0; by RULING, also from infinite state, and from sums of such
// numbers with both signs.
template <class Real>
Real number_or_zero(Real x) {
    return select(x == x, x, ruled(Ruling::kNoNumber, Real(0)));
}
template <class Real>
Vec3<Real> number_or_zero(Vec3<Real> c) {
    return {number_or_zero(c.x), number_or_zero(c.y), number_or_zero(c.z)};
}
// The largest number of its sign in place of infinity.
template <class Real>
Real saturated(Real x) {
    const Real largest = Limits<Real>::largest;
    return number_or_zero(select(x > largest, largest, select(x < -largest, -largest, x)));
}
template <class Real>
Vec3<Real> saturated(Vec3<Real> c) {
    return {saturated(c.x), saturated(c.y), saturated(c.z)};
}

// RULING: a direction's components that are NaN or infinite are 0.
template <class Real>
Real finite_or_zero(Real x) {
    using std::abs;
    return select(abs(x) <= Limits<Real>::largest, x, ruled(Ruling::kNoNumber, Real(0)));
}
template <class Real>
Vec3<Real> finite_or_zero(Vec3<Real> c) {
    return {finite_or_zero(c.x), finite_or_zero(c.y), finite_or_zero(c.z)};
}

template <class Real>
Vec3<Real> magnitudes(Vec3<Real> c) {
    using std::abs;
    return {abs(c.x), abs(c.y), abs(c.z)};
}

// 2.1.1: 0^0 = 1.
template <class Real>
Real power(Real base, Real exponent) {
    using std::pow;
    return select(exponent == Real(0), Real(1), pow(base, exponent));
}

// A safe divisor: x, or 1 if x is not positive.
template <class Real>
Real positive_or_one(Real x) {
    return select(x > Real(0), x, Real(1));
}

// a / length; by `ruling`, a itself if the length is 0.
template <class Real>
Real over_length(Real a, Real length, Ruling ruling) {
    return ruled(ruling, length <= Real(0), a / positive_or_one(length));
}

// 1 / x; by `ruling`, 0 if x is not positive.
template <class Real>
Real inverse_or_zero(Real x, Ruling ruling) {
    return select(x > Real(0), Real(1) / x, ruled(ruling, Real(0)));
}

template <class Real>
struct UnitAndLength {
    Vec3<Real> dir;
    Real length;
};

// v / |v| and |v|. RULING: the direction of the zero vector, or of one with an infinite component, is 0.
// If squares would overflow or underflow, v is first scaled by a power of two, which is exact. Where the squares of
// floats would fail, as they do in shaders and drivers, the result is marked with kSquares.
template <class Real>
UnitAndLength<Real> unit_and_length(Vec3<Real> v) {
    using L = Limits<Real>;
    const Vec3<Real> a = magnitudes(v);
    const Real biggest = larger(larger(a.x, a.y), a.z);
    const Real scale = select(biggest > L::big, L::scale_down, select(biggest < L::small, L::scale_up, Real(1)));
    const Vec3<Real> scaled = v * scale;
    const Real scaled_length = length(scaled);
    const Real inverse = Real(1) / positive_or_one(scaled_length);
    const Real full_length = scaled_length / scale;
    const Vec3<Real> dir =
        ruled(Ruling::kSquares, biggest > Real(Limits<float>::big), finite_or_zero(scaled * inverse));
    return {ruled(Ruling::kSquares, positive_or_one(biggest) < Real(Limits<float>::small), dir),
            select(full_length <= L::largest, full_length, L::largest)};
}

// dir, which results from `ruling` if it is 0.
template <class Real>
Vec3<Real> ruled_zero(Ruling ruling, Vec3<Real> dir) {
    return ruled(ruling, dot(dir, dir) <= Real(0), dir);
}

template <class Real>
Vec3<Real> unit(Vec3<Real> v) {
    return unit_and_length(v).dir;
}
template <class Real>
Vec3<Real> unit(Vec3<Real> v, Ruling where_zero) {
    return ruled_zero(where_zero, unit(v));
}

// (v, w) divided by w. A point at infinity (w = 0) becomes a point very far away in the same direction, from which all
// vectors to other points have the direction that 2.14.1 requires; so does a quotient whose square overflows. RULING:
// its distance is the limit as w goes to 0. Not for batches.
template <class Real>
Vec3<Real> divided(Vec3<Real> v, Real w) {
    const Vec3<Real> quotient = v / w, size = magnitudes(quotient);
    constexpr Real kFar = Limits<Real>::big;
    if (size.x <= kFar && size.y <= kFar && size.z <= kFar) return quotient;
    return unit(v) * (w < 0 ? -kFar : kFar);
}

}  // namespace twinlight::lighting

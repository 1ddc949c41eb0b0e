// What lanes give for arrays of numbers. lanes_test.cpp computes the same with plain numbers and compares. lanes.h and
// points_kernel.h need each of these properties; if a version of xsimd lacks one, the test names it.
//
// This is compiled for wide instructions (lane_results_avx2.cpp, ...), so it must contain only templates over lanes.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "lighting/points_kernel.h"

namespace twinlight::lighting {

struct LaneArrays {
    const double *a, *b, *c;
    std::size_t count;  // a multiple of kMostLanesOfAny
    double* results;    // `count` results of each property, one property after the other
};
inline constexpr std::size_t kMostLanesOfAny = 16;

struct LaneCounts {
    std::size_t lanes, properties;
    bool has_fused;  // whether the instruction set has products and sums with a single rounding
};
LaneCounts double_lanes_avx2(const LaneArrays& arrays);
LaneCounts float_lanes_avx2(const LaneArrays& arrays);
LaneCounts double_lanes_avx512(const LaneArrays& arrays);
LaneCounts float_lanes_avx512(const LaneArrays& arrays);

template <class Real>
inline constexpr bool kIsPlainNumber = std::is_floating_point_v<Real>;

// Calls visit(name, value) for each value that must be the same for lanes and plain numbers, in every bit; any two NaNs
// are the same. It calls visit(name, value, most) if values may differ by `most` units in the last place.
template <class Real, class Visit>
[[gnu::always_inline]] inline void for_each_guarded_property(Real a, Real b, Real c, Visit&& visit) {
    using std::abs, std::sqrt;
    const Real one(1), zero(0);
    visit("load and store", a);
    visit("a + b", a + b);
    visit("a - b", a - b);
    visit("a * b", a * b);
    visit("a / b", a / b);
    visit("-a", -a);
    visit("a < b", select(a < b, one, zero));
    visit("a <= b", select(a <= b, one, zero));
    visit("a > b", select(a > b, one, zero));
    visit("a >= b", select(a >= b, one, zero));
    visit("a == b", select(a == b, one, zero));
    visit("select(a < b, b, c)", select(a < b, b, c));
    visit("select(a >= b, b, c)", select(a >= b, b, c));
    visit("abs(a)", abs(a));
    visit("sqrt(a)", sqrt(a));
    visit("larger(a, b) with guards", larger(a, b));
    visit("clamp01(a)", clamp01(a));
    visit("finite_or_zero(a) with guards", finite_or_zero(a));
    visit("positive_or_one(a) with guards", positive_or_one(a));
    visit("inverse_or_zero(a) with guards", inverse_or_zero(a, Ruling::kAttenuation));
    const UnitAndLength<Real> unit = unit_and_length(Vec3<Real>{a, b, c});
    visit("x of unit(a, b, c) with guards", unit.dir.x);
    visit("length(a, b, c) with guards", unit.length);
    visit("power(abs(a), b)", power(abs(a), b), 4);
}

// Without guards, NaN and infinity must survive, so that the work is repeated with guards. For plain numbers, these
// functions say what lanes.h promises.
template <class Real>
[[gnu::always_inline]] inline Real larger_or_nan(Real a, Real b) {
    if constexpr (kIsPlainNumber<Real>)
        return b > a ? b : a;
    else
        return larger(a, b);
}
template <class Real>
[[gnu::always_inline]] inline UnitAndLength<Real> unit_or_nan(Vec3<Real> v) {
    if constexpr (kIsPlainNumber<Real>) {
        const Real square = dot(v, v), length = std::sqrt(square);
        constexpr Real kLeast = 4 * Limits<Real>::small, kMost = Limits<Real>::big / 4;
        const bool in_range = square > kLeast * kLeast && square < kMost * kMost;
        return {v * (in_range ? 1 / length : std::numeric_limits<Real>::quiet_NaN()), length};
    } else {
        return unit_and_length(v);
    }
}
// a^5; a method for lanes takes one exponent for all of them.
template <PowerBy kBy, class Real>
[[gnu::always_inline]] inline Real fifth_power(Real a) {
    if constexpr (!kIsPlainNumber<Real>)
        return Real(power_of<kBy>(a.batch, typename Real::Batch(5)));
    else if constexpr (kBy == PowerBy::kTable)
        return abs(a) <= Limits<Real>::largest ? Real(1) : a;  // only whether it is finite counts
    else
        return a * a * a * a * a;
}
template <class Real>
[[gnu::always_inline]] inline Real fused_sum(Real a, Real b, Real c) {
    if constexpr (kIsPlainNumber<Real>)
        return std::fma(a, b, c);
    else
        return Real(FusedProduct<typename Real::Batch::arch_type>::sum(a.batch, b.batch, c.batch));
}
template <class Real>
[[gnu::always_inline]] inline Real fused_difference(Real a, Real b, Real c) {
    if constexpr (kIsPlainNumber<Real>)
        return std::fma(a, b, -c);
    else
        return Real(FusedProduct<typename Real::Batch::arch_type>::difference(a.batch, b.batch, c.batch));
}

template <bool kHasFused, class Real, class Visit>
[[gnu::always_inline]] inline void for_each_unguarded_property(Real a, Real b, Real c, Visit&& visit) {
    using std::abs;
    const Real one(1), zero(0), largest(Limits<Real>::largest);
    visit("larger(a, b) without guards", larger_or_nan(a, b));
    const UnitAndLength<Real> unit = unit_or_nan(Vec3<Real>{a, b, c});
    visit("x of unit(a, b, c) without guards", unit.dir.x);
    visit("length(a, b, c) without guards", unit.length);
    visit("whether a^5 by rounded products is finite",
          select(abs(fifth_power<PowerBy::kRoundedProducts>(a)) <= largest, one, zero));
    visit("whether a^5 by a table is finite", select(abs(fifth_power<PowerBy::kTable>(abs(a))) <= largest, one, zero));
    if constexpr (kHasFused) {
        visit("a b + c with one rounding", fused_sum(a, b, c));
        visit("a b - c with one rounding", fused_difference(a, b, c));
        visit("whether a^5 by exact products is finite",
              select(abs(fifth_power<PowerBy::kExactProducts>(a)) <= largest, one, zero));
    }
}

// The last property is whether all lanes of the batch are finite.
template <class Scalar, class Arch>
LaneCounts lane_results(const LaneArrays& arrays) {
    using Guarded = Lanes<Scalar, Arch, Range::kAny, PowerBy::kLibrary>;
    using Unguarded = Lanes<Scalar, Arch, Range::kPlain, PowerBy::kLibrary>;
    std::size_t property = 0;
    for (std::size_t first = 0; first < arrays.count; first += kPointsIn<Guarded>) {
        property = 0;
        const auto keep = [&](const char* /*name*/, auto lanes, int /*most*/ = 0) {
            store(lanes, arrays.results + property++ * arrays.count, first);
        };
        for_each_guarded_property(load<Guarded>(arrays.a, first), load<Guarded>(arrays.b, first),
                                  load<Guarded>(arrays.c, first), keep);
        const auto a = load<Unguarded>(arrays.a, first), b = load<Unguarded>(arrays.b, first),
                   c = load<Unguarded>(arrays.c, first);
        for_each_unguarded_property<FusedProduct<Arch>::kAvailable>(a, b, c, keep);
        Lit<Unguarded> lit;
        lit.primary.x = a;
        keep("whether all lanes are finite", Unguarded(Scalar(is_finite(lit) ? 1 : 0)));
    }
    return {kPointsIn<Guarded>, property, FusedProduct<Arch>::kAvailable};
}

}  // namespace twinlight::lighting

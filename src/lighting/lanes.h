// Lanes: a number type that holds several doubles or floats and computes them with one instruction, for the templates
// of equation.h. Each lane follows IEEE arithmetic without contraction, so only powers may round differently from
// scalar ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <xsimd/xsimd.hpp>

#include "lighting/lane_powers.h"
#include "lighting/real.h"

namespace twinlight::lighting {

enum class Range : std::uint8_t {
    kAny,    // the rulings of real.h hold
    kPlain,  // no guards: if one is needed, the result is NaN or infinite, and the caller repeats the work with kAny
};

// a > b ? a : b in each lane, so b if one of them is NaN. This is what the processor's instruction computes. It is not
// xsimd's max(): which operand that returns for NaN depends on its version.
#if defined(__AVX512F__)
[[gnu::always_inline]] inline __m512d larger_or_second(__m512d a, __m512d b) { return _mm512_max_pd(a, b); }
[[gnu::always_inline]] inline __m512 larger_or_second(__m512 a, __m512 b) { return _mm512_max_ps(a, b); }
#elif defined(__AVX__)
[[gnu::always_inline]] inline __m256d larger_or_second(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
[[gnu::always_inline]] inline __m256 larger_or_second(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
#elif defined(__x86_64__)
[[gnu::always_inline]] inline __m128d larger_or_second(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
[[gnu::always_inline]] inline __m128 larger_or_second(__m128 a, __m128 b) { return _mm_max_ps(a, b); }
#else
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> larger_or_second(xsimd::batch<Scalar, Arch> a, xsimd::batch<Scalar, Arch> b) {
    return xsimd::select(a > b, a, b);
}
#endif

// Scalar: float or double. Arch: the xsimd instruction set that the including file is compiled for.
template <class Scalar, class Arch, Range kRange, PowerBy kPower>
struct Lanes {
    using Batch = xsimd::batch<Scalar, Arch>;
    using Mask = xsimd::batch_bool<Scalar, Arch>;
    static constexpr std::size_t kCount = Batch::size;

    Lanes() : batch(Scalar(0)) {}
    Lanes(Scalar all) : batch(all) {}
    explicit Lanes(Batch lanes) : batch(lanes) {}
    // Copied as one batch. The default copy is slow with gcc 12, which copies the bytes in pieces.
    Lanes(const Lanes& other) : batch(other.batch) {}
    Lanes& operator=(const Lanes& other) {
        batch = other.batch;
        return *this;
    }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.batch + b.batch); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.batch - b.batch); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.batch * b.batch); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.batch / b.batch); }
    // xsimd's own minus gives 0 for 0 in some instruction sets; this gives -0.
    friend Lanes operator-(Lanes a) { return Lanes(Batch(Scalar(-0.0)) - a.batch); }
    friend Mask operator<(Lanes a, Lanes b) { return a.batch < b.batch; }
    friend Mask operator<=(Lanes a, Lanes b) { return a.batch <= b.batch; }
    friend Mask operator>(Lanes a, Lanes b) { return a.batch > b.batch; }
    friend Mask operator>=(Lanes a, Lanes b) { return a.batch >= b.batch; }
    friend Mask operator==(Lanes a, Lanes b) { return a.batch == b.batch; }

    friend Lanes select(Mask mask, Lanes a, Lanes b) { return Lanes(xsimd::select(mask, a.batch, b.batch)); }
    friend Lanes abs(Lanes a) { return Lanes(xsimd::abs(a.batch)); }
    friend Lanes sqrt(Lanes a) { return Lanes(xsimd::sqrt(a.batch)); }
    friend Lanes power(Lanes base, Lanes exponent) { return Lanes(power_of<kPower>(base.batch, exponent.batch)); }

    // With guards: as in real.h, where NaN in `a` is never the larger value. Without: NaN in `a` must survive, so the
    // operands are swapped.
    friend Lanes larger(Lanes a, Lanes b) {
        if constexpr (kRange == Range::kPlain) std::swap(a, b);
        return Lanes(Batch(larger_or_second(a.batch, b.batch)));
    }

    Batch batch;
};

template <class Scalar, class Arch, Range kRange, PowerBy kPower>
struct Limits<Lanes<Scalar, Arch, kRange, kPower>> : Limits<Scalar> {};

template <class Scalar, class Arch, PowerBy kPower>
Lanes<Scalar, Arch, Range::kPlain, kPower> finite_or_zero(Lanes<Scalar, Arch, Range::kPlain, kPower> x) {
    return x;
}
template <class Scalar, class Arch, PowerBy kPower>
Lanes<Scalar, Arch, Range::kPlain, kPower> number_or_zero(Lanes<Scalar, Arch, Range::kPlain, kPower> x) {
    return x;
}
template <class Scalar, class Arch, PowerBy kPower>
Lanes<Scalar, Arch, Range::kPlain, kPower> saturated(Lanes<Scalar, Arch, Range::kPlain, kPower> x) {
    return x;
}

// No guard: a division by 0 gives NaN or infinity. It reaches the result unless a select() discards it, and that would
// discard the guarded value too. Negative values need no guard: larger(x, 0) has already made them 0.
template <class Scalar, class Arch, PowerBy kPower>
Lanes<Scalar, Arch, Range::kPlain, kPower> positive_or_one(Lanes<Scalar, Arch, Range::kPlain, kPower> x) {
    return x;
}
// x must not be negative; 0 gives infinity.
template <class Scalar, class Arch, PowerBy kPower>
Lanes<Scalar, Arch, Range::kPlain, kPower> inverse_or_zero(Lanes<Scalar, Arch, Range::kPlain, kPower> x,
                                                           Ruling /*ruling*/) {
    return Lanes<Scalar, Arch, Range::kPlain, kPower>(Scalar(1)) / x;
}

// The same results as in real.h for lengths whose squares neither overflow nor underflow; NaN for others.
template <class Scalar, class Arch, PowerBy kPower>
UnitAndLength<Lanes<Scalar, Arch, Range::kPlain, kPower>> unit_and_length(
    Vec3<Lanes<Scalar, Arch, Range::kPlain, kPower>> v) {
    using Real = Lanes<Scalar, Arch, Range::kPlain, kPower>;
    using L = Limits<Scalar>;
    const Real square = dot(v, v), length = sqrt(square);
    const auto in_range = (square.batch > (4 * L::small) * (4 * L::small)) & (square.batch < L::big * L::big / 16);
    // Faster than 1 / select(...), where the division would wait for the comparisons.
    const Real inverse = select(in_range, Real(1) / length, Real(std::numeric_limits<Scalar>::quiet_NaN()));
    return {v * inverse, length};
}

}  // namespace twinlight::lighting

// Powers of SIMD lanes: base^exponent for bases that are not negative. 0^0 is 1 (2.1.1).
// xsimd's pow() is not used: its measured error is up to 57 epsilon (these: 1), and in doubles it takes 1.1 to 2.6
// times as long as the C library's.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <xsimd/xsimd.hpp>

#include "lighting/power_table.h"

namespace twinlight::lighting {

enum class PowerBy : std::uint8_t {
    kLibrary,  // for any exponents
    // Only if all lanes have the same exponent:
    kTable,
    // Only if is_short_product(exponent) holds too:
    kExactProducts,
    kRoundedProducts,
};

// a b + c and a b - c with a single rounding, if the processor has the instruction. Not xsimd's functions: version 8
// rounds twice with AVX-512, and its fms() for NEON is c - a b.
template <class Arch>
struct FusedProduct {
    static constexpr bool kAvailable = false;
};

#if defined(__AVX512F__) || defined(__FMA__) || defined(__aarch64__)
template <>
struct FusedProduct<xsimd::default_arch> {
    static constexpr bool kAvailable = true;
    using D = xsimd::batch<double, xsimd::default_arch>;
    using F = xsimd::batch<float, xsimd::default_arch>;
#if defined(__AVX512F__)
    static D sum(D a, D b, D c) { return D(_mm512_fmadd_pd(a, b, c)); }
    static F sum(F a, F b, F c) { return F(_mm512_fmadd_ps(a, b, c)); }
    static D difference(D a, D b, D c) { return D(_mm512_fmsub_pd(a, b, c)); }
    static F difference(F a, F b, F c) { return F(_mm512_fmsub_ps(a, b, c)); }
#elif defined(__FMA__)
    static D sum(D a, D b, D c) { return D(_mm256_fmadd_pd(a, b, c)); }
    static F sum(F a, F b, F c) { return F(_mm256_fmadd_ps(a, b, c)); }
    static D difference(D a, D b, D c) { return D(_mm256_fmsub_pd(a, b, c)); }
    static F difference(F a, F b, F c) { return F(_mm256_fmsub_ps(a, b, c)); }
#else
    static D sum(D a, D b, D c) { return D(vfmaq_f64(c, a, b)); }
    static F sum(F a, F b, F c) { return F(vfmaq_f32(c, a, b)); }
    static D difference(D a, D b, D c) { return -D(vfmsq_f64(c, a, b)); }
    static F difference(F a, F b, F c) { return -F(vfmsq_f32(c, a, b)); }
#endif
};
#endif

#if defined(__x86_64__) && defined(__GLIBC__)
// libmvec's functions under their names in the x86 vector function ABI. Error: at most 4 units in the last place
// (glibc's manual).
#if defined(__AVX512F__)
extern "C" __m512d _ZGVeN8vv_pow(__m512d, __m512d);
extern "C" __m512 _ZGVeN16vv_powf(__m512, __m512);
inline auto library_pow(__m512d base, __m512d exponent) { return _ZGVeN8vv_pow(base, exponent); }
inline auto library_pow(__m512 base, __m512 exponent) { return _ZGVeN16vv_powf(base, exponent); }
#elif defined(__AVX2__)
extern "C" __m256d _ZGVdN4vv_pow(__m256d, __m256d);
extern "C" __m256 _ZGVdN8vv_powf(__m256, __m256);
inline auto library_pow(__m256d base, __m256d exponent) { return _ZGVdN4vv_pow(base, exponent); }
inline auto library_pow(__m256 base, __m256 exponent) { return _ZGVdN8vv_powf(base, exponent); }
#else
extern "C" __m128d _ZGVbN2vv_pow(__m128d, __m128d);
extern "C" __m128 _ZGVbN4vv_powf(__m128, __m128);
inline auto library_pow(__m128d base, __m128d exponent) { return _ZGVbN2vv_pow(base, exponent); }
inline auto library_pow(__m128 base, __m128 exponent) { return _ZGVbN4vv_powf(base, exponent); }
#endif
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> library_power(xsimd::batch<Scalar, Arch> base, xsimd::batch<Scalar, Arch> exponent) {
    return xsimd::batch<Scalar, Arch>(library_pow(base, exponent));
}
#else
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> library_power(xsimd::batch<Scalar, Arch> base, xsimd::batch<Scalar, Arch> exponent) {
    constexpr std::size_t kCount = xsimd::batch<Scalar, Arch>::size;
    Scalar x[kCount], y[kCount];
    base.store_unaligned(x);
    exponent.store_unaligned(y);
    for (std::size_t i = 0; i < kCount; ++i) x[i] = std::pow(x[i], y[i]);
    return xsimd::batch<Scalar, Arch>::load_unaligned(x);
}
#endif

// Whether the exponent is a whole number small enough that products are faster than pow(). GL's exponents end at 128.
inline constexpr double kMostProducts = 1024;
[[gnu::always_inline]] inline bool is_short_product(double exponent) {
    return exponent >= 0 && exponent <= kMostProducts && exponent == static_cast<double>(static_cast<int>(exponent));
}

// Goes through the exponent's bits from the highest down: squares, and multiplies by the base if the bit is set.
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> rounded_product(xsimd::batch<Scalar, Arch> base, unsigned exponent) {
    xsimd::batch<Scalar, Arch> product = base;
    for (int bit = 30 - __builtin_clz(exponent); bit >= 0; --bit) {
        product = product * product;
        if ((exponent >> bit & 1U) != 0) product = product * base;
    }
    return product;
}

// Keeps each product as high + low, with twice as many digits (Dekker, "A floating-point technique for extending the
// available precision", 1971, with fused products). Only the last product is rounded.
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> exact_product(xsimd::batch<Scalar, Arch> base, unsigned exponent) {
    using Batch = xsimd::batch<Scalar, Arch>;
    using Fused = FusedProduct<Arch>;
    if (exponent <= 2) return exponent == 1 ? base : base * base;
    // All higher powers start with the square of the base.
    Batch high = base * base, low = Fused::difference(base, base, high);
    const auto square = [&] {
        const Batch product = high * high;
        low = Fused::sum(high + high, low, Fused::difference(high, high, product));
        high = product;
    };
    // First the odd factor of the exponent, then the remaining squarings.
    int squarings = __builtin_ctz(exponent);
    const unsigned odd = exponent >> squarings;
    if (odd == 1) --squarings;
    const int second_bit = 30 - __builtin_clz(odd);
    for (int bit = second_bit; bit >= 0; --bit) {
        if (bit != second_bit) square();
        if ((odd >> bit & 1U) == 0) continue;
        const Batch product = high * base;
        low = Fused::sum(low, base, Fused::difference(high, base, product));
        high = product;
    }
    if (squarings == 0) return high + low;
    while (--squarings > 0) square();
    return Fused::sum(high + high, low, high * high);
}

// base^exponent. All methods but kLibrary use the first lane's exponent for all lanes.
template <PowerBy kBy, class Scalar, class Arch>
xsimd::batch<Scalar, Arch> power_of(xsimd::batch<Scalar, Arch> base, xsimd::batch<Scalar, Arch> exponent) {
    const xsimd::batch<Scalar, Arch> one(Scalar(1));
    if constexpr (kBy == PowerBy::kLibrary)
        return xsimd::select(exponent == Scalar(0), one, library_power(base, exponent));
    const Scalar common = exponent.get(0);
    if (common == 0) return one;
    if constexpr (kBy == PowerBy::kTable) return between_entries(base, power_table(common));
    const auto count = static_cast<unsigned>(common);
    if constexpr (kBy == PowerBy::kExactProducts) return exact_product(base, count);
    if constexpr (kBy == PowerBy::kRoundedProducts) return rounded_product(base, count);
}

}  // namespace twinlight::lighting

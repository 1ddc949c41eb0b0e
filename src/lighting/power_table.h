// x^s on [0, 1] from a table: the lecture's method where pow() is slow.
#pragma once

#include <cstddef>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace twinlight::lighting {

inline constexpr std::size_t kPowerTableSteps = 256;

// The table of an exponent s: kPowerTableSteps + 2 entries, entry i is (i / kPowerTableSteps)^s. Each thread keeps its
// last 16 tables; a new one overwrites the oldest.
const double* power_table(double exponent);

// Interpolates linearly between the two nearest entries. Bases must not be negative; those above 1 count as 1.
template <class Scalar, class Arch>
xsimd::batch<Scalar, Arch> between_entries(xsimd::batch<Scalar, Arch> base, const double* table) {
    constexpr std::size_t kCount = xsimd::batch<Scalar, Arch>::size;
    constexpr Scalar kLargest = std::numeric_limits<Scalar>::max();
    Scalar x[kCount];
    base.store_unaligned(x);
    for (Scalar& value : x) {
        if (!(value <= kLargest)) continue;  // NaN and infinity stay
        const double place = static_cast<double>(value < 1 ? value : Scalar(1)) * kPowerTableSteps;
        const auto below = static_cast<std::size_t>(place);
        value = static_cast<Scalar>(table[below] +
                                    (place - static_cast<double>(below)) * (table[below + 1] - table[below]));
    }
    return xsimd::batch<Scalar, Arch>::load_unaligned(x);
}

}  // namespace twinlight::lighting

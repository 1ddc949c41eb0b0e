// x^s on [0, 1] from a table: the lecture's way out where pow() is dear.
#pragma once

#include <cstddef>
#include <limits>
#include <xsimd/xsimd.hpp>

namespace twinlight::lighting {

inline constexpr std::size_t kPowerTableSteps = 256;
// Entry i: (i / kPowerTableSteps)^s; one more at the end.

// The kPowerTableSteps + 2 entries of this exponent. The last few tables are kept, for the thread that asks.
const double* power_table(double exponent);

// Linearly between the two nearest entries; of bases above 1 as at 1. Bases are not negative.
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

#include "scene/trace/as_printed.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace twinlight::trace {

double as_printed(double value) {
    if (value == std::trunc(value) && std::abs(value) < 1e15) return value;
    if (std::isnan(value)) return std::numeric_limits<double>::quiet_NaN();
    return std::isinf(value) ? value : std::strtod(fmt::format("{:.16g}", value).c_str(), nullptr);
}

double as_printed(float value) {
    static constexpr double kPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
    constexpr double kSevenDigits = 1e6;
    const double exact = value, size = std::abs(exact);
    if (exact == std::trunc(exact) && size < 10 * kSevenDigits) return exact;
    if (!std::isfinite(value)) return as_printed(exact);
    if (size < 1e-6 || size >= 10 * kSevenDigits) return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
    // The product is exact: 24 bits of the float and 28 of 5^12. So each step rounds once, as printing and reading would.
    const double* power = kPowers;
    while (size * *power < kSevenDigits) ++power;
    return std::nearbyint(exact * *power) / *power;
}

}  // namespace twinlight::trace

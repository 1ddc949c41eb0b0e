// Rounding of channels to 8 bits.
#include "base/image/image.h"

#include <algorithm>
#include <cmath>

namespace twinlight {

// GL 2.1 section 2.14.9, "Final Color Processing": "rounded to the nearest" of the fixed-point values.
std::uint8_t channel_code(float channel) {
    if (std::isnan(channel)) return 0;
    // Exact: the product needs 32 of a double's 53 bits. If adding 0.5 needs more bits than that, the sum is still
    // below 1.
    return static_cast<std::uint8_t>(std::clamp(static_cast<double>(channel), 0.0, 1.0) * 255 + 0.5);
}

}  // namespace twinlight

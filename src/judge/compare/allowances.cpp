#include "judge/compare/allowances.h"

#include <algorithm>
#include <cmath>

namespace twinlight::compare {

namespace {

// 2.1.1: a colour must be accurate to 1 part in 10^5. If the right value is that close to halfway between two 8-bit values, such as
// a background of 0.3 (76.5/255), both are allowed.
constexpr double kArithmetic = 1e-5;

// Whether an error of `error` can change the channel's 8-bit value.
bool may_cross(float channel, double error) {
    const double codes = 255 * std::clamp(static_cast<double>(channel), 0.0, 1.0);
    return std::abs(codes - std::floor(codes) - 0.5) <= 255 * error;
}

}  // namespace

void allow_ties(AllowedDifference& allowed, const Image& reference) {
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        for (std::size_t c = 0; c < reference.pixels[i].size(); ++c) {
            if (may_cross(reference.pixels[i][c], kArithmetic))
                allowed.channels.pixels[i][c] += static_cast<float>(kArithmetic);
        }
    }
}

AllowedDifference allowed_of_drivers(AllowedDifference allowed, const Render& reference) {
    for (std::size_t i = 0; i < allowed.channels.pixels.size(); ++i) {
        for (std::size_t c = 0; c < allowed.channels.pixels[i].size(); ++c) {
            float& channel = allowed.channels.pixels[i][c];
            channel *= 2;
            if (!reference.other_cut) continue;
            channel += std::abs(reference.image.pixels[i][c] - reference.other_cut->pixels[i][c]);
        }
    }
    return allowed;
}

AllowedDifference with_plans(AllowedDifference allowed, const Render& a, const Render& b, const Render& reference) {
    const double error = error_bound(a.plan) + error_bound(b.plan);
    if (error == 0) return allowed;
    for (std::size_t i = 0; i < allowed.channels.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {  // lights do not change alpha
            float& channel = allowed.channels.pixels[i][c];
            const bool more =
                channel > 0 || may_cross(reference.image.pixels[i][c], error + kArithmetic) ||
                (reference.other_cut && may_cross(reference.other_cut->pixels[i][c], error + kArithmetic));
            if (more) channel += static_cast<float>(error);
        }
    }
    return allowed;
}

}  // namespace twinlight::compare

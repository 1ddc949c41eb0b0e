#include "judge/compare/allowances.h"

#include <cmath>

namespace twinlight::compare {

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

#include "judge/compare/allowed_difference.h"

#include <algorithm>
#include <cmath>

namespace twinlight::compare {

namespace {

// 2.1.1: a colour need not be computed to more than 1 part in 10^5. Where the right value lies that near to the border of
// two codes, such as a background of 0.3 (76.5 codes), either code is right.
constexpr double kArithmetic = 1e-5;

// Whether a channel that is off by `error` may have another code.
bool may_cross(float channel, double error) {
    const double codes = 255 * std::clamp(static_cast<double>(channel), 0.0, 1.0);
    return std::abs(codes - std::floor(codes) - 0.5) <= 255 * error;
}

}  // namespace

void allow_ties(Freedom& freedom, const Image& reference) {
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        for (std::size_t c = 0; c < reference.pixels[i].size(); ++c) {
            if (may_cross(reference.pixels[i][c], kArithmetic))
                freedom.slack.pixels[i][c] += static_cast<float>(kArithmetic);
        }
    }
}

Freedom freedom_of_drivers(Freedom freedom, const Render& reference) {
    for (std::size_t i = 0; i < freedom.slack.pixels.size(); ++i) {
        for (std::size_t c = 0; c < freedom.slack.pixels[i].size(); ++c) {
            float& slack = freedom.slack.pixels[i][c];
            slack *= 2;
            if (!reference.other_cut) continue;
            slack += std::abs(reference.image.pixels[i][c] - reference.other_cut->pixels[i][c]);
        }
    }
    return freedom;
}

Freedom with_plans(Freedom freedom, const Render& a, const Render& b, const Render& reference) {
    const double error = error_bound(a.plan) + error_bound(b.plan);
    if (error == 0) return freedom;
    for (std::size_t i = 0; i < freedom.slack.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {  // alpha is no light's
            float& slack = freedom.slack.pixels[i][c];
            const bool more =
                slack > 0 || may_cross(reference.image.pixels[i][c], error + kArithmetic) ||
                (reference.other_cut && may_cross(reference.other_cut->pixels[i][c], error + kArithmetic));
            if (more) slack += static_cast<float>(error);
        }
    }
    return freedom;
}

}  // namespace twinlight::compare

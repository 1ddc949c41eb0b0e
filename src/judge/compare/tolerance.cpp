#include "judge/compare/tolerance.h"

#include <algorithm>
#include <cmath>

namespace twinlight::compare {

bool is_within(const ImageDifference& difference, const Tolerance& tolerance) {
    const RegionDifference& judged = difference.beyond_allowed;
    return judged.max <= tolerance.max &&
           (judged.differing == 0 || judged.differing_share() < tolerance.differing_share);
}

bool may_cross(float channel, double error) {
    const double codes = 255 * std::clamp(static_cast<double>(channel), 0.0, 1.0);
    return std::abs(codes - std::floor(codes) - 0.5) <= 255 * error;
}

void allow_ties(AllowedDifference& allowed, const Image& reference) {
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        for (std::size_t c = 0; c < reference.pixels[i].size(); ++c) {
            if (may_cross(reference.pixels[i][c], kArithmetic))
                allowed.channels.pixels[i][c] += static_cast<float>(kArithmetic);
        }
    }
}

void allow_rounded_positions(AllowedDifference& allowed, const Image& reference, int bits) {
    const float way = std::ldexp(0.5F, -bits);
    // To the neighbours on both sides; to those at edges only where there are no others.
    const auto change = [&](int x, int y, int dx, int dy, std::size_t c) {
        float within = -1, at_edges = 0;
        for (const int side : {-1, 1}) {
            const int to_x = x + side * dx, to_y = y + side * dy;
            if (to_x < 0 || to_y < 0 || to_x >= reference.width || to_y >= reference.height) continue;
            float& largest = allowed.edge[reference.index(to_x, to_y)] ? at_edges : within;
            largest = std::max(largest, std::abs(reference.at(to_x, to_y)[c] - reference.at(x, y)[c]));
        }
        return within < 0 ? at_edges : within;
    };
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                allowed.channels.at(x, y)[c] += way * (change(x, y, 1, 0, c) + change(x, y, 0, 1, c));
}

}  // namespace twinlight::compare

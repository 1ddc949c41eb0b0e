#include "judge/compare/tolerance.h"

#include <algorithm>
#include <cmath>

namespace twinlight::compare {

bool is_within(const ImageDifference& difference, const Tolerance& tolerance) {
    const RegionDifference& judged = difference.beyond_allowed;
    return judged.max <= tolerance.max &&
           (judged.differing == 0 || judged.differing_share() < tolerance.differing_share);
}

void allow_reference(AllowedDifference& allowed, const Image& reference, const Image* other_cut) {
    for (auto& [i, ranges] : allowed.ranges)
        for (const Image* image : {&reference, other_cut})
            if (image) ranges.push_back({image->pixels[i], image->pixels[i]});
}

bool may_cross(float channel, double error) {
    const double codes = 255 * std::clamp(static_cast<double>(channel), 0.0, 1.0);
    return std::abs(codes - std::floor(codes) - 0.5) <= 255 * error;
}

void allow_ties(AllowedDifference& allowed, const Image& reference) { allow_drawing(allowed, reference, nullptr, {}); }

namespace {

// The change of a channel from a pixel to the neighbours on both sides; to those at edges only where there are no others.
float change_to(int dx, int dy, int x, int y, std::size_t c, const PixelMask& edge, const Image& reference) {
    float within = -1, at_edges = 0;
    for (const int side : {-1, 1}) {
        const int to_x = x + side * dx, to_y = y + side * dy;
        if (to_x < 0 || to_y < 0 || to_x >= reference.width || to_y >= reference.height) continue;
        float& largest = edge[reference.index(to_x, to_y)] ? at_edges : within;
        largest = std::max(largest, std::abs(reference.at(to_x, to_y)[c] - reference.at(x, y)[c]));
    }
    return within < 0 ? at_edges : within;
}

// The change of a channel on the way across and up to a place that is `way` pixels away.
float change_on(float way, int x, int y, std::size_t c, const PixelMask& edge, const Image& reference) {
    return way * (change_to(1, 0, x, y, c, edge, reference) + change_to(0, 1, x, y, c, edge, reference));
}

}  // namespace

void allow_drawing(AllowedDifference& allowed, const Image& reference, const Image* other_cut,
                   const DrawingPrecision& precision) {
    const auto way = static_cast<float>(precision.position);
    const float conversion = static_cast<float>(precision.conversion / 255);
    const Image before = allowed.channels();
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x) {
            const std::size_t i = reference.index(x, y);
            for (std::size_t c = 0; c < 4; ++c) {
                const float of_places = way > 0 ? change_on(way, x, y, c, allowed.edge, reference) : 0;
                const double more = static_cast<double>(conversion + of_places), error = kArithmetic + more;
                const bool counts =
                    allowed.edge[i] || may_cross(reference.pixels[i][c], error) ||
                    (more > 0 && (before.pixels[i][c] > 0 || (other_cut && may_cross(other_cut->pixels[i][c], error))));
                if (!counts) continue;
                allowed.part(Why::kTie).pixels[i][c] += static_cast<float>(kArithmetic);
                if (of_places > 0) allowed.part(Why::kPositions).pixels[i][c] += of_places;
                if (conversion > 0) allowed.part(Why::kConversion).pixels[i][c] += conversion;
            }
        }
    }
}

void allow_rounded_positions(AllowedDifference& allowed, const Image& reference, int bits) {
    const float way = std::ldexp(0.5F, -bits);
    Image& part = allowed.part(Why::kPositions);
    for (int y = 0; y < reference.height; ++y)
        for (int x = 0; x < reference.width; ++x)
            for (std::size_t c = 0; c < 4; ++c) part.at(x, y)[c] += change_on(way, x, y, c, allowed.edge, reference);
}

}  // namespace twinlight::compare

#include "judge/compare/judged.h"

#include <algorithm>
#include <vector>

namespace twinlight::compare {

namespace {

constexpr std::size_t kSeen = 3;  // no window shows alpha

// The widest channel of the widest range.
double width_of(const std::vector<AllowedRange>& ranges) {
    float widest = 0;
    for (const AllowedRange& range : ranges)
        for (std::size_t c = 0; c < kSeen; ++c) widest = std::max(widest, range.high[c] - range.low[c]);
    return static_cast<double>(widest);
}

double width_of(const Rgba& allowed) {
    return 2 * static_cast<double>(*std::max_element(allowed.begin(), allowed.begin() + kSeen));
}

Judged::Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    const auto at = [&](double share) {
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::ranges::nth_element(values, place);
        return *place;
    };
    const double median = at(0.5);
    return {.median = median, .most = at(0.95)};
}

}  // namespace

Judged judged(const AllowedDifference& allowed) {
    Judged result;
    std::vector<double> colors, widths;
    for (std::size_t i = 0; i < allowed.edge.size(); ++i) {
        const bool drawn = allowed.drawn.empty() || allowed.drawn[i], is_judged = allowed.is_judged(i);
        double width = 0;
        if (!allowed.edge[i]) {
            ++result.to_allowed;
            width = width_of(allowed.channels(i));
        } else if (is_judged) {
            ++result.to_one_of;
            const std::vector<AllowedRange>& ranges = allowed.ranges.at(i);
            width = width_of(ranges);
            colors.push_back(static_cast<double>(ranges.size()));
            widths.push_back(width);
        } else {
            ++result.not_judged;
        }
        if (!drawn) continue;
        ++result.drawn;
        if (!is_judged) ++result.drawn_not_judged;
        if (width > Judged::kWide) ++result.drawn_widely;
    }
    result.colors = spread_of(std::move(colors));
    result.width = spread_of(std::move(widths));
    return result;
}

}  // namespace twinlight::compare

#include "judge/compare/allowances.h"

#include <cmath>

namespace twinlight::compare {

AllowedDifference allowed_of_drivers(AllowedDifference allowed, const Render& reference) {
    allowed.part(Why::kDrivers) = allowed.channels();
    if (!reference.other_cut) return allowed;
    Image& cut = allowed.part(Why::kCut);
    for (std::size_t i = 0; i < cut.pixels.size(); ++i)
        for (std::size_t c = 0; c < cut.pixels[i].size(); ++c)
            cut.pixels[i][c] = std::abs(reference.image.pixels[i][c] - reference.other_cut->pixels[i][c]);
    return allowed;
}

std::optional<AllowedDifference> with_plans(const AllowedDifference& before_plans, const Render& a, const Render& b,
                                            const Render& reference) {
    const double error = error_bound(a.plan) + error_bound(b.plan);
    if (error == 0) return std::nullopt;
    AllowedDifference allowed = before_plans;
    const Image before = allowed.channels();
    Image& plan = allowed.part(Why::kPlan);
    for (std::size_t i = 0; i < plan.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {  // lights do not change alpha
            const bool more =
                before.pixels[i][c] > 0 || may_cross(reference.image.pixels[i][c], error + kArithmetic) ||
                (reference.other_cut && may_cross(reference.other_cut->pixels[i][c], error + kArithmetic));
            if (more) plan.pixels[i][c] = static_cast<float>(error);
        }
    }
    return allowed;
}

}  // namespace twinlight::compare

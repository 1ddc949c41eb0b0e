// Allowed differences at a pixel in addition to those of the reference (render/reference) and of ties (tolerance.h): for lights
// that plans skip, and for pairs of two drivers.
#pragma once

#include <optional>

#include "base/image/difference.h"
#include "judge/compare/comparison.h"

namespace twinlight::compare {

// For a pair of drivers: each may be off in its own direction, and may split quadrilaterals its own way. One driver may even split
// those in a display list differently.
AllowedDifference allowed_of_drivers(AllowedDifference allowed, const Render& reference);

// Adds the plans' own bounds on what they skip (PlanOptions::budget), at pixels where that can change the 8-bit value: where the
// right value is that close to halfway between two of them, or where a difference is allowed already. Empty if they skip nothing.
std::optional<AllowedDifference> with_plans(const AllowedDifference& before_plans, const Render& a, const Render& b,
                                            const Render& reference);

}  // namespace twinlight::compare

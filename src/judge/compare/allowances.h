// How far two right pictures may differ at a pixel beyond what the reference allows (render/reference): ties of rounding, what
// plans leave out, what two drivers may each do.
#pragma once

#include "base/image/difference.h"
#include "judge/compare/comparison.h"

namespace twinlight::compare {

// Where the right value lies on the border of two codes either code is right.
void allow_ties(AllowedDifference& allowed, const Image& reference);

// Of two pictures of drivers each may use the allowed difference to its side, and cut quadrilaterals its own way: a driver may cut those
// of a display list otherwise than the same ones outside of it.
AllowedDifference allowed_of_drivers(AllowedDifference allowed, const Render& reference);

// What planning may leave out of either picture (PlanOptions::budget), as the plans bound it: where the right value lies that
// near to the border of two codes, it may cross it. Where a difference is allowed already, it is more of it.
AllowedDifference with_plans(AllowedDifference allowed, const Render& a, const Render& b, const Render& reference);

}  // namespace twinlight::compare

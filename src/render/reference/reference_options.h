// How the reference draws a Frame.
#pragma once

#include <cstdint>

#include "base/math/arithmetic.h"
#include "render/look.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

// Where a quadrilateral is cut into triangles. The specification leaves it open (3.5: any correct algorithm), it shows
// wherever colours do not vary linearly over it, and a driver may do now this, now that.
enum class QuadCut : std::uint8_t { kFirstToThird, kSecondToFourth };  // corners in their order around it
// Whether there is a choice.
bool has_quadrilaterals(const Frame& frame);

struct Options : Look {
    QuadCut quad_cut = QuadCut::kFirstToThird;
    Arithmetic arithmetic{};  // of the lighting
};

}  // namespace twinlight::reference

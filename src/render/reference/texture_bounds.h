// Which texels right implementations may get for one fragment.
//
// Two things are told apart. A **choice** is discrete: which texel GL_NEAREST takes where the border of two passes
// through the fragment, which level or which of two filters where lambda stands at the switch. What is not a choice is
// bounded by an **interval** a channel: the precision of filter weights, of lambda between two levels, of the
// arithmetic. Where the numbers come from:
//   - texture coordinates: float arithmetic, and vertices that are snapped to 1/256 pixel before the planes are made;
//   - weights of GL_LINEAR: 8 bits, and each mean of two texels rounded to 8 bits (llvmpipe and most graphics hardware);
//   - derivatives: differences over any 2 x 2 pixels that hold the fragment, in the place of the derivatives at its
//     centre;
//   - lambda between two levels: log2 of a mantissa taken as linear (llvmpipe), which is off by at most 0.0861;
//     of rho squared, which halves that.
// 3.8.8 allows more, any rho between half and twice the ideal one. That is not used: what would be left to compare?
#pragma once

#include "render/reference/interval.h"
#include "render/reference/texture.h"

namespace twinlight::reference {

struct TexelBounds {
    Channels<Interval> texel{};
    bool has_choice = false;  // with different outcomes
};

// `st_error`: what s and t may be off by. `rho`: the scale factors that right implementations may find.
TexelBounds sample_bounds(const TextureUnit& unit, const glm::dvec2& st, const glm::dvec2& st_error,
                          const Interval& rho);

}  // namespace twinlight::reference

// Which texels correct implementations may get for one fragment.
//
// There are two kinds of freedom. A **choice** is discrete: which texel GL_NEAREST takes if the border of two texels
// passes through the fragment; which level or which of two filters if lambda is at the switch. Everything else is an
// **interval** per channel: the precision of filter weights, of lambda between two levels, of the arithmetic. The
// numbers are:
//   - texture coordinates: float arithmetic, and vertices snapped before the planes are computed (Options::snap);
//   - weights of GL_LINEAR: 8 bits, and each mean of two texels rounded to 8 bits (llvmpipe and most GPUs);
//   - derivatives: differences over any 2 x 2 pixels that include the fragment, instead of those at its centre;
//   - anisotropic filters: any mean of texels around the place, because drivers choose how they filter;
//   - lambda between two levels: half of a log2 of rho squared that is linear in the mantissa (llvmpipe). The log2 is
//     off by at most 0.0861.
// 3.8.8 allows any rho between half and twice the ideal one. That is not used, because almost any texel would then be
// correct.
#pragma once

#include "render/reference/textures/interval.h"
#include "render/reference/textures/texture.h"
#include "scene/frame/copied_texels.h"

namespace twinlight::reference {

struct TexelBounds {
    Channels<Interval> texel{};
    bool has_choice = false;  // there is a choice between different texels
};

// A comparison of depths with r (3.8.14) is a choice if it may fail at one of the depths near the place and pass at another: which
// depths a linear filter compares, or whether it compares their mean, is open.
//
// `error`: the largest error of s, t and r. `rho`: the scale factors that correct implementations may find. `change`: how much s, t
// and r change within a pixel, for anisotropic filters.
TexelBounds sample_bounds(const TextureUnit& unit, const glm::dvec3& str, const glm::dvec3& error, const Interval& rho,
                          std::size_t face = 0, const glm::dvec3& change = glm::dvec3(0),
                          const CopyRanges::OfTexels* copied = nullptr);
// Either of two.
TexelBounds choice(const TexelBounds& a, const TexelBounds& b);

}  // namespace twinlight::reference

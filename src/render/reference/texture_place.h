// Where a fragment lies in its texture (3.4.1, 3.5.1, 3.8.8), and how far right implementations may be off.
//
// In: a piece and the stage vertices that it is of. Out: (s, t) divided by q and its derivatives over the window.
#pragma once

#include <vector>

#include "lighting/marked.h"
#include "render/reference/interval.h"
#include "render/reference/piece.h"
#include "render/reference/texture.h"

namespace twinlight::reference {

TexturePlace texture_place(const std::vector<StageVertex>& vertices, const Piece& piece,
                           const glm::dvec2& position_window);

// What texture_bounds.h starts from.
struct TexturePlaceBounds {
    glm::dvec2 st{0}, st_error{0};
    Interval rho;
};
TexturePlaceBounds texture_place_bounds(const std::vector<StageVertex>& vertices, const Piece& piece,
                                        const glm::dvec2& position_window, const Texture& texture);

// Rasterisers snap vertices to a grid, llvmpipe's and most GPUs' is 1/256 pixel.
inline constexpr double kSnap = 1.0 / 256;

// The rulings by which it has its place; of a mesh.
lighting::RulingSet texture_rulings(const std::vector<StageVertex>& vertices, const Piece& piece,
                                    const glm::dvec2& position_window);

// RULING: what is divided by a q or w of 0 is 0.
template <class Real>
Real quotient(Real a, Real b) {
    return b == Real(0) ? ruled(lighting::Ruling::kZeroQuotient, Real(0)) : a / b;
}

}  // namespace twinlight::reference

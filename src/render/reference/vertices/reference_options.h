// The options of the reference renderer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/math/arithmetic.h"
#include "render/look.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// Where a quadrilateral is cut into triangles. The specification leaves it open (3.5: any correct algorithm). It is
// visible if colours do not vary linearly over the quadrilateral, and a driver may use both.
enum class QuadCut : std::uint8_t { kFirstToThird, kSecondToFourth };  // corners in their order around it
// Whether the cut matters.
bool has_quadrilaterals(const Frame& frame);
// The numbers of the Draws (Frame::draws()) for which it does.
std::vector<std::size_t> draws_of_quadrilaterals(const Frame& frame);

// What of a primitive that lies in a plane of glClipPlane, or nearly in one of the view volume, is drawn. 2.12 keeps it, but only rounding decides whether its computed
// positions are in the plane, beside it or beyond it.
enum class InClipPlane : std::uint8_t {
    kAsComputed,  // what its positions in double precision say
    kPerhaps,     // all of it; Piece::is_perhaps_clipped marks it
};

// Rasterisers snap vertices to a grid of 1/256 pixel (llvmpipe and most GPUs; 3.5.1 leaves it open).
inline constexpr double kSnap = 1.0 / 256;

struct Options : Look {
    QuadCut quad_cut = QuadCut::kFirstToThird;
    Arithmetic arithmetic{};  // used for lighting
    InClipPlane in_clip_plane = InClipPlane::kAsComputed;
    // For allowed_difference(): the driver approximates rho, as 3.8.8 allows (DrawingPrecision).
    bool approximates_rho = false;
    // The same: by how many pixels vertices may be moved, across and up, before texture coordinates are interpolated; and by how many
    // a polygon's border may be off.
    double snap = kSnap;
    double border = kSnap;
    // The Draws, by their numbers, that are cut the other way; the numbers beyond are not.
    std::vector<bool> cut_otherwise{};

    QuadCut cut_of(std::size_t draw) const {
        const bool other = draw < cut_otherwise.size() && cut_otherwise[draw];
        return other == (quad_cut == QuadCut::kFirstToThird) ? QuadCut::kSecondToFourth : QuadCut::kFirstToThird;
    }
    friend bool operator==(const Options&, const Options&) = default;
};

}  // namespace twinlight::reference

// SurfaceDraw: one exact surface of a shape as a Draw of its own, for those who draw it by its equation (Shading::kExact).
//
// Its object space is the surface's: the axis is z, the origin the middle of the surface, and the unit of length a power of two
// that leaves the surface about as large as 1. All its points have what a vertex of the mesh would have there, but normals
// of length 1, as the surface itself has: GL_NORMALIZE stands for that, whatever the shape's state is.
#pragma once

#include <vector>

#include "render/effect/vertex_facts.h"
#include "scene/shape/surface.h"
#include "scene/state/frame.h"

namespace twinlight {

struct SurfaceDraw {
    Surface surface;  // its lengths in the new unit; a frustum from -height / 2 to height / 2, a disk at z = 0
    Draw draw;  // a strip of two triangles, a square from (0, 0) to (1, 1), with the surface's colour and coordinates
    VertexFacts facts;  // of the surface's points, not of the square's
};

// Of a Draw that has_exact_surfaces(), of the first part of a shape. RULING: under matrices without an inverse a surface is not
// seen: then there are none.
std::vector<SurfaceDraw> surface_draws(const Draw& draw);

// How far a surface of a SurfaceDraw reaches from the origin: across the axis and along it.
struct Reach {
    double across, along;
};
Reach reach_of(const Surface& surface);

}  // namespace twinlight

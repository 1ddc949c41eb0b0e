// SurfaceDraw: one exact surface of a shape as its own Draw, for renderers that draw it by its equation
// (Shading::kExact).
//
// Its object space is the surface's: the axis is z, the origin the middle of the surface, and the unit of length a
// power of two that makes the surface's size about 1. Its points have the attributes that a vertex of the mesh would
// have there, except that normals have length 1: the state has GL_NORMALIZE on, whatever the shape's state is.
#pragma once

#include <vector>

#include "render/effect/vertex_facts.h"
#include "scene/frame/frame.h"
#include "scene/shape/surface.h"

namespace twinlight {

struct SurfaceDraw {
    Surface surface;  // its lengths in the new unit; a frustum from -height / 2 to height / 2, a disk at z = 0
    Draw draw;  // a strip of two triangles, a square from (0, 0) to (1, 1), with the surface's colour and coordinates
    VertexFacts facts;  // of the surface's points, not of the square's corners
};

// For the Draw that is the first part of a shape; it must have exact surfaces (has_exact_surfaces()). RULING: if a
// matrix has no inverse, the surfaces are not visible and the result is empty.
std::vector<SurfaceDraw> surface_draws(const Draw& draw);

// How far a surface of a SurfaceDraw reaches from the origin: across the axis and along it.
struct Reach {
    double across, along;
};
Reach reach_of(const Surface& surface);

}  // namespace twinlight

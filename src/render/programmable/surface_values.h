// Exact surfaces by shaders: a surface is drawn as the rectangle of the window around it, whose fragments cast their pixels' rays.
//
// A ray is given by its Pluecker coordinates, a direction d and the moment p x d of any of its points p, in the surface's space
// (render/effect/surface_draw.h). Both are linear in window coordinates, so that matrices are inverted in double precision, once, for
// the pixel in the middle of the rectangle, and floats add what a pixel is away from it: nothing is lost to an eye that is far
// away or a near plane that is close. Discriminants are products in Pluecker coordinates, too (shaders/surface_crossings.glsl).
//
// A ray meets a sphere or the side of a cone twice, a torus four times. Where colours are blended or tested each of these
// points, from far to near, is a fragment of its own, drawn in a pass of its own; elsewhere the nearest is all that shows.
#pragma once

#include <vector>

#include "render/programmable/draw_values.h"

namespace twinlight::programmable {

struct SurfaceProgram {
    Draw
        draw;  // a SurfaceDraw's, without the state that the program takes the place of: culling, clip planes, polygon offset
    Plan plan;
    Code code;
    std::vector<Uniforms> passes;  // one for each time that it is drawn
};

// What is drawn in the place of a shape's mesh: one for each of its surfaces that may be seen. Of a Draw that has_exact_surfaces(),
// of the first part of a shape.
std::vector<SurfaceProgram> surface_programs(const Draw& draw, const PlanOptions& options);

}  // namespace twinlight::programmable

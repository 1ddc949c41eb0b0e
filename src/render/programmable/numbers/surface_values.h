// Exact surfaces by shaders: draws a rectangle around the surface in the window; each fragment casts its pixel's ray.
//
// A ray is given by its Pluecker coordinates, a direction d and the moment p x d of any of its points p, in the
// surface's space (render/effect/surface_draw.h). Both are linear in window coordinates. So matrices are inverted once,
// in double precision, for the pixel in the middle of the rectangle, and floats add the difference for other pixels: a
// distant eye or a close near plane loses no precision. Discriminants are products in Pluecker coordinates too
// (shaders/surface_crossings.glsl).
//
// A ray meets a sphere or the side of a cone up to twice, a torus up to four times. If colours are blended or
// alpha-tested, each of these points is a separate fragment, drawn in a separate pass, from far to near; otherwise only
// the nearest is drawn.
#pragma once

#include <vector>

#include "render/programmable/numbers/draw_values.h"

namespace twinlight::programmable {

struct SurfaceProgram {
    Draw draw;  // a SurfaceDraw's, without the state that the shader handles: culling, clip planes, polygon offset
    Plan plan;
    Code code;
    std::vector<Uniforms> passes;  // the uniforms of each pass
};

// One program for each surface of the shape that may be visible, drawn instead of its mesh. Takes the Draw that is the
// first part of a shape; it must have exact surfaces (has_exact_surfaces()).
std::vector<SurfaceProgram> surface_programs(const Draw& draw, const PlanOptions& options);

}  // namespace twinlight::programmable

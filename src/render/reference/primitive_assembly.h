// Primitive assembly (2.6.1): from the order in which vertices are sent to points, lines and triangles.
//
// In: glBegin's primitive type and the Draw's vertex order. Out: primitives of at most three vertices, each with its
// provoking vertex (2.14.7, table 2.12) and with the edges that PolygonMode may draw: the boundary edges. Edge flags
// (2.6.2) say which those are of independent triangles, quadrilaterals and polygons; of strips and fans all edges are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/reference/reference_options.h"
#include "scene/state/frame.h"

namespace twinlight::reference {

enum class Shape : std::uint8_t { kPoint, kLine, kTriangle, kSurface };  // the last: of no primitive (surface_rays.h)

struct Primitive {
    Shape shape = Shape::kPoint;
    std::array<std::uint32_t, 3> vertices{};         // into Draw::vertices; a line uses two, a point one
    std::uint32_t provoking = 0;                     // into Draw::vertices
    std::array<bool, 3> boundary{true, true, true};  // of a triangle: is the edge from vertex i to i+1 on the border
};

bool is_quadrilaterals(const Draw& draw);

// RULING (2.6.1 and 3.5 leave the split of quadrilaterals and polygons open): quadrilaterals are cut as `cut` says,
// and a picture of the driver may follow either cut at each pixel; GL_POLYGON is the fan of its first vertex.
// llvmpipe cuts smooth quadrilaterals from the first corner to the third, but from the second to the fourth where a
// batch is clipped or shaded flat.
std::vector<Primitive> assemble(const Draw& draw, QuadCut cut);

}  // namespace twinlight::reference

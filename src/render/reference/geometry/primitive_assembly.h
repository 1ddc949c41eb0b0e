// Primitive assembly (2.6.1): turns the sequence of vertices into points, lines and triangles.
//
// In: glBegin's primitive type and the Draw's vertex order. Out: primitives of at most three vertices, each with its
// provoking vertex (2.14.7, table 2.12) and its boundary edges, which are the edges that glPolygonMode may draw. For
// independent triangles, quadrilaterals and polygons, edge flags (2.6.2) select the boundary edges; in strips and fans
// all edges are boundary edges.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/reference/vertices/reference_options.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

enum class Shape : std::uint8_t { kPoint, kLine, kTriangle, kSurface };  // kSurface: from no primitive (surface_rays.h)

struct Primitive {
    Shape shape = Shape::kPoint;
    std::array<std::uint32_t, 3> vertices{};  // into Draw::vertices; a line uses two, a point one
    std::uint32_t provoking = 0;              // into Draw::vertices
    std::array<bool, 3> boundary{true, true,
                                 true};  // for a triangle: whether the edge from vertex i to i+1 is a boundary edge
};

bool is_quadrilaterals(const Draw& draw);

// RULING (2.6.1 and 3.5 leave open how quadrilaterals and polygons are split): quadrilaterals are cut as `cut` says,
// and a driver's picture may follow either cut at each pixel; a GL_POLYGON is a fan around its first vertex. llvmpipe
// cuts smooth quadrilaterals from the first corner to the third, but from the second to the fourth if a batch is
// clipped or flat-shaded.
std::vector<Primitive> assemble(const Draw& draw, QuadCut cut);

}  // namespace twinlight::reference

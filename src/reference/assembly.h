// Primitive assembly (2.6.1): from the order in which vertices are sent to points, lines and triangles.
//
// In: glBegin's primitive type and the Draw's vertex order. Out: primitives of at most three vertices, each
// with its provoking vertex (2.14.7, table 2.12) and with the edges that PolygonMode may draw (2.6.2: the
// boundary).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "state/frame.h"

namespace twinlight::reference {

enum class Shape : std::uint8_t { kPoint, kLine, kTriangle };

struct Primitive {
    Shape shape = Shape::kPoint;
    std::array<std::uint32_t, 3> vertices{};  // into Draw::vertices; a line uses two, a point one
    std::uint32_t provoking = 0;              // into Draw::vertices
    std::array<bool, 3> boundary{true, true,
                                 true};  // of a triangle: is the edge from vertex i to i+1 on the border
};

// RULING (2.6.1 leaves the split of quadrilaterals and polygons open): GL_QUADS is cut from its first to its
// third vertex, GL_QUAD_STRIP from the first to the fourth that was sent, GL_POLYGON into the fan of its
// first vertex. It is what llvmpipe does with batches that it need not clip.
std::vector<Primitive> assemble(const Draw& draw);

}  // namespace twinlight::reference

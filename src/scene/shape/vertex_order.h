// Triangles in another order, so that a driver runs its vertex shader less often for a vertex that several share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twinlight {

// A list of triangles in patches that a driver may draw on their own. A vertex on the border of two patches is there twice.
struct PatchedTriangles {
    struct Patch {
        std::uint32_t first_vertex = 0, vertex_count = 0;  // into old_from_new
        std::uint32_t first_index = 0, index_count = 0;    // into indices
    };
    std::vector<Patch> patches;
    // Three a triangle, each triangle's in their own order (its provoking vertex stays), counted from its patch's first vertex.
    std::vector<std::uint16_t> indices;
    std::vector<std::uint32_t> old_from_new;  // the number of each vertex in what was given
};

// What Mesa's draw module (22.3, draw_pt_vsplit.c) shades in one go: a draw of 16-bit indices, of this many at most, whose range
// the program gives (glDrawRangeElementsBaseVertex) and which has more indices than vertices. Others it cuts into runs of 1,023
// indices, and within a run finds a vertex again as long as no other with the same number modulo 256 has come.
inline constexpr std::size_t kPatchIndices = 4096 / 3 * 3;

// Patches that grow from triangle to neighbour: of a grid some 26 by 26 squares, with 1.1 vertices for each of the grid's.
// `indices` has three for each triangle, all below vertex_count. Linear time.
PatchedTriangles patched(std::span<const std::uint32_t> indices, std::size_t vertex_count);

}  // namespace twinlight

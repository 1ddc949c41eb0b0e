// Reorders triangles so that a driver runs its vertex shader less often for shared vertices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twinlight {

// Triangles grouped into patches that can be drawn separately. A vertex on the border of two patches is in both.
struct PatchedTriangles {
    struct Patch {
        std::uint32_t first_vertex = 0, vertex_count = 0;  // into old_from_new
        std::uint32_t first_index = 0, index_count = 0;    // into indices
    };
    std::vector<Patch> patches;
    // Three per triangle, counted from the first vertex of its patch. A triangle keeps the order of its vertices, and
    // so its provoking vertex.
    std::vector<std::uint16_t> indices;
    std::vector<std::uint32_t> old_from_new;  // the original number of each vertex
};

// The largest draw that Mesa's draw module shades in one piece (22.3, draw_pt_vsplit.c). It must also have 16-bit
// indices, a range given by the program (glDrawRangeElementsBaseVertex) and more indices than vertices. Mesa splits
// other draws into runs of 1,023 indices. Within a run it reuses a vertex until another one with the same number modulo
// 256 replaces it.
inline constexpr std::size_t kPatchIndices = 4096 / 3 * 3;

// Grows patches from triangle to neighbouring triangle. On a grid a patch has about 26 by 26 squares, and the patches
// together have 1.1 times as many vertices as the grid. `indices` has three entries per triangle, all below
// vertex_count. Linear time.
PatchedTriangles patched(std::span<const std::uint32_t> indices, std::size_t vertex_count);

}  // namespace twinlight

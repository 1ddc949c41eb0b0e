// Triangles in another order, so that a driver runs its vertex shader less often for a vertex that several share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twinlight {

struct VertexOrder {
    // Three a triangle, each triangle's in their own order (its provoking vertex stays), into the new vertices.
    std::vector<std::uint32_t> indices;
    // The old number of each new vertex: those that a triangle uses, in the order of their first use.
    std::vector<std::uint32_t> old_from_new;
};

// How Mesa's draw module sees indices (22.3, draw_pt_vsplit.c): runs of this many at most, and within a run a vertex is
// found again as long as no other one with the same number modulo kVertexCacheSize has come.
inline constexpr std::size_t kVertexRunIndices = 1024 / 3 * 3;
inline constexpr std::size_t kVertexCacheSize = 256;

// Patches that grow from triangle to neighbour, each as large as a run: of a grid some 13 by 13 squares, for whose 341
// triangles 200 vertices are enough. `indices` has three for each triangle, all below vertex_count. Linear time.
VertexOrder ordered_for_vertex_cache(std::span<const std::uint32_t> indices, std::size_t vertex_count);

// How many vertices that module shades for a list of triangles.
std::size_t vertices_shaded(std::span<const std::uint32_t> indices);

}  // namespace twinlight

// Triangles grouped into patches for the driver's vertex cache.
#include "scene/shape/vertex_order.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace twinlight::vertex_order_test {
namespace {

std::vector<std::uint32_t> grid(std::uint32_t columns, std::uint32_t rows) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column, c = a + columns + 1;
            for (const std::uint32_t i : {a, c, a + 1, a + 1, c, c + 1}) indices.push_back(i);
        }
    }
    return indices;
}

// How many vertices Mesa's draw module shades for a list of triangles in one draw (docs/performance.md).
std::size_t vertices_shaded_in_runs(std::span<const std::uint32_t> indices) {
    constexpr std::size_t kRun = 1024 / 3 * 3, kCache = 256;
    std::size_t shaded = 0;
    std::array<std::uint32_t, kCache> cache{};
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i % kRun == 0) cache.fill(std::numeric_limits<std::uint32_t>::max());
        std::uint32_t& kept = cache[indices[i] % kCache];
        if (kept != indices[i]) ++shaded;
        kept = indices[i];
    }
    return shaded;
}

TEST(Patches, HoldTheSameTrianglesEachWithItsOwnOrderOfVertices) {
    const std::vector<std::uint32_t> indices = grid(100, 70);
    const PatchedTriangles triangles = patched(indices, 101 * 71);
    using Triangle = std::array<std::uint32_t, 3>;
    std::vector<Triangle> before, after;
    for (std::size_t i = 0; i < indices.size(); i += 3) before.push_back({indices[i], indices[i + 1], indices[i + 2]});
    for (const PatchedTriangles::Patch& patch : triangles.patches) {
        EXPECT_LE(patch.index_count, kPatchIndices);
        EXPECT_LE(patch.vertex_count, patch.index_count);  // otherwise the driver looks up each vertex
        for (std::uint32_t i = 0; i < patch.index_count; i += 3) {
            Triangle triangle{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint16_t index = triangles.indices.at(patch.first_index + i + k);
                ASSERT_LT(index, patch.vertex_count);
                triangle.at(k) = triangles.old_from_new.at(patch.first_vertex + index);
            }
            after.push_back(triangle);
        }
    }
    std::ranges::sort(before);
    std::ranges::sort(after);
    EXPECT_EQ(before, after);
}

// A patch of n by n squares has (n + 1)^2 vertices, for n = 26 that is 1.08 n^2; patches are not quite square.
TEST(Patches, ShadeAVertexHardlyMoreThanOnce) {
    const std::vector<std::uint32_t> indices = grid(512, 256);
    constexpr double kVertices = 513 * 257;
    const double shaded = static_cast<double>(patched(indices, 513 * 257).old_from_new.size());
    const double in_rows = static_cast<double>(vertices_shaded_in_runs(indices));
    fmt::print("{:.3f} times in patches, {:.2f} times in rows\n", shaded / kVertices, in_rows / kVertices);
    EXPECT_LT(shaded / kVertices, 1.12);
    EXPECT_GT(in_rows / kVertices, 3.9);
}

TEST(Patches, TakeMeshesWithoutTriangles) { EXPECT_TRUE(patched({}, 0).patches.empty()); }

}  // namespace
}  // namespace twinlight::vertex_order_test

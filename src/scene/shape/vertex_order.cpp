#include "scene/shape/vertex_order.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <optional>

namespace twinlight {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

// The triangles of each vertex: those of vertex v are triangles[first[v]] to triangles[first[v + 1] - 1].
struct Neighbours {
    Neighbours(std::span<const std::uint32_t> indices, std::size_t vertex_count)
        : first(vertex_count + 1), triangles(indices.size()) {
        for (const std::uint32_t v : indices) ++first[v + 1];
        for (std::size_t v = 0; v < vertex_count; ++v) first[v + 1] += first[v];
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i < indices.size(); ++i)
            triangles[next[indices[i]]++] = static_cast<std::uint32_t>(i / 3);
    }
    std::span<const std::uint32_t> of(std::uint32_t v) const {
        return std::span(triangles).subspan(first[v], first[v + 1] - first[v]);
    }
    std::vector<std::uint32_t> first, triangles;
};

class Grower {
  public:
    Grower(std::span<const std::uint32_t> indices, std::size_t vertex_count)
        : indices_(indices),
          neighbours_(indices, vertex_count),
          patch_of_vertex_(vertex_count, kNone),
          placed_(indices.size() / 3),
          known_(indices.size() / 3) {}

    std::vector<std::uint32_t> triangles() {
        std::vector<std::uint32_t> order;
        order.reserve(placed_.size());
        while (order.size() < placed_.size()) {
            if (order.size() % (kPatchIndices / 3) == 0) begin_patch(order);
            const std::uint32_t triangle = next();
            placed_[triangle] = true;
            order.push_back(triangle);
            for (std::uint32_t i = 0; i < 3; ++i) take(indices_[3 * triangle + i]);
        }
        return order;
    }

  private:
    // The new patch starts with the triangles that the old one would have continued with, so that they are neighbours.
    void begin_patch(const std::vector<std::uint32_t>& order) {
        ++patch_;
        const std::optional<std::uint32_t> start = order.empty() ? std::nullopt : waiting();
        for (auto& queue : queues_) queue.clear();
        if (start) queues_[1].push_back(*start);
    }

    // The triangle that adds the fewest new vertices; of several, the one that has waited longest.
    std::optional<std::uint32_t> waiting() {
        for (std::size_t known = 3; known-- > 0;) {
            std::deque<std::uint32_t>& queue = queues_[known];
            while (!queue.empty()) {
                const std::uint32_t triangle = queue.front();
                queue.pop_front();
                if (!placed_[triangle]) return triangle;
            }
        }
        return {};
    }

    std::uint32_t next() {
        if (const auto triangle = waiting()) return *triangle;
        while (placed_[first_left_]) ++first_left_;
        return first_left_;
    }

    // Adds the vertex to the patch: its triangles now have one more known vertex.
    void take(std::uint32_t vertex) {
        if (patch_of_vertex_[vertex] == patch_) return;
        patch_of_vertex_[vertex] = patch_;
        for (const std::uint32_t triangle : neighbours_.of(vertex)) {
            if (placed_[triangle]) continue;
            auto& [patch, count] = known_[triangle];
            if (patch != patch_) count = 0;
            patch = patch_;
            queues_[std::min<std::size_t>(count++, 2)].push_back(triangle);
        }
    }

    std::span<const std::uint32_t> indices_;
    Neighbours neighbours_;
    std::vector<std::uint32_t> patch_of_vertex_;
    std::vector<bool> placed_;
    // How many vertices of a triangle are in the patch with that number.
    struct Known {
        std::uint32_t patch = 0, count = 0;
    };
    std::vector<Known> known_;
    // Triangles with one, two and three known vertices. Some entries are outdated: placed, or with more known vertices.
    std::array<std::deque<std::uint32_t>, 3> queues_;
    std::uint32_t patch_ = 0, first_left_ = 0;
};

}  // namespace

PatchedTriangles patched(std::span<const std::uint32_t> indices, std::size_t vertex_count) {
    PatchedTriangles result;
    result.indices.reserve(indices.size());
    struct InPatch {
        std::size_t patch = 0;  // the number of patches at that time
        std::uint32_t index = 0;
    };
    std::vector<InPatch> in_patch(vertex_count);
    for (const std::uint32_t triangle : Grower(indices, vertex_count).triangles()) {
        if (result.indices.size() % kPatchIndices == 0) {
            result.patches.push_back({.first_vertex = static_cast<std::uint32_t>(result.old_from_new.size()),
                                      .first_index = static_cast<std::uint32_t>(result.indices.size())});
        }
        PatchedTriangles::Patch& patch = result.patches.back();
        for (const std::uint32_t old : indices.subspan(3 * std::size_t{triangle}, 3)) {
            InPatch& there = in_patch[old];
            if (there.patch != result.patches.size()) {
                there = {result.patches.size(), patch.vertex_count++};
                result.old_from_new.push_back(old);
            }
            result.indices.push_back(static_cast<std::uint16_t>(there.index));
            ++patch.index_count;
        }
    }
    return result;
}

}  // namespace twinlight

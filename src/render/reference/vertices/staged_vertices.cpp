#include "render/reference/vertices/staged_vertices.h"

#include <algorithm>

namespace twinlight::reference {

StagedVertices::StagedVertices(const Draw& draw, const std::vector<bool>& needed) {
    const auto count = static_cast<std::size_t>(std::ranges::count(needed, true));
    if (2 * count >= needed.size()) {
        kept_ = vertex_stage(draw);
        return;
    }
    const VertexStage stage(draw);
    kept_.reserve(count);
    numbers_.reserve(count);
    words_.resize(needed.size() / 64 + 1);
    for (std::size_t i = 0; i < needed.size(); ++i) {
        if (i % 64 == 0) words_[i / 64].before = static_cast<std::uint32_t>(kept_.size());
        if (!needed[i]) continue;
        words_[i / 64].bits |= std::uint64_t{1} << i % 64;
        numbers_.push_back(static_cast<std::uint32_t>(i));
        kept_.push_back(stage(draw.vertices[i]));
    }
}

}  // namespace twinlight::reference

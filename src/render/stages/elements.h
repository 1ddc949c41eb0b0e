// Elements: what of a Draw's vertices is drawn in which order (2.8), in a buffer of the driver's.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/shape/vertex_order.h"
#include "scene/state/frame.h"

namespace twinlight {

// Where the options allow patches (scene/shape/vertex_order.h), and the order of the Draw's triangles is free.
bool may_be_patched(const Draw& draw, const RenderOptions& options);

// Owns its buffer: dies before the context does.
class Elements {
  public:
    // In patches where it may be patched and is large.
    Elements(const Draw& draw, const RenderOptions& options);
    ~Elements();
    Elements(const Elements&) = delete;
    Elements& operator=(const Elements&) = delete;

    // The numbers of the Draw's vertices as the arrays must have them; empty: as they are.
    const std::vector<std::uint32_t>& vertices() const { return patched_.old_from_new; }

    // From the arrays that are enabled. Binds the buffer of indices, where there is one.
    void draw() const;

    std::size_t bytes() const { return bytes_; }  // of the buffer

  private:
    Enum mode_;
    int count_ = 0;
    unsigned indices_ = 0;  // 0: 0, 1, 2, ...
    std::size_t bytes_ = 0;
    PatchedTriangles patched_;
};

// 2.6.2: edge flags count where polygons are drawn as their edges or corners, and only of these.
bool needs_edge_flags(const Draw& draw);

}  // namespace twinlight

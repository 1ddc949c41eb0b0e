// Elements: what of a Draw's vertices is drawn in which order (2.8), in a buffer of the driver's.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/shape/vertex_order.h"
#include "scene/state/frame.h"

namespace twinlight {

// Owns its buffer: dies before the context does.
class Elements {
  public:
    // `patches`: a large mesh goes in patches that suit the driver's vertex cache (scene/shape/vertex_order.h), where the order
    // of its triangles is free. Making them takes as long as some frames: for who draws the same vertices again and again.
    Elements(const Draw& draw, bool patches);
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

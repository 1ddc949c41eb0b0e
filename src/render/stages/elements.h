// Elements: which of a Draw's vertices are drawn, in which order (2.8), in a buffer of the driver.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/shape/vertex_order.h"
#include "scene/state/frame.h"

namespace twinlight {

// Owns its buffer, so it must be destroyed before the context.
class Elements {
  public:
    // `patches`: draws a large mesh in patches that suit the driver's vertex cache (scene/shape/vertex_order.h), if the
    // order of its triangles is free. Making patches takes as long as a few frames, so it pays for vertices that are
    // drawn many times.
    Elements(const Draw& draw, bool patches);
    ~Elements();
    Elements(const Elements&) = delete;
    Elements& operator=(const Elements&) = delete;

    // The order in which the arrays must have the Draw's vertices; empty: unchanged.
    const std::vector<std::uint32_t>& vertices() const { return patched_.old_from_new; }

    // Draws from the enabled arrays. Binds the index buffer, if there is one.
    void draw() const;

    std::size_t bytes() const { return bytes_; }  // size of the buffer

  private:
    Enum mode_;
    int count_ = 0;
    unsigned indices_ = 0;  // 0: 0, 1, 2, ...
    std::size_t bytes_ = 0;
    PatchedTriangles patched_;
};

// 2.6.2: edge flags matter only if polygons are drawn as edges or corners; strips and fans ignore them.
bool needs_edge_flags(const Draw& draw);

}  // namespace twinlight

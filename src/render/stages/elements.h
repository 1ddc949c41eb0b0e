// Elements: which of a Draw's vertices are drawn, in which order (2.8), in a buffer of the driver.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/frame/frame.h"
#include "scene/shape/vertex_order.h"

namespace twinlight {

// Draws that are uploaded together: the vertices of each follow those of the one before, and so do the indices.
struct ElementsPart {
    Enum mode = kGL_TRIANGLES;
    std::size_t vertices = 0, indices = 0;  // how many
    bool cuts_quads = false;                // see cuts_quadrilaterals()
    bool begins_range = false;              // a range of parts that are drawn apart from those before

    friend bool operator==(const ElementsPart&, const ElementsPart&) = default;
};

// Owns its buffer, so it must be destroyed before the context.
class Elements {
  public:
    // `patches`: draws a large mesh in patches that suit the driver's vertex cache (scene/shape/vertex_order.h), if the
    // order of its triangles is free. Making patches takes as long as a few frames, so it pays for vertices that are
    // drawn many times.
    Elements(const Draw& draw, bool patches);
    // The Draw has the vertices of all parts. Either all parts have indices, which count its vertices, or none has.
    Elements(const Draw& draw, const std::vector<ElementsPart>& parts);
    ~Elements();
    Elements(const Elements&) = delete;
    Elements& operator=(const Elements&) = delete;

    // The order in which the arrays must have the Draw's vertices; empty: unchanged.
    const std::vector<std::uint32_t>& vertices() const { return patched_.old_from_new; }

    // Draws a range of the parts, or all if no part begins one, from the enabled arrays. Binds the index buffer, if there is one.
    void draw(std::size_t range = 0) const;

    std::size_t bytes() const { return bytes_; }  // size of the buffer

  private:
    // Primitives of one mode that are drawn by one command.
    struct Run {
        Enum mode;
        std::vector<int> firsts, counts;
        std::vector<const void*> offsets;  // of the indices, in bytes; empty if there are none
    };
    void draw_runs(std::size_t range) const;

    Enum mode_;
    int count_ = 0;
    std::vector<Run> runs_;            // empty: one part
    std::vector<std::size_t> ranges_;  // the first run of each
    unsigned indices_ = 0;             // 0: 0, 1, 2, ...
    std::size_t bytes_ = 0;
    PatchedTriangles patched_;
};

// Whether filled quadrilaterals are drawn as triangles, cut from the second corner to the fourth. Mesa does so with those
// in display lists, but draws others from the first corner to the third; 2.6.1 allows both. With the same cut, fixed
// function and shaders give the same colours.
bool cuts_quadrilaterals(const Draw& draw);
std::vector<std::uint32_t> cut_indices(const Draw& draw);  // the indices of those triangles

// 2.6.2: edge flags matter only if polygons are drawn as edges or corners; strips and fans ignore them.
bool needs_edge_flags(const Draw& draw);

}  // namespace twinlight

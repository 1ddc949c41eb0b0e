// A Draw's primitives for WebGL 2. What OpenGL ES lacks of lines and of polygons' borders is drawn as rectangles: wide and stippled
// lines (GL 2.1, sections 3.4.2.1 and 3.4.2.2), edges with a depth offset (3.5.5), and the edges and corners of back faces, which
// have two sides only as triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight::webgl {

struct Part {
    Enum mode = kGL_TRIANGLES;
    std::vector<std::uint32_t> indices{};  // into the Draw's vertices, or into `vertices`
    // Of rectangles, the Draw's vertices that their corners have their values from, with programmable::line_attributes(): the
    // way from the vertex to the corner, the visible ends, and how the fragments of stippled lines are counted.
    std::vector<std::uint32_t> vertices{};
    std::vector<float> line_attributes{};
    bool counts = false;      // of lines of a Draw with a line stipple
    bool shows_ends = false;  // of lines some of which are partly outside the view volume

    bool is_widened() const { return !vertices.empty(); }
};

// flat: each triangle's last vertex gives its colour. two_side: back faces have colours of their own.
std::vector<Part> parts_of(const Draw& draw, bool flat, bool two_side);

}  // namespace twinlight::webgl

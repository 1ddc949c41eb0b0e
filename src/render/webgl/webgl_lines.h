// A Draw's primitives for WebGL 2. What OpenGL ES lacks of lines, points and polygons' borders is drawn as rectangles
// (programmable/shaders/rectangles.glsl): wide, stippled and smooth lines (GL 2.1, section 3.4.2), edges with a depth offset (3.5.5),
// and the edges and corners of back faces, which have two sides only as triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "render/programmable/numbers/form.h"
#include "scene/frame/frame.h"

namespace twinlight::webgl {

struct PartOptions {
    bool flat = false;          // each triangle's last vertex gives its colour
    bool flat_edges = false;    // edges and corners have the colours of their polygons' provoking vertices
    bool two_side = false;      // back faces have colours or a stencil test of their own
    bool for_any_pose = false;  // also lines that are not visible now
};

struct Part {
    Enum mode = kGL_TRIANGLES;
    std::vector<std::uint32_t> indices{};  // into the Draw's vertices, or into `vertices`
    programmable::Rectangles rectangles = programmable::Rectangles::kNone;
    // Of rectangles: for each corner the Draw's vertex that it has its values from, for lines also the vertex at the other end, and
    // the rest of programmable::line_attributes().
    std::vector<std::uint32_t> vertices{}, others{};
    std::vector<float> corners{};
    // Of edges and corners of flat polygons, which have `vertices` too: those that give the colours.
    std::vector<std::uint32_t> colors_from{};
    bool counts = false;     // lines of a Draw with a line stipple
    bool is_smooth = false;  // lines or points

    bool has_vertices() const { return !vertices.empty(); }
    bool has_rectangles() const { return rectangles != programmable::Rectangles::kNone; }
};

struct Parts {
    std::vector<Part> parts{};  // in their order
    bool loses_order = false;   // faces, edges and corners follow each other too often to be parts of their own
    bool lacks_clipped =
        false;  // edges or corners that clipping adds to polygons (2.12), which Mesa does not draw either
};
Parts parts_of(const Draw& draw, const PartOptions& options);

}  // namespace twinlight::webgl

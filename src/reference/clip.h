// Clipping to the view volume (2.12): -w <= x, y, z <= w, in clip coordinates.
//
// In: the clip positions of a primitive. Out: what of it lies in the volume, as convex polygon, piece of a
// line or point, together with the weights of the primitive's own vertices there. All attributes are linear
// in clip space, so the weights are all that interpolation needs, and a flat colour is not touched (2.14.8).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace twinlight::reference {

// Where an edge of a clipped polygon comes from.
enum class EdgeOrigin : std::uint8_t {
    kBoundary,  // the border of what glBegin's primitive type describes
    kInner,     // the cut between two triangles of one quadrilateral or polygon
    kNearFar,   // the near or far plane
    kSide,      // one of the four sides of the view volume
};

struct ClipVertex {
    glm::dvec4 position_clip{0};
    glm::dvec3 weights{0};                         // of the primitive's vertices
    EdgeOrigin edge_to_next = EdgeOrigin::kInner;  // of the edge from this vertex to the next one
};

bool inside_view_volume(const glm::dvec4& position_clip);

// Fewer than three vertices: nothing is left. The edges that clipping adds are boundary edges by 2.12 (Mesa
// leaves them out of lines); their origin says which they are.
std::vector<ClipVertex> clip_polygon(std::span<const ClipVertex> polygon);

// The part of the line that is inside: two vertices, or none.
std::vector<ClipVertex> clip_line(const ClipVertex& from, const ClipVertex& to);

}  // namespace twinlight::reference

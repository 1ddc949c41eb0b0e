// Clipping (2.12): to the view volume -w <= x, y, z <= w of clip coordinates, and to the half-spaces of the enabled
// clip planes, which stand in eye coordinates.
//
// In: the positions of a primitive. Out: what of it lies inside, as convex polygon, piece of a line or point, together
// with the weights of the primitive's own vertices there. All attributes are linear in clip space, so the weights are
// all that interpolation needs, and a flat colour is not touched (2.14.8).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight::reference {

// Where an edge of a clipped polygon comes from.
enum class EdgeOrigin : std::uint8_t {
    kBoundary,   // the border of what glBegin's primitive type describes
    kInner,      // of the cut between two triangles of one quadrilateral or polygon, or with its edge flag false
    kNearFar,    // the near or far plane
    kSide,       // one of the four sides of the view volume
    kClipPlane,  // one of glClipPlane's
};

struct ClipVertex {
    glm::dvec4 position_clip{0};
    glm::dvec4 position_eye{0};
    glm::dvec3 weights{0};                         // of the primitive's vertices
    EdgeOrigin edge_to_next = EdgeOrigin::kInner;  // of the edge from this vertex to the next one
};

class ClipVolume {
  public:
    explicit ClipVolume(const RasterState& raster);

    bool contains(const ClipVertex& v) const;
    // Fewer than three vertices: nothing is left. The edges that clipping adds are boundary edges by 2.12 (Mesa leaves
    // them out of lines); their origin says which they are.
    std::vector<ClipVertex> polygon(std::span<const ClipVertex> polygon) const;
    // The part of the line that is inside: two vertices, or none.
    std::vector<ClipVertex> line(const ClipVertex& from, const ClipVertex& to) const;

  private:
    struct Plane {  // inside where the dot products add up to no negative number
        glm::dvec4 normal_clip, normal_eye;
        EdgeOrigin origin;

        double signed_distance(const ClipVertex& v) const;
    };
    std::vector<Plane> planes_;
};

}  // namespace twinlight::reference

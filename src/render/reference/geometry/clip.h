// Clipping (2.12): to the view volume -w <= x, y, z <= w in clip coordinates, and to the half-spaces of the enabled
// clip planes in eye coordinates.
//
// In: the positions of a primitive. Out: the part inside, as a convex polygon, part of a line, or point, with the
// weights of the primitive's vertices at each corner. All attributes are linear in clip space, so interpolation needs
// only these weights. Flat colours are not changed (2.14.8).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight::reference {

// The origin of a clipped polygon's edge.
enum class EdgeOrigin : std::uint8_t {
    kBoundary,   // a boundary edge of the primitive given to glBegin
    kInner,      // between two triangles of one quadrilateral or polygon, or with edge flag false
    kNearFar,    // the near or far plane
    kSide,       // one of the four sides of the view volume
    kClipPlane,  // one of glClipPlane's
};

struct ClipVertex {
    glm::dvec4 position_clip{0};
    glm::dvec4 position_eye{0};
    glm::dvec3 weights{0};                         // weights of the primitive's vertices
    EdgeOrigin edge_to_next = EdgeOrigin::kInner;  // the edge from this vertex to the next
};

class ClipVolume {
  public:
    explicit ClipVolume(const RasterState& raster);

    // The volume without the planes that the whole primitive lies in, as far as single precision can tell; nullopt if
    // there are none.
    std::optional<ClipVolume> without_planes_of(std::span<const ClipVertex> primitive) const;

    bool contains(const ClipVertex& v) const;
    // The part inside; fewer than three vertices mean nothing is left. By 2.12 the edges that clipping adds are
    // boundary edges (Mesa does not draw them as lines); their origin tells them apart.
    std::vector<ClipVertex> polygon(std::span<const ClipVertex> polygon) const;
    // The part of the line that is inside: two vertices, or none.
    std::vector<ClipVertex> line(const ClipVertex& from, const ClipVertex& to) const;

  private:
    struct Plane {  // inside if the sum of the dot products is at least 0
        glm::dvec4 normal_clip, normal_eye;
        EdgeOrigin origin;

        double signed_distance(const ClipVertex& v) const;
    };
    std::vector<Plane> planes_;
};

}  // namespace twinlight::reference

// How far a mesh is from the curved surface that it approximates.
#pragma once

#include <cstddef>

#include "scene/frame/frame.h"

namespace twinlight::session {

struct MeshError {
    bool has_surfaces = false;  // false: the mesh itself is the shape
    double distance = 0;        // the largest, in object coordinates
    double of_size = 0;         // the same as a share of the mesh's largest half width
};

// The error of the Draws `first` to `first + count - 1` of the frame, which are one shape. Measured at the middles of edges
// and triangles, where a mesh is farthest from its surface.
MeshError mesh_error(const Frame& frame, std::size_t first, std::size_t count);

}  // namespace twinlight::session

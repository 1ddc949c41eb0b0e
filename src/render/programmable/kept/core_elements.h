// The elements of a Draw in the primitives of core GL.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight::programmable {

// The mode and the indices of its vertices. Core GL has no quadrilaterals and polygons: they become triangles. The last
// vertex of a triangle gives a flat colour; it is the vertex that gives the colour of the quadrilateral or polygon
// (table 2.12). Unless `flat`, quadrilaterals are cut from the first corner to the third, as llvmpipe does.
std::pair<Enum, std::vector<std::uint32_t>> core_elements(const Draw& draw, bool flat);

}  // namespace twinlight::programmable

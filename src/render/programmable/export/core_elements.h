// The elements, point sizes and texels of Draws as exported files and the page for browsers take them.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <utility>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight::programmable {

using CoreElements = std::pair<Enum, std::vector<std::uint32_t>>;  // the mode, and the indices of the vertices

// Core GL has no quadrilaterals and polygons: they become triangles. The last
// vertex of a triangle gives a flat colour; it is the vertex that gives the colour of the quadrilateral or polygon
// (table 2.12). Unless `flat`, quadrilaterals are cut from the first corner to the third, as llvmpipe does.
CoreElements core_elements(const Draw& draw, bool flat);
// The same primitives as points, lines or triangles, one by one, with the same last vertices.
CoreElements separate_elements(CoreElements elements);

// glPointSize's size in pixels, without attenuation (3.3).
double point_size(const Draw& draw);

// Red in the lowest byte, alpha in the highest: the bytes of GL_RGBA and GL_UNSIGNED_BYTE.
std::uint32_t texel_word(const glm::vec4& texel);

}  // namespace twinlight::programmable

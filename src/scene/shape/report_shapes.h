// The shapes of the course report, `#pragma twinlight shape(kind, sizes...)`. The axis is y; all triangles are
// counter-clockwise seen from outside. Lengths are in object units.
#pragma once

#include <vector>

#include "scene/shape/shape.h"

namespace twinlight {

// 12 triangles without shared vertices (GL_TRIANGLES), centred at the origin.
std::vector<ShapePart> report_cube(double size);

// From y = 0 to y = height. Each cap is a GL_TRIANGLE_FAN around its centre, the side is one GL_TRIANGLE_STRIP.
std::vector<ShapePart> report_cylinder(double radius, double height, int slices);

// The same cylinder, but with the side that the report shows as wrong (its figure 3): separate triangles
// (GL_TRIANGLES), each with a single normal, the mean of the correct normals of its corners. Of the two triangles of a
// slice, one has two corners on the left border and the other two on the right, so their normals lean to different
// sides and the shading looks like teeth.
std::vector<ShapePart> report_cylinder_triangles(double radius, double height, int slices);

// The centre of the base is at the origin, the apex at (0, height, 0); each is the centre of a fan. The side's normals
// have the slope radius / height. The apex is one vertex, so its normal is the mean of all of them: the axis.
std::vector<ShapePart> report_cone(double radius, double height, int slices);

// Centred at the origin: a fan around each pole, strips between them. The normals are exact.
std::vector<ShapePart> report_sphere(double radius, int slices, int stacks);

}  // namespace twinlight

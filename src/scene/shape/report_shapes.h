// The constructions of the course report, `#pragma twinlight shape(kind, sizes...)`: y is the axis, every
// triangle faces outward counter-clockwise.
#pragma once

#include <vector>

#include "scene/shape/shape.h"

namespace twinlight {

// 12 GL_TRIANGLES that share no vertex, centred at the origin.
std::vector<ShapePart> report_cube(double size);

// From y = 0 to y = height: two caps of GL_TRIANGLE_FAN, centre first, and the side of one GL_TRIANGLE_STRIP.
std::vector<ShapePart> report_cylinder(double radius, double height, int slices);

// The same cylinder with the side that the report calls wrong (its figure 3): GL_TRIANGLES that share no
// vertex, each with one normal, the mean of the normals that its own corners would have. The two triangles of
// a slice have two corners on different borders of it, so their normals lean to different sides, and the
// shading is a row of teeth.
std::vector<ShapePart> report_cylinder_triangles(double radius, double height, int slices);

// Base centre at the origin, apex at (0, height, 0): a fan around each. The side's normals rise by radius /
// height; the apex, which one vertex stands for, has the mean of them all, the axis.
std::vector<ShapePart> report_cone(double radius, double height, int slices);

// Centred at the origin: a fan around each pole, strips between; the normals are the sphere's own.
std::vector<ShapePart> report_sphere(double radius, int slices, int stacks);

}  // namespace twinlight

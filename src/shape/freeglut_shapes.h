// What freeglut 3.4 sends for its glutSolid* and glutWire* shapes.
#pragma once

#include <vector>

#include "shape/shape.h"

namespace twinlight {

// Lengths in object units; `wire` chooses glutWire*. Counts that freeglut does nothing for give no parts. So
// do negative counts, for which freeglut stops the program or writes outside its arrays.
std::vector<ShapePart> freeglut_sphere(double radius, int slices, int stacks, bool wire);
std::vector<ShapePart> freeglut_cube(double size, bool wire);
std::vector<ShapePart> freeglut_cone(double base, double height, int slices, int stacks, bool wire);
std::vector<ShapePart> freeglut_cylinder(double radius, double height, int slices, int stacks, bool wire);
std::vector<ShapePart> freeglut_torus(double inner_radius, double outer_radius, int sides, int rings, bool wire);

}  // namespace twinlight

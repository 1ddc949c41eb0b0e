// The vertices that freeglut 3.4 sends for its glutSolid* and glutWire* shapes.
#pragma once

#include <vector>

#include "scene/shape/shape.h"

namespace twinlight {

// Lengths are in object units; `wire` chooses glutWire*. Counts for which freeglut draws nothing give no parts. So do
// negative counts, for which freeglut stops the program or writes outside its arrays. These can be large, so each part is taken when
// it is made (TakePart).
void freeglut_sphere(double radius, int slices, int stacks, bool wire, const TakePart& take);
void freeglut_cone(double base, double height, int slices, int stacks, bool wire, const TakePart& take);
void freeglut_cylinder(double radius, double height, int slices, int stacks, bool wire, const TakePart& take);
void freeglut_torus(double inner_radius, double outer_radius, int sides, int rings, bool wire, const TakePart& take);

// Solids with flat faces. Corners are at distance 1 from the origin, for the dodecahedron at sqrt(3); not so for the
// cube.
std::vector<ShapePart> freeglut_cube(double size, bool wire);
std::vector<ShapePart> freeglut_tetrahedron(bool wire);
std::vector<ShapePart> freeglut_octahedron(bool wire);
std::vector<ShapePart> freeglut_dodecahedron(bool wire);
std::vector<ShapePart> freeglut_icosahedron(bool wire);
std::vector<ShapePart> freeglut_rhombic_dodecahedron(bool wire);
// 4^levels tetrahedra; none for negative levels.
std::vector<ShapePart> freeglut_sponge(int levels, const glm::dvec3& offset, double scale, bool wire);

// Newell's tea set. Of freeglut's solids only these have texture coordinates: (0,0) to (1,1) on each patch.
std::vector<ShapePart> freeglut_teapot(double size, bool wire);
std::vector<ShapePart> freeglut_teacup(double size, bool wire);
std::vector<ShapePart> freeglut_teaspoon(double size, bool wire);

}  // namespace twinlight

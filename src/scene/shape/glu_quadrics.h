// The vertices that GLU sends for gluSphere, gluCylinder, gluDisk and gluPartialDisk.
#pragma once

#include <vector>

#include "scene/shape/quadric.h"
#include "scene/shape/shape.h"

namespace twinlight {

// Lengths are in object units, angles in degrees. They throw std::invalid_argument with a message for arguments that
// GLU refuses with GLU_INVALID_VALUE, and ShapeTooLarge for shapes beyond the limits of shape.h.
std::vector<ShapePart> glu_sphere(const Quadric& quadric, double radius, int slices, int stacks);
std::vector<ShapePart> glu_cylinder(const Quadric& quadric, double base, double top, double height, int slices,
                                    int stacks);
std::vector<ShapePart> glu_disk(const Quadric& quadric, double inner, double outer, int slices, int loops);
std::vector<ShapePart> glu_partial_disk(const Quadric& quadric, double inner, double outer, int slices, int loops,
                                        double start_deg, double sweep_deg);

}  // namespace twinlight

// The parts of shapes to the driver, in floats: as freeglut sends them, and as GLU does.
#pragma once

#include <vector>

#include "scene/shape/shape.h"

namespace twinlight::fixed {

// By vertex arrays. The program's own arrays and buffer objects neither take part in it nor change. RULING: freeglut's
// drawing would read those that are enabled, past their end where they are shorter than the shape.
void draw_by_arrays(const std::vector<ShapePart>& parts);

// Between glBegin and glEnd.
void draw_immediately(const std::vector<ShapePart>& parts);

}  // namespace twinlight::fixed

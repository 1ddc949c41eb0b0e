// Sends the parts of shapes to the driver, in floats, as freeglut and GLU do.
#pragma once

#include <vector>

#include "scene/shape/shape.h"

namespace twinlight::fixed {

// The parts of a command, by vertex arrays. Neither function uses or changes the program's own arrays and buffer objects.
// RULING: freeglut would also read the program's enabled arrays, past their end if they are shorter than the shape.
void draw_by_arrays(const Command& command);

// Between glBegin and glEnd.
void draw_immediately(const std::vector<ShapePart>& parts);

}  // namespace twinlight::fixed

// Shapes as the primitives that the libraries send: freeglut's glutSolid*/glutWire*, and the report's own
// constructions (`#pragma twinlight shape(...)`). Orientation and order are the libraries', so the provoking
// vertices are too; tests/window/freeglut_shapes_test.cpp records what freeglut really sends and compares.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/command.h"

namespace twinlight {

struct ShapeVertex {
    glm::dvec3 position_object;
    glm::dvec3 normal_object;
};

// One batch: a primitive type and its vertices, in the order they are sent.
struct ShapePart {
    Enum mode = kGL_TRIANGLES;
    std::vector<ShapeVertex> vertices;
    std::vector<std::uint32_t> indices;  // empty: 0, 1, 2, ...
};

inline constexpr std::size_t kMaxShapeVertices = 50'000'000;

// The parts of a SHAPE_COMMAND or of the pragma `shape`. Object space, units of the arguments. Arguments that
// the library does nothing for (no slices, a negative count) give no parts. Throws std::invalid_argument with
// a message for sizes beyond kMaxShapeVertices, wrong word or count of the pragma.
std::vector<ShapePart> shape_parts(const Command& command);

}  // namespace twinlight

// Shapes as the primitives that the libraries send: freeglut's glutSolid*/glutWire*, GLU's quadrics
// (glu_quadrics.h), and the report's own constructions (`#pragma twinlight shape(...)`). Orientation and order are the
// libraries', so the provoking vertices are too; tests/window records what the libraries really send and compares.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/command/command.h"

namespace twinlight {

struct ShapeVertex {
    glm::dvec3 position_object;
    glm::dvec3 normal_object;
    glm::dvec2 tex_coord{0, 0};  // s and t; r is 0, q is 1
};

// One batch: a primitive type and its vertices, in the order they are sent.
struct ShapePart {
    Enum mode = kGL_TRIANGLES;
    std::vector<ShapeVertex> vertices;
    std::vector<std::uint32_t> indices;  // empty: 0, 1, 2, ...

    // The vertices before this one are sent without a normal: the current one is theirs.
    std::size_t first_normal = 0;
    // Whether vertices are sent with texture coordinates; otherwise the current one is theirs.
    bool sends_tex_coords = false;
    // Sent between glBegin and glEnd, so that the last normal and texture coordinate stay current; else by vertex
    // arrays, which leave the current ones alone.
    bool immediate = false;
};

// Limits on untrusted counts. A part becomes a Draw of its own, with a copy of the state.
inline constexpr std::size_t kMaxShapeVertices = 8'000'000;
inline constexpr std::size_t kMaxShapeParts = 1 << 16;

struct ShapeTooLarge : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

// Throws ShapeTooLarge where a shape of so many slices and stacks (sides and rings, slices and loops) would go beyond these
// limits.
void limit_shape(std::string_view name, double slices, double stacks);

// The parts of a SHAPE_COMMAND or of the pragma `shape`. Object space, units of the arguments. Arguments that
// the library does nothing for (no slices, a negative count) give no parts. Throws std::invalid_argument with
// a message for sizes beyond the limits, wrong word or count of the pragma.
std::vector<ShapePart> shape_parts(const Command& command);

}  // namespace twinlight

// Shapes as primitives: freeglut's glutSolid* and glutWire*, GLU's quadrics (glu_quadrics.h), and the course report's
// shapes (`#pragma twinlight shape(...)`). Orientation and order are the same as in the libraries, and so are the
// provoking vertices; tests/window compares them with what the libraries really send.
#pragma once

#include <cstdint>
#include <functional>
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

// One batch: a primitive type and its vertices in drawing order.
struct ShapePart {
    Enum mode = kGL_TRIANGLES;
    std::vector<ShapeVertex> vertices;
    std::vector<std::uint32_t> indices;  // empty: 0, 1, 2, ...

    // Vertices before this one are sent without a normal and get the current one.
    std::size_t first_normal = 0;
    // Whether vertices are sent with texture coordinates; otherwise they get the current ones.
    bool sends_tex_coords = false;
    // True if sent between glBegin and glEnd, so the last normal and texture coordinate become current. False if sent
    // by vertex arrays, which do not change the current values.
    bool immediate = false;
};

// Limits on untrusted counts. Each part becomes a separate Draw with a copy of the state.
inline constexpr std::size_t kMaxShapeVertices = 8'000'000;
inline constexpr std::size_t kMaxShapeParts = 1 << 16;

struct ShapeTooLarge : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

// Throws ShapeTooLarge if a shape with this many slices and stacks (or sides and rings, or slices and loops) would
// exceed these limits.
void limit_shape(std::string_view name, double slices, double stacks);

// The parts of a SHAPE_COMMAND or of the pragma `shape`, in object space and in the units of the arguments. Arguments
// for which the library draws nothing (no slices, a negative count) give no parts. Throws std::invalid_argument with a
// message if a size exceeds the limits, or if the pragma has a wrong word or a wrong number of sizes.
std::vector<ShapePart> shape_parts(const Command& command);
// The same, each part as soon as it is made, until `take` returns false. A large shape needs half of the memory so.
using TakePart = std::function<bool(ShapePart&& part)>;
void for_each_part(const Command& command, const TakePart& take);

}  // namespace twinlight

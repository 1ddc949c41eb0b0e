// Which construction a command asks for, and the checks that stand before it.
#include "shape/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shape/freeglut_shapes.h"
#include "shape/report_shapes.h"

namespace twinlight {
namespace {

template <class... Parts>
[[noreturn]] void refuse(fmt::format_string<Parts...> message, Parts&&... parts) {
    throw std::invalid_argument(fmt::format(message, std::forward<Parts>(parts)...));
}

// A solid sends about two vertices for each of slices * stacks; in double, where nothing overflows.
void limit_vertices(std::string_view name, double slices, double stacks) {
    constexpr double kCapStacks = 3;  // both caps of a cylinder, and the closing of each turn
    if (2 * (slices + 1) * (stacks + kCapStacks) <= static_cast<double>(kMaxShapeVertices)) return;
    refuse("{} would have more than {} vertices; give it fewer slices or stacks", name, kMaxShapeVertices);
}

// ---- The pragma: shape(kind, sizes...) ----

// The sizes after the kind, checked against what the usage names.
class Sizes {
  public:
    Sizes(const Command& command, std::string_view usage, std::size_t expected) : command_(command), usage_(usage) {
        const std::size_t given = command.arguments.size() - 1;
        if (given != expected) refuse("sizes given: {}; write shape({})", given, usage_);
    }

    double length(std::size_t i, std::string_view name) const {
        const double value = command_.number(i);
        if (value > 0 && std::isfinite(value)) return value;
        refuse("{} of shape({}) is {}; it must be greater than 0", name, usage_, value);
    }

    int count(std::size_t i, std::string_view name, int least) const {
        const double value = command_.number(i);
        if (!(value >= least) || value != std::floor(value)) {
            refuse("{} of shape({}) is {}; it must be a whole number, {} or more", name, usage_, value, least);
        }
        limit_vertices(fmt::format("shape({})", usage_), value, 1);
        return static_cast<int>(value);
    }

  private:
    const Command& command_;
    std::string_view usage_;
};

constexpr std::string_view kKinds = "cube, cylinder, cylinder_triangles, cone or sphere";
constexpr int kLeastSlices = 3;  // fewer enclose nothing
constexpr int kLeastStacks = 2;

// cylinder, cylinder_triangles and cone have the same sizes.
std::vector<ShapePart> tall_shape(const Command& command, std::string_view usage,
                                  std::vector<ShapePart> construct(double radius, double height, int slices)) {
    const Sizes sizes(command, usage, 3);
    return construct(sizes.length(1, "radius"), sizes.length(2, "height"), sizes.count(3, "slices", kLeastSlices));
}

std::vector<ShapePart> pragma_shape(const Command& command) {
    if (command.arguments.empty()) refuse("shape needs a kind: {}", kKinds);
    switch (command.word(0)) {
        case Word::cube: return report_cube(Sizes(command, "cube, size", 1).length(1, "size"));
        case Word::cylinder: return tall_shape(command, "cylinder, radius, height, slices", report_cylinder);
        case Word::cylinder_triangles:
            return tall_shape(command, "cylinder_triangles, radius, height, slices", report_cylinder_triangles);
        case Word::cone: return tall_shape(command, "cone, radius, height, slices", report_cone);
        case Word::sphere: {
            constexpr std::string_view kUsage = "sphere, radius, slices, stacks";
            const Sizes sizes(command, kUsage, 3);
            const int slices = sizes.count(2, "slices", kLeastSlices);
            const int stacks = sizes.count(3, "stacks", kLeastStacks);
            limit_vertices("shape(sphere)", slices, stacks);
            return report_sphere(sizes.length(1, "radius"), slices, stacks);
        }
        case Word::half_vector:
        case Word::reflection:
        case Word::attenuated:
        case Word::unattenuated: break;
    }
    refuse("{} is no shape; a shape is {}", word_name(command.word(0)), kKinds);
}

// ---- freeglut's ----

std::vector<ShapePart> freeglut_shape(const Command& command) {
    const auto number = [&](std::size_t i) { return command.number(i); };
    const auto count = [&](std::size_t i) { return static_cast<int>(command.number(i)); };

    const CommandId id = command.id;
    if (id == CommandId::glutSolidCube || id == CommandId::glutWireCube) {
        return freeglut_cube(number(0), id == CommandId::glutWireCube);
    }
    // Of all others the last two arguments are the counts.
    const std::size_t counts = command.arguments.size() - 2;
    limit_vertices(command.name(), std::max(number(counts), 0.0), std::max(number(counts + 1), 0.0));
    if (id == CommandId::glutSolidSphere || id == CommandId::glutWireSphere) {
        return freeglut_sphere(number(0), count(1), count(2), id == CommandId::glutWireSphere);
    }
    if (id == CommandId::glutSolidCone || id == CommandId::glutWireCone) {
        return freeglut_cone(number(0), number(1), count(2), count(3), id == CommandId::glutWireCone);
    }
    if (id == CommandId::glutSolidCylinder || id == CommandId::glutWireCylinder) {
        return freeglut_cylinder(number(0), number(1), count(2), count(3), id == CommandId::glutWireCylinder);
    }
    if (id == CommandId::glutSolidTorus || id == CommandId::glutWireTorus) {
        return freeglut_torus(number(0), number(1), count(2), count(3), id == CommandId::glutWireTorus);
    }
    refuse("{} draws no shape", command.name());
}

}  // namespace

std::vector<ShapePart> shape_parts(const Command& command) {
    return command.id == CommandId::pragma_shape ? pragma_shape(command) : freeglut_shape(command);
}

}  // namespace twinlight

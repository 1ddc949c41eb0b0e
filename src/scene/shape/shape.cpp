// Chooses the shape for a command and checks its arguments.
#include "scene/shape/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/translation.h"
#include "scene/shape/freeglut_shapes.h"
#include "scene/shape/report_shapes.h"

namespace twinlight {
namespace {

template <class... Parts>
[[noreturn]] void refuse(fmt::format_string<Parts...> message, Parts&&... parts) {
    throw std::invalid_argument(vtr(message, fmt::make_format_args(parts...)));
}

// ---- The pragma: shape(kind, sizes...) ----

// The sizes after the kind. `usage` names them for messages.
class Sizes {
  public:
    Sizes(const Command& command, std::string_view usage, std::size_t expected) : command_(command), usage_(usage) {
        const std::size_t given = command.arguments.size() - 1;
        if (given != expected)
            refuse("shape({}) needs {}, not {}", usage_, expected == 1 ? tr("1 size") : tr("{} sizes", expected),
                   given);
    }

    double length(std::size_t i, std::string_view name) const {
        const double value = command_.number(i);
        if (value > 0 && std::isfinite(value)) return value;
        refuse("{} of shape({}) is {}; it must be greater than 0", name, usage_, value);
    }

    int count(std::size_t i, std::string_view name, int least) const {
        const double value = command_.number(i);
        if (!(value >= least) || value != std::floor(value)) {
            refuse("{} of shape({}) is {}; it must be a whole number of {} or more", name, usage_, value, least);
        }
        limit_shape(fmt::format("shape({})", usage_), value, 1);
        return static_cast<int>(value);
    }

  private:
    const Command& command_;
    std::string_view usage_;
};

constexpr std::string_view kKinds = "cube, cylinder, cylinder_triangles, cone or sphere";
constexpr int kLeastSlices = 3;  // fewer do not enclose a volume
constexpr int kLeastStacks = 2;

// cylinder, cylinder_triangles and cone have the same sizes.
std::vector<ShapePart> tall_shape(const Command& command, std::string_view usage,
                                  std::vector<ShapePart> construct(double radius, double height, int slices)) {
    const Sizes sizes(command, usage, 3);
    return construct(sizes.length(1, "radius"), sizes.length(2, "height"), sizes.count(3, "slices", kLeastSlices));
}

std::vector<ShapePart> pragma_shape(const Command& command) {
    if (command.arguments.empty()) refuse("shape needs a kind: {}", tr(kKinds));
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
            limit_shape("shape(sphere)", slices, stacks);
            return report_sphere(sizes.length(1, "radius"), slices, stacks);
        }
        default: break;  // a word for other pragmas
    }
    refuse("{} is not a shape; expected {}", word_name(command.word(0)), tr(kKinds));
}

// ---- freeglut's ----

// A tetrahedron has 12 vertices and 4 faces; each level multiplies the number of tetrahedra by 4.
void limit_sponge(std::string_view name, double levels, bool wire) {
    const double tetrahedra = std::exp2(2 * levels);
    if (12 * tetrahedra <= static_cast<double>(kMaxShapeVertices) &&
        (!wire || 4 * tetrahedra <= static_cast<double>(kMaxShapeParts))) {
        return;
    }
    refuse("{} with {} levels would have {:.3g} tetrahedra; use fewer levels", name, levels, tetrahedra);
}

void take_all(std::vector<ShapePart> parts, const TakePart& take) {
    for (ShapePart& part : parts)
        if (!take(std::move(part))) return;
}

// The command's name is "glutSolid" or "glutWire" and the kind of shape.
void freeglut_shape(const Command& command, const TakePart& take) {
    constexpr std::string_view kSolid = "glutSolid", kWire = "glutWire";
    const bool wire = command.name().starts_with(kWire);
    const std::string_view kind = command.name().substr(wire ? kWire.size() : kSolid.size());
    const auto number = [&](std::size_t i) { return command.number(i); };
    const auto count = [&](std::size_t i) { return static_cast<int>(command.number(i)); };

    if (kind == "Cube") return take_all(freeglut_cube(number(0), wire), take);
    if (kind == "Tetrahedron") return take_all(freeglut_tetrahedron(wire), take);
    if (kind == "Octahedron") return take_all(freeglut_octahedron(wire), take);
    if (kind == "Dodecahedron") return take_all(freeglut_dodecahedron(wire), take);
    if (kind == "Icosahedron") return take_all(freeglut_icosahedron(wire), take);
    if (kind == "RhombicDodecahedron") return take_all(freeglut_rhombic_dodecahedron(wire), take);
    if (kind == "Teapot") return take_all(freeglut_teapot(number(0), wire), take);
    if (kind == "Teacup") return take_all(freeglut_teacup(number(0), wire), take);
    if (kind == "Teaspoon") return take_all(freeglut_teaspoon(number(0), wire), take);
    if (kind == "SierpinskiSponge") {
        limit_sponge(command.name(), number(0), wire);
        return take_all(freeglut_sponge(count(0), {number(1), number(2), number(3)}, number(4), wire), take);
    }
    // For all other shapes the last two arguments are counts.
    const std::size_t counts = command.arguments.size() - 2;
    limit_shape(command.name(), std::max(number(counts), 0.0), std::max(number(counts + 1), 0.0));
    if (kind == "Sphere") return freeglut_sphere(number(0), count(1), count(2), wire, take);
    if (kind == "Cone") return freeglut_cone(number(0), number(1), count(2), count(3), wire, take);
    if (kind == "Cylinder") return freeglut_cylinder(number(0), number(1), count(2), count(3), wire, take);
    if (kind == "Torus") return freeglut_torus(number(0), number(1), count(2), count(3), wire, take);
    refuse("{} does not draw a shape", command.name());
}

}  // namespace

// A solid has about 2 * slices * stacks vertices and one part per stack; wires have one part per slice and per stack.
// Computed in double, which does not overflow.
void limit_shape(std::string_view name, double slices, double stacks) {
    constexpr double kCapStacks = 3;  // both caps of a cylinder, and the repeated vertices
    if (2 * (slices + 1) * (stacks + kCapStacks) > static_cast<double>(kMaxShapeVertices)) {
        throw ShapeTooLarge(
            tr("{} would have more than {} vertices; use fewer slices or stacks", name, kMaxShapeVertices));
    }
    if (slices + stacks + kCapStacks > static_cast<double>(kMaxShapeParts)) {
        throw ShapeTooLarge(
            tr("{} would have more than {} strips and loops; use fewer slices or stacks", name, kMaxShapeParts));
    }
}

void for_each_part(const Command& command, const TakePart& take) {
    if (command.id == CommandId::pragma_shape) return take_all(pragma_shape(command), take);
    freeglut_shape(command, take);
}

std::vector<ShapePart> shape_parts(const Command& command) {
    std::vector<ShapePart> parts;
    for_each_part(command, [&](ShapePart&& part) {
        parts.push_back(std::move(part));
        return true;
    });
    return parts;
}

}  // namespace twinlight

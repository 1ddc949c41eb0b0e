#include "scene/shape/quadric.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <stdexcept>

#include "scene/shape/glu_quadrics.h"

namespace twinlight {

namespace {

std::span<const Enum> allowed(CommandId id) {
    static constexpr Enum kNormals[] = {kGLU_SMOOTH, kGLU_FLAT, kGLU_NONE};
    static constexpr Enum kOrientations[] = {kGLU_OUTSIDE, kGLU_INSIDE};
    static constexpr Enum kStyles[] = {kGLU_FILL, kGLU_LINE, kGLU_SILHOUETTE, kGLU_POINT};
    switch (id) {
        case CommandId::gluQuadricNormals: return kNormals;
        case CommandId::gluQuadricOrientation: return kOrientations;
        case CommandId::gluQuadricDrawStyle: return kStyles;
        default: return {};
    }
}

}  // namespace

bool set(Quadric& quadric, const Command& command) {
    if (command.id == CommandId::gluQuadricTexture) {
        quadric.texture = command.number(1) != 0;
        return true;
    }
    const std::span<const Enum> values = allowed(command.id);
    const Enum value = command.enumerant(1);
    if (std::find(values.begin(), values.end(), value) == values.end()) return false;
    if (command.id == CommandId::gluQuadricNormals) quadric.normals = value;
    if (command.id == CommandId::gluQuadricOrientation) quadric.orientation = value;
    if (command.id == CommandId::gluQuadricDrawStyle) quadric.draw_style = value;
    return true;
}

std::string choices(CommandId id) {
    std::vector<std::string> names;
    for (const Enum value : allowed(id)) names.push_back(enum_name(value));
    return fmt::format("{}", fmt::join(names, ", "));
}

bool draws_quadric(const Command& command) {
    const Signature& sig = command.sig();
    return sig.family == Family::kShape && !sig.parameters.empty() && sig.parameters.front().kind == Kind::kQuadric;
}

std::vector<ShapePart> quadric_parts(const Quadric& quadric, const Command& command) {
    const auto number = [&](std::size_t i) { return command.number(i); };
    const auto count = [&](std::size_t i) { return static_cast<int>(command.number(i)); };
    switch (command.id) {
        case CommandId::gluSphere: return glu_sphere(quadric, number(1), count(2), count(3));
        case CommandId::gluCylinder: return glu_cylinder(quadric, number(1), number(2), number(3), count(4), count(5));
        case CommandId::gluDisk: return glu_disk(quadric, number(1), number(2), count(3), count(4));
        case CommandId::gluPartialDisk:
            return glu_partial_disk(quadric, number(1), number(2), count(3), count(4), number(5), number(6));
        default: throw std::invalid_argument(fmt::format("{} does not draw a quadric", command.name()));
    }
}

}  // namespace twinlight

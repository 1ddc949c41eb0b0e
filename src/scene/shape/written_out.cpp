#include "scene/shape/written_out.h"

#include <cmath>

#include "scene/shape/shape.h"
#include "scene/spectrum/spectrum.h"

namespace twinlight {

namespace {

// The command with the colour rounded to floats, as GL takes it.
Command with_color(const Command& pragma, CommandId id, Vec3<double> rgb) {
    Command command{id, {pragma.arguments[0], pragma.arguments[1]}, pragma.place, {}};
    for (const double c : {rgb.x, rgb.y, rgb.z, 1.0}) command.arguments.push_back(static_cast<float>(c));
    return command;
}

}  // namespace

std::optional<Command> gl_command_of(const Command& pragma) {
    if (pragma.id == CommandId::pragma_texture) {
        return Command{CommandId::gluBuild2DMipmaps,
                       {double{kGL_TEXTURE_2D}, double{kGL_RGBA}, pragma.number(0), pragma.number(1), double{kGL_RGBA},
                        double{kGL_UNSIGNED_BYTE}, 0},
                       pragma.place,
                       pragma.memory};
    }
    if (pragma.id == CommandId::pragma_reflectance) {
        const Enum pname = pragma.enumerant(1);
        const bool is_reflected =
            pname == kGL_AMBIENT || pname == kGL_DIFFUSE || pname == kGL_SPECULAR || pname == kGL_AMBIENT_AND_DIFFUSE;
        if (const Spectrum* found = find_reflectance(word_name(pragma.word(2))); found && is_reflected)
            return with_color(pragma, CommandId::glMaterialfv, rgb_of_reflectance(found->lines));
    }
    if (pragma.id == CommandId::pragma_illuminant) {
        const Enum pname = pragma.enumerant(1);
        const bool is_direct = pname == kGL_DIFFUSE || pname == kGL_SPECULAR;
        const double scale = pragma.number(3);
        if (const Spectrum* found = find_illuminant(word_name(pragma.word(2)));
            found && is_direct && scale >= 0 && std::isfinite(scale))
            return with_color(pragma, CommandId::glLightfv, scale * rgb_of_light(found->lines));
    }
    return std::nullopt;
}

CommandList with_pragmas_written_out(const CommandList& scene) {
    CommandList result{scene.name, {}};
    for (const Command& command : scene.commands) {
        if (command.id != CommandId::pragma_shape) {
            result.commands.push_back(gl_command_of(command).value_or(command));
            continue;
        }
        const auto add = [&](CommandId id, std::vector<double> arguments) {
            result.commands.push_back({id, std::move(arguments), command.place});
        };
        for (const ShapePart& part : shape_parts(command)) {
            add(CommandId::glBegin, {static_cast<double>(part.mode)});
            const std::size_t count = part.indices.empty() ? part.vertices.size() : part.indices.size();
            for (std::size_t i = 0; i < count; ++i) {
                const ShapeVertex& v = part.vertices[part.indices.empty() ? i : part.indices[i]];
                add(CommandId::glNormal3d, {v.normal_object.x, v.normal_object.y, v.normal_object.z});
                add(CommandId::glVertex3d, {v.position_object.x, v.position_object.y, v.position_object.z});
            }
            add(CommandId::glEnd, {});
        }
    }
    return result;
}

}  // namespace twinlight

#include "scene/shape/primitives.h"

#include "scene/shape/shape.h"
#include "scene/spectrum/commands.h"

namespace twinlight {

CommandList with_pragmas_written_out(const CommandList& scene) {
    CommandList result{scene.name, {}};
    for (const Command& command : scene.commands) {
        if (command.id == CommandId::pragma_texture) {
            result.commands.push_back(texture_command(command));
            continue;
        }
        if (const auto color = gl_command_of_spectrum(command)) {
            result.commands.push_back(*color);
            continue;
        }
        if (command.id != CommandId::pragma_shape) {
            result.commands.push_back(command);
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

#include "scene/shape/written_out.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "scene/command/mesh.h"
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

std::vector<Command> mesh_commands(const Command& pragma) {
    std::vector<Command> result;
    if (!pragma.memory || !pragma.memory->mesh) return result;
    const Mesh& mesh = *pragma.memory->mesh;
    const auto add = [&](CommandId id, std::vector<double> arguments, std::shared_ptr<const Memory> memory = nullptr) {
        result.push_back({id, std::move(arguments), pragma.place, std::move(memory)});
    };
    const auto has_texture = [](const MeshPart& part) { return part.material && part.material->texture != nullptr; };
    const bool has_textures = std::ranges::any_of(mesh.parts, has_texture);
    add(CommandId::glPushClientAttrib, {double{kGL_CLIENT_VERTEX_ARRAY_BIT}});
    add(CommandId::glBindBuffer, {double{kGL_ARRAY_BUFFER}, 0});
    add(CommandId::glBindBuffer, {double{kGL_ELEMENT_ARRAY_BUFFER}, 0});
    add(CommandId::glClientActiveTexture, {double{kGL_TEXTURE0}});
    add(CommandId::glInterleavedArrays,
        {static_cast<double>(mesh.has_tex_coords ? kGL_T2F_N3F_V3F : kGL_N3F_V3F), 0, 0}, mesh.vertices);
    for (const MeshPart& part : mesh.parts) {
        if (part.material) {
            add(CommandId::glPushAttrib, {double{kGL_LIGHTING_BIT | kGL_ENABLE_BIT}});
            const MeshMaterial& material = *part.material;
            const auto set = [&](Enum pname, std::span<const float> values) {
                std::vector<double> arguments{double{kGL_FRONT_AND_BACK}, static_cast<double>(pname)};
                arguments.insert(arguments.end(), values.begin(), values.end());
                add(CommandId::glMaterialfv, std::move(arguments));
            };
            set(kGL_AMBIENT, material.ambient);
            set(kGL_DIFFUSE, material.diffuse);
            set(kGL_SPECULAR, material.specular);
            set(kGL_EMISSION, material.emission);
            set(kGL_SHININESS, std::span(&material.shininess, 1));
        }
        if (has_textures && part.material)
            add(has_texture(part) ? CommandId::glEnable : CommandId::glDisable, {double{kGL_TEXTURE_2D}});
        if (has_texture(part)) {
            const MeshMaterial& material = *part.material;
            add(CommandId::gluBuild2DMipmaps,
                {double{kGL_TEXTURE_2D}, double{kGL_RGBA}, static_cast<double>(material.texture_width),
                 static_cast<double>(material.texture_height), double{kGL_RGBA}, double{kGL_UNSIGNED_BYTE}, 0},
                material.texture);
        }
        const auto count = static_cast<double>(part.indices->bytes.size() / sizeof(std::uint32_t));
        add(CommandId::glDrawElements, {double{kGL_TRIANGLES}, count, double{kGL_UNSIGNED_INT}, 0}, part.indices);
        if (part.material) add(CommandId::glPopAttrib, {});
    }
    add(CommandId::glPopClientAttrib, {});
    return result;
}

std::vector<Command> shape_commands(const Command& shape) {
    std::vector<Command> result;
    const auto add = [&](CommandId id, std::vector<double> arguments) {
        result.push_back({id, std::move(arguments), shape.place});
    };
    for (const ShapePart& part : shape_parts(shape)) {
        add(CommandId::glBegin, {static_cast<double>(part.mode)});
        const std::size_t count = part.indices.empty() ? part.vertices.size() : part.indices.size();
        for (std::size_t i = 0; i < count; ++i) {
            const ShapeVertex& v = part.vertices[part.indices.empty() ? i : part.indices[i]];
            add(CommandId::glNormal3d, {v.normal_object.x, v.normal_object.y, v.normal_object.z});
            add(CommandId::glVertex3d, {v.position_object.x, v.position_object.y, v.position_object.z});
        }
        add(CommandId::glEnd, {});
    }
    return result;
}

CommandList with_pragmas_written_out(const CommandList& scene) {
    CommandList result{scene.name, {}};
    result.window = scene.window;
    for (const Command& command : scene.commands) {
        if (command.id == CommandId::pragma_mesh) {
            std::ranges::copy(mesh_commands(command), std::back_inserter(result.commands));
            continue;
        }
        if (command.id != CommandId::pragma_shape) {
            result.commands.push_back(gl_command_of(command).value_or(command));
            continue;
        }
        std::ranges::copy(shape_commands(command), std::back_inserter(result.commands));
    }
    return result;
}

}  // namespace twinlight

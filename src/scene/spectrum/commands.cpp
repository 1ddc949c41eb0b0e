#include "scene/spectrum/commands.h"

#include <cmath>

#include "scene/spectrum/spectrum.h"

namespace twinlight {

namespace {

// As GL takes them: in floats.
Command with_color(const Command& pragma, CommandId id, Vec3<double> rgb) {
    Command command{id, {pragma.arguments[0], pragma.arguments[1]}, pragma.place, {}};
    for (const double c : {rgb.x, rgb.y, rgb.z, 1.0}) command.arguments.push_back(static_cast<float>(c));
    return command;
}

}  // namespace

std::optional<Command> gl_command_of_spectrum(const Command& pragma) {
    if (pragma.id != CommandId::pragma_reflectance && pragma.id != CommandId::pragma_illuminant) return std::nullopt;
    const Enum pname = pragma.enumerant(1);
    if (pragma.id == CommandId::pragma_reflectance) {
        const bool is_reflected =
            pname == kGL_AMBIENT || pname == kGL_DIFFUSE || pname == kGL_SPECULAR || pname == kGL_AMBIENT_AND_DIFFUSE;
        if (const Spectrum* found = find_reflectance(word_name(pragma.word(2))); found && is_reflected)
            return with_color(pragma, CommandId::glMaterialfv, rgb_of_reflectance(found->lines));
    } else {
        const bool is_direct = pname == kGL_DIFFUSE || pname == kGL_SPECULAR;
        const double scale = pragma.number(3);
        if (const Spectrum* found = find_illuminant(word_name(pragma.word(2)));
            found && is_direct && scale >= 0 && std::isfinite(scale))
            return with_color(pragma, CommandId::glLightfv, scale * rgb_of_light(found->lines));
    }
    return std::nullopt;
}

}  // namespace twinlight

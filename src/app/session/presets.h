// Presets: the classic materials of OpenGL's example teapots.c (Silicon Graphics, 1993).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "app/session/light_values.h"
#include "scene/command/command.h"

namespace twinlight::session {

struct MaterialPreset {
    std::string_view name;  // "emerald"
    std::array<double, 3> ambient, diffuse, specular;
    double shininess;  // GL_SHININESS
};

std::span<const MaterialPreset> material_presets();

// Gives one drawing command this material on both faces, with alpha 1, and leaves all others as they are: glMaterial is
// called before it, and after it where later ones need the old values. Calls that only served this one are replaced.
// Where GL_COLOR_MATERIAL is on, the tracked colours stay those of glColor.
CommandList with_preset(const CommandList& commands, std::size_t drawing_command, const MaterialPreset& preset);

}  // namespace twinlight::session

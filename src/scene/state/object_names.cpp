// Generating and deleting the names of objects (3.8.12).
#include <fmt/format.h>

#include <algorithm>

#include "scene/state/state.h"

namespace twinlight {

bool State::counts(const Command& c, const char* what) {
    if (c.number(0) >= 0) return true;
    raise(kGL_INVALID_VALUE, c,
          fmt::format("{} is given {} {}; a number cannot be below 0", c.name(), c.number(0), what));
    return false;
}

void State::gen_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    for (double name : c.array()) textures_.named.try_emplace(static_cast<std::uint32_t>(name), nullptr);
}

// 3.8.12: of the textures that there are; others, and 0, are passed over.
void State::prioritize_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    const auto names = c.values(1), priorities = c.values(2);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = textures_.named.find(static_cast<std::uint32_t>(names[i]));
        if (names[i] == 0 || found == textures_.named.end() || !found->second) continue;
        std::shared_ptr<Texture>& texture = found->second;
        if (texture.use_count() > 1) texture = std::make_shared<Texture>(*texture);
        texture->priority = std::clamp(priorities[i], 0.0, 1.0);
    }
}

// A texture that is bound is bound no more; 0 and names that are not in use are passed over.
void State::delete_textures(const Command& c) {
    if (!counts(c, "textures")) return;
    for (double value : c.array()) {
        const auto name = static_cast<std::uint32_t>(value);
        const auto found = textures_.named.find(name);
        if (name == 0 || found == textures_.named.end()) continue;
        if (found->second) textures_.texels -= texels_of(*found->second);
        textures_.named.erase(found);
        for (TextureBindings& unit : a_.units) {
            if (unit.bound_1d == name) unit.bound_1d = 0;
            if (unit.bound_2d == name) unit.bound_2d = 0;
        }
    }
}

}  // namespace twinlight

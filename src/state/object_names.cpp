// Generating and deleting the names of objects (3.8.12).
#include <fmt/format.h>

#include "state/state.h"

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

// CommandSet: a set of commands, given by their effects (the second column of commands.def).
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight {

// Indexed by CommandId.
inline constexpr std::string_view kEffects[] = {
#define GL_COMMAND(name, effect, ...) #effect,
#include "scene/command/commands.def"
};

class CommandSet {
  public:
    // An unknown effect is a compile error.
    static consteval CommandSet of(std::initializer_list<std::string_view> effects) {
        CommandSet set;
        for (const std::string_view effect : effects) {
            bool is_known = false;
            for (std::size_t i = 0; i < std::size(kEffects); ++i)
                if (kEffects[i] == effect) is_known = set.has_[i] = true;
            if (!is_known) throw std::invalid_argument("no command of commands.def has this effect");
        }
        return set;
    }

    // Those of either.
    friend constexpr CommandSet operator|(CommandSet a, const CommandSet& b) {
        for (std::size_t i = 0; i < b.has_.size(); ++i) a.has_[i] = a.has_[i] || b.has_[i];
        return a;
    }

    constexpr bool contains(CommandId id) const { return has_[static_cast<std::size_t>(id)]; }

  private:
    std::array<bool, std::size(kEffects)> has_{};
};

// The commands that draw primitives or pixels by themselves. A display list may draw, too.
inline constexpr CommandSet kDrawCommands =
    CommandSet::of({"begin", "rect", "draw_arrays", "eval_mesh", "shape", "mesh_file", "quadric_shape", "bitmap",
                    "draw_pixels", "copy_pixels"});
inline constexpr CommandSet kListCommands = CommandSet::of({"call_list", "call_lists"});

}  // namespace twinlight

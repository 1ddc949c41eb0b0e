// Where an argument of a command belongs: its parameter, and the parameter of a light, material or other owner that it sets.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "scene/command/command.h"

namespace twinlight::session {

// The State function that carries the command out: "light", "enable".
std::string_view effect_of(const Command& command);

// The parameter that an argument belongs to, and the number of the element in it.
struct ArgumentPlace {
    std::size_t parameter = 0, element = 0;
};
ArgumentPlace place_of(const Command& command, std::size_t argument);

// The index of the argument pname of glLight and its kin; nullopt for other commands.
std::optional<std::size_t> pname_argument(const Command& command);
std::optional<Owner> owner_of_command(const Command& command);
// The parameter that a command with a pname sets; null for others.
const ParameterInfo* parameter_set(const Command& command);
// Whether an argument is a value of glLight and its kin, not the light or the pname.
bool is_parameter_value(const Command& command, std::size_t argument);

}  // namespace twinlight::session

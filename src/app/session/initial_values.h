// GL's initial values of the arguments of commands.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "scene/command/command.h"

namespace twinlight::session {

// Empty for an argument without one, such as a coordinate of glVertex.
std::optional<double> initial_value(const Command& command, std::size_t argument);
// The initial values of a parameter (tables 6.5 to 6.35). Empty if GL has none, and for GL_AMBIENT_AND_DIFFUSE, whose
// two colours differ.
std::vector<double> initial_parameter(const Command& command, Owner owner, Enum pname);
// A real number as an argument of this kind: an integer becomes a colour by table 2.9, which is inverted here.
double as_argument(double value, Kind kind, bool is_color);

}  // namespace twinlight::session

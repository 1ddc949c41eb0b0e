// NaN and infinity as arguments of commands. GL raises no error for them and leaves their effect open (2.1.1).
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "scene/command/command.h"

namespace twinlight {

// False for NaN and infinity. A number beyond the largest float counts as infinite, because it is so in a driver.
inline bool is_in_float_range(double x) { return std::abs(x) <= std::numeric_limits<float>::max(); }

// The first argument that is not in the range of floats. Commands that set a vertex's attributes may have such numbers:
// see sanitize() in state.h.
std::optional<double> number_that_is_not_finite(const Command& command);

// RULING for recorded programs: NaN becomes 0, and infinity 2^32, the largest position that every GL can represent
// (2.1.1). All renderers draw the command with these numbers. nullopt: it needs no change.
std::optional<Command> made_finite(const Command& command);

}  // namespace twinlight

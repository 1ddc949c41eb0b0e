#include "scene/state/not_finite.h"

#include <algorithm>
#include <cmath>

#include "scene/command/command_set.h"

namespace twinlight {

namespace {

constexpr double kInsteadOfInfinity = 0x1p32;

// Commands that set a vertex's attributes.
constexpr CommandSet kTakesAnyNumber = CommandSet::of({"vertex", "normal", "color", "tex_coord", "multi_tex_coord",
                                                       "secondary_color", "fog_coord", "driver_only_attribute"});

}  // namespace

std::optional<double> number_that_is_not_finite(const Command& command) {
    if (kTakesAnyNumber.contains(command.id)) return {};
    const auto found = std::ranges::find_if_not(command.arguments, is_in_float_range);
    return found == command.arguments.end() ? std::nullopt : std::optional(*found);
}

std::optional<Command> made_finite(const Command& command) {
    if (!number_that_is_not_finite(command)) return std::nullopt;
    Command finite = command;
    for (double& v : finite.arguments) {
        if (!is_in_float_range(v)) v = std::isnan(v) ? 0 : std::copysign(kInsteadOfInfinity, v);
    }
    return finite;
}

}  // namespace twinlight

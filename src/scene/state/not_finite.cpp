#include "scene/state/not_finite.h"

#include <algorithm>
#include <cmath>

#include "scene/command/command_set.h"

namespace twinlight {

namespace {

constexpr double kInsteadOfInfinity = 0x1p32;

// Commands that set a vertex's attributes.
constexpr CommandSet kTakesAnyNumber = CommandSet::of({"vertex", "normal", "color", "tex_coord", "multi_tex_coord",
                                                       "driver_only_secondary_color", "driver_only_attribute"});

}  // namespace

bool has_number_that_is_not_finite(const Command& command) {
    return !std::ranges::all_of(command.arguments, [](double v) { return std::isfinite(v); }) &&
           !kTakesAnyNumber.contains(command.id);
}

std::optional<Command> made_finite(const Command& command) {
    if (!has_number_that_is_not_finite(command)) return std::nullopt;
    Command finite = command;
    for (double& v : finite.arguments) {
        if (std::isnan(v)) v = 0;
        if (std::isinf(v)) v = std::copysign(kInsteadOfInfinity, v);
    }
    return finite;
}

}  // namespace twinlight

// Commands that the driver carries out and State does not follow.
#include <fmt/format.h>

#include <algorithm>

#include "state/state.h"

namespace twinlight {

namespace {

// How many points of a map a command evaluates (5.1). A count up to the largest integer never ends in Mesa.
double evaluated_points(const Command& c) {
    const auto between = [&c](std::size_t from) {
        constexpr double kLargest = 2147483647;
        const double first = c.number(from), last = c.number(from + 1);
        return last == kLargest ? kLargest : std::max(0.0, last - first + 1);
    };
    if (c.id == CommandId::glEvalMesh1) return between(1);
    if (c.id == CommandId::glEvalMesh2) return between(1) * between(3);
    return 1;
}

}  // namespace

// These set what changes a picture only under a capability, or for a command, that is named itself.
void State::elsewhere_state(const Command&) {}

// These change the picture.
void State::elsewhere_drawing(const Command& c) {
    if (!has_time(c, evaluated_points(c))) return;
    note_unsupported(std::string(c.name()), c.place, {"programmable", "reference"});
}

// The same, and legal between Begin and End.
void State::elsewhere_vertex(const Command& c) { elsewhere_drawing(c); }

// 4.2.1. A picture here has one colour buffer, whatever its name.
void State::draw_buffer(const Command& c) {
    const Enum mode = c.enumerant(0);
    if (!known(c, mode,
               {kGL_NONE, kGL_FRONT, kGL_BACK, kGL_LEFT, kGL_RIGHT, kGL_FRONT_AND_BACK, kGL_FRONT_LEFT, kGL_FRONT_RIGHT,
                kGL_BACK_LEFT, kGL_BACK_RIGHT}))
        return;
    a_.draws_color = mode != kGL_NONE;
}

}  // namespace twinlight

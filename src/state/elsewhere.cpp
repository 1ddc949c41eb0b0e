// Commands that the driver carries out and State does not follow.
#include <fmt/format.h>

#include "state/state.h"

namespace twinlight {

// These set what changes a picture only under a capability, or for a command, that is named itself.
void State::elsewhere_state(const Command&) {}

// These change the picture.
void State::elsewhere_drawing(const Command& c) {
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

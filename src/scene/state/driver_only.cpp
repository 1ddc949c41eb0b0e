// Commands that only the driver supports.
#include "scene/state/state.h"

namespace twinlight {

// These set state that affects pictures only together with a capability or a command that is itself noted.
void State::driver_only_state(const Command&) {}
// The same, but also allowed between Begin and End: the indices of color index mode.
void State::driver_only_attribute(const Command&) {}

// A scene cannot use the results of queries, and only the driver knows all their names.
void State::driver_only_query(const Command&) {}

// 4.2.1. There is one colour buffer, so all names but GL_NONE mean the same.
void State::draw_buffer(const Command& c) {
    const Enum mode = c.enumerant(0);
    if (!known(c, mode,
               {kGL_NONE, kGL_FRONT, kGL_BACK, kGL_LEFT, kGL_RIGHT, kGL_FRONT_AND_BACK, kGL_FRONT_LEFT, kGL_FRONT_RIGHT,
                kGL_BACK_LEFT, kGL_BACK_RIGHT}))
        return;
    a_.draws_color = mode != kGL_NONE;
}

}  // namespace twinlight

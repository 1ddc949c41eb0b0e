// Commands that only the driver supports. State notes them as unsupported if they can change the picture.
#include <fmt/format.h>

#include <algorithm>

#include "scene/state/state.h"

namespace twinlight {

// These set state that affects pictures only together with a capability or a command that is itself noted.
void State::driver_only_state(const Command&) {}
// The same, but also allowed between Begin and End: the indices of color index mode.
void State::driver_only_attribute(const Command&) {}

// A scene cannot use the results of queries, and only the driver knows all their names.
void State::driver_only_query(const Command&) {}

// These change the picture.
void State::driver_only_drawing(const Command& c) { note_unsupported(std::string(c.name()), c.place); }

// ---- Values that change later drawing ----

// Section 3.3, table 6.12.
void State::driver_only_point_parameter(const Command& c) {
    const Enum pname = c.enumerant(0);
    const auto values = parameter_values(c, Owner::kPoint, pname);
    if (!values) return;
    // The driver chooses the initial maximum size, so setting it always counts as a change.
    const bool is_initial = pname == kGL_POINT_SIZE_MIN               ? values->front() == 0
                            : pname == kGL_POINT_DISTANCE_ATTENUATION ? *values == std::vector<double>{1, 0, 0}
                            : pname == kGL_POINT_SPRITE_COORD_ORIGIN
                                ? values->front() == kGL_UPPER_LEFT
                                : pname == kGL_POINT_FADE_THRESHOLD_SIZE;  // only affects multisampling
    if (is_initial)
        a_.point_parameters.erase(pname);
    else
        a_.point_parameters[pname] = c.place;
}

void State::note_driver_only_values(const Draw& draw) {
    const auto note = [this](const std::string& name, const Place& place) { note_unsupported(name, place); };
    if (!draw.draws_points()) return;
    for (const auto& [pname, place] : a_.point_parameters)
        note(fmt::format("glPointParameter({})", enum_name(pname)), place);
}

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

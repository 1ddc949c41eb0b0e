// Commands that only the driver supports.
#include "scene/state/state.h"

namespace twinlight {

// These set state that affects pictures only together with a capability or a command that is itself noted.
void State::driver_only_state(const Command&) {}
// The same, but also allowed between Begin and End: the indices of color index mode.
void State::driver_only_attribute(const Command&) {}

// A scene cannot use the results of queries, and only the driver knows all their names.
void State::driver_only_query(const Command&) {}

}  // namespace twinlight

// The variables of GL's state that are plain values (tables 6.5 to 6.35): a row for each, with the name by which glGet and glEnable know
// it, and the bits of glPushAttrib that save it. Queries, capabilities and the attribute stack follow from the rows. What belongs to one of
// several lights, clip planes or texture units, and the matrices, have functions of their own there.
#pragma once

#include <span>
#include <vector>

#include "scene/state/attributes.h"

namespace twinlight {

struct StateVariable {
    Enum pname;                                           // 0: no query names it
    Enum groups;                                          // the bits of glPushAttrib
    std::vector<double> (*values)(const Attributes& of);  // as glGetDoublev returns them (6.1.2)
    void (*copy)(Attributes& to, const Attributes& from);
    const bool* (*flag)(const Attributes& of);  // null if it is not a bool

    // GL_ENABLE_BIT saves what glEnable turns on.
    bool is_capability() const { return (groups & kGL_ENABLE_BIT) != 0; }
};

std::span<const StateVariable> state_variables();
const StateVariable* find_state_variable(Enum pname);  // null for other names

}  // namespace twinlight

// Capabilities that State does not follow: the fixed renderer obeys them, and a picture made under one of them is
// reported as partial.
#pragma once

#include <span>

#include "command/names.h"

namespace twinlight {

struct Elsewhere {
    Enum cap;
    Enum group;  // the bit of glPushAttrib that saves it, beside GL_ENABLE_BIT; 0: that one alone
    bool changes_pixels;
};

std::span<const Elsewhere> capabilities_elsewhere();

}  // namespace twinlight

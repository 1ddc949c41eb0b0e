// Capabilities that State does not follow: the fixed renderer obeys them, and a picture made under one of them is
// reported as partial.
#pragma once

#include <span>

#include "scene/command/names.h"

namespace twinlight {

struct DriverOnlyCapability {
    Enum cap;
    Enum group;  // the bit of glPushAttrib that saves it, beside GL_ENABLE_BIT; 0: that one alone
    bool changes_pixels;

    bool of_unit() const { return group == kGL_TEXTURE_BIT; }  // each texture unit has its own
    // Whether it gives coordinates to a texture, and so changes nothing without one.
    bool generates_coordinates() const { return cap >= kGL_TEXTURE_GEN_S && cap <= kGL_TEXTURE_GEN_Q; }
};

std::span<const DriverOnlyCapability> driver_only_capabilities();
const DriverOnlyCapability& driver_only_capability(Enum cap);  // one of them

}  // namespace twinlight

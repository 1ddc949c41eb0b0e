// Capabilities that only the driver supports. State ignores them, and reports a picture that uses one as partial.
#pragma once

#include <span>

#include "scene/command/names.h"

namespace twinlight {

struct DriverOnlyCapability {
    Enum cap;
    Enum group;  // the bit of glPushAttrib that saves it besides GL_ENABLE_BIT; 0 if there is none
    bool changes_pixels;

    bool is_per_unit() const { return group == kGL_TEXTURE_BIT; }  // each texture unit has its own
};

std::span<const DriverOnlyCapability> driver_only_capabilities();
const DriverOnlyCapability& driver_only_capability(Enum cap);  // `cap` must be in that list

}  // namespace twinlight

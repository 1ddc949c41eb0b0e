// Colours of GL 2.1 in a buffer of floats.
#pragma once

#include "render/context/gl.h"

namespace twinlight {

// Clamps floats when they are read, as a screen would show them, and in the fragment's texture environments, colour sum and fog, as GL
// 2.1 does (3.8.13, 3.9, 3.10). OSMesa 22.3 does both by itself: it treats floats as fixed-point. Since 25.0 it does not.
inline void clamp_colors() {
    glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
}

}  // namespace twinlight

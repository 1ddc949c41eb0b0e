// A frame at another size of its picture.
#pragma once

#include "scene/frame/frame.h"

namespace twinlight {

// The same picture with these sides: all window coordinates are scaled. Borders are rounded, so that neighbours still touch.
Frame resized(Frame frame, int width, int height);

}  // namespace twinlight

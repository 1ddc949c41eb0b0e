#include "render/context/egl_devices.h"

namespace twinlight {

const bool kTakesGpus = false;

}  // namespace twinlight

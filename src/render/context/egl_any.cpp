#include "render/context/egl_devices.h"

namespace twinlight {

const bool kTakesGpus = true;

}  // namespace twinlight

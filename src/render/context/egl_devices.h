// Which of EGL's devices a program takes; the program links one of two files that say so.
#pragma once

namespace twinlight {

// True with `make GL=egl` (egl_any.cpp). False where EGL stands in for OSMesa, which draws without a GPU, too (egl_software.cpp).
extern const bool kTakesGpus;

}  // namespace twinlight

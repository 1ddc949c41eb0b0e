// The stages of GL that no shader takes the place of: how a Draw is rasterised, and the per-fragment operations (4.1).
#pragma once

#include "scene/state/frame.h"

namespace twinlight {

// Keeps what it finds in the context, and sets what would change a picture and no Frame has: stipples, smoothing, the
// stencil test, logical operations. At the end of the scope the context is as before; no program, no arrays, no buffers
// are bound.
class FixedStages {
  public:
    FixedStages();
    ~FixedStages();
    FixedStages(const FixedStages&) = delete;
    FixedStages& operator=(const FixedStages&) = delete;

    static void set(const Draw& draw);
    void clear(const Clear& what) const;
};

}  // namespace twinlight

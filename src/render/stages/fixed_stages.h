// The stages of GL that no shader replaces: rasterisation state and the per-fragment operations (4.1).
#pragma once

#include "scene/frame/frame.h"

namespace twinlight {

// Saves the context's state, and turns off what no Frame has but would change the picture: smooth polygons, point
// sprites. The destructor restores the state; afterwards no program, arrays or buffers are
// bound.
class FixedStages {
  public:
    FixedStages();
    ~FixedStages();
    FixedStages(const FixedStages&) = delete;
    FixedStages& operator=(const FixedStages&) = delete;

    // `before` is the state that was set last: what is equal is not set again. Null sets everything.
    static void set(const RasterState& raster, const RasterState* before = nullptr);
    static void set(const FragmentState& fragment, const FragmentState* before = nullptr);
    static void set(const RasterState& raster, const FragmentState& fragment);
    // Except the accumulation buffer (accumulation_buffer.h).
    void clear(const Clear& clear) const;
    void clear_all() const;  // to black, depth 1 and stencil 0
};

}  // namespace twinlight

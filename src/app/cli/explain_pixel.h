// One pixel of a scene: every lighting term, and its colour by all three renderers.
#pragma once

#include <string>

#include "render/effect/plan.h"
#include "scene/state/scene.h"

namespace twinlight::cli {

struct Pixel {
    int x = 0, y = 0;  // from the top left corner of the picture
};

// Throws UsageError unless `text` is "X,Y" and inside the frame.
Pixel parse_pixel(const std::string& text, const Frame& frame);

// The fragments that cover the pixel, with every lighting term as the reference computes it; then the colours of the three renderers.
std::string explain_pixel(const Scene& scene, const PlanOptions& options, const Pixel& pixel, bool as_json);

}  // namespace twinlight::cli

// One pixel of a scene, term by term and by all three renderers.
#pragma once

#include <string>

#include "render/effect/plan.h"
#include "scene/state/scene.h"

namespace twinlight::cli {

struct Pixel {
    int x = 0, y = 0;  // of the picture, from the top left corner
};

// Throws UsageError unless it is "X,Y" within the frame.
Pixel parse_pixel(const std::string& text, const Frame& frame);

// The fragments that cover it, with every term of their lighting by the reference; then what the three renderers draw there.
std::string explain_pixel(const Scene& scene, const PlanOptions& options, const Pixel& pixel, bool as_json);

}  // namespace twinlight::cli

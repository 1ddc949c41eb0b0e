// One pixel or vertex of a scene: every lighting term with its numbers, and the colour by all three renderers.
#pragma once

#include <string>

#include "render/effect/plan.h"
#include "scene/frame/scene.h"

namespace twinlight::cli {

struct ExplainOptions {
    PlanOptions plan{};
    bool as_json = false;
    bool all = false;    // also what the scene does not use
    bool calls = false;  // the chains of calls of a recorded program
};

// What covers the pixel "X,Y". Throws UsageError unless it is inside the frame.
std::string explain_pixel(const Scene& scene, const ExplainOptions& options, const std::string& pixel);
// An exam sheet about the pixel, as HTML (exercise.h).
std::string exercise_of_pixel(const Scene& scene, const Look& look, const std::string& pixel);
// The same for the vertex "DRAW,N", both counted from 1. Throws UsageError unless the frame has it and lights it.
std::string explain_vertex(const Scene& scene, const ExplainOptions& options, const std::string& vertex);

}  // namespace twinlight::cli

// One pixel or vertex of a scene: every lighting term with its numbers, and the colour by all three renderers.
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

struct VertexOfDraw {
    std::size_t draw = 0, vertex = 0;  // both count from 0
};
// Throws UsageError unless `text` is "DRAW,N", both counted from 1, and the frame has that vertex.
VertexOfDraw parse_vertex(const std::string& text, const Frame& frame);

struct ExplainOptions {
    PlanOptions plan{};
    bool as_json = false;
    bool all = false;  // also what the scene does not use
};

// The fragments that cover the pixel, with every lighting term as the reference computes it; then the colours of the
// three renderers.
std::string explain_pixel(const Scene& scene, const ExplainOptions& options, const Pixel& pixel);
// The same for a vertex, lit as GL lights vertices.
std::string explain_vertex(const Scene& scene, const ExplainOptions& options, const VertexOfDraw& vertex);

}  // namespace twinlight::cli

// The lit colours of a Draw's vertices.
#pragma once

#include <vector>

#include "render/reference/vertices/reference_options.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

// A vertex after lighting, as GL's feedback returns it.
struct LitVertex {
    glm::dvec4 position_clip{0};
    glm::dvec4 front_primary{0}, front_secondary{0};
    glm::dvec4 back_primary{0}, back_secondary{0};
    // For each channel, the sum of the magnitudes of the primary colour's terms: the scale for judging errors.
    glm::dvec4 front_magnitude{0}, back_magnitude{0};
};

// Runs the vertex stage on every vertex of the Draw (not on every index). `clamped`: clamps colours to [0,1] (2.14.6).
// Magnitudes are double, whatever the options' arithmetic.
std::vector<LitVertex> light_vertices(const Draw& draw, const Options& options, bool clamped);

}  // namespace twinlight::reference

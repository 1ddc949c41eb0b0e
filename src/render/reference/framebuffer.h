// The framebuffer, in whole rows: depth test, alpha test, blending, masks and clears (4.1, 4.2), one step after the other.
//
// Colours wait where they can: a pixel holds either the step whose colour it has, to be lit once it is known that it is
// seen, or a colour. A fragment whose colour depends on what lies beneath (blending, a colour mask) or decides whether
// there is a fragment at all (the alpha test) is lit at once.
#pragma once

#include <optional>
#include <vector>

#include "render/reference/coverage.h"
#include "render/reference/staged_frame.h"

namespace twinlight::reference {

class Framebuffer {
  public:
    // The rows from y0 to y1 (excluded; y up), after all steps. StagedFrame and shaders must outlive it.
    Framebuffer(const StagedFrame& stages, const std::vector<Shader>& shaders, int width, int y0, int y1);

    // The colours of all pixels, row by row from y0 up, before they are rounded to the bits of the colour buffer for the last
    // time.
    std::vector<glm::dvec4> colors() const;

    // The step whose colour it has; nothing where colours were blended.
    std::optional<StepId> step(int x, int y) const;

  private:
    void clear(StepId id);
    void piece(StepId id);

    PixelRect window() const { return {0, y0_, width_, y1_}; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - y0_) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    glm::dvec4 color_at(int x, int y, std::size_t at) const;
    void write(const FragmentState& state, const glm::dvec4& source, int x, int y);

    const StagedFrame& stages_;
    const std::vector<Shader>& shaders_;
    const int width_, y0_, y1_;
    std::vector<StepId> step_;        // of the colour, or kColor
    std::vector<glm::dvec4> colors_;  // where the step is kColor; empty as long as nowhere
    std::vector<double> depth_;
};

// Table 4.1 of 4.1.5: whether a fragment of depth `incoming` passes against what is stored.
bool depth_passes(Enum depth_func, double incoming, double stored);

}  // namespace twinlight::reference

// Probe: the numbers behind a pixel or vertex, laid out as the equation for the window's panel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/session.h"
#include "judge/explain/derivation.h"
#include "judge/explain/explain.h"
#include "render/look.h"
#include "scene/frame/scene.h"

namespace twinlight::session {

// What `twinlight explain` knows about a probe. The numbers are the reference's.
struct ProbeAnswer {
    Probe probe{};
    std::string trouble{};                // why nothing can be explained: one sentence
    explain::PixelExplanation pixel{};    // of a pixel
    explain::VertexExplanation vertex{};  // of a vertex
};
ProbeAnswer answer_probe(const Scene& scene, const Look& look, const Probe& probe);

// A Draw that covers the pixel. A vertex has one such row for each lit face.
struct ProbeFragment {
    std::string name;  // "draw 3, scene.gl:12:1, front face"
    std::string fate;  // "seen", "a later draw covers it", "discarded by a test"
    bool is_lit = true;
    bool is_seen = true;
};
std::vector<ProbeFragment> fragments_of(const Scene& scene, const ProbeAnswer& answer);
// The index of the fragment to show first: the last one that is seen.
std::size_t main_fragment(const std::vector<ProbeFragment>& fragments);

// Where a fragment was lit, and its share of the fragment's colour.
struct ProbePoint {
    std::string name;  // "vertex 115", "this pixel"
    double weight = 1;
    reference::Vec color{};  // c_pri, clamped
    explain::Derivation derivation;
};
// The references in a point's derivation are to `scene` and `answer`.
std::vector<ProbePoint> points_of(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment);

// A row of a sum of colours.
struct SumRow {
    std::string sign{};  // "+", "="; empty at the start
    std::string what{};  // "GL_LIGHT0"
    std::string how{};   // "to [0, 1]"
    reference::Vec color{};
    bool is_result = false;
};
// The lighting equation as a sum: emission, the scene's ambient light, each light, the total before and after the clamp. For one
// light: its three terms.
std::vector<SumRow> sum_rows(const explain::Derivation& at, std::optional<int> light,
                             Symbols symbols = Symbols::kSpecification);
// A smooth fragment as the mean of its vertices' clamped colours; empty with one point.
std::vector<SumRow> mean_rows(const std::vector<ProbePoint>& points);
// Texture, colour sum and fog of a fragment, if they are used. Empty for a vertex.
std::vector<explain::Line> after_lighting(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment);
// What follows after lighting: the fragment's colour. Empty for a vertex.
std::vector<SumRow> fragment_rows(const Scene& scene, const ProbeAnswer& answer, std::size_t fragment);
// "the specification is silent (...); our choice: ...": a line for each of our choices that affected the colour.
std::string rulings_of(const ProbeAnswer& answer, std::size_t fragment);

// "c = e_cm + a_cm a_cs + sum of att spot [ ... ]", with the formulas of the scene's variants.
// The lecture's: "I = e + k_a I_a + sum of att spot [ ... ]".
std::string equation_of(const explain::Derivation& at, Symbols symbols = Symbols::kSpecification);
// The lines of a derivation about the place and normal, or about one light.
std::vector<explain::Line> lines_of(const explain::Derivation& at, std::optional<int> light,
                                    Symbols symbols = Symbols::kSpecification);

// Everything as text, as `twinlight explain` prints it, with the colours that the panes show.
std::string probe_text(const Scene& scene, ProbeAnswer answer, const std::vector<explain::Rendered>& rendered);

}  // namespace twinlight::session

// From a Draw's lighting state to the structs of the lighting equation.
//
// In: LightingState (GL's words, 2.14.2). Out: what equation.h takes, prepared once a Draw; then the two
// colours of any point of a surface.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lighting/equation.h"
#include "reference/spectral_lighting.h"
#include "reference/vertex_stage.h"
#include "state/frame.h"

namespace twinlight::reference {

using Vec = Vec3<double>;

struct Colors {
    glm::dvec4 primary{0};
    glm::dvec4 secondary{0, 0, 0, 1};
    glm::dvec4 magnitude{0};  // the sum of the magnitudes of primary's terms
};

enum class Face : std::uint8_t { kFront, kBack };

struct LitPoint;  // pixel.h

class DrawLighting {
  public:
    // Without `lecture_variants` the lighting is GL's own.
    DrawLighting(const Draw& draw, bool lecture_variants);

    // The colours, unclamped, of a vertex, or of a point of a surface that has all that a vertex has. The back face is
    // lit with its own material and the normal reversed (2.14.1). Without lighting: the current colour.
    Colors colors(const StageVertex& v, Face face) const;
    // With lighting, and with a material that need not be a vertex's.
    Colors lit(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, const LitMaterial& material,
               Face face) const;
    // The same term by term (pixel.h).
    LitPoint point(const StageVertex& v, const LitMaterial& material, Face face) const;
    // What the vertex is lit with: its own material, with its colour where the material follows it (2.14.3).
    LitMaterial material(const StageVertex& v, Face face) const;

    bool enabled() const { return enabled_; }
    // Whether the back face has colours of its own; GL uses the front's where it has not.
    bool two_side() const { return enabled_ && two_side_; }
    // Whether vertices may differ in more of their material than what follows the current colour.
    bool has_vertex_materials() const { return materials_.size() > 1; }

  private:
    lighting::Lit<double> light_surface(const LitMaterial& material, const lighting::Surface<double>& surface,
                                        lighting::LightTerms<double>* breakdown = nullptr) const;

    bool enabled_ = false;
    bool two_side_ = false;
    lighting::Model<double> model_;
    std::vector<lighting::Light<double>> lights_;  // the enabled ones
    std::vector<Materials> materials_;             // at least one
    ColorMaterial color_material_;
    std::optional<SpectralLighting> spectral_;
};

// V: the eye position divided by its w. RULING: what lies at infinity is lit as if it were very far away.
Vec lit_position(const glm::dvec4& position_eye);

// The material between three, as far as `weights` says.
LitMaterial mixed(const glm::dvec3& weights, const std::array<LitMaterial, 3>& materials);

// Every component to [0,1] (2.14.6).
glm::dvec4 clamped(const glm::dvec4& color);

}  // namespace twinlight::reference

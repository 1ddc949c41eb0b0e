// The colour of a fragment before the per-fragment operations: lighting's colours interpolated (gouraud), of the
// provoking vertex (flat), or lit for every pixel (phong and exact, which GL itself does not have); then texturing (3.8), the
// colour sum (3.9) and fog (3.10).
#pragma once

#include <vector>

#include "reference/interval.h"
#include "reference/piece.h"
#include "reference/reference.h"
#include "reference/surface_rays.h"

namespace twinlight::reference {

// A Draw after its vertex stage.
struct StagedDraw {
    const Draw* draw = nullptr;
    std::vector<StageVertex> vertices;
};

// All colours that right implementations may find for one fragment.
struct FragmentBounds {
    Channels<Interval> color{};
    bool has_choice = false;  // of texels: texture_bounds.h
};

// Colours one Draw's pieces. The StagedDraw must outlive it.
class Shader {
  public:
    Shader(const StagedDraw& staged, const RenderOptions& options);

    // In [0,1].
    glm::dvec4 color(const Piece& piece, const glm::dvec2& position_window) const;
    FragmentBounds bounds(const Piece& piece, const glm::dvec2& position_window) const;

  private:
    struct LitColors {
        glm::dvec4 primary{0}, secondary{0};
    };
    bool lights_pixels() const {
        return (shading_ == Shading::kPhong || shading_ == Shading::kExact) && lighting_.enabled();
    }
    LitColors lit(const Piece& piece, const glm::dvec2& position_window) const;
    LitColors flat(const Piece& piece) const;
    LitColors gouraud(const Piece& piece, const glm::dvec3& weights) const;
    LitColors phong(const Piece& piece, const glm::dvec3& weights) const;
    LitColors exact(const SurfacePoint& point) const;
    glm::dvec4 exact_color(const Piece& piece, const glm::dvec2& position_window) const;
    double fog_at(const Piece& piece, const glm::dvec2& position_window) const;
    glm::dvec4 sampled(const TexturePlace& place) const;
    template <class Real>
    Channels<Real> finished(const LitColors& colors, const Channels<Real>* texel, Real fog) const;

    const Draw& draw_;
    const std::vector<StageVertex>& vertices_;
    const Shading shading_;
    const DrawLighting lighting_;
    const bool srgb_coded_;
    std::vector<LitVertex> lit_;
};

}  // namespace twinlight::reference

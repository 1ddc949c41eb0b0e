// The colour of a fragment before the per-fragment operations: lighting's colours interpolated (gouraud), of the
// provoking vertex (flat), or lit for every pixel (phong and exact, which GL itself does not have); then texturing (3.8), the
// colour sum (3.9) and fog (3.10).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/reference/interval.h"
#include "render/reference/piece.h"
#include "render/reference/reference.h"
#include "render/reference/surface_rays.h"

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

struct Fragment {
    const Piece* piece;
    glm::dvec2 position_window;
};

// Colours one Draw's pieces. The StagedDraw must outlive it.
class Shader {
  public:
    Shader(const StagedDraw& staged, const Options& options);

    // In [0,1]. Of many the same as of each, to the last places of a double (lighting/points.h).
    glm::dvec4 color(const Piece& piece, const glm::dvec2& position_window) const;
    std::vector<glm::dvec4> colors(const std::vector<Fragment>& fragments) const;
    FragmentBounds bounds(const Piece& piece, const glm::dvec2& position_window) const;

    // The color() of lit colours that know the rulings they come from, in [0,1], where `position` decided the position.
    struct MarkedColors {
        Channels<lighting::Marked> primary, secondary;
    };
    Channels<lighting::Marked> marked_color(const Piece& piece, const glm::dvec2& position_window,
                                            const MarkedColors& lit, lighting::RulingSet position) const;

  private:
    struct LitColors {
        glm::dvec4 primary{0}, secondary{0};
    };
    struct LitFaces {  // of a vertex
        LitColors front, back;
    };
    // What the colour of a pixel needs beside its lighting.
    struct Finish {
        double fog = 1;
        std::optional<Channels<double>> texel;
    };
    // What phong and exact light at a pixel.
    struct LitPlace {
        StageVertex vertex;
        Face face = Face::kFront;  // which is lit: the front where lighting has one side
        Finish finish;
    };

    bool lights_pixels(const Piece& piece) const { return piece.rays || lights_pixels(); }
    bool lights_pixels() const {
        return (shading_ == Shading::kPhong || shading_ == Shading::kExact) && lighting_.enabled();
    }
    static LitColors clamped_colors(const Colors& colors);
    void light_vertices();
    void light_together(PointBatch& batch, std::span<const Fragment> fragments, glm::dvec4* colors) const;
    LitColors vertex_colors(const Piece& piece, const glm::dvec2& position_window) const;
    LitPlace lit_place(const Fragment& fragment) const;
    LitMaterial material(const Fragment& fragment, const LitPlace& place) const;
    LitColors lit(const Fragment& fragment, const LitPlace& place) const;
    double fog_at(const Piece& piece, const glm::dvec2& position_window) const;
    glm::dvec4 sampled(const TexturePlace& place) const;
    glm::dvec4 finished(const LitColors& colors, const Finish& finish) const;
    template <class Real, class Colors>
    Channels<Real> finished(const Colors& colors, const Channels<Real>* texel, Real fog) const;

    const Draw& draw_;
    const std::vector<StageVertex>& vertices_;
    const Shading shading_;
    const DrawLighting lighting_;
    const bool srgb_coded_;
    const Arithmetic arithmetic_;
    std::vector<LitFaces> lit_;  // by vertex, where those are what is lit
};

}  // namespace twinlight::reference

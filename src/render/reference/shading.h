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

struct Fragment {
    const Piece* piece;
    glm::dvec2 position_window;       // the pixel's centre
    const RayPoint* point = nullptr;  // of a surface; where it is left out the ray is cast again
};

// A fragment's colour; over intervals all that right implementations may find.
template <class Real>
struct Shaded {
    Channels<Real> color{};
    bool has_choice = false;  // of texels: texture_bounds.h
};

// A point that is lit for a fragment: of flat and gouraud shading a vertex, else the fragment's own place.
struct PointOfFragment {
    StageVertex vertex;
    Face face = Face::kFront;  // which is lit: the front where lighting has one side
    LitMaterial material;
    double weight = 1;
    std::optional<std::uint32_t> number{};  // into Draw::vertices
};

// Colours one Draw's pieces. The StagedDraw must outlive it.
class Shader {
  public:
    Shader(const StagedDraw& staged, const Options& options);

    // In [0,1]. Real: double or Interval.
    template <class Real>
    Shaded<Real> shade(const Fragment& fragment) const;
    // Of many, those that light pixels together: the same as of each, to the last places of a double (lighting/points.h).
    std::vector<Channels<double>> colors(std::span<const Fragment> fragments) const;

    // What the colour is lit from; nothing without lighting. The weights add up to 1.
    std::vector<PointOfFragment> points(const Fragment& fragment) const;
    const DrawLighting& lighting() const { return lighting_; }
    Shading shading() const { return shading_; }

    // The colour of lit colours that know the rulings they come from, in [0,1], where `position` decided the position.
    struct MarkedColors {
        Channels<lighting::Marked> primary, secondary;
    };
    Channels<lighting::Marked> marked_color(const Fragment& fragment, const MarkedColors& lit,
                                            lighting::RulingSet position) const;

  private:
    struct LitColors {
        glm::dvec4 primary{0}, secondary{0};
    };
    struct LitFaces {  // of a vertex
        LitColors front, back;
    };
    // What the colour of a pixel needs beside its lighting.
    template <class Real>
    struct Finish {
        Real fog = 1;
        std::optional<Channels<Real>> texel{};
        bool has_choice = false;
    };
    // What phong and exact light at a pixel.
    struct LitPlace {
        StageVertex vertex;
        Face face = Face::kFront;
    };

    bool lights_pixels(const Piece& piece) const { return piece.rays || lights_pixels(); }
    bool lights_pixels() const {
        return (shading_ == Shading::kPhong || shading_ == Shading::kExact) && lighting_.enabled();
    }
    Face lit_face(Face face) const { return lighting_.two_side() ? face : Face::kFront; }
    static LitColors clamped_colors(const Colors& colors);
    void light_vertices();
    LitColors vertex_colors(const Fragment& fragment) const;
    LitPlace lit_place(const Fragment& fragment) const;
    LitPlace lit_place_of_unit_normal(const Fragment& fragment) const;
    LitMaterial material(const Fragment& fragment, const LitPlace& place) const;
    LitColors lit(const Fragment& fragment) const;
    glm::dvec2 eye_zw(const Fragment& fragment) const;
    template <class Real>
    Finish<Real> finish(const Fragment& fragment) const;
    void add_texel(const Fragment& fragment, Finish<double>& finish) const;
    void add_texel(const Fragment& fragment, Finish<Interval>& finish) const;
    template <class Real, class Colors>
    Channels<Real> finished(const Colors& colors, const Finish<Real>& finish) const;

    const Draw& draw_;
    const std::vector<StageVertex>& vertices_;
    const Shading shading_;
    const DrawLighting lighting_;
    const bool srgb_coded_;
    const Arithmetic arithmetic_;
    std::vector<LitFaces> lit_;  // by vertex, where those are what is lit
};

}  // namespace twinlight::reference

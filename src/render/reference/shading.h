// The colour of a fragment before the per-fragment operations: colours interpolated from lit vertices (gouraud), taken
// from the provoking vertex (flat), or lit for every pixel (phong and exact, which GL lacks); then texturing (3.8), the
// colour sum (3.9) and fog (3.10).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/reference/fog.h"
#include "render/reference/geometry/piece.h"
#include "render/reference/geometry/surface_rays.h"
#include "render/reference/geometry/texture_place.h"
#include "render/reference/reference.h"
#include "render/reference/textures/color_steps.h"
#include "render/reference/textures/interval.h"

namespace twinlight::reference {

// A Draw after its vertex stage.
struct StagedDraw {
    const Draw* draw = nullptr;
    StagedVertices vertices;
    std::vector<std::vector<glm::dvec4>> further_tex_coords{};  // of each of Draw::further_units, at vertices.kept()
};

struct Fragment {
    const Piece* piece;
    glm::dvec2 position_window;       // the pixel's centre
    const RayPoint* point = nullptr;  // for a surface; if null, the ray is cast again
};

// A fragment's colour; over intervals, all colours that correct implementations may find.
template <class Real>
struct Shaded {
    Channels<Real> color{};
    bool has_choice = false;  // there is a choice of texels (texture_bounds.h)
};

// A point that is lit for a fragment: a vertex (flat, gouraud), or the fragment's own position (phong, exact).
struct PointOfFragment {
    StageVertex vertex;
    Face face = Face::kFront;  // the face to light; kFront if lighting is one-sided
    LitMaterial material;
    double weight = 1;
    std::optional<std::uint32_t> number{};  // index into Draw::vertices
};

// Colours one Draw's pieces. The StagedDraw must outlive it.
class Shader {
  public:
    Shader(const StagedDraw& staged, const Options& options, const CopyRanges* ranges = nullptr);

    // The colour, in [0,1]. Real: double or Interval.
    template <class Real>
    Shaded<Real> shade(const Fragment& fragment) const;
    // The colours of many fragments, lit together where pixels are lit; equal to shade()'s except for the last places
    // of a double (lighting/points.h).
    std::vector<Channels<double>> colors(std::span<const Fragment> fragments) const;

    // The points that are lit for the colour; empty without lighting. The sum of the weights is 1.
    std::vector<PointOfFragment> points(const Fragment& fragment) const;
    // Whether correct implementations may find different colours on this piece: textured, in linear fog that reaches behind
    // the eye, copied from their own pictures, with pixels that are lit by spots, or of a curved surface.
    bool has_several_colors(const Piece& piece) const;
    // The first cause of that.
    Why why_several_colors(const Piece& piece) const;
    // How the fragment's colour comes from its lit colours. The last step gives shade()'s colour, before the transfer
    // curve.
    ColorSteps steps(const Fragment& fragment) const;
    const DrawLighting& lighting() const { return lighting_; }
    Shading shading() const { return shading_; }
    // Whether colours need more of a Draw's vertices than what is lit when the Shader is made. points() always does.
    bool needs_vertices() const { return lights_pixels() || !units_.empty() || draw_.fog.enabled; }

    // The fragment's colour from lit colours, in [0,1], with the rulings that it depends on; `position`: the rulings of
    // the position.
    struct MarkedColors {
        Channels<lighting::Marked> primary, secondary;
    };
    Channels<lighting::Marked> marked_color(const Fragment& fragment, const MarkedColors& lit,
                                            lighting::RulingSet position) const;

  private:
    struct LitColors {
        glm::dvec4 primary{0}, secondary{0};
    };
    // Everything besides lighting that a pixel's colour needs.
    template <class Real>
    struct Finish {
        Real fog = 1;
        std::optional<Channels<Real>> texel{};  // of the only unit
        std::vector<Channels<Real>> texels{};   // of each unit, if the Draw combines textures
        bool has_choice = false;
    };
    // A texture unit that has a texture.
    struct Unit {
        std::size_t number = 0;
        const TextureUnit* state = nullptr;
        const CopyRanges::OfTexels* copied = nullptr;
        TexCoords tex_coords;
    };
    // The point that phong and exact shading light at a pixel.
    struct LitPlace {
        StageVertex vertex;
        Face face = Face::kFront;
    };

    // The lit colours that correct implementations may find.
    struct LitRanges {
        Channels<Interval> primary{}, secondary{};
    };
    // What renderers may have copied from their pictures (4.3.3).
    bool copies_colors() const { return copied_ != nullptr && !copied_->colors.empty(); }
    LitRanges copied_colors(const Piece& piece) const;
    // Where a pixel is lit beside the border of a spot's cone.
    std::optional<LitRanges> colors_beside_cones(const Fragment& fragment) const;

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
    double fog_distance(const Fragment& fragment) const;
    double fog(const Fragment& fragment) const { return fog_factor(draw_.fog, fog_distance(fragment)); }
    double fog_of_vertices(const Fragment& fragment) const;
    bool has_linear_fog_behind_eye(const Piece& piece) const;
    void add_fog(const Fragment& fragment, Finish<double>& finish) const;
    void add_fog(const Fragment& fragment, Finish<Interval>& finish) const;
    template <class Real>
    Finish<Real> finish(const Fragment& fragment) const;
    template <class Real>
    void add_texels(const Fragment& fragment, Finish<Real>& finish) const;
    void find_texel(const Fragment& fragment, const Unit& unit, Channels<double>& texel, bool& has_choice) const;
    void find_texel(const Fragment& fragment, const Unit& unit, Channels<Interval>& texel, bool& has_choice) const;
    TexturePlace texture_place_of(const Fragment& fragment, const Unit& unit) const;
    std::vector<Unit> units(const StagedDraw& staged, const CopyRanges* ranges) const;
    template <class Real, class Colors>
    Channels<Real> finished(const Colors& colors, const Finish<Real>& finish) const;
    // Calls see(Step, colour) after each step; kTextured after each unit, or once without any.
    enum class Step : std::uint8_t { kTextured, kSummed, kFogged };
    template <class Real, class Colors, class See>
    Channels<Real> finished(const Colors& colors, const Finish<Real>& finish, const See& see) const;

    const Draw& draw_;
    const StagedVertices& vertices_;
    const CopyRanges::OfPixels* copied_;  // by this Draw; null if none
    const std::vector<Unit> units_;
    const bool combines_textures_;
    const Shading shading_;
    const DrawLighting lighting_;
    const bool srgb_coded_;
    const Arithmetic arithmetic_;
    const PlaceErrors place_errors_;               // of drivers, for texture_bounds.h
    std::vector<LitColors> lit_front_, lit_back_;  // of vertices_.kept(), if vertices are lit; lit_back_ if two-sided
};

}  // namespace twinlight::reference

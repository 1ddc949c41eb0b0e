// Converts a Draw's lighting state to the structs of the lighting equation.
//
// In: LightingState (GL's words, 2.14.2). Out: the inputs of equation.h, prepared once per Draw; then the two colours
// of any point of a surface.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lighting/breakdown.h"
#include "lighting/marked.h"
#include "lighting/points.h"
#include "render/reference/vertices/spectral_lighting.h"
#include "render/reference/vertices/vertex_stage.h"
#include "scene/frame/frame.h"

namespace twinlight::reference {

using Vec = Vec3<double>;

struct Colors {
    glm::dvec4 primary{0};
    glm::dvec4 secondary{0, 0, 0, 1};
    glm::dvec4 magnitude{0};  // the sum of the magnitudes of primary's terms
};

enum class Face : std::uint8_t { kFront, kBack };

// The enabled lights for the equation at a point with these eye coordinates, marked with the rulings that they depend on.
std::vector<lighting::Light<lighting::Marked>> marked_lights(const Draw& draw, bool lecture_variants,
                                                             const glm::dvec4& position_eye);

// The equation's inputs at a point: V, and the normal, reversed for the back face (2.14.1).
lighting::SurfacePoint<double> surface_of(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, Face face);

class DrawLighting {
  public:
    // Without `lecture_variants`, lighting is GL's own.
    DrawLighting(const Draw& draw, bool lecture_variants);

    // The unclamped colours of a vertex, or of a surface point with the same attributes. The back face has its own
    // material and the reversed normal (2.14.1). Without lighting: the current colour.
    Colors colors(const StageVertex& v, Face face) const;
    // The same with lighting, and with any material.
    Colors lit(const glm::dvec4& position_eye, const glm::dvec3& normal_eye, const LitMaterial& material,
               Face face) const;
    // The same in the equation's types, with the terms of each light if `breakdown` is given.
    lighting::MeasuredLit<double> light_surface(const LitMaterial& material,
                                                const lighting::SurfacePoint<double>& surface,
                                                lighting::LightTerms<double>* breakdown = nullptr) const;
    // The colours on both sides of the cones' borders, if rounding in floats decides whether the point is within one that ends
    // there (2.14.1); empty elsewhere.
    std::optional<std::array<Colors, 2>> beside_cones(const glm::dvec4& position_eye, const glm::dvec3& normal_eye,
                                                      const LitMaterial& material, Face face) const;
    Vec scene_ambient(const LitMaterial& material) const;
    // The vertex's material: its own, with the current colour for the properties that follow it (2.14.3).
    LitMaterial material(const StageVertex& v, Face face) const;

    // The lighting of a point whose w is 0: VP depends on a directional light's direction only, and not at all on another
    // light's place (2.14.1). RULING: its distance from positional lights is infinite.
    bool differs_at(const glm::dvec4& position_eye) const { return position_eye.w == 0 && differs_at_infinity_; }
    DrawLighting at(const glm::dvec4& position_eye) const;

    const lighting::Model<double>& model() const { return model_; }
    const std::vector<lighting::Light<double>>& lights() const { return lights_; }  // the enabled ones
    bool enabled() const { return enabled_; }
    // Whether the back face has its own colours; if not, GL uses the front's.
    bool two_side() const { return enabled_ && two_side_; }
    bool has_cones() const { return std::ranges::any_of(lights_, &lighting::Light<double>::is_spot); }
    // Whether all points of a face have the same material, ignoring the current colour.
    bool has_one_material(Face face) const;
    // Whether materials of vertices may differ in more than the properties that follow the current colour.
    bool has_vertex_materials() const { return materials_.size() > 1; }

  private:
    friend class PointBatch;

    bool enabled_ = false;
    bool two_side_ = false;
    bool differs_at_infinity_ = false;  // there are lights, and at() has not turned them
    lighting::Model<double> model_;
    std::vector<lighting::Light<double>> lights_;
    std::vector<glm::dvec3> positions_eye_;  // of the lights, as glLight gave them
    std::vector<Materials> materials_;       // at least one
    ColorMaterial color_material_;
    std::optional<SpectralLighting> spectral_;
};

// Lights many points of a Draw together, using SIMD (lighting/points.h). The DrawLighting must outlive it.
class PointBatch {
  public:
    enum class Normals : std::uint8_t { kAsTheyAre, kMadeUnit };
    // How many points to add at a time: enough for SIMD, few enough for the processor's cache.
    static constexpr std::size_t kPoints = 1024;

    PointBatch(const DrawLighting& lighting, Normals normals);

    // Calls material() only if points differ in their material.
    template <class MaterialOf>
    void add(const StageVertex& v, Face face, const MaterialOf& material) {
        if (lighting_.differs_at(v.position_eye)) {
            at_infinity_.push_back({v, face, material(), count_++});
            return;
        }
        Side& side = sides_[face == Face::kFront ? 0 : 1];
        if (side.places.empty() || !lighting_.has_one_material(face)) add(material(), side);
        add(surface_of(v.position_eye, v.normal_eye, face), side);
    }
    // Calls visit(i, primary, secondary) for each point, numbered as added, with the colours of DrawLighting::lit().
    template <class Visit>
    void light(const Arithmetic& arithmetic, const Visit& visit) {
        light_sides(arithmetic, visit);
        for (const AtInfinity& point : at_infinity_) {
            const DrawLighting lighting = lighting_.at(point.vertex.position_eye);
            PointBatch one(lighting, normals_);
            one.add(point.vertex, point.face, [&] { return point.material; });
            one.light_sides(arithmetic, [&](std::size_t, const glm::dvec4& primary, const glm::dvec4& secondary) {
                visit(point.place, primary, secondary);
            });
        }
    }
    // Removes all points and keeps the memory.
    void clear();

  private:
    struct Side {                              // one face
        std::vector<lighting::Points> points;  // one, or one per group of samples (spectral_lighting.h)
        std::vector<std::size_t> places;       // their numbers among all points
    };
    struct AtInfinity {  // a point that has lights of its own: DrawLighting::at()
        StageVertex vertex;
        Face face;
        LitMaterial material;
        std::size_t place;
    };
    template <class Visit>
    void light_sides(const Arithmetic& arithmetic, const Visit& visit) {
        for (const Side& side : sides_) {
            light(side, arithmetic);
            const Vec3<lighting::Each> primary = lighting::each(lit_.primary),
                                       secondary = lighting::each(lit_.secondary);
            const lighting::Each alpha(lit_.alpha);
            for (std::size_t i = 0; i < side.places.size(); ++i)
                visit(side.places[i], glm::dvec4(primary.x[i], primary.y[i], primary.z[i], alpha[i]),
                      glm::dvec4(secondary.x[i], secondary.y[i], secondary.z[i], 1));
        }
    }
    void add(const LitMaterial& material, Side& side) const;
    void add(const lighting::SurfacePoint<double>& point, Side& side);
    void light(const Side& side, const Arithmetic& arithmetic);

    const DrawLighting& lighting_;
    const Normals normals_;
    std::array<Side, 2> sides_;
    std::vector<AtInfinity> at_infinity_;
    lighting::Lit<lighting::Column> lit_;
    std::size_t count_ = 0;
};

// The weighted mean of three materials.
LitMaterial mixed(const glm::dvec3& weights, const std::array<LitMaterial, 3>& materials);

// Clamps every component to [0,1] (2.14.6).
glm::dvec4 clamped(const glm::dvec4& color);

}  // namespace twinlight::reference

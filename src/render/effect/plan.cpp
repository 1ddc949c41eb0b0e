// plan_effects: finds the facts that change a Draw's code, with a reason for each fact that is left out.
#include "render/effect/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <utility>

#include "base/text/translation.h"
#include "render/effect/plan_parts.h"

namespace twinlight {
namespace {

constexpr double kSteepestSrgb = 12.92;  // the slope of sRGB's linear part

bool is_zero(const glm::dvec3& c) { return c == glm::dvec3(0); }
glm::dvec3 rgb(const glm::dvec4& c) { return glm::dvec3(c); }

// ---- The effective state ----

// 2.14.3: the material's colours that glColorMaterial's mode selects.
FaceEffects tracked_by(Enum mode) {
    const bool both = mode == kGL_AMBIENT_AND_DIFFUSE;
    return {.tracks_emission = mode == kGL_EMISSION,
            .tracks_ambient = mode == kGL_AMBIENT || both,
            .tracks_diffuse = mode == kGL_DIFFUSE || both,
            .tracks_specular = mode == kGL_SPECULAR};
}

void put_color(Material& material, const FaceEffects& tracked, const glm::dvec4& color) {
    const auto put = [&](bool tracks, glm::dvec4& property, const Spectrum*& reflectance) {
        if (!tracks) return;
        property = color;
        reflectance = nullptr;
    };
    if (tracked.tracks_emission) material.emission = color;
    put(tracked.tracks_ambient, material.ambient, material.reflectances.ambient);
    put(tracked.tracks_diffuse, material.diffuse, material.reflectances.diffuse);
    put(tracked.tracks_specular, material.specular, material.reflectances.specular);
}

bool names_front(Enum face) { return face != kGL_BACK; }
bool names_back(Enum face) { return face != kGL_FRONT; }

// Whether the picture's error is at most the largest error of its Draws, however many of them overlap. That holds if
// blending is a mean with weights that no light changes and whose sum is at most 1, or if it picks one of the two
// colours.
bool keeps_errors_from_adding(const FragmentState& fragment) {
    if (!fragment.blend) return true;
    const auto is_mean = [](Enum equation, Enum src, Enum dst) {
        if (equation == kGL_MIN || equation == kGL_MAX) return true;
        constexpr std::pair<Enum, Enum> kMeans[] = {
            {kGL_ONE, kGL_ZERO},
            {kGL_ZERO, kGL_ONE},
            {kGL_SRC_ALPHA, kGL_ONE_MINUS_SRC_ALPHA},
            {kGL_ONE_MINUS_SRC_ALPHA, kGL_SRC_ALPHA},
            {kGL_CONSTANT_ALPHA, kGL_ONE_MINUS_CONSTANT_ALPHA},
            {kGL_CONSTANT_COLOR, kGL_ONE_MINUS_CONSTANT_COLOR},
        };
        return std::ranges::find(kMeans, std::pair(src, dst)) != std::end(kMeans);
    };
    return is_mean(fragment.blend_equation, fragment.blend_src, fragment.blend_dst);
}

Material::Reflectances reflectances_of(const Material& material, const FaceEffects& face) {
    const auto unless = [](bool is_per_vertex, const Spectrum* reflectance) {
        return is_per_vertex ? nullptr : reflectance;
    };
    return {.ambient = unless(face.tracks_ambient || face.varies_ambient, material.reflectances.ambient),
            .diffuse = unless(face.tracks_diffuse || face.varies_diffuse, material.reflectances.diffuse),
            .specular = unless(face.tracks_specular || face.varies_specular, material.reflectances.specular)};
}

// ---- The planner ----

class Planner {
  public:
    Planner(const Draw& draw, const PlanOptions& options, const VertexFacts& vertices)
        : draw_(draw),
          options_(options),
          vertices_(vertices),
          plan_{.effects = {},
                .vertices = vertices,
                .left_out = {},
                .has_reasons = options.reasons,
                .for_any_pose = options.for_any_pose,
                .lights = {},
                .lighting = draw.lighting.enabled ? draw.lighting : LightingState(),
                .light_bounds = {}} {
        if (options.reasons) plan_.left_out.reserve(16);
    }

    Plan plan() {
        // GL_COMBINE may make an error four times as large, or more by GL_DOT3_RGB.
        const bool has_budget =
            !options_.for_any_pose && keeps_errors_from_adding(draw_.fragment) && !draw_.combines_textures();
        plan_.budget = has_budget ? std::max(options_.budget, 0.0) : 0;
        facts().srgb_coded = options_.lecture_variants && draw_.fragment.srgb_coded;
        // sRGB's curve is steepest at black, so an error in linear light grows most there.
        if (facts().srgb_coded) plan_.budget /= kSteepestSrgb;
        plan_fragments(draw_, vertices_, plan_);
        facts().at_pixels = draw_.pixels != nullptr;
        facts().shading =
            options_.shading.value_or(draw_.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud);
        // Meshes without exact surfaces, and exact surfaces (surface_draw.h), are lit at each fragment.
        if (facts().shading == Shading::kExact) facts().shading = Shading::kPhong;
        if (facts().shading == Shading::kFlat && draw_.mode == kGL_POINTS) {
            facts().shading = Shading::kGouraud;
            plan_.leave_out("flat shading", "a point has one vertex");
        }
        if (draw_.lighting.enabled)
            plan_lit();
        else
            plan_unlit();
        plan_colors_that_are_left();
        plan_w();
        if (facts().srgb_coded) {
            plan_.error_bound *= kSteepestSrgb;
            plan_.budget *= kSteepestSrgb;
        }
        return std::move(plan_);
    }

  private:
    EffectSet& facts() { return plan_.effects; }
    LightingState& state() { return plan_.lighting; }

    void plan_unlit() {
        plan_.leave_out("lighting", "GL_LIGHTING is disabled, so vertex colours are drawn unchanged");
        if (facts().shading == Shading::kPhong) {
            facts().shading = Shading::kGouraud;
            plan_.leave_out("per-fragment lighting", "GL_LIGHTING is disabled");
        }
        facts().clamp = glm::clamp(vertices_.color_low, 0.0, 1.0) != vertices_.color_low ||
                        glm::clamp(vertices_.color_high, 0.0, 1.0) != vertices_.color_high;
        if (!facts().clamp) plan_.leave_out("clamping", "all vertex colours are within [0,1]");
    }

    void plan_lit() {
        facts().lighting = true;
        find_effective_state();
        plan_faces();
        plan_color_material();
        plan_materials();
        plan_.constant_ambient = rgb(state().light_model.ambient);
        const LightsToPlan lights{
            .bounds = options_.for_any_pose
                          ? DrawBounds{}
                          : draw_bounds(draw_, vertices_, state(), facts().shading == Shading::kPhong),
            .faces = {face_range(&Materials::front, facts().front), face_range(&Materials::back, facts().back)},
            .primary = facts().needs_primary_rgb(),
            .for_any_pose = options_.for_any_pose,
            .has_directions = has_directions()};
        plan_clamp(lights, plan_lights(lights, plan_));
        plan_specular();
        drop_idle_colors();
        plan_spectral_products();
        plan_shading_per_fragment();
        plan_geometry(lights.bounds);
    }

    void plan_shading_per_fragment() {
        if (facts().shading != Shading::kPhong || facts().needs_position_eye() || facts().needs_color() ||
            facts().front.varies() || facts().back.varies())
            return;
        if (!facts().needs_normal()) {
            plan_.leave_out("per-fragment lighting", "its inputs are the same everywhere on the primitive");
        } else if (vertices_.normals_equal) {
            plan_.leave_out("per-fragment lighting",
                            "all normals are equal, all lights are directional, the viewer is at infinity");
            state().normalize = true;  // phong shading would have scaled each fragment's normal to length 1
        } else {
            return;
        }
        facts().shading = Shading::kGouraud;
    }

    // GL_REPLACE may replace the whole primary colour. Then only a separate specular colour needs lighting.
    void plan_colors_that_are_left() {
        if (facts().needs_primary() || facts().separate_specular || facts().secondary_color) return;
        plan_.leave_out("lighting and colours", "the texture replaces both colour and alpha (GL_REPLACE)");
        EffectSet left;
        left.texture = facts().texture;
        left.fog = facts().fog;
        left.fog_coords = facts().fog_coords;
        left.attenuated_points = facts().attenuated_points;
        left.srgb_coded = facts().srgb_coded;
        left.clip_plane_count = facts().clip_plane_count;
        left.at_pixels = facts().at_pixels;
        facts() = left;
        state().enabled = false;
        plan_.lights.clear();
        plan_.error_bound = 0;
        for (LightBound& light : plan_.light_bounds) {
            if (light.fate != LightFate::kDisabled) light.fate = LightFate::kReplaced;
            light.bound = glm::dvec3(0);
        }
    }

    // Whether a vertex has w = 0 in eye coordinates: then it is a direction.
    bool has_directions() const {
        const glm::dmat4& m = draw_.eye_from_object;
        if (keeps_w(m)) return vertices_.has_w_0;
        return std::ranges::any_of(draw_.vertices, [&](const Vertex& v) { return (m * v.position_object).w == 0; });
    }

    void plan_w() {
        const bool w_is_1 = keeps_w(draw_.eye_from_object) && vertices_.w_is_1;
        const bool w_matters =
            facts().needs_position_eye() || (facts().has_fog() && !facts().fog_coords) || facts().attenuated_points;
        facts().vertex_w = w_matters && !w_is_1;
        if (w_matters && w_is_1) plan_.leave_out("division by w", "w is 1 at every vertex");
    }

    void find_effective_state() {
        if (options_.lecture_variants) return;
        const LightModel initial;
        state().light_model.specular = initial.specular;
        state().light_model.light_ambient = initial.light_ambient;
        state().light_model.spectrum = nullptr;
        LightSources& lights = state().lights;
        if (std::ranges::any_of(std::as_const(lights), [](const LightSource& l) { return l.smooth_cone.has_value(); }))
            for (LightSource& light : lights) light.smooth_cone.reset();
    }

    // 2.14.1: two-sided lighting; 2.13.1: culled faces are not visible.
    void plan_faces() {
        const RasterState& raster = draw_.raster;
        const std::string_view why_one_sided = [&]() -> std::string_view {
            if (!state().light_model.two_side) return "GL_LIGHT_MODEL_TWO_SIDE is off";
            if (!draws_polygons(draw_.mode)) return "points and lines have no back face";
            if (raster.cull_enabled && raster.cull_face != kGL_FRONT) return "back faces are culled";
            return "";
        }();
        facts().two_side = why_one_sided.empty();
        if (!facts().two_side) {
            plan_.leave_out("two-sided lighting", why_one_sided, !state().light_model.two_side);
            state().back = state().front;
        }
        for (const std::uint32_t i : vertices_.materials) materials_.push_back(draw_.materials.at(i));
        if (materials_.empty()) materials_.push_back({state().front, state().back});
        if (!facts().two_side)
            for (Materials& m : materials_) m.back = m.front;
    }

    void plan_color_material() {
        ColorMaterial& tracking = state().color_material;
        if (!tracking.enabled) {
            plan_.leave_out("colour material", "GL_COLOR_MATERIAL is disabled", true);
            return;
        }
        const FaceEffects tracked = tracked_by(tracking.mode);
        const bool front = names_front(tracking.face);
        const bool back = facts().two_side && names_back(tracking.face);
        if (vertices_.colors_equal) {
            const glm::dvec4& color = vertices_.color_low;
            for (Materials& m : materials_) {
                if (front) put_color(m.front, tracked, color);
                if (back) put_color(m.back, tracked, color);
            }
            plan_.leave_out("colour material", "all vertices have the same colour, so the material is set once");
            tracking.enabled = false;
        } else if (!front && !back) {
            plan_.leave_out("colour material", "it sets only the back face's material, and no back face is visible");
            tracking.enabled = false;
        } else {
            if (front) facts().front = tracked;
            if (back) facts().back = tracked;
        }
    }

    // 2.14.2: glMaterial between glBegin and glEnd. A property with the same value in all materials is not per vertex.
    void plan_materials() {
        state().front = materials_.front().front;
        state().back = materials_.front().back;
        const auto plan_face = [&](FaceEffects& face, Material Materials::*of) {
            const auto varies = [&](auto Material::*property, bool tracked) {
                return !tracked && std::any_of(materials_.begin(), materials_.end(), [&](const Materials& m) {
                    return (m.*of).*property != (materials_.front().*of).*property;
                });
            };
            face.varies_emission = varies(&Material::emission, face.tracks_emission);
            face.varies_ambient = varies(&Material::ambient, face.tracks_ambient);
            face.varies_diffuse = varies(&Material::diffuse, face.tracks_diffuse);
            face.varies_specular = varies(&Material::specular, face.tracks_specular);
            face.varies_shininess = varies(&Material::shininess, false);
        };
        plan_face(facts().front, &Materials::front);
        if (facts().two_side) plan_face(facts().back, &Materials::back);
        if (!draw_.materials.empty() && !facts().front.varies() && !facts().back.varies())
            plan_.leave_out("per-vertex materials", "all vertices have the same material");
    }

    // The ranges of the face's material, at the vertices and between them.
    FaceRange face_range(Material Materials::*of, const FaceEffects& face) const {
        const auto range = [&](glm::dvec4 Material::*color, bool tracked) {
            if (tracked) return std::pair(vertices_.color_low, vertices_.color_high);
            std::pair all((materials_.front().*of).*color, (materials_.front().*of).*color);
            for (const Materials& m : materials_)
                all = {glm::min(all.first, (m.*of).*color), glm::max(all.second, (m.*of).*color)};
            return all;
        };
        const auto colors = [&](glm::dvec4 Material::*color, bool tracked) {
            const auto [low, high] = range(color, tracked);
            return ColorRange{rgb(low), rgb(high)};
        };
        const auto [least_shiny, most_shiny] =
            std::ranges::minmax(materials_, {}, [of](const Materials& m) { return (m.*of).shininess; });
        const auto [low, high] = range(&Material::diffuse, face.tracks_diffuse);
        return {.emission = colors(&Material::emission, face.tracks_emission),
                .ambient = colors(&Material::ambient, face.tracks_ambient),
                .diffuse = colors(&Material::diffuse, face.tracks_diffuse),
                .specular = colors(&Material::specular, face.tracks_specular),
                .shininess = {(least_shiny.*of).shininess, (most_shiny.*of).shininess},
                .alpha = {low.a, high.a},
                .reflectances = reflectances_of(materials_.front().*of, face)};
    }

    // 2.14.6: a colour needs no clamp if the sum of its terms' bounds lies in [0,1].
    void plan_clamp(const LightsToPlan& lights, const ColorRange& of_lights) {
        facts().clamp = true;
        if (options_.for_any_pose) return;
        double low = 0, high = 0;
        for (std::size_t i = 0; i < (facts().two_side ? 2 : 1); ++i) {
            const FaceRange& face = lights.faces[i];
            const ColorRange ambient =
                product_of(state().light_model, {plan_.constant_ambient, {}}, face, &FaceRange::ambient);
            for (int c = 0; c < 3; ++c) {
                low = std::min(low, face.emission.low[c] + ambient.low[c] + of_lights.low[c]);
                high = std::max(high, face.emission.high[c] + ambient.high[c] + of_lights.high[c]);
            }
            low = std::min(low, face.alpha.low);
            high = std::max(high, face.alpha.high);
        }
        // Separate colours are clamped one by one: a negative highlight becomes 0, whatever the primary colour is.
        if (state().light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR)
            for (int c = 0; c < 3; ++c) low = std::min(low, of_lights.low[c]);
        facts().clamp = !(low >= 0 && high <= 1);
        if (!facts().clamp && plan_.has_reasons)
            plan_.leave_out("clamping", tr("the sum of all terms is at most {:.3g}, and no term is negative", high));
    }

    void plan_specular() {
        const LightModel& model = state().light_model;
        if (!facts().any_light(&LightEffects::specular)) {
            plan_.leave_out("specular highlights", "no light has a specular term");
            return;
        }
        facts().separate_specular = model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
        if (!facts().separate_specular)
            plan_.leave_out("separate specular colour", "GL_LIGHT_MODEL_COLOR_CONTROL is GL_SINGLE_COLOR", true);
        facts().highlight = model.specular == Word::reflection ? Highlight::kReflection : Highlight::kHalfVector;
        // Phong shading interpolates the exponent, which is then not an integer.
        const bool between =
            facts().shading == Shading::kPhong && (facts().front.varies_shininess || facts().back.varies_shininess);
        facts().shininess = between ? Power::kReal : Power::kZero;
        for (const Materials& m : materials_)
            facts().shininess = std::max({facts().shininess, power_of(m.front.shininess), power_of(m.back.shininess)});
        facts().local_viewer = model.local_viewer && facts().shininess != Power::kZero;
        if (facts().shininess == Power::kZero)
            plan_.leave_out("specular exponent", "GL_SHININESS is 0, and x^0 is 1 for every x");
        if (!facts().local_viewer)
            plan_.leave_out("local viewer",
                            model.local_viewer ? "GL_SHININESS is 0, so the viewer's position does not matter"
                                               : "GL_LIGHT_MODEL_LOCAL_VIEWER is off",
                            !model.local_viewer);
    }

    // A vertex colour that no light uses is dropped. The diffuse colour is also the alpha.
    void drop_idle_colors() {
        const bool primary = facts().needs_primary_rgb();
        const bool ambient = !is_zero(plan_.constant_ambient) || facts().any_light(&LightEffects::ambient);
        const bool diffuse = facts().any_light(&LightEffects::diffuse);
        const bool specular = facts().any_light(&LightEffects::specular);
        const auto drop = [&](bool& fact, bool is_used, const char* what, const char* why) {
            if (!fact || is_used) return;
            fact = false;
            plan_.leave_out(what, primary ? why : "the texture replaces it");
        };
        const auto drop_of_face = [&](FaceEffects& face, Material Materials::*of) {
            const bool alpha = facts().needs_primary_alpha();
            const bool alphas = alpha && std::any_of(materials_.begin(), materials_.end(), [&](const Materials& m) {
                                    return (m.*of).diffuse.a != (materials_.front().*of).diffuse.a;
                                });
            drop(face.tracks_emission, primary, "emission from glColor", "");
            drop(face.tracks_ambient, primary && ambient, "ambient colour from glColor", "there is no ambient light");
            drop(face.tracks_diffuse, diffuse || alpha, "diffuse colour from glColor", "");
            drop(face.tracks_specular, specular, "specular colour from glColor", "no light has a specular term");
            drop(face.varies_emission, primary, "per-vertex emission", "");
            drop(face.varies_ambient, primary && ambient, "per-vertex ambient colour", "there is no ambient light");
            drop(face.varies_diffuse, diffuse || alphas, "per-vertex diffuse colour", "no light has a diffuse term");
            drop(face.varies_specular, specular, "per-vertex specular colour", "no light has a specular term");
            drop(face.varies_shininess, specular, "per-vertex shininess", "no light has a specular term");
        };
        drop_of_face(facts().front, &Materials::front);
        drop_of_face(facts().back, &Materials::back);
    }

    // Products that are the same at every vertex are made before drawing, so the number of samples costs nothing.
    void plan_spectral_products() {
        if (!state().light_model.spectrum) return;
        const auto brings_colors = [](const FaceEffects& face) {
            return face.tracks_ambient || face.tracks_diffuse || face.tracks_specular || face.varies_ambient ||
                   face.varies_diffuse || face.varies_specular;
        };
        facts().spectral_products = brings_colors(facts().front) || brings_colors(facts().back);
        constexpr std::size_t kMostSampledLights = 8;
        if (!options_.fold_spectra && !facts().spectral_products && facts().needs_primary_rgb() &&
            facts().lights.size() <= kMostSampledLights) {
            facts().spectral_groups = (state().light_model.spectrum->count() + 2) / 3;
            return;
        }
        if (!plan_.has_reasons) return;
        plan_.leave_out(
            tr("{} spectral samples", state().light_model.spectrum->count()),
            facts().spectral_products
                ? "the products with a light are linear in the vertex colours, so a matrix replaces the samples"
                : "the products of lights and materials are the same at every vertex, so they are "
                  "converted to red, green and blue once");
    }

    void plan_geometry(const DrawBounds& bounds) {
        if (!facts().needs_position_eye())
            plan_.leave_out("positions in eye coordinates", "no light is positional, and the viewer is at infinity");

        facts().normalize = facts().needs_normal() && state().normalize;
        if (!facts().needs_normal())
            plan_.leave_out("normals", "no light has a diffuse or specular term");
        else if (!state().normalize)
            plan_.leave_out("GL_NORMALIZE",
                            state().rescale_normal
                                ? "it is disabled; the normal matrix includes GL_RESCALE_NORMAL's factor"
                                : "it is disabled",
                            !state().rescale_normal);
        else if (!options_.for_any_pose)
            plan_normalize(bounds);
    }

    // 2.11.3: if all normals are unit vectors and the modelview matrix scales all directions alike, one factor
    // makes the normals unit in eye coordinates: GL_RESCALE_NORMAL's, or 1.
    void plan_normalize(const DrawBounds& bounds) {
        constexpr double kOffByRounding =
            10 * kBoundsRounding;  // double's rounding error and the bounds' margin for it
        const double shortest = vertices_.shortest_normal, longest = vertices_.longest_normal;
        if (longest == 0) return;
        const double off = bounds.unequal_normals + std::max(std::abs(shortest - 1), std::abs(longest - 1));
        if (off > kOffByRounding && !is_within_budget(off)) return;
        facts().normalize = state().normalize = false;
        state().rescale_normal = std::abs(bounds.normal_scale - 1) > kOffByRounding;
        plan_.leave_out("GL_NORMALIZE",
                        state().rescale_normal
                            ? "the normals are unit vectors and the scale is uniform, so GL_RESCALE_NORMAL's factor in "
                              "the normal matrix is enough"
                            : "the normals are unit vectors, and the modelview matrix does not scale them");
    }

    // Whether the error of skipping GL_NORMALIZE fits into the budget; if so, adds it to error_bound. `off`: the
    // largest relative error of a normal's length. The diffuse terms get the same error, the highlights its power.
    // Phong shading is excluded: there the error would also turn the interpolated normals, past the step of f_i.
    bool is_within_budget(double off) {
        if (facts().shading == Shading::kPhong || off > 1e-4) return false;
        double exponent = 1;
        for (const Materials& m : materials_) exponent = std::max({exponent, m.front.shininess, m.back.shininess});
        if (facts().highlight == Highlight::kReflection) exponent *= 2;
        double lights = 0;
        for (const LightBound& light : plan_.light_bounds)
            if (light.in()) lights += light.largest();
        const double error = plan_.error_bound + lights * 1.01 * (std::exp(off * exponent) - 1);
        if (!(error <= plan_.budget)) return false;
        plan_.error_bound = error;
        return true;
    }

    const Draw& draw_;
    const PlanOptions& options_;
    const VertexFacts& vertices_;
    Plan plan_;
    std::vector<Materials> materials_;  // the vertices' effective materials; a single one if all are equal
};

}  // namespace

Plan plan_effects(const Draw& draw, const PlanOptions& options) {
    return plan_effects(draw, options, vertex_facts(draw));
}

Plan plan_effects(const Draw& draw, const PlanOptions& options, const VertexFacts& vertices) {
    return Planner(draw, options, vertices).plan();
}

}  // namespace twinlight

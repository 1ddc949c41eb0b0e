// plan_effects: from a Draw to the facts that change its code, with a reason for each that is left out.
#include "effect/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "effect/directional_spot.h"
#include "effect/fragment_effects.h"

namespace twinlight {
namespace {

bool is_zero(const glm::dvec3& c) { return c == glm::dvec3(0); }
glm::dvec3 rgb(const glm::dvec4& c) { return glm::dvec3(c); }
bool is_whole(double x) { return x == std::floor(x); }

bool has_faces(Enum mode) {
    return mode != kGL_POINTS && mode != kGL_LINES && mode != kGL_LINE_LOOP && mode != kGL_LINE_STRIP;
}

Power power_of(double exponent) {
    if (exponent == 0) return Power::kOne;
    return is_whole(exponent) ? Power::kWhole : Power::kReal;
}

// ---- The state in force ----

// 2.14.3: the colours of the material that color_material's mode names.
FaceEffects tracked_by(Enum mode) {
    const bool both = mode == kGL_AMBIENT_AND_DIFFUSE;
    return {.tracks_emission = mode == kGL_EMISSION,
            .tracks_ambient = mode == kGL_AMBIENT || both,
            .tracks_diffuse = mode == kGL_DIFFUSE || both,
            .tracks_specular = mode == kGL_SPECULAR};
}

void put_color(Material& material, const FaceEffects& tracked, const glm::dvec4& color) {
    if (tracked.tracks_emission) material.emission = color;
    if (tracked.tracks_ambient) material.ambient = color;
    if (tracked.tracks_diffuse) material.diffuse = color;
    if (tracked.tracks_specular) material.specular = color;
}

bool names_front(Enum face) { return face != kGL_BACK; }
bool names_back(Enum face) { return face != kGL_FRONT; }

bool all_colors_equal(const Draw& draw) {
    return std::all_of(draw.vertices.begin(), draw.vertices.end(),
                       [&](const Vertex& v) { return v.color == draw.vertices.front().color; });
}

// ---- The planner ----

class Planner {
  public:
    Planner(const Draw& draw, const RenderOptions& options) : draw_(draw), options_(options) {}

    Plan plan() {
        state().enabled = draw_.lighting.enabled;
        plan_fragments(draw_, plan_);
        facts().shading =
            options_.shading.value_or(draw_.lighting.shade_model == kGL_FLAT ? Shading::kFlat : Shading::kGouraud);
        if (facts().shading == Shading::kFlat && draw_.mode == kGL_POINTS) {
            facts().shading = Shading::kGouraud;
            leave_out("flat shading", "a point has one vertex");
        }
        if (state().enabled)
            plan_lit();
        else
            plan_unlit();
        plan_colors_that_are_left();
        plan_w();
        return std::move(plan_);
    }

  private:
    EffectSet& facts() { return plan_.effects; }
    LightingState& state() { return plan_.lighting; }
    void leave_out(std::string what, std::string why) { plan_.left_out.push_back({std::move(what), std::move(why)}); }

    void plan_unlit() {
        leave_out("lighting", "GL_LIGHTING is disabled: the vertex's colour is shown as it is");
        if (facts().shading == Shading::kPhong) {
            facts().shading = Shading::kGouraud;
            leave_out("lighting per fragment", "GL_LIGHTING is disabled");
        }
        facts().clamp = std::any_of(draw_.vertices.begin(), draw_.vertices.end(),
                                    [](const Vertex& v) { return glm::clamp(v.color, 0.0, 1.0) != v.color; });
        if (!facts().clamp) leave_out("the clamp", "no vertex's colour leaves [0,1]");
    }

    void plan_lit() {
        facts().lighting = facts().clamp = true;
        put_state_in_force();
        plan_faces();
        plan_color_material();
        plan_materials();
        plan_.constant_ambient = rgb(state().light_model.ambient);
        for (std::size_t i = 0; i < state().lights.size(); ++i) plan_light(static_cast<int>(i));
        plan_specular();
        drop_idle_colors();
        plan_geometry();
        if (facts().shading == Shading::kPhong && !facts().needs_normal() && !facts().needs_position_eye() &&
            !facts().needs_color() && !facts().front.varies() && !facts().back.varies()) {
            facts().shading = Shading::kGouraud;
            leave_out("lighting per fragment", "nothing that it depends on varies over the primitive");
        }
    }

    // GL_REPLACE may leave nothing of the primary colour; then only a separate specular colour is worth lighting.
    void plan_colors_that_are_left() {
        if (facts().needs_primary() || facts().separate_specular) return;
        leave_out("lighting and colours", "GL_REPLACE by a texture with colour and alpha leaves nothing of them");
        EffectSet left;
        left.texture = facts().texture;
        left.fog = facts().fog;
        left.clip_plane_count = facts().clip_plane_count;
        facts() = left;
        state().enabled = false;
        plan_.lights.clear();
    }

    void plan_w() {
        const glm::dmat4& m = draw_.eye_from_object;
        const bool affine = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
        const bool w_is_1 = affine && std::all_of(draw_.vertices.begin(), draw_.vertices.end(),
                                                  [](const Vertex& v) { return v.position_object.w == 1; });
        const bool w_matters = facts().needs_position_eye() || facts().has_fog();
        facts().vertex_w = w_matters && !w_is_1;
        if (w_matters && w_is_1) leave_out("the division by w", "w is 1 at every vertex");
    }

    void put_state_in_force() {
        state() = draw_.lighting;
        if (options_.lecture_variants) return;
        const LightModel initial;
        state().light_model.specular = initial.specular;
        state().light_model.light_ambient = initial.light_ambient;
        for (LightSource& light : state().lights) light.smooth_cone.reset();
    }

    // 2.14.1: two-sided lighting; 2.13.1: what is culled is not seen.
    void plan_faces() {
        const RasterState& raster = draw_.raster;
        const auto why_one_sided = [&]() -> std::string {
            if (!state().light_model.two_side) return "GL_LIGHT_MODEL_TWO_SIDE is off";
            if (!has_faces(draw_.mode)) return "points and lines are always front";
            if (raster.cull_enabled && raster.cull_face != kGL_FRONT) return "back faces are culled";
            return "";
        }();
        facts().two_side = why_one_sided.empty();
        if (!facts().two_side) {
            leave_out("two-sided lighting", why_one_sided);
            state().back = state().front;
        }
        // Those that a vertex has.
        std::set<std::uint32_t> used;
        if (!draw_.materials.empty())
            for (const Vertex& v : draw_.vertices) used.insert(v.material);
        for (const std::uint32_t i : used) materials_.push_back(draw_.materials.at(i));
        if (materials_.empty()) materials_.push_back({state().front, state().back});
        if (!facts().two_side)
            for (Materials& m : materials_) m.back = m.front;
    }

    void plan_color_material() {
        ColorMaterial& tracking = state().color_material;
        if (!tracking.enabled) {
            leave_out("colour material", "GL_COLOR_MATERIAL is disabled");
            return;
        }
        const FaceEffects tracked = tracked_by(tracking.mode);
        const bool front = names_front(tracking.face);
        const bool back = facts().two_side && names_back(tracking.face);
        if (draw_.vertices.empty() || all_colors_equal(draw_)) {
            const glm::dvec4 color = draw_.vertices.empty() ? glm::dvec4(1) : draw_.vertices.front().color;
            for (Materials& m : materials_) {
                if (front) put_color(m.front, tracked, color);
                if (back) put_color(m.back, tracked, color);
            }
            leave_out("colour material", "every vertex has the same colour: it is the material's");
            tracking.enabled = false;
        } else if (!front && !back) {
            leave_out("colour material", "it tracks the back face's material, which is not shown");
            tracking.enabled = false;
        } else {
            if (front) facts().front = tracked;
            if (back) facts().back = tracked;
        }
    }

    // 2.14.2: glMaterial between glBegin and glEnd. What is the same in all materials is no vertex's.
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
            leave_out("materials of vertices", "every vertex has the same");
    }

    // Whether a colour of the light meets a material that is not black there: on a face that shows, in some channel.
    bool meets(const glm::dvec4& light_color, glm::dvec4 Material::*color, bool FaceEffects::*tracks) {
        const auto on = [&](const Material& material, const FaceEffects& face) {
            return !is_zero(face.*tracks ? rgb(light_color) : rgb(light_color) * rgb(material.*color));
        };
        return std::any_of(materials_.begin(), materials_.end(), [&](const Materials& m) {
            return on(m.front, facts().front) || (facts().two_side && on(m.back, facts().back));
        });
    }

    void plan_light(int number) {
        const LightSource& light = state().lights[static_cast<std::size_t>(number)];
        const std::string name = light_name(number);
        if (!light.enabled) return leave_out(name, "it is not enabled");

        LightEffects effects;
        PlannedLight planned{.number = number};
        std::vector<LeftOut> notes;
        const auto note = [&](const char* what, std::string why) {
            notes.push_back({fmt::format("{}'s {}", name, what), std::move(why)});
        };
        effects.directional = light.position_eye.w == 0;
        const bool is_spot = light.spot_cutoff_deg != 180 || light.smooth_cone;
        if (effects.directional) {
            planned.constant_reach = directional_spot(light);
            note("attenuation", "its position's w is 0: it is directional");
            if (is_spot)
                note("cone", fmt::format("it is directional: its spot factor is {:.6g} at every vertex",
                                         planned.constant_reach));
        } else {
            const double k0 = light.constant_attenuation;
            effects.attenuated = light.linear_attenuation != 0 || light.quadratic_attenuation != 0;
            if (!effects.attenuated) {
                // RULING: 1/0 contributes nothing.
                planned.constant_reach = k0 > 0 ? 1 / k0 : 0;
                note("attenuation",
                     fmt::format("its factors are {}, 0, 0: it is {:.6g} at every vertex", k0, planned.constant_reach));
            }
            effects.spot = is_spot && !light.smooth_cone;
            effects.smooth_cone = light.smooth_cone.has_value();
            effects.spot_exponent = effects.spot ? power_of(light.spot_exponent) : Power::kOne;
            if (effects.spot && effects.spot_exponent == Power::kOne)
                note("fall-off inside the cone", "GL_SPOT_EXPONENT is 0");
        }
        if (!is_spot) note("cone", "GL_SPOT_CUTOFF is 180");

        const bool reaches = planned.constant_reach > 0;
        const bool primary = facts().needs_primary_rgb();
        const bool ambient = primary && meets(light.ambient, &Material::ambient, &FaceEffects::tracks_ambient);
        effects.diffuse = primary && reaches && meets(light.diffuse, &Material::diffuse, &FaceEffects::tracks_diffuse);
        effects.specular = (primary || is_specular_separate()) && reaches &&
                           meets(light.specular, &Material::specular, &FaceEffects::tracks_specular);

        // An ambient term that nothing weakens on its way belongs to the scene's.
        const bool unattenuated = state().light_model.light_ambient == Word::unattenuated;
        const bool varies = effects.attenuated || effects.spot || effects.smooth_cone;
        if (ambient && (unattenuated || !varies)) {
            plan_.constant_ambient += (unattenuated ? 1 : planned.constant_reach) * rgb(light.ambient);
            note("ambient term", "it is the same at every vertex: it is added to the scene's ambient light");
        } else {
            effects.ambient = reaches && ambient;
        }

        if (!effects.ambient && !effects.diffuse && !effects.specular)
            return leave_out(name, why_nothing(light, ambient, reaches));
        if (!effects.ambient && !ambient)
            note("ambient term", "the product of its and the material's ambient colours is 0");
        if (!effects.diffuse) note("diffuse term", "the product of its and the material's diffuse colours is 0");
        if (!effects.specular) note("specular term", "the product of its and the material's specular colours is 0");
        plan_.left_out.insert(plan_.left_out.end(), notes.begin(), notes.end());
        plan_.lights.push_back(planned);
        facts().lights.push_back(effects);
    }

    bool is_specular_separate() const {
        return plan_.lighting.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    }

    std::string why_nothing(const LightSource& light, bool ambient, bool reaches) const {
        if (ambient && (reaches || plan_.lighting.light_model.light_ambient == Word::unattenuated))
            return "it has an ambient term alone, the same at every vertex: it is added to the scene's "
                   "ambient light";
        if (!plan_.effects.needs_primary_rgb()) return "the texture takes the place of the colours that it gives";
        if (reaches) return "the products of its colours and the material's are 0";
        return light.position_eye.w == 0 ? "it is directional, and its direction is outside its cone"
                                         : "its attenuation factors are 0, 0, 0: it contributes nothing";
    }

    void plan_specular() {
        const LightModel& model = state().light_model;
        if (!facts().any_light(&LightEffects::specular)) {
            leave_out("specular highlights", "no light has a specular term");
            return;
        }
        facts().separate_specular = is_specular_separate();
        if (!facts().separate_specular)
            leave_out("a separate specular colour", "GL_LIGHT_MODEL_COLOR_CONTROL is GL_SINGLE_COLOR");
        facts().highlight = model.specular == Word::reflection ? Highlight::kReflection : Highlight::kHalfVector;
        // What lies between two whole numbers is not whole.
        const bool between =
            facts().shading == Shading::kPhong && (facts().front.varies_shininess || facts().back.varies_shininess);
        facts().shininess = between ? Power::kReal : Power::kOne;
        for (const Materials& m : materials_)
            facts().shininess = std::max({facts().shininess, power_of(m.front.shininess), power_of(m.back.shininess)});
        facts().local_viewer = model.local_viewer && facts().shininess != Power::kOne;
        if (facts().shininess == Power::kOne)
            leave_out("the highlight's shape", "GL_SHININESS is 0: x^0 is 1 for every x");
        if (!facts().local_viewer)
            leave_out("the local viewer", model.local_viewer ? "with a GL_SHININESS of 0 no viewer matters"
                                                             : "GL_LIGHT_MODEL_LOCAL_VIEWER is off");
    }

    // A colour of the vertex that meets no light is not called for. The diffuse colour is also the alpha.
    void drop_idle_colors() {
        const bool primary = facts().needs_primary_rgb();
        const bool ambient = !is_zero(plan_.constant_ambient) || facts().any_light(&LightEffects::ambient);
        const bool diffuse = facts().any_light(&LightEffects::diffuse);
        const bool specular = facts().any_light(&LightEffects::specular);
        const auto drop = [&](bool& fact, bool called_for, const char* what, const char* why) {
            if (!fact || called_for) return;
            fact = false;
            leave_out(what, primary ? why : "the texture takes its place");
        };
        const auto drop_of_face = [&](FaceEffects& face, Material Materials::*of) {
            const bool alpha = facts().needs_primary_alpha();
            const bool alphas = alpha && std::any_of(materials_.begin(), materials_.end(), [&](const Materials& m) {
                                    return (m.*of).diffuse.a != (materials_.front().*of).diffuse.a;
                                });
            drop(face.tracks_emission, primary, "the tracked emission", "");
            drop(face.tracks_ambient, primary && ambient, "the tracked ambient colour", "there is no ambient light");
            drop(face.tracks_diffuse, diffuse || alpha, "the tracked diffuse colour", "");
            drop(face.tracks_specular, specular, "the tracked specular colour", "no light has a specular term");
            drop(face.varies_emission, primary, "the vertices' emission", "");
            drop(face.varies_ambient, primary && ambient, "the vertices' ambient colours", "there is no ambient light");
            drop(face.varies_diffuse, diffuse || alphas, "the vertices' diffuse colours",
                 "no light has a diffuse term");
            drop(face.varies_specular, specular, "the vertices' specular colours", "no light has a specular term");
            drop(face.varies_shininess, specular, "the vertices' shininess", "no light has a specular term");
        };
        drop_of_face(facts().front, &Materials::front);
        drop_of_face(facts().back, &Materials::back);
    }

    void plan_geometry() {
        if (!facts().needs_position_eye())
            leave_out("positions in eye coordinates", "no light is positional and the viewer is infinite");

        facts().normalize = facts().needs_normal() && state().normalize;
        if (!facts().needs_normal())
            leave_out("normals", "no light has a diffuse or a specular term");
        else if (!state().normalize)
            leave_out("GL_NORMALIZE", state().rescale_normal
                                          ? "it is disabled; GL_RESCALE_NORMAL's factor is in the normals' matrix"
                                          : "it is disabled");
    }

    const Draw& draw_;
    const RenderOptions& options_;
    Plan plan_;
    std::vector<Materials> materials_;  // in force, of the vertices; one where they have all the same
};

}  // namespace

Plan plan_effects(const Draw& draw, const RenderOptions& options) { return Planner(draw, options).plan(); }

}  // namespace twinlight

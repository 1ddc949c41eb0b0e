// plan_effects: from a Draw to the facts that change its code, with a reason for each that is left out.
#include "effect/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

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

// spot_i of a directional light (2.14.1), the same at every vertex; the lecture's cone takes its place where
// it is set. A cosine at the border belongs to the cone: kRounding is what two roundings to double can take from it.
double directional_spot(const LightSource& light) {
    constexpr double kRounding = 1e-15;
    const auto cos_deg = [](double deg) { return deg == 90 ? 0 : std::cos(deg * std::numbers::pi / 180); };
    const auto unit = [](const glm::dvec3& v) {
        const double biggest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return biggest > 0 ? glm::normalize(v / biggest) : glm::dvec3(0);
    };
    const double cosine = glm::dot(-unit(rgb(light.position_eye)), unit(light.spot_direction_eye));
    if (light.smooth_cone) {
        const double outer = cos_deg(light.smooth_cone->outer_deg);
        const double span = cos_deg(light.smooth_cone->inner_deg) - outer;
        if (span > 0) return std::clamp((cosine - outer) / span, 0.0, 1.0);
        return cosine >= outer - kRounding ? 1 : 0;  // RULING: equal cones are a step that includes its border
    }
    if (light.spot_cutoff_deg == 180) return 1;
    if (cosine < cos_deg(light.spot_cutoff_deg) - kRounding) return 0;
    return light.spot_exponent == 0 ? 1 : std::pow(std::max(cosine, 0.0), light.spot_exponent);
}

// ---- The planner ----

class Planner {
  public:
    Planner(const Draw& draw, const RenderOptions& options) : draw_(draw), options_(options) {}

    Plan plan() {
        state().enabled = draw_.lighting.enabled;
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
        plan_.constant_ambient = rgb(state().light_model.ambient);
        for (int number = 0; number < kMaxLights; ++number) plan_light(number);
        plan_specular();
        drop_idle_tracking();
        plan_geometry();
        if (facts().shading == Shading::kPhong && !facts().needs_normal() && !facts().needs_position_eye() &&
            !facts().needs_color()) {
            facts().shading = Shading::kGouraud;
            leave_out("lighting per fragment", "nothing that it depends on varies over the primitive");
        }
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
            if (front) put_color(state().front, tracked, color);
            if (back) put_color(state().back, tracked, color);
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

    // Whether a colour of the light meets a material that is not black there: on a face that shows, in some channel.
    bool meets(const glm::dvec4& light_color, glm::dvec4 Material::*color, bool FaceEffects::*tracks) {
        const auto on = [&](const Material& material, const FaceEffects& face) {
            return !is_zero(face.*tracks ? rgb(light_color) : rgb(light_color) * rgb(material.*color));
        };
        return on(state().front, facts().front) || (facts().two_side && on(state().back, facts().back));
    }

    void plan_light(int number) {
        const LightSource& light = state().lights[static_cast<std::size_t>(number)];
        const std::string name = fmt::format("GL_LIGHT{}", number);
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
        const bool ambient = meets(light.ambient, &Material::ambient, &FaceEffects::tracks_ambient);
        effects.diffuse = reaches && meets(light.diffuse, &Material::diffuse, &FaceEffects::tracks_diffuse);
        effects.specular = reaches && meets(light.specular, &Material::specular, &FaceEffects::tracks_specular);

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
        facts().lights[static_cast<std::size_t>(facts().light_count++)] = effects;
    }

    std::string why_nothing(const LightSource& light, bool ambient, bool reaches) const {
        if (ambient && (reaches || plan_.lighting.light_model.light_ambient == Word::unattenuated))
            return "it has an ambient term alone, the same at every vertex: it is added to the scene's "
                   "ambient light";
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
        facts().separate_specular = model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
        if (!facts().separate_specular)
            leave_out("a separate specular colour", "GL_LIGHT_MODEL_COLOR_CONTROL is GL_SINGLE_COLOR");
        facts().highlight = model.specular == Word::reflection ? Highlight::kReflection : Highlight::kHalfVector;
        facts().shininess = std::max(power_of(state().front.shininess), power_of(state().back.shininess));
        facts().local_viewer = model.local_viewer && facts().shininess != Power::kOne;
        if (facts().shininess == Power::kOne)
            leave_out("the highlight's shape", "GL_SHININESS is 0: x^0 is 1 for every x");
        if (!facts().local_viewer)
            leave_out("the local viewer", model.local_viewer ? "with a GL_SHININESS of 0 no viewer matters"
                                                             : "GL_LIGHT_MODEL_LOCAL_VIEWER is off");
    }

    // A tracked colour that meets no light is not called for. The diffuse colour is also the alpha.
    void drop_idle_tracking() {
        const bool ambient = !is_zero(plan_.constant_ambient) || facts().any_light(&LightEffects::ambient);
        const bool specular = facts().any_light(&LightEffects::specular);
        for (FaceEffects* face : {&facts().front, &facts().back}) {
            if (face->tracks_ambient && !ambient) {
                face->tracks_ambient = false;
                leave_out("the tracked ambient colour", "there is no ambient light");
            }
            if (face->tracks_specular && !specular) {
                face->tracks_specular = false;
                leave_out("the tracked specular colour", "no light has a specular term");
            }
        }
    }

    void plan_geometry() {
        const glm::dmat4& m = draw_.eye_from_object;
        const bool affine = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
        const bool w_is_1 = affine && std::all_of(draw_.vertices.begin(), draw_.vertices.end(),
                                                  [](const Vertex& v) { return v.position_object.w == 1; });
        facts().vertex_w = facts().needs_position_eye() && !w_is_1;
        if (!facts().needs_position_eye())
            leave_out("positions in eye coordinates", "no light is positional and the viewer is infinite");
        else if (w_is_1)
            leave_out("the division by w", "w is 1 at every vertex");

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
};

std::string describe(const LightEffects& light) {
    std::string text = light.directional ? "directional" : "positional";
    const auto add = [&](bool fact, const char* name) {
        if (fact) text += fmt::format(", {}", name);
    };
    add(light.attenuated, "attenuated");
    add(light.spot, "spot");
    add(light.spot_exponent == Power::kWhole, "whole spot exponent");
    add(light.spot_exponent == Power::kReal, "spot exponent");
    add(light.smooth_cone, "smooth cone");
    add(light.ambient, "ambient");
    add(light.diffuse, "diffuse");
    add(light.specular, "specular");
    return text;
}

std::string tracked_names(const FaceEffects& face) {
    std::string text;
    const auto add = [&](bool fact, const char* name) {
        if (fact) text += (text.empty() ? "" : ", ") + std::string(name);
    };
    add(face.tracks_emission, "emission");
    add(face.tracks_ambient, "ambient");
    add(face.tracks_diffuse, "diffuse");
    add(face.tracks_specular, "specular");
    return text;
}

}  // namespace

std::string describe(const EffectSet& effects) {
    std::string text;
    const auto add = [&](bool fact, const std::string& line) {
        if (fact) text += line + "\n";
    };
    add(effects.lighting, "lighting");
    add(!effects.lighting, "no lighting");
    add(effects.shading == Shading::kFlat, "flat shading");
    add(effects.shading == Shading::kGouraud, "gouraud shading");
    add(effects.shading == Shading::kPhong, "phong shading");
    add(effects.clamp, "clamp");
    add(effects.two_side, "two-sided");
    add(effects.local_viewer, "local viewer");
    add(effects.vertex_w, "division by w");
    add(effects.normalize, "normalize");
    add(effects.separate_specular, "separate specular colour");
    add(effects.highlight == Highlight::kReflection, "specular by reflection");
    add(effects.shininess == Power::kWhole, "whole shininess");
    add(effects.shininess == Power::kReal, "shininess");
    add(effects.front != FaceEffects{}, "front material tracks: " + tracked_names(effects.front));
    add(effects.back != FaceEffects{}, "back material tracks: " + tracked_names(effects.back));
    for (int i = 0; i < effects.light_count; ++i)
        add(true, fmt::format("light {}: {}", i, describe(effects.lights[static_cast<std::size_t>(i)])));
    return text;
}

Plan plan_effects(const Draw& draw, const RenderOptions& options) { return Planner(draw, options).plan(); }

}  // namespace twinlight

// The derivation as JSON.
#include <glm/mat4x4.hpp>

#include "judge/explain/derivation_light.h"

namespace twinlight::explain {

Json color_json(const reference::Vec& c) { return {c.x, c.y, c.z}; }

std::vector<std::string> names_of(const std::vector<int>& lights) {
    std::vector<std::string> names;
    for (const int light : lights) names.push_back(light_name(light));
    return names;
}

namespace {

using lighting::LightGeometry;
using reference::LitPoint;
using reference::Vec;

Json list_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Json list_of(const glm::dvec4& v) { return {v.x, v.y, v.z, v.w}; }
// Row by row, as in the specification.
Json list_of(const glm::dmat4& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) rows.push_back({m[0][row], m[1][row], m[2][row], m[3][row]});
    return rows;
}

// JSON for the typed value; null for its place if it is GL's initial one.
template <class Value>
Json typed_json(const Value& typed) {
    return {{"value", list_of(typed.value)},
            {"place", typed.is_initial() ? Json(nullptr) : Json(typed.place.str())},
            {"modelview", list_of(typed.eye_from_typed)}};
}

Json light_json(const Derivation& at, std::size_t i) {
    const LightAt light(at, i);
    const LightSource& s = light.source;
    const LightGeometry<double>& g = light.geometry;
    Json json = {{"name", light_name(light.number)}, {"directional", light.directional()}};
    if (light.typed) json["position_typed"] = typed_json(light.typed->position);
    json["position_eye"] = list_of(s.position_eye);
    json["to_light"] = color_json(g.vp_dir);
    if (!light.directional()) json["distance"] = g.distance;
    json["normal_to_light_deg"] = light.normal_to_light_deg;
    json["attenuation"] = light.terms.attenuation;
    json["attenuation_factors"] = {s.constant_attenuation, s.linear_attenuation, s.quadratic_attenuation};
    json["attenuation_denominator"] = g.denominator;
    json["spot"] = light.terms.spot;
    json["spot_cutoff_deg"] = s.spot_cutoff_deg;
    if (light.is_spot()) {
        if (light.typed) json["spot_direction_typed"] = typed_json(light.typed->spot_direction);
        json["spot_direction_eye"] = list_of(s.spot_direction_eye);
        json["spot_exponent"] = s.spot_exponent;
        if (light.has_smooth_cone) json["smooth_cone_deg"] = {s.smooth_cone->inner_deg, s.smooth_cone->outer_deg};
        json["axis_deg"] = light.axis_deg;
        json["cosine_to_axis"] = g.cosine_to_axis;
    }
    json["n_dot_vp"] = light.terms.n_dot_vp;
    json["n_dot_vp_unclamped"] = g.cosine_to_light;
    json["half_vector"] = color_json(g.half_dir);
    json["n_dot_h_unclamped"] = g.cosine_highlight;
    json["normal_to_half_vector_deg"] = light.highlight_deg;
    json["highlight"] = light.terms.highlight;
    json["colors"] = {{"ambient", color_json(light.ambient())},
                      {"diffuse", color_json(light.diffuse())},
                      {"specular", color_json(light.specular())}};
    json["ambient"] = color_json(light.terms.ambient);
    json["diffuse"] = color_json(light.terms.diffuse);
    json["specular"] = color_json(light.terms.specular);
    return json;
}

}  // namespace

Json derivation_json(const Derivation& at) {
    const LitPoint& point = at.point;
    const LightingState& state = at.draw.lighting;
    Json json = {{"weight", point.weight}, {"face", point.face == reference::Face::kFront ? "front" : "back"}};
    if (point.vertex) json["vertex"] = *point.vertex + 1;
    if (point.position_object) json["position_object"] = list_of(*point.position_object);
    json["modelview"] = list_of(at.draw.eye_from_object);
    json["position_eye"] = color_json(point.surface.position_eye);
    if (point.normal_steps) {
        json["normal_object"] = color_json(point.normal_steps->object);
        json["normal_transformed"] = color_json(point.normal_steps->transformed);
        json["normal_transformed_length"] = point.normal_steps->transformed_length();
        json["rescale_factor"] = point.normal_steps->rescale;
    }
    json["normalize"] = state.normalize;
    json["normal_eye"] = color_json(point.surface.normal_eye);
    json["normal_length"] = length_of(point.surface.normal_eye);
    json["to_viewer"] = color_json(point.vpe_dir);
    json["material"] = {{"emission", color_json(point.material.emission)},
                        {"ambient", color_json(point.material.ambient)},
                        {"diffuse", color_json(point.material.diffuse)},
                        {"specular", color_json(point.material.specular)},
                        {"shininess", point.material.shininess}};
    json["scene_ambient_color"] = color_json(rgb_of(state.light_model.ambient));
    json["scene_ambient"] = color_json(point.scene_ambient);
    json["spectral"] = at.is_spectral();
    json["separate_specular"] = state.light_model.color_control == kGL_SEPARATE_SPECULAR_COLOR;
    json["lights"] = Json::array();
    for (std::size_t i = 0; i < at.lights.size(); ++i) json["lights"].push_back(light_json(at, i));
    json["formulas"] = {{"ambient", formula_text(point.formulas.ambient)},
                        {"diffuse", formula_text(point.formulas.diffuse)},
                        {"specular", formula_text(point.formulas.specular)}};
    json["primary_unclamped"] = color_json(point.primary);
    json["primary"] = color_json(clamped_color(point.primary));
    json["secondary_unclamped"] = color_json(point.secondary);
    json["secondary"] = color_json(clamped_color(point.secondary));
    return json;
}

Json rulings_json(const std::vector<reference::PixelFragment::Decided>& rulings) {
    Json json = Json::array();
    for (const auto& decided : rulings) {
        const lighting::RulingText& text = lighting::text_of(decided.ruling);
        json.push_back({{"state", text.state}, {"answer", text.answer}, {"lights", names_of(decided.lights)}});
    }
    return json;
}

}  // namespace twinlight::explain

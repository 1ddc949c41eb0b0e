// An explanation as JSON.
#include "judge/explain/derivation_light.h"
#include "judge/explain/explain.h"

namespace twinlight::explain {

namespace {

using reference::Face;
using reference::LitPoint;
using reference::PixelFragment;
using reference::Vec;

// Means over the fragment's points; "points" has each.
Json mean_json(const LitPoint& mean, const std::vector<int>& lights) {
    Json json = {{"emission", color_json(mean.material.emission)}, {"scene_ambient", color_json(mean.scene_ambient)}};
    json["lights"] = Json::array();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const lighting::LightTerms<double>& terms = mean.terms[i];
        json["lights"].push_back({{"name", light_name(lights[i])},
                                  {"attenuation", terms.attenuation},
                                  {"spot", terms.spot},
                                  {"n_dot_vp", terms.n_dot_vp},
                                  {"highlight", terms.highlight},
                                  {"ambient", color_json(terms.ambient)},
                                  {"diffuse", color_json(terms.diffuse)},
                                  {"specular", color_json(terms.specular)},
                                  {"formulas",
                                   {{"ambient", formula_text(mean.formulas.ambient)},
                                    {"diffuse", formula_text(mean.formulas.diffuse)},
                                    {"specular", formula_text(mean.formulas.specular)}}}});
    }
    json["primary_unclamped"] = color_json(mean.primary);
    json["secondary_unclamped"] = color_json(mean.secondary);
    return json;
}

Json fragment_json(const PixelFragment& fragment, const Scene& scene, const Draw& draw, bool lecture_variants) {
    Json json = {{"draw", fragment.draw + 1},
                 {"place", draw.place.str()},
                 {"face", fragment.face == Face::kFront ? "front" : "back"},
                 {"depth", fragment.depth},
                 {"passes", fragment.passes},
                 {"lit", fragment.is_lit},
                 {"shading", name_of(fragment.shading)}};
    json["corners"] = Json::array();
    for (const PixelFragment::Corner& corner : fragment.corners)
        json["corners"].push_back({{"vertex", corner.vertex + 1}, {"weight", corner.weight}});
    if (fragment.is_lit) {
        json.update(mean_json(mean_of(fragment), fragment.lights));
        json["points"] = Json::array();
        for (const LitPoint& point : fragment.points)
            json["points"].push_back(
                derivation_json({scene.frame, draw, fragment.draw + 1, fragment.lights, point, lecture_variants}));
    }
    add_after_lighting(fragment.steps, draw, json);
    json["color"] = color_json(vec3_cast<Vec>(fragment.color));
    json["rulings"] = rulings_json(fragment.rulings);
    return json;
}

void add_pictures(const std::vector<Rendered>& pictures, Json& json) {
    for (const Rendered& picture : pictures)
        json["pictures"][std::string(name_of(picture.renderer))] = {picture.color[0], picture.color[1],
                                                                    picture.color[2]};
}

}  // namespace

Json json_of(const Scene& scene, const PixelExplanation& explanation) {
    const Pixel& pixel = explanation.pixel;
    Json json = {{"scene", scene.name()}, {"pixel", {pixel.x, pixel.y}}, {"fragments", Json::array()}};
    const std::vector<const Draw*> draws = scene.frame.draws();
    for (const PixelFragment& fragment : explanation.history.fragments)
        json["fragments"].push_back(
            fragment_json(fragment, scene, *draws[fragment.draw], explanation.look.lecture_variants));
    if (const std::string note = almost_one_depth(scene.frame, explanation.history.fragments); !note.empty())
        json["note"] = note;
    add_pictures(explanation.rendered, json);
    if (explanation.allowed) {
        Json& allowed = json["allowed"] = {{"edge", explanation.allowed->edge}};
        if (!explanation.allowed->edge) allowed["difference"] = explanation.allowed->channels;
        allowed["why"] = Json::array();
        for (const Why why : explanation.allowed->why) allowed["why"].push_back(words_of(why));
        if (!explanation.allowed->undefined.empty()) allowed["undefined"] = explanation.allowed->undefined;
        if (explanation.allowed->edge) allowed["colors"] = Json::array();
        for (const AllowedRange& range : explanation.allowed->ranges)
            allowed["colors"].push_back({{"low", range.low}, {"high", range.high}});
    }
    return json;
}

Json json_of(const Scene& scene, const VertexExplanation& explanation) {
    const auto [number, vertex] = explanation.vertex;
    const Draw& draw = *scene.frame.draws()[number];
    Json json = {{"scene", scene.name()}, {"draw", number + 1}, {"vertex", vertex + 1}, {"place", draw.place.str()}};
    for (const FaceExplanation& face : explanation.faces) {
        Json one = derivation_json({scene.frame, draw, number + 1, face.history.lights, face.history.point,
                                    explanation.look.lecture_variants});
        one["rulings"] = rulings_json(face.history.rulings);
        add_pictures(face.rendered, one);
        json["faces"].push_back(std::move(one));
    }
    return json;
}

}  // namespace twinlight::explain

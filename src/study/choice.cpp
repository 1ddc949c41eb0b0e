#include "study/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

namespace twinlight::study {

namespace {

constexpr int kQuickSlices[] = {8, 16, 32, 64};
constexpr int kFullSlices[] = {6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
constexpr int kMiddleSlices = 32;  // where one thing is changed at a time

struct Simplification {
    Without without;
    const char* words;
    const char* key;
};
constexpr Simplification kSimplifications[] = {
    {Without::kSpecular, "no highlights", "no-specular"},
    {Without::kLocalViewer, "distant viewer", "distant-viewer"},
    {Without::kPlaces, "directional lights", "directional"},
    {Without::kAttenuation, "no attenuation", "no-attenuation"},
    {Without::kSpots, "no cones", "no-spots"},
    {Without::kNormalize, "normals as they come", "no-normalize"},
};

const Simplification* of(Without without) {
    const auto* found = std::ranges::find(kSimplifications, without, &Simplification::without);
    return found == std::end(kSimplifications) ? nullptr : found;
}

// What comes after the renderer's name.
const char* tier_words(Tier tier) { return tier == Tier::kBaked ? " with constants" : " with uniforms"; }

// All parts of a round shape have one middle: its object space's origin.
glm::dvec3 middle_eye(const Draw& draw) {
    glm::dvec4 sum(0);
    for (const Vertex& vertex : draw.vertices) sum += vertex.position_object;
    const glm::dvec4 middle = draw.eye_from_object * (draw.surfaces ? glm::dvec4(0, 0, 0, 1) : sum);
    return middle.w == 0 ? glm::dvec3(0) : glm::dvec3(middle) / middle.w;
}

void make_directional(Draw& draw, LightSource& light) {
    if (light.position_eye.w == 0) return;
    const glm::dvec3 way = glm::dvec3(light.position_eye) / light.position_eye.w - middle_eye(draw);
    light.position_eye = glm::dvec4(glm::dot(way, way) == 0 ? glm::dvec3(0, 0, 1) : way, 0);
}

void simplify(Draw& draw, Without without) {
    LightingState& state = draw.lighting;
    const auto for_materials = [&](const auto& change) {
        for (Material* material : {&state.front, &state.back}) change(*material);
        for (Materials& materials : draw.materials)
            for (Material* material : {&materials.front, &materials.back}) change(*material);
    };
    switch (without) {
        case Without::kNothing: return;
        case Without::kSpecular:
            for_materials([](Material& material) { material.specular = glm::dvec4(0, 0, 0, 1); });
            return;
        case Without::kLocalViewer: state.light_model.local_viewer = false; return;
        case Without::kNormalize: state.normalize = state.rescale_normal = false; return;
        case Without::kPlaces:
        case Without::kAttenuation:
        case Without::kSpots: break;
    }
    for (LightSource& light : state.lights) {
        if (!light.enabled) continue;
        if (without == Without::kPlaces) make_directional(draw, light);
        if (without == Without::kAttenuation) {
            light.constant_attenuation = 1;
            light.linear_attenuation = light.quadratic_attenuation = 0;
        }
        if (without == Without::kSpots) {
            light.spot_cutoff_deg = 180;
            light.smooth_cone.reset();
        }
    }
}

// Whether the scene has it at all.
bool matters(const Frame& frame, Without without) {
    const auto any = [](const LightingState& state, const auto& of_light) {
        return std::ranges::any_of(state.lights,
                                   [&](const LightSource& light) { return light.enabled && of_light(light); });
    };
    return std::ranges::any_of(frame.items, [&](const auto& item) {
        const Draw* draw = std::get_if<Draw>(&item);
        if (!draw || !draw->lighting.enabled) return false;
        const LightingState& state = draw->lighting;
        const auto is_place = [](const LightSource& light) { return light.position_eye.w != 0; };
        const auto shines = [](const Material& material) { return glm::dvec3(material.specular) != glm::dvec3(0); };
        switch (without) {
            case Without::kNothing: return false;
            case Without::kSpecular: return shines(state.front) || !draw->materials.empty();
            case Without::kLocalViewer: return state.light_model.local_viewer;
            case Without::kPlaces: return any(state, is_place);
            case Without::kNormalize: return state.normalize || state.rescale_normal;
            case Without::kAttenuation:
                return any(state, [&](const LightSource& light) {
                    return is_place(light) && (light.linear_attenuation != 0 || light.quadratic_attenuation != 0 ||
                                               light.constant_attenuation != 1);
                });
            case Without::kSpots:
                return any(state, [](const LightSource& light) {
                    return light.spot_cutoff_deg != 180 || light.smooth_cone.has_value();
                });
        }
        return false;
    });
}

}  // namespace

const char* name_of(Shading shading) {
    switch (shading) {
        case Shading::kFlat: return "flat";
        case Shading::kGouraud: return "gouraud";
        case Shading::kPhong: return "phong";
        case Shading::kExact: return "exact";
    }
    return "";
}

std::string Choice::words() const {
    std::string text = name_of(shading);
    if (slices > 0) text += fmt::format(", {} slices", slices);
    text += renderer == "fixed" ? ", fixed function" : renderer == "reference" ? ", reference" : ", shaders";
    if (renderer == "programmable") text += tier_words(tier);
    if (const Simplification* simplification = of(without)) text += std::string(", ") + simplification->words;
    if (budget != RenderOptions{}.budget) text += fmt::format(", budget {:.3g}", budget);
    return text;
}

std::string Choice::key() const {
    std::string text = renderer + (tier == Tier::kBaked ? "-baked-" : "-") + name_of(shading);
    if (slices > 0) text += fmt::format("-{}", slices);
    if (const Simplification* simplification = of(without)) text += std::string("-") + simplification->key;
    if (budget != RenderOptions{}.budget) text += fmt::format("-budget-{:.3g}", budget);
    return text;
}

RenderOptions Choice::options() const {
    RenderOptions options;
    options.shading = shading;
    options.tier = tier;
    options.budget = budget;
    return options;
}

Frame simplified(const Frame& frame, Without without) {
    Frame result = frame;
    for (auto& item : result.items)
        if (Draw* draw = std::get_if<Draw>(&item)) simplify(*draw, without);
    return result;
}

std::vector<Choice> choices(const Frame& frame, bool has_slices, Extent extent) {
    std::vector<int> slices = {0};
    if (has_slices && extent == Extent::kQuick) slices.assign(std::begin(kQuickSlices), std::end(kQuickSlices));
    if (has_slices && extent == Extent::kFull) slices.assign(std::begin(kFullSlices), std::end(kFullSlices));
    std::vector<Choice> result;
    for (const int n : slices) {
        for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
            result.push_back({.renderer = "fixed", .shading = shading, .slices = n});
            result.push_back({.renderer = "programmable", .shading = shading, .slices = n});
            result.push_back({.renderer = "programmable", .shading = shading, .tier = Tier::kBaked, .slices = n});
        }
        result.push_back({.renderer = "programmable", .shading = Shading::kPhong, .slices = n});
        result.push_back({.renderer = "programmable", .shading = Shading::kPhong, .tier = Tier::kBaked, .slices = n});
        result.push_back({.renderer = "reference", .shading = Shading::kPhong, .slices = n});
    }
    result.push_back({.renderer = "programmable", .shading = Shading::kExact});
    result.push_back({.renderer = "programmable", .shading = Shading::kExact, .tier = Tier::kBaked});
    result.push_back({.renderer = "reference", .shading = Shading::kExact});
    const int middle = has_slices ? kMiddleSlices : 0;
    for (const Simplification& simplification : kSimplifications) {
        if (!matters(frame, simplification.without)) continue;
        for (const Shading shading : {Shading::kGouraud, Shading::kPhong})
            result.push_back(
                {.renderer = "programmable", .shading = shading, .slices = middle, .without = simplification.without});
    }
    for (const double budget : {0.0, 4.0 / 255, 16.0 / 255})
        result.push_back({.renderer = "programmable", .shading = Shading::kPhong, .slices = middle, .budget = budget});
    return result;
}

}  // namespace twinlight::study

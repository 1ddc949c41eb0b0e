#include "render/programmable/export/kind_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "render/programmable/export/kept_code.h"
#include "render/programmable/numbers/vertex_attributes.h"
#include "render/programmable/text/kept_text.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

using Flags = std::vector<std::pair<bool, const char*>>;

// "FF_LIGHTING | FF_TWO_SIDE", or "0".
std::string joined(const Flags& flags) {
    std::vector<const char*> names;
    for (const auto& [is_set, name] : flags)
        if (is_set) names.push_back(name);
    return names.empty() ? "0" : fmt::format("{}", fmt::join(names, " | "));
}

std::string features(const Draw& draw, const Plan& plan, const Options& options, bool by_number) {
    const EffectSet& effects = plan.effects;
    const bool depends_on_w = effects.needs_position_eye() || (effects.has_fog() && !effects.fog_coords) ||
                              effects.generates_from_direction();
    return joined({
        {effects.lighting, "FF_LIGHTING"},
        {!effects.needs_primary() && !effects.separate_specular, "FF_ANY_COLOR"},
        {effects.lighting && !effects.needs_primary_rgb(), "FF_LIGHTS_ALPHA"},
        {effects.shading == Shading::kFlat, "FF_FLAT"},
        {options.shading.has_value(), "FF_ANY_SHADE_MODEL"},
        {effects.two_side, "FF_TWO_SIDE"},
        {effects.local_viewer, "FF_LOCAL_VIEWER"},
        {effects.separate_specular, "FF_SEPARATE_SPECULAR"},
        {effects.takes_normal() && draw.lighting.normalize, "FF_NORMALIZE"},
        {effects.takes_normal() && draw.lighting.rescale_normal && !draw.lighting.normalize, "FF_RESCALE"},
        {!effects.takes_normal(), "FF_ANY_NORMAL"},
        {effects.shininess != Power::kZero, "FF_SHININESS"},
        {effects.shininess == Power::kReal, "FF_REAL_SHININESS"},
        {effects.vertex_w || effects.texture.generated_w, "FF_W"},
        {!depends_on_w, "FF_ANY_W"},
        {effects.texture.matrix, "FF_TEXTURE_MATRIX"},
        {effects.texture.q, "FF_Q"},
        {by_number, "FF_BY_NUMBER"},
    });
}

std::string tracked(const EffectSet& effects) {
    const auto flags = [](const FaceEffects& face) {
        return joined({{face.tracks_emission, "FF_TRACKS_EMISSION"},
                       {face.tracks_ambient, "FF_TRACKS_AMBIENT"},
                       {face.tracks_diffuse, "FF_TRACKS_DIFFUSE"},
                       {face.tracks_specular, "FF_TRACKS_SPECULAR"}});
    };
    const std::string front = flags(effects.front), back = flags(effects.back);
    return back == "0" ? front : fmt::format("({}) | ({}) << 4", front, back);
}

std::string light_flags(const LightEffects& light) {
    const bool is_spot = light.cone == SpotCone::kGl;
    return joined({{light.ambient, "FF_AMBIENT"},
                   {light.diffuse, "FF_DIFFUSE"},
                   {light.specular, "FF_SPECULAR"},
                   {light.directional || light.meets_directions, "FF_DIRECTIONAL"},
                   {light.attenuated, "FF_ATTENUATED"},
                   {is_spot, "FF_SPOT"},
                   {is_spot && light.spot_exponent != Power::kZero, "FF_EXPONENT"},
                   {is_spot && light.spot_exponent == Power::kReal, "FF_REAL_EXPONENT"}});
}

const char* mode_of(FogEffect fog) {
    switch (fog) {
        case FogEffect::kNone: return "0";
        case FogEffect::kLinear: return "GL_LINEAR";
        case FogEffect::kExp: return "GL_EXP";
        case FogEffect::kExp2: return "GL_EXP2";
    }
    return "0";
}

}  // namespace

bool is_not_gl(const Plan& plan) {
    const LightModel& model = plan.lighting.light_model;
    const bool has_cone = std::ranges::any_of(
        plan.effects.lights, [](const LightEffects& light) { return light.cone == SpotCone::kSmooth; });
    return has_cone || plan.effects.highlight == Highlight::kReflection || plan.effects.srgb_coded ||
           model.light_ambient == Word::unattenuated;
}

std::string kind_row(const Draw& draw, const Plan& plan, const Code& code, const Options& options, Enum texture,
                     bool by_number) {
    const EffectSet& effects = code.effects;
    const KeptForm& kept = *code.form.kept;
    std::array<std::string, kMostKeptLights> lights;
    lights.fill("0");
    for (std::size_t i = 0; i < kept.lights.size(); ++i)
        lights.at(static_cast<std::size_t>(kept.lights[i])) = light_flags(effects.lights[i]);
    const std::size_t light_count = kept.lights.empty() ? 1 : static_cast<std::size_t>(kept.lights.back()) + 1;

    unsigned planes = 0;
    for (const int plane : kept.clip_planes) planes |= 1U << plane;

    std::array<std::string, 4> generated;
    for (std::size_t i = 0; i < 4; ++i)
        generated[i] = texture == 0 || !effects.has_texture() || effects.texture.uses(i) ? "0" : "1";
    for (const GeneratedCoordinate& one : draw.texture.generated) {
        std::string& mode = generated[static_cast<std::size_t>(one.coordinate)];
        if (mode == "0") mode = enum_name(one.mode);
    }

    std::string names;
    for (const Attribute& attribute : attributes(effects))
        names += fmt::format("\"{}\", ", with_words(attribute.name, kept_names()));
    return fmt::format("{},\n     {},\n     {{{}}},\n     {}, {}, {:#x}, {}, {}, {{{}}},\n     {{{}NULL}}",
                       features(draw, plan, options, by_number), tracked(effects),
                       fmt::join(lights.begin(), lights.begin() + static_cast<std::ptrdiff_t>(light_count), ", "),
                       mode_of(effects.fog),
                       enum_name(draw.fragment.alpha_test ? draw.fragment.alpha_func : Enum{kGL_ALWAYS}), planes,
                       texture == 0 ? "0" : enum_name(texture), texture == 0 ? "0" : enum_name(draw.texture.env_mode),
                       fmt::join(generated, ", "), names);
}

}  // namespace twinlight::programmable

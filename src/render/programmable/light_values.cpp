#include "render/programmable/light_values.h"

#include <fmt/format.h>

namespace twinlight::programmable {

bool needs_light_cosine(const EffectSet& effects, std::size_t i) {
    const LightEffects& light = effects.lights[i];
    return light.diffuse || (light.specular && effects.highlight != Highlight::kReflection);
}

bool needs_light_direction(const EffectSet& effects, std::size_t i) {
    const LightEffects& light = effects.lights[i];
    return light.spot || light.smooth_cone || needs_light_cosine(effects, i) ||
           (light.specular && effects.shininess != Power::kZero);
}

LightValues values_of_light(const EffectSet& effects, const Form& form, std::size_t i) {
    using enum LightValue;
    const LightEffects& light = effects.lights[i];
    const bool is_near = !light.directional && !light.meets_directions;
    const bool has_one_half_vector = light.directional && light.specular && !effects.local_viewer &&
                                     effects.shininess != Power::kZero && effects.highlight == Highlight::kHalfVector;
    LightValues values;
    values.add(kDirection, light.directional && needs_light_direction(effects, i));
    values.add(kHalfDir, has_one_half_vector);
    values.add(kToward, light.meets_directions);
    values.add(kPosition, is_near && !form.wide_range);
    values.add(kNearVertex, is_near && form.wide_range);
    values.add(kWay, is_near && form.wide_range);
    values.add(kAttenuation, light.attenuated);
    values.add(kSpotDir, light.spot || light.smooth_cone);
    values.add(kCosCutoff, light.spot && !light.smooth_cone);
    values.add(kSpotExponent, light.spot && !light.smooth_cone && light.spot_exponent != Power::kZero);
    values.add(kCosOuter, light.smooth_cone);
    values.add(kConeSlope, light.smooth_cone);
    values.add(kAmbient, light.ambient);
    values.add(kDiffuse, light.diffuse);
    values.add(kSpecular, light.specular);
    return values;
}

LightUniform declaration_of(LightValue value, const EffectSet& effects, const Form& form, std::size_t i) {
    const std::string_view space = form.object_space ? "_object" : "_eye";
    switch (value) {
        case LightValue::kDirection: return {"direction", space, "vec3", "VP_i, of length 1"};
        case LightValue::kHalfDir: return {"half_dir", space, "vec3", "h_i, the same at every vertex"};
        case LightValue::kToward: return {"toward", "_eye", "vec3", "P_pli, a direction of any length"};
        case LightValue::kPosition: return {"position", space, "vec3", "P_pli"};
        case LightValue::kNearVertex:
            return {"near", "_object", form.position_w ? "vec4" : "vec3", "the vertex that is nearest to P_pli"};
        case LightValue::kWay: return {"way", "_eye", "vec3", "from there to P_pli"};
        case LightValue::kAttenuation: return {"attenuation", "", "vec3", "k_0i, k_1i, k_2i"};
        case LightValue::kSpotDir: return {"spot_dir", space, "vec3", "s_dli, of length 1"};
        case LightValue::kCosCutoff:
            return {"cos_cutoff", "", "float", form.precise ? "cos(c_rli)" : "cos(c_rli), minus a margin for rounding"};
        case LightValue::kSpotExponent:
            return {"spot_exponent", "", effects.lights[i].spot_exponent == Power::kWhole ? "int" : "float", "s_rli"};
        case LightValue::kCosOuter: return {"cos_outer", "", "float", ""};
        case LightValue::kConeSlope: return {"cone_slope", "", "float", "1 / (cos inner - cos outer)"};
        case LightValue::kAmbient: return {"ambient", "", "vec3", "a_cm a_cli"};
        case LightValue::kDiffuse: return {"diffuse", "", "vec3", "d_cm d_cli"};
        case LightValue::kSpecular: return {"specular", "", "vec3", "s_cm s_cli"};
    }
    return {};
}

std::string name_of(std::size_t i, const LightUniform& uniform, std::string_view face) {
    return fmt::format("u_light{}_{}{}{}{}", i, face, face.empty() ? "" : "_", uniform.name, uniform.space);
}

std::string kept_cone_name(int number, LightValue value) {
    return name_of(static_cast<std::size_t>(number), declaration_of(value, {}, {}, 0));
}

}  // namespace twinlight::programmable

#include "render/programmable/numbers/light_values.h"

#include <fmt/format.h>

#include <initializer_list>

namespace twinlight::programmable {
namespace {

// Calls make(beginning of the name, {the rest}).
template <class Make>
void make_name(std::size_t i, const LightUniform& uniform, std::string_view face, const Make& make) {
    make("u_light" + std::to_string(i) + "_", {face, face.empty() ? "" : "_", uniform.name, uniform.space});
}
template <class Make>
void make_name(std::string_view face, FaceValue value, const EffectSet& effects, const Make& make) {
    make("u_", {face, "_", declaration_of(value, effects).name});
}

using Rest = std::initializer_list<std::string_view>;
auto adding_to(Uniforms& uniforms) {
    return [&uniforms](std::string_view name, Rest rest) { uniforms.add(name, rest); };
}
auto appending_to(std::string& text) {
    return [&text](std::string_view name, Rest rest) {
        text += name;
        for (const std::string_view part : rest) text += part;
    };
}

}  // namespace

bool needs_light_cosine(const EffectSet& effects, std::size_t i) {
    const LightEffects& light = effects.lights[i];
    return light.diffuse || (light.specular && effects.highlight != Highlight::kReflection);
}

bool needs_light_direction(const EffectSet& effects, std::size_t i) {
    const LightEffects& light = effects.lights[i];
    return light.cone != SpotCone::kNone || needs_light_cosine(effects, i) ||
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
    values.add(kSpotDir, light.cone != SpotCone::kNone);
    values.add(kCosCutoff, light.cone == SpotCone::kGl);
    values.add(kSpotExponent, light.cone == SpotCone::kGl && light.spot_exponent != Power::kZero);
    values.add(kCosOuter, light.cone == SpotCone::kSmooth);
    values.add(kConeSlope, light.cone == SpotCone::kSmooth);
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
    std::string name;
    make_name(i, uniform, face, appending_to(name));
    return name;
}
void add_to(Uniforms& uniforms, std::size_t i, const LightUniform& uniform, std::string_view face) {
    make_name(i, uniform, face, adding_to(uniforms));
}

int loop_length(const EffectSet& effects, const Form& form, std::size_t i) {
    const std::size_t written_out = effects.lights.size() - form.loops.size();
    return i < written_out ? 0 : form.loops[i - written_out];
}

std::string name_of_count(std::size_t i) { return fmt::format("u_count_of_light{}", i); }

// ---- Materials ----

ValueSet<ModelValue> values_of_model(const EffectSet& effects) {
    const bool has_ambient =
        ambient_of(effects.front) || (effects.two_side && ambient_of(effects.back));  // with each vertex
    ValueSet<ModelValue> values;
    values.add(ModelValue::kConstantAmbient, has_ambient);
    values.add(ModelValue::kRgbFromSamples, effects.spectral_groups > 0);
    return values;
}

Declaration declaration_of(ModelValue value, const EffectSet& effects) {
    switch (value) {
        case ModelValue::kConstantAmbient:
            return {effects.spectral_products ? "mat3" : "vec3", "u_constant_ambient",
                    "a_cs, plus a_cli of the lights that nothing weakens"};
        case ModelValue::kRgbFromSamples: return {"mat3", "u_rgb_from_samples"};
    }
    return {};
}

ValueSet<FaceValue> values_of_face(const EffectSet& effects, const FaceEffects& face) {
    ValueSet<FaceValue> values;
    values.add(FaceValue::kBase, !emission_of(face) || !ambient_of(face));
    values.add(FaceValue::kAlpha, !diffuse_of(face));
    values.add(FaceValue::kShininess, !face.varies_shininess && effects.shininess != Power::kZero);
    return values;
}

Declaration declaration_of(FaceValue value, const EffectSet& effects) {
    switch (value) {
        case FaceValue::kBase: return {"vec3", "base", "the part of e_cm + a_cm a_cs that is the same at every vertex"};
        case FaceValue::kAlpha: return {"float", "alpha", "the alpha of d_cm"};
        case FaceValue::kShininess: return {effects.shininess == Power::kWhole ? "int" : "float", "shininess", "s_rm"};
    }
    return {};
}

std::string name_of(std::string_view face, FaceValue value, const EffectSet& effects) {
    std::string name;
    make_name(face, value, effects, appending_to(name));
    return name;
}
void add_to(Uniforms& uniforms, std::string_view face, FaceValue value, const EffectSet& effects) {
    make_name(face, value, effects, adding_to(uniforms));
}

LightValues sampled_colors(const EffectSet& effects) {
    LightValues colors;
    if (effects.spectral_groups == 0) return colors;
    colors.add(LightValue::kAmbient, effects.any_light(&LightEffects::ambient));
    colors.add(LightValue::kDiffuse, effects.any_light(&LightEffects::diffuse));
    colors.add(LightValue::kSpecular, effects.any_light(&LightEffects::specular));
    return colors;
}

std::string name_of_face_samples(std::string_view face, LightValue color) {
    return fmt::format("u_{}_{}_samples", face, declaration_of(color, {}, {}, 0).name);
}
std::string name_of_light_samples(std::size_t i, LightValue color) {
    return fmt::format("u_light{}_{}_samples", i, declaration_of(color, {}, {}, 0).name);
}

// ---- Shaders to keep ----

std::string kept_cone_name(int number, LightValue value) {
    return name_of(static_cast<std::size_t>(number), declaration_of(value, {}, {}, 0));
}

}  // namespace twinlight::programmable

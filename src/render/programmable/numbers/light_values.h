// The uniforms of a program's lights and materials, in one list. The text declares those that the list has (LightingNames), and a
// Draw gives a value for each of these and for no other (draw_values.cpp, precise.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "render/effect/effect_set.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/uniforms.h"
#include "render/programmable/numbers/value_set.h"

namespace twinlight::programmable {

// What a program may need of a light, in the coordinates that it lights in: eye or object coordinates.
enum class LightValue : std::uint8_t {
    kDirection,     // VP_i of a directional light, of length 1: u_light0_direction_eye
    kHalfDir,       // its h_i, if the viewer is infinitely far away: u_light0_half_dir_eye
    kToward,        // P_pli of a light that meets directions
    kPosition,      // P_pli, after the division by w
    kNearVertex,    // Form::wide_range: the vertex that is nearest to P_pli
    kWay,           // and the way from there to P_pli
    kAttenuation,   // k_0i, k_1i, k_2i
    kSpotDir,       // s_dli, of length 1
    kCosCutoff,     // of GL's cone
    kSpotExponent,  // s_rli
    kCosOuter,      // of the lecture's cone
    kConeSlope,     // 1 / (cos inner - cos outer)
    kAmbient,       // a_cli, or its product with each face's a_cm, or samples of both
    kDiffuse,       // the same of d_cli and d_cm
    kSpecular,      // and of s_cli and s_cm
};
inline constexpr std::size_t kLightValueCount = static_cast<std::size_t>(LightValue::kSpecular) + 1;
inline constexpr bool is_color(LightValue value) { return value >= LightValue::kAmbient; }

using LightValues = ValueSet<LightValue>;

// The list: all that the program of these effects and this form needs of the i-th light.
LightValues values_of_light(const EffectSet& effects, const Form& form, std::size_t i);

// Whether the i-th light's direction from the vertex is computed, and its cosine with the normal.
bool needs_light_direction(const EffectSet& effects, std::size_t i);
bool needs_light_cosine(const EffectSet& effects, std::size_t i);

// How a uniform of the i-th light is declared: vec3 u_light0_position_eye, whose space is "_eye". A colour's name has its face, too:
// u_light0_front_ambient.
struct LightUniform {
    std::string_view name, space;
    std::string_view type = "vec3";
    std::string_view comment = "";
};
LightUniform declaration_of(LightValue value, const EffectSet& effects, const Form& form, std::size_t i);

// "u_light0_position_eye"; of a face's colours "u_light0_front_ambient".
std::string name_of(std::size_t i, const LightUniform& uniform, std::string_view face = {});
// Adds a uniform of this name, which is made in place: each Draw of each frame comes here.
void add_to(Uniforms& uniforms, std::size_t i, const LightUniform& uniform, std::string_view face = {});

// If the i-th light of the effects represents many lights (Form::loops): the length of its arrays, otherwise 0. Their number is a
// uniform too.
int loop_length(const EffectSet& effects, const Form& form, std::size_t i);
std::string name_of_count(std::size_t i);

// ---- Materials ----

// What a program may need of the light model.
enum class ModelValue : std::uint8_t {
    kConstantAmbient,  // a_cs, to be multiplied with colours that come with each vertex
    kRgbFromSamples,   // the weights from spectral samples to red, green and blue
};
ValueSet<ModelValue> values_of_model(const EffectSet& effects);
Declaration declaration_of(ModelValue value, const EffectSet& effects);

// What a program may need of a face's material: u_front_base.
enum class FaceValue : std::uint8_t {
    kBase,       // the part of e_cm + a_cm a_cs that is the same at every vertex
    kAlpha,      // of d_cm
    kShininess,  // s_rm
};
ValueSet<FaceValue> values_of_face(const EffectSet& effects, const FaceEffects& face);
Declaration declaration_of(FaceValue value, const EffectSet& effects);  // its name is "base"
std::string name_of(std::string_view face, FaceValue value, const EffectSet& effects);
void add_to(Uniforms& uniforms, std::string_view face, FaceValue value, const EffectSet& effects);

// Programs that light in spectral samples need samples of these colours, of each face (u_front_ambient_samples) and of each light
// (u_light0_ambient_samples).
LightValues sampled_colors(const EffectSet& effects);
std::string name_of_face_samples(std::string_view face, LightValue color);
std::string name_of_light_samples(std::size_t i, LightValue color);

// A colour of the material that comes with each vertex: glColor's (2.14.3) or glMaterial's between glBegin and glEnd
// (2.14.2).
struct PerVertexColor {
    bool tracks = false, varies = false;
    explicit operator bool() const { return tracks || varies; }
};
inline PerVertexColor emission_of(const FaceEffects& face) { return {face.tracks_emission, face.varies_emission}; }
inline PerVertexColor ambient_of(const FaceEffects& face) { return {face.tracks_ambient, face.varies_ambient}; }
inline PerVertexColor diffuse_of(const FaceEffects& face) { return {face.tracks_diffuse, face.varies_diffuse}; }
inline PerVertexColor specular_of(const FaceEffects& face) { return {face.tracks_specular, face.varies_specular}; }

// The uniforms of shaders to keep that are not GL's: u_light3_cos_outer. The number is the light's in GL.
std::string kept_cone_name(int number, LightValue value);

}  // namespace twinlight::programmable

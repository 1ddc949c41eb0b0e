// The uniforms of a program's lights, in one list. The text declares those that the list has (LightingNames), and a Draw gives a
// value for each of these and for no other (draw_values.cpp, precise.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "render/effect/effect_set.h"
#include "render/programmable/form.h"
#include "render/programmable/value_set.h"

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

// The uniforms of shaders to keep that are not GL's: u_light3_cos_outer. The number is the light's in GL.
std::string kept_cone_name(int number, LightValue value);

}  // namespace twinlight::programmable

#include "render/programmable/export/c_text.h"

#include <fmt/format.h>

#include <string_view>

#include "render/programmable/numbers/draw_values.h"

namespace twinlight::programmable {

std::string printable(std::string text) {
    for (char& c : text)
        if ((c >= 0 && c < ' ') || std::string_view("<>&\\\x7F").find(c) != std::string_view::npos) c = '?';
    return text;
}

std::string c_number(double x) {
    const std::string text = fmt::format("{:.9g}", to_float(x));
    return text.find_first_of(".en") == text.npos ? text : text + "f";
}

std::string c_floats(const glm::dvec4& v) { return fmt::format("(float[]){{{}}}", c_numbers(v)); }
std::string c_floats(const glm::dmat4& m) {
    return fmt::format("(float[]){{{}, {}, {}, {}}}", c_numbers(m[0]), c_numbers(m[1]), c_numbers(m[2]),
                       c_numbers(m[3]));
}

std::string c_material(const Material& m) {
    return fmt::format(
        "(struct material){{\n        .emission = {{{}}}, .ambient = {{{}}},\n        .diffuse = {{{}}}, .specular = "
        "{{{}}}, .shininess = {}}}",
        c_numbers(m.emission), c_numbers(m.ambient), c_numbers(m.diffuse), c_numbers(m.specular),
        c_number(m.shininess));
}

std::string c_light(const LightSource& light) {
    const glm::dvec3 attenuation(light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation);
    return fmt::format(
        "(struct light){{\n        .ambient = {{{}}}, .diffuse = {{{}}}, .specular = {{{}}},\n        .position = "
        "{{{}}}, .spot_direction = {{{}}},\n        .spot_exponent = {}, .spot_cutoff = {}, .attenuation = {{{}}}}}",
        c_numbers(light.ambient), c_numbers(light.diffuse), c_numbers(light.specular), c_numbers(light.position_eye),
        c_numbers(light.spot_direction_eye), c_number(light.spot_exponent), c_number(light.spot_cutoff_deg),
        c_numbers(attenuation));
}

}  // namespace twinlight::programmable

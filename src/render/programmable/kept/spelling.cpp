#include "render/programmable/kept/spelling.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "render/programmable/shader_pieces.h"

namespace twinlight::programmable {

std::string printable(std::string text) {
    for (char& c : text)
        if ((c >= 0 && c < ' ') || std::string_view("<>&\\\x7F").find(c) != std::string_view::npos) c = '?';
    return text;
}

std::string Spelling::statement(const std::string& c) const {
    if (is_c_) return c;
    std::string text;
    for_each_token(c, [&](std::string_view token, bool is_identifier) {
        const bool is_command = is_identifier && token.starts_with("gl") && token.size() > 2 &&
                                std::isupper(static_cast<unsigned char>(token[2]));
        if (is_command)
            text += fmt::format("gl.{}{}", static_cast<char>(std::tolower(static_cast<unsigned char>(token[2]))),
                                token.substr(3));
        else if (is_identifier && token.starts_with("GL_"))
            text += fmt::format("gl.{}", token.substr(3));
        else
            text += token;
    });
    return text;
}

std::string Spelling::number(double x) const {
    const std::string text = fmt::format("{:.9g}", to_float(x));
    return !is_c_ || text.find_first_of(".en") == text.npos ? text : text + "f";
}

std::string Spelling::floats(const glm::dvec4& v) const {
    return is_c_ ? fmt::format("(float[]){{{}}}", numbers(v)) : fmt::format("[{}]", numbers(v));
}
std::string Spelling::floats(const glm::dmat4& m) const {
    const std::string all = fmt::format("{}, {}, {}, {}", numbers(m[0]), numbers(m[1]), numbers(m[2]), numbers(m[3]));
    return is_c_ ? fmt::format("(float[]){{{}}}", all) : fmt::format("[{}]", all);
}

std::string Spelling::structure(const std::string& type, const std::string& members) const {
    return is_c_ ? fmt::format("(struct {}){{\n        {}}}", type, members) : fmt::format("{{\n        {}}}", members);
}
std::string Spelling::member(const char* name, const std::string& value) const {
    return is_c_ ? fmt::format(".{} = {}", name, value) : fmt::format("{}: {}", name, value);
}
std::string Spelling::list(const std::string& values) const { return is_c_ ? "{" + values + "}" : "[" + values + "]"; }

std::string Spelling::material(const Material& m) const {
    const auto color = [&](const char* name, const glm::dvec4& c) { return member(name, list(numbers(c))); };
    return structure("material", color("emission", m.emission) + ", " + color("ambient", m.ambient) + ",\n        " +
                                     color("diffuse", m.diffuse) + ", " + color("specular", m.specular) + ", " +
                                     member("shininess", number(m.shininess)));
}

std::string Spelling::light(const LightSource& light) const {
    const auto vector = [&](const char* name, const auto& v) { return member(name, list(numbers(v))); };
    const glm::dvec3 attenuation(light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation);
    return structure(
        "light", vector("ambient", light.ambient) + ", " + vector("diffuse", light.diffuse) + ", " +
                     vector("specular", light.specular) + ",\n        " + vector("position", light.position_eye) +
                     ", " + vector("spot_direction", light.spot_direction_eye) + ",\n        " +
                     member("spot_exponent", number(light.spot_exponent)) + ", " +
                     member("spot_cutoff", number(light.spot_cutoff_deg)) + ", " + vector("attenuation", attenuation));
}

}  // namespace twinlight::programmable

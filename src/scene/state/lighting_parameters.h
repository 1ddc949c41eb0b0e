// The parameters of lights, materials and the light model as rows: the name that glLight, glMaterial, glLightModel and their queries
// take (2.14.2, tables 2.9 and 2.10; 6.1.3), the member that holds the value, and its name in GLSL's gl_LightSource, gl_FrontMaterial
// and gl_LightModel (GLSL 1.20, 7.5). The members have GL's initial values. parameters.def has the number of values and their range,
// argument_help.def the words.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scene/state/frame.h"

namespace twinlight {

// A parameter of an Owner: LightSource, Material or LightModel.
template <class Owner>
struct LightingParameter {
    Enum pname;
    std::variant<glm::dvec4 Owner::*, glm::dvec3 Owner::*, double Owner::*, bool Owner::*, Enum Owner::*> member;
    std::string_view glsl = "";  // empty: GLSL does not have it
};

// In the order in which the window shows them.
inline constexpr std::array kLightParameters = {
    LightingParameter<LightSource>{kGL_AMBIENT, &LightSource::ambient, "ambient"},
    LightingParameter<LightSource>{kGL_DIFFUSE, &LightSource::diffuse, "diffuse"},
    LightingParameter<LightSource>{kGL_SPECULAR, &LightSource::specular, "specular"},
    LightingParameter<LightSource>{kGL_POSITION, &LightSource::position_eye, "position"},
    LightingParameter<LightSource>{kGL_SPOT_DIRECTION, &LightSource::spot_direction_eye, "spotDirection"},
    LightingParameter<LightSource>{kGL_SPOT_EXPONENT, &LightSource::spot_exponent, "spotExponent"},
    LightingParameter<LightSource>{kGL_SPOT_CUTOFF, &LightSource::spot_cutoff_deg, "spotCutoff"},
    LightingParameter<LightSource>{kGL_CONSTANT_ATTENUATION, &LightSource::constant_attenuation, "constantAttenuation"},
    LightingParameter<LightSource>{kGL_LINEAR_ATTENUATION, &LightSource::linear_attenuation, "linearAttenuation"},
    LightingParameter<LightSource>{kGL_QUADRATIC_ATTENUATION, &LightSource::quadratic_attenuation,
                                   "quadraticAttenuation"},
};
// GL_AMBIENT_AND_DIFFUSE is two of them. GL_COLOR_INDEXES is not among them: it has no effect here.
inline constexpr std::array kMaterialParameters = {
    LightingParameter<Material>{kGL_AMBIENT, &Material::ambient, "ambient"},
    LightingParameter<Material>{kGL_DIFFUSE, &Material::diffuse, "diffuse"},
    LightingParameter<Material>{kGL_SPECULAR, &Material::specular, "specular"},
    LightingParameter<Material>{kGL_EMISSION, &Material::emission, "emission"},
    LightingParameter<Material>{kGL_SHININESS, &Material::shininess, "shininess"},
};
inline constexpr std::array kLightModelParameters = {
    LightingParameter<LightModel>{kGL_LIGHT_MODEL_AMBIENT, &LightModel::ambient, "ambient"},
    LightingParameter<LightModel>{kGL_LIGHT_MODEL_LOCAL_VIEWER, &LightModel::local_viewer},
    LightingParameter<LightModel>{kGL_LIGHT_MODEL_TWO_SIDE, &LightModel::two_side},
    LightingParameter<LightModel>{kGL_LIGHT_MODEL_COLOR_CONTROL, &LightModel::color_control},
};

template <class Owner>
constexpr std::span<const LightingParameter<Owner>> lighting_parameters() {
    if constexpr (std::is_same_v<Owner, LightSource>)
        return kLightParameters;
    else if constexpr (std::is_same_v<Owner, Material>)
        return kMaterialParameters;
    else
        return kLightModelParameters;
}

// The row's number; the number of rows if there is none.
template <class Owner>
std::size_t number_of_parameter(Enum pname) {
    const auto rows = lighting_parameters<Owner>();
    return static_cast<std::size_t>(std::ranges::find(rows, pname, &LightingParameter<Owner>::pname) - rows.begin());
}
template <class Owner>
const LightingParameter<Owner>* find_lighting_parameter(Enum pname) {
    const std::size_t number = number_of_parameter<Owner>(pname);
    return number < lighting_parameters<Owner>().size() ? &lighting_parameters<Owner>()[number] : nullptr;
}

// Sets the parameter, with as many values as it has (parameters.def); any value but 0 is true.
template <class Owner>
void set_parameter(Owner& owner, const LightingParameter<Owner>& parameter, std::span<const double> values) {
    const auto set = [&](auto member) {
        auto& of = owner.*member;
        using Value = std::remove_reference_t<decltype(of)>;
        if constexpr (std::is_same_v<Value, bool>)
            of = values[0] != 0;
        else if constexpr (std::is_arithmetic_v<Value>)
            of = static_cast<Value>(values[0]);
        else
            for (int i = 0; i < Value::length(); ++i) of[i] = values[static_cast<std::size_t>(i)];
    };
    std::visit(set, parameter.member);
}

// What a query returns.
template <class Owner>
std::vector<double> values_of(const Owner& owner, const LightingParameter<Owner>& parameter) {
    const auto get = [&](auto member) -> std::vector<double> {
        const auto& of = owner.*member;
        using Value = std::remove_cvref_t<decltype(of)>;
        if constexpr (std::is_arithmetic_v<Value>)
            return {static_cast<double>(of)};
        else
            return {&of[0], &of[0] + Value::length()};
    };
    return std::visit(get, parameter.member);
}

template <class Owner>
bool has_equal(const Owner& a, const Owner& b, const LightingParameter<Owner>& parameter) {
    return std::visit([&](auto member) { return a.*member == b.*member; }, parameter.member);
}

// GL_TRUE and GL_FALSE, and no number.
template <class Owner>
bool is_flag(const LightingParameter<Owner>& parameter) {
    return std::holds_alternative<bool Owner::*>(parameter.member);
}

}  // namespace twinlight

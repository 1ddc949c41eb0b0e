// The parameters of lights, materials, the light model and textures as rows, and in attributes.h those of pixel storage: the name that
// glLight, glMaterial, glLightModel, glTexParameter, glPixelStore and their queries take (GL 2.1 tables 2.9, 2.10, 3.1 and 3.18; 6.1), and
// the member that holds the value.
// The members have GL's initial values. parameters.def has the number of values and their range, argument_help.def the words.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/frame/frame.h"

namespace twinlight {

// A parameter of an Owner: LightSource, Material, LightModel, Texture or PixelStore.
template <class Owner>
struct ParameterRow {
    Enum pname;
    std::variant<glm::dvec4 Owner::*, glm::dvec3 Owner::*, double Owner::*, bool Owner::*, int Owner::*, Enum Owner::*>
        member;
    // Its name in gl_LightSource, gl_FrontMaterial and gl_LightModel (GLSL 1.20, 7.5); empty: it is not there.
    std::string_view glsl = "";
};

// In the order in which the window shows them.
inline constexpr std::array kLightParameters = {
    ParameterRow<LightSource>{kGL_AMBIENT, &LightSource::ambient, "ambient"},
    ParameterRow<LightSource>{kGL_DIFFUSE, &LightSource::diffuse, "diffuse"},
    ParameterRow<LightSource>{kGL_SPECULAR, &LightSource::specular, "specular"},
    ParameterRow<LightSource>{kGL_POSITION, &LightSource::position_eye, "position"},
    ParameterRow<LightSource>{kGL_SPOT_DIRECTION, &LightSource::spot_direction_eye, "spotDirection"},
    ParameterRow<LightSource>{kGL_SPOT_EXPONENT, &LightSource::spot_exponent, "spotExponent"},
    ParameterRow<LightSource>{kGL_SPOT_CUTOFF, &LightSource::spot_cutoff_deg, "spotCutoff"},
    ParameterRow<LightSource>{kGL_CONSTANT_ATTENUATION, &LightSource::constant_attenuation, "constantAttenuation"},
    ParameterRow<LightSource>{kGL_LINEAR_ATTENUATION, &LightSource::linear_attenuation, "linearAttenuation"},
    ParameterRow<LightSource>{kGL_QUADRATIC_ATTENUATION, &LightSource::quadratic_attenuation, "quadraticAttenuation"},
};
// GL_AMBIENT_AND_DIFFUSE is two of them. GL_COLOR_INDEXES is not among them: it has no effect here.
inline constexpr std::array kMaterialParameters = {
    ParameterRow<Material>{kGL_AMBIENT, &Material::ambient, "ambient"},
    ParameterRow<Material>{kGL_DIFFUSE, &Material::diffuse, "diffuse"},
    ParameterRow<Material>{kGL_SPECULAR, &Material::specular, "specular"},
    ParameterRow<Material>{kGL_EMISSION, &Material::emission, "emission"},
    ParameterRow<Material>{kGL_SHININESS, &Material::shininess, "shininess"},
};
inline constexpr std::array kLightModelParameters = {
    ParameterRow<LightModel>{kGL_LIGHT_MODEL_AMBIENT, &LightModel::ambient, "ambient"},
    ParameterRow<LightModel>{kGL_LIGHT_MODEL_LOCAL_VIEWER, &LightModel::local_viewer},
    ParameterRow<LightModel>{kGL_LIGHT_MODEL_TWO_SIDE, &LightModel::two_side},
    ParameterRow<LightModel>{kGL_LIGHT_MODEL_COLOR_CONTROL, &LightModel::color_control},
};

// Tables 6.16 and 6.17. That of the level of detail's bias is not in table 3.18 (3.8.8).
inline constexpr std::array kTextureParameters = {
    ParameterRow<Texture>{kGL_TEXTURE_BORDER_COLOR, &Texture::border_color},
    ParameterRow<Texture>{kGL_TEXTURE_MIN_FILTER, &Texture::min_filter},
    ParameterRow<Texture>{kGL_TEXTURE_MAG_FILTER, &Texture::mag_filter},
    ParameterRow<Texture>{kGL_TEXTURE_WRAP_S, &Texture::wrap_s},
    ParameterRow<Texture>{kGL_TEXTURE_WRAP_T, &Texture::wrap_t},
    ParameterRow<Texture>{kGL_TEXTURE_WRAP_R, &Texture::wrap_r},
    ParameterRow<Texture>{kGL_TEXTURE_PRIORITY, &Texture::priority},
    ParameterRow<Texture>{kGL_TEXTURE_MIN_LOD, &Texture::min_lod},
    ParameterRow<Texture>{kGL_TEXTURE_MAX_LOD, &Texture::max_lod},
    ParameterRow<Texture>{kGL_TEXTURE_BASE_LEVEL, &Texture::base_level},
    ParameterRow<Texture>{kGL_TEXTURE_MAX_LEVEL, &Texture::max_level},
    ParameterRow<Texture>{kGL_TEXTURE_LOD_BIAS, &Texture::lod_bias},
    ParameterRow<Texture>{kGL_DEPTH_TEXTURE_MODE, &Texture::depth_mode},
    ParameterRow<Texture>{kGL_TEXTURE_COMPARE_MODE, &Texture::compare_mode},
    ParameterRow<Texture>{kGL_TEXTURE_COMPARE_FUNC, &Texture::compare_func},
    ParameterRow<Texture>{kGL_GENERATE_MIPMAP, &Texture::generate_mipmap},
    ParameterRow<Texture>{kGL_TEXTURE_MAX_ANISOTROPY_EXT, &Texture::max_anisotropy},
};

// The rows of an Owner. What is no part of a Draw has a specialisation beside it (attributes.h).
template <class Owner>
inline constexpr std::span<const ParameterRow<Owner>> kParameterRows;
template <>
inline constexpr std::span<const ParameterRow<LightSource>> kParameterRows<LightSource> = kLightParameters;
template <>
inline constexpr std::span<const ParameterRow<Material>> kParameterRows<Material> = kMaterialParameters;
template <>
inline constexpr std::span<const ParameterRow<LightModel>> kParameterRows<LightModel> = kLightModelParameters;
template <>
inline constexpr std::span<const ParameterRow<Texture>> kParameterRows<Texture> = kTextureParameters;

// The index of the row with this name; how many rows there are, if none has it.
template <class Owner>
std::size_t number_of_parameter(Enum pname) {
    const auto rows = kParameterRows<Owner>;
    return static_cast<std::size_t>(std::ranges::find(rows, pname, &ParameterRow<Owner>::pname) - rows.begin());
}
template <class Owner>
const ParameterRow<Owner>* find_parameter_row(Enum pname) {
    const std::size_t number = number_of_parameter<Owner>(pname);
    return number < kParameterRows<Owner>.size() ? &kParameterRows<Owner>[number] : nullptr;
}

// Sets the parameter, with as many values as it has (parameters.def); any value but 0 is true.
template <class Owner>
void set_parameter(Owner& owner, const ParameterRow<Owner>& parameter, std::span<const double> values) {
    const auto set = [&](auto member) {
        auto& of = owner.*member;
        using Of = std::remove_reference_t<decltype(of)>;
        if constexpr (std::is_same_v<Of, bool>)
            of = values[0] != 0;
        else if constexpr (std::is_arithmetic_v<Of>)
            of = static_cast<Of>(values[0]);
        else
            for (int i = 0; i < Of::length(); ++i) of[i] = values[static_cast<std::size_t>(i)];
    };
    std::visit(set, parameter.member);
}

// What a query returns.
template <class Owner>
std::vector<double> values_of(const Owner& owner, const ParameterRow<Owner>& parameter) {
    const auto get = [&](auto member) -> std::vector<double> {
        const auto& of = owner.*member;
        using Of = std::remove_cvref_t<decltype(of)>;
        if constexpr (std::is_arithmetic_v<Of>)
            return {static_cast<double>(of)};
        else
            return {&of[0], &of[0] + Of::length()};
    };
    return std::visit(get, parameter.member);
}

// The values as floats, as the calls with v take them.
template <class Owner>
std::array<float, 4> floats_of(const Owner& owner, const ParameterRow<Owner>& parameter) {
    std::array<float, 4> floats{};
    const auto get = [&](auto member) {
        const auto& of = owner.*member;
        using Of = std::remove_cvref_t<decltype(of)>;
        if constexpr (std::is_arithmetic_v<Of>)
            floats[0] = static_cast<float>(of);
        else
            std::transform(&of[0], &of[0] + Of::length(), floats.begin(),
                           [](double value) { return static_cast<float>(value); });
    };
    std::visit(get, parameter.member);
    return floats;
}

template <class Owner>
bool has_equal(const Owner& a, const Owner& b, const ParameterRow<Owner>& parameter) {
    return std::visit([&](auto member) { return a.*member == b.*member; }, parameter.member);
}

// GL_TRUE and GL_FALSE, and no number.
template <class Owner>
bool is_flag(const ParameterRow<Owner>& parameter) {
    return std::holds_alternative<bool Owner::*>(parameter.member);
}

}  // namespace twinlight

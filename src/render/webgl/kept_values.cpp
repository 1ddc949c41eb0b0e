#include "render/webgl/kept_values.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "base/math/directions.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/light_values.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::webgl {

double short_number(double x) { return std::strtod(fmt::format("{}", programmable::to_float(x)).c_str(), nullptr); }

namespace {

Json list_of(double x) { return {short_number(x)}; }
template <int kLength>
Json list_of(const glm::vec<kLength, double>& v) {
    Json list = Json::array();
    for (int i = 0; i < kLength; ++i) list.push_back(short_number(v[i]));
    return list;
}
// Column by column, in double precision: matrices are multiplied before they become floats.
Json list_of(const glm::dmat4& m) {
    Json list = Json::array();
    for (int i = 0; i < 16; ++i) list.push_back(m[i / 4][i % 4]);
    return list;
}

// The members of GLSL's gl_LightSource or gl_FrontMaterial.
template <class Owner>
void add_members(Json& values, const std::string& variable, const Owner& owner) {
    for (const ParameterRow<Owner>& parameter : kParameterRows<Owner>) {
        Json& list = values[variable + "." + std::string(parameter.glsl)] = Json::array();
        for (const double value : values_of(owner, parameter)) list.push_back(short_number(value));
    }
}

Json light_of(const LightSource& light, int number) {
    const std::string source = fmt::format("LightSource[{}]", number);
    Json values;
    add_members(values, source, light);
    values[source + ".spotCosCutoff"] = list_of(cos_deg(light.spot_cutoff_deg));
    if (light.smooth_cone) {
        const programmable::SmoothConeValues cone = programmable::smooth_cone_values(light);
        values[programmable::kept_cone_name(number, programmable::LightValue::kCosOuter)] = list_of(cone.cos_outer);
        values[programmable::kept_cone_name(number, programmable::LightValue::kConeSlope)] = list_of(cone.slope);
    }
    return values;
}

Json fog_of(const Fog& fog) {
    // RULING: linear fog with end = start is a step there.
    constexpr double kStep = 1e30;
    return {{"Fog.color", list_of(fog.color)},
            {"Fog.density", list_of(fog.density)},
            {"Fog.start", list_of(fog.start)},
            {"Fog.end", list_of(fog.end)},
            {"Fog.scale", list_of(fog.end == fog.start ? kStep : 1 / (fog.end - fog.start))}};
}

// `suffix`: the unit's number in a Draw that combines textures.
Json texture_of(const TextureUnit& unit, const std::string& suffix) {
    Json values = {{"TextureMatrix" + suffix, list_of(unit.texture_matrix)},
                   {"TextureEnvColor" + suffix, list_of(unit.env_color)}};
    for (const GeneratedCoordinate& one : unit.generated)
        if (!one.needs_normal())
            values[fmt::format("{}Plane{}{}", one.mode == kGL_EYE_LINEAR ? "Eye" : "Object", "STRQ"[one.coordinate],
                               suffix)] = list_of(one.plane);
    return values;
}

}  // namespace

std::vector<Json> kept_values(const Draw& draw, const Plan& plan, const programmable::Code& code) {
    std::vector<Json> groups = {
        {{"ModelViewMatrix", list_of(draw.eye_from_object)}, {"ProjectionMatrix", list_of(draw.clip_from_eye)}}};
    if (code.effects.lighting) {
        groups.push_back({{"LightModel.ambient", list_of(glm::dvec4(plan.constant_ambient, 1))}});
        add_members(groups.back(), "FrontMaterial", plan.lighting.front);
        if (code.effects.two_side) add_members(groups.back(), "BackMaterial", plan.lighting.back);
        for (const int number : code.form.kept->lights)
            groups.push_back(light_of(plan.lighting.lights[static_cast<std::size_t>(number)], number));
    }
    if (draw.raster.clip_plane_count() > 0) {
        Json planes = Json::array();
        for (const auto& plane_eye : draw.raster.clip_planes_eye)
            for (const Json& part : list_of(plane_eye.value_or(glm::dvec4(0)))) planes.push_back(part);
        groups.push_back({{"ClipPlane", planes}});
    }
    if (code.effects.has_fog()) groups.push_back(fog_of(draw.fog));
    if (code.effects.has_texture()) groups.push_back(texture_of(draw.texture, ""));
    if (!code.effects.units.empty())
        draw.for_each_unit([&](std::size_t number, const TextureUnit& unit) {
            groups.push_back(texture_of(unit, std::to_string(number)));
        });
    if (code.effects.attenuated_points) {
        const PointParameters& parameters = draw.raster.point_parameters;
        groups.push_back({{"PointAttenuation", list_of(parameters.distance_attenuation)},
                          {"PointSizes", {draw.raster.point_size, parameters.size_min, parameters.size_max}}});
    }
    return groups;
}

}  // namespace twinlight::webgl

#include "render/programmable/numbers/precise.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/math/normal_matrix.h"
#include "render/programmable/numbers/form.h"
#include "render/programmable/numbers/light_values.h"
#include "render/programmable/numbers/mesa_floats.h"
#include "render/programmable/numbers/program_uniforms.h"
#include "render/programmable/numbers/wide_range.h"

namespace twinlight::programmable {
namespace {

// Visits the enabled lights, in the order of their numbers.
template <class Visit>
void for_each_light(const LightingState& lighting, const Visit& visit) {
    std::size_t i = 0;
    for (const LightSource& light : lighting.lights)
        if (light.enabled) visit(i++, light);
}

bool is_shiny(const Draw& draw) {
    const auto shiny = [&](const Material& front, const Material& back) {
        return front.shininess != 0 || (draw.lighting.light_model.two_side && back.shininess != 0);
    };
    return shiny(draw.lighting.front, draw.lighting.back) ||
           std::ranges::any_of(draw.materials, [&](const Materials& m) { return shiny(m.front, m.back); });
}

bool may_have_w(const Draw& draw) {
    const glm::dmat4& m = draw.eye_from_object;
    return m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1 ||
           std::ranges::any_of(draw.vertices, [](const Vertex& v) { return v.position_object.w != 1; });
}

bool has_one_color(const Draw& draw) {
    return std::ranges::all_of(draw.vertices, [&](const Vertex& v) { return v.color == draw.vertices.front().color; });
}

void check_lights(const Draw& draw) {
    const auto& lights = draw.lighting.lights;
    for (std::size_t i = kMaxLights; i < lights.size(); ++i)
        if (lights[i].enabled)
            throw std::runtime_error(
                fmt::format("{}: --precise follows the fixed function, which has only {} lights, so it cannot draw {}; "
                            "remove --precise",
                            draw.place.str(), kMaxLights, light_name(static_cast<int>(i))));
}

// Sets every effect that the driver's program has. A plan would leave out some that change no colour but change its
// rounding.
void set_all_effects(EffectSet& effects, const Draw& draw, const LightingState& lighting) {
    const bool rgb = effects.needs_primary_rgb();
    effects.lights.clear();
    for_each_light(lighting, [&](std::size_t, const LightSource& light) {
        const bool spot = light.has_cone();
        effects.lights.push_back({.directional = light.is_directional(),
                                  .attenuated = light.is_attenuated(),
                                  .cone = spot ? SpotCone::kGl : SpotCone::kNone,
                                  .spot_exponent = spot ? Power::kReal : Power::kZero,
                                  .ambient = rgb,
                                  .diffuse = rgb,
                                  .specular = true});
    });
    effects.clamp = true;
    effects.shininess = is_shiny(draw) ? Power::kReal : Power::kZero;
    effects.local_viewer = lighting.light_model.local_viewer && effects.shininess != Power::kZero;
    effects.separate_specular = lighting.light_model.color_control != kGL_SINGLE_COLOR;
    effects.highlight = Highlight::kHalfVector;
    effects.normalize = draw.lighting.normalize;  // not lighting.normalize, which the plan may have turned off
    effects.vertex_w = (effects.needs_position_eye() || (effects.has_fog() && !effects.fog_coords)) && may_have_w(draw);
}

std::vector<float> floats(const glm::vec3& v) { return {v.x, v.y, v.z}; }

template <class Matrix>
std::vector<float> columns(const Matrix& m) {
    std::vector<float> values;
    for (int column = 0; column < Matrix::length(); ++column)
        for (int row = 0; row < Matrix::length(); ++row) values.push_back(m[column][row]);
    return values;
}

glm::vec3 rgb_in_floats(const glm::dvec4& color) { return glm::vec3(color); }

// These functions return nothing where other programs have the right value.

// The scene colour (program/prog_statevars.c, STATE_LIGHTMODEL_SCENECOLOR), without the parts that come with each vertex.
std::vector<float> value_of(FaceValue value, const LightingState& lighting, const Material& material,
                            const FaceEffects& varying) {
    switch (value) {
        case FaceValue::kBase: {
            glm::vec3 base(0);
            if (!ambient_of(varying))
                base = rgb_in_floats(lighting.light_model.ambient) * rgb_in_floats(material.ambient);
            if (!emission_of(varying)) base = base + rgb_in_floats(material.emission);
            return floats(base);
        }
        case FaceValue::kAlpha:
        case FaceValue::kShininess: break;
    }
    return {};
}

std::vector<float> value_of(ModelValue value, const LightingState& lighting) {
    switch (value) {
        case ModelValue::kConstantAmbient: return floats(rgb_in_floats(lighting.light_model.ambient));
        case ModelValue::kRgbFromSamples: break;
    }
    return {};
}

// Replaces the values of a face, and sets the products of its colours with the lights' (STATE_LIGHTPROD).
void set_face(Uniforms& uniforms, const std::string& name, const Code& code, const LightingState& lighting,
              const Material& material, const FaceEffects& varying) {
    values_of_face(code.effects, varying).for_each([&](FaceValue value) {
        const std::vector<float> own = value_of(value, lighting, material, varying);
        if (!own.empty()) uniforms.set(name_of(name, value, code.effects), own);
    });
    for_each_light(lighting, [&](std::size_t i, const LightSource& light) {
        const LightValues needed = values_of_light(code.effects, code.form, i);
        const auto product = [&](LightValue value, const glm::dvec4& color, const glm::dvec4& of,
                                 PerVertexColor per_vertex) {
            if (!needed.contains(value)) return;
            uniforms.set(name_of(i, declaration_of(value, code.effects, code.form, i), name),
                         floats(per_vertex ? rgb_in_floats(color) : rgb_in_floats(color) * rgb_in_floats(of)));
        };
        product(LightValue::kAmbient, light.ambient, material.ambient, ambient_of(varying));
        product(LightValue::kDiffuse, light.diffuse, material.diffuse, diffuse_of(varying));
        product(LightValue::kSpecular, light.specular, material.specular, specular_of(varying));
    });
}

// A value of a light in the coordinates that the driver lights in.
std::vector<float> value_of(LightValue value, const LightSource& light, const MesaLight& in_space) {
    switch (value) {
        case LightValue::kDirection:
        case LightValue::kPosition: return floats(in_space.position);
        case LightValue::kHalfDir: return floats(in_space.half_dir);
        case LightValue::kSpotDir: return floats(in_space.spot_direction);
        case LightValue::kCosCutoff: return {in_space.spot_cutoff_cosine};
        case LightValue::kSpotExponent: return {static_cast<float>(normal_exponent(light.spot_exponent))};
        case LightValue::kAttenuation:
            return floats({light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation});
        case LightValue::kAmbient:
        case LightValue::kDiffuse:
        case LightValue::kSpecular:  // set_face() has them
        case LightValue::kToward:
        case LightValue::kNearVertex:
        case LightValue::kWay:
        case LightValue::kCosOuter:
        case LightValue::kConeSlope: break;  // set_all_effects() and floats_suffice() leave these out
    }
    throw std::logic_error("--precise has no such value of a light");
}

// The matrices that the driver computes with.
struct DriverMatrices {
    glm::mat4 eye_from_object, clip_from_object;
    MesaMatrix modelview;
};

std::vector<float> value_of(DrawValue value, const DriverMatrices& matrices, const Plan& plan) {
    switch (value) {
        case DrawValue::kClipFromObject: {
            const double scale = clip_scale(glm::dmat4(matrices.clip_from_object), plan.vertices.position_reach);
            return columns(matrices.clip_from_object / static_cast<float>(scale));
        }
        case DrawValue::kEyeFromObject: return columns(matrices.eye_from_object);
        case DrawValue::kEyeFromObjectNormal: return columns(glm::transpose(matrices.modelview.inverse));
        case DrawValue::kNormalScale: return {mesa_normal_scale(matrices.modelview)};
        case DrawValue::kEyeFromObjectTurned:
        case DrawValue::kObjectScale:
        case DrawValue::kNormalUnit:
        case DrawValue::kViewerObject:
        case DrawValue::kViewerNearObject:
        case DrawValue::kViewerWayEye:
        case DrawValue::kViewerDirObject:
        case DrawValue::kGeneratedEyeFromObject:
        case DrawValue::kGeneratedNormalFromObject:
        case DrawValue::kPointEyeFromObject:
        case DrawValue::kPointAttenuation:
        case DrawValue::kPointSizes:
        case DrawValue::kEyeZFromObject:
        case DrawValue::kEyeWFromObject:
        case DrawValue::kFogColor:
        case DrawValue::kFogEnd:
        case DrawValue::kFogScale:
        case DrawValue::kFogDensity: break;
    }
    return {};
}

}  // namespace

Options precise_options(Options options) {
    if (options.shading == Shading::kPhong || options.shading == Shading::kExact)
        throw std::invalid_argument(
            "--precise follows the fixed function, which lights only vertices, so it does not work with phong or exact "
            "shading; remove one of the two");
    if (options.tier != Tier::kUniform)
        throw std::invalid_argument(
            "--precise does not work with constants in the shader text (--baked), because the compiler would fold them "
            "with different rounding");
    options.budget = 0;
    options.lecture_variants = false;
    return options;
}

bool floats_suffice(const Draw& draw, const Plan& plan) {
    if (upload_origin(draw, plan.vertices)) return false;
    if (!draw.lighting.enabled) return true;
    // The driver's program computes all lights, those too that the plan leaves out.
    Plan all;
    all.lighting = plan.lighting;
    all.vertices = plan.vertices;
    all.effects = plan.effects;
    set_all_effects(all.effects, draw, plan.lighting);
    for (std::size_t i = 0; i < plan.lighting.lights.size(); ++i)
        if (plan.lighting.lights[i].enabled) all.lights.push_back({.number = static_cast<int>(i)});
    for (const Plan* each : {&plan, &std::as_const(all)}) {
        if (has_wide_range(draw, *each) || has_sized_normals(draw, *each)) return false;
        if (each->effects.vertex_w && !keeps_w(draw.eye_from_object)) return false;
    }
    // Where a matrix projects, the driver takes normals from the inverse of all of it, and not of its upper 3x3 (2.11.3).
    const glm::dmat4& all_of_it = draw.eye_from_object;
    if (all_of_it[0][3] != 0 || all_of_it[1][3] != 0 || all_of_it[2][3] != 0) return false;
    // The squares of vectors and the determinants of matrices must be floats, which go from 1e-45 to 3e38.
    const auto fits = [](const glm::dvec3& v, double most) {
        const double length = glm::length(v);
        return length == 0 || (length > 1 / most && length < most);
    };
    const glm::dmat3 m(draw.eye_from_object);
    for (int column = 0; column < 3; ++column)
        if (!fits(m[column], 1e12)) return false;
    if (is_singular(m)) return false;
    // The driver inverts the matrix in floats, which costs as many digits as the columns differ in length.
    constexpr double kMostDifferent = 4096;
    const auto [shortest, longest] = std::minmax({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
    if (longest > kMostDifferent * shortest) return false;
    const auto is_denormal = [](double k) { return k > 0 && k < std::numeric_limits<float>::min(); };
    return std::ranges::all_of(draw.lighting.lights, [&](const LightSource& light) {
        const double w = light.position_eye.w == 0 ? 1 : light.position_eye.w;
        return !light.enabled ||
               (!is_denormal(light.constant_attenuation) && !is_denormal(light.linear_attenuation) &&
                !is_denormal(light.quadratic_attenuation) && fits(glm::dvec3(light.position_eye) / w, 1e18) &&
                fits(light.spot_direction_eye, 1e18));
    });
}

Code precise_code(const Draw& draw, const Plan& plan) {
    Code code = code_for(draw, plan);
    code.form = {.precise = true, .position_w = code.form.position_w, .loops = {}};
    if (!code.effects.lighting) {
        // A single colour is not interpolated: the fixed function's fragments get it unchanged.
        if (has_one_color(draw)) code.effects.shading = Shading::kFlat;
        return code;
    }
    check_lights(draw);
    set_all_effects(code.effects, draw, plan.lighting);
    code.lights.assign(code.effects.lights.size(), {});
    const MesaMatrix modelview = mesa_matrix(glm::mat4(draw.eye_from_object));
    code.form.object_space = !mesa_lights_in_eye_space(plan.lighting, modelview);
    code.form.rescale = !code.form.object_space && draw.lighting.rescale_normal && !draw.lighting.normalize;
    return code;
}

Uniforms precise_uniforms(const Draw& draw, const Plan& plan, const Code& code) {
    Uniforms values = uniforms(draw, plan, code);
    const glm::mat4 eye_from_object(draw.eye_from_object);
    const DriverMatrices matrices{.eye_from_object = eye_from_object,
                                  .clip_from_object = mesa_product(glm::mat4(draw.clip_from_eye), eye_from_object),
                                  .modelview = mesa_matrix(eye_from_object)};
    values_of_draw(code.effects, code.form).for_each([&](DrawValue value) {
        const std::vector<float> own = value_of(value, matrices, plan);
        if (!own.empty()) values.set(declaration_of(value).name, own);
    });
    if (!code.effects.lighting) return values;

    const LightingState& lighting = plan.lighting;
    values_of_model(code.effects).for_each([&](ModelValue value) {
        const std::vector<float> own = value_of(value, lighting);
        if (!own.empty()) values.set(declaration_of(value, code.effects).name, own);
    });
    set_face(values, "front", code, lighting, lighting.front, code.effects.front);
    if (code.effects.two_side) set_face(values, "back", code, lighting, lighting.back, code.effects.back);
    for_each_light(lighting, [&](std::size_t i, const LightSource& light) {
        const MesaLight in_space = mesa_light(light, eye_from_object, matrices.modelview, !code.form.object_space);
        values_of_light(code.effects, code.form, i).for_each([&](LightValue value) {
            if (is_color(value)) return;  // set_face() has them
            values.set(name_of(i, declaration_of(value, code.effects, code.form, i)), value_of(value, light, in_space));
        });
    });
    return values;
}

}  // namespace twinlight::programmable

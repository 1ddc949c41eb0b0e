#include "render/programmable/export/state_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "render/programmable/export/core_elements.h"
#include "render/programmable/export/kept_code.h"
#include "render/programmable/numbers/draw_values.h"
#include "render/programmable/numbers/light_values.h"
#include "render/programmable/text/kept_text.h"
#include "scene/command/names.h"

namespace twinlight::programmable {
namespace {

template <class Vector>
std::vector<float> floats_of(const Vector& v) {
    std::vector<float> values;
    for (int i = 0; i < Vector::length(); ++i) values.push_back(to_float(v[i]));
    return values;
}
std::vector<float> floats_of(const glm::dmat4& m) {
    std::vector<float> values;
    for (int column = 0; column < 4; ++column)
        for (const float value : floats_of(m[column])) values.push_back(value);
    return values;
}

std::string factor_name(Enum value) {
    return value == kGL_ZERO ? "GL_ZERO" : value == kGL_ONE ? "GL_ONE" : enum_name(value);
}

struct MaterialProperty {
    const char* name;
    glm::dvec4 Material::*color;
};
constexpr std::array kMaterialColors = {
    MaterialProperty{"GL_EMISSION", &Material::emission}, MaterialProperty{"GL_AMBIENT", &Material::ambient},
    MaterialProperty{"GL_DIFFUSE", &Material::diffuse}, MaterialProperty{"GL_SPECULAR", &Material::specular}};

std::string material_key(const char* face, const char* property) { return fmt::format("{} {}", face, property); }

// Whether glColorMaterial replaces this colour of this face (2.14.3).
bool is_tracked(const ColorMaterial& tracking, Enum face, const MaterialProperty& property) {
    const std::string mode = enum_name(tracking.mode), name = property.name;
    return (tracking.face == kGL_FRONT_AND_BACK || tracking.face == face) &&
           (mode == name || (mode == "GL_AMBIENT_AND_DIFFUSE" && (name == "GL_AMBIENT" || name == "GL_DIFFUSE")));
}

class StateCalls {
  public:
    explicit StateCalls(Glsl version = Glsl::k330) : version_(version) {}
    std::vector<Setting> take() { return std::move(settings_); }

    void set(std::string key, std::string text, std::vector<float> numbers = {},
             CallScope scope = CallScope::kAnywhere) {
        settings_.push_back({std::move(key), scope, {std::move(text), std::move(numbers)}});
    }
    void enable(Enum capability, bool enabled) { enable_by("gl", capability, enabled); }
    // A capability that core GL lacks.
    void enable_kept(Enum capability, bool enabled) { enable_by("ff", capability, enabled); }

    // ---- State of core GL ----

    void scissor(const Scissor& scissor, const std::array<bool, 4>& mask) {
        enable(kGL_SCISSOR_TEST, scissor.enabled);
        const Rectangle& box = scissor.box;
        if (scissor.enabled)
            set("scissor", fmt::format("glScissor({}, {}, {}, {});", box.x, box.y, box.width, box.height));
        set("color mask", fmt::format("glColorMask({:d}, {:d}, {:d}, {:d});", mask[0], mask[1], mask[2], mask[3]));
    }

    void clear(const Clear& clear) {
        scissor(clear.scissor, clear.color_mask);
        depth_mask(true);
        if (clear.color) set("clear color", "glClearColor(@);", floats_of(clear.clear_color));
        if (clear.depth) set("clear depth", fmt::format("glClearDepth({});", clear.clear_depth));
        if (!clear.stencil) return;
        set("clear stencil", fmt::format("glClearStencil({});", clear.clear_stencil));
        set("GL_FRONT stencil mask", fmt::format("glStencilMaskSeparate(GL_FRONT, {:#x});", clear.stencil_mask));
    }

    void raster(const Draw& draw) {
        const RasterState& raster = draw.raster;
        const Rectangle& v = raster.viewport;
        set("viewport", fmt::format("glViewport({}, {}, {}, {});", v.x, v.y, v.width, v.height), {}, CallScope::kFrame);
        set("depth range", fmt::format("glDepthRange({}, {});", raster.depth_near, raster.depth_far));
        set("front face", fmt::format("glFrontFace({});", enum_name(raster.front_face)));
        enable(kGL_CULL_FACE, raster.cull_enabled);
        if (raster.cull_enabled) set("cull face", fmt::format("glCullFace({});", enum_name(raster.cull_face)));
        const PolygonOffset& offset = raster.polygon_offset;
        enable(kGL_POLYGON_OFFSET_FILL, offset.fill);
        enable(kGL_POLYGON_OFFSET_LINE, offset.line);
        enable(kGL_POLYGON_OFFSET_POINT, offset.point);
        if (offset.fill || offset.line || offset.point)
            set("offset", "glPolygonOffset(@);", {to_float(offset.factor), to_float(offset.units)});
        if (draw.draws_lines()) set("line width", "glLineWidth(@);", {to_float(raster.line_width)});
        // Core GL has one mode for both faces: that of the face that is not culled.
        const bool hides_front = raster.cull_enabled && raster.cull_face == kGL_FRONT;
        set("polygon mode", fmt::format("glPolygonMode(GL_FRONT_AND_BACK, {});",
                                        enum_name(hides_front ? raster.polygon_mode_back : raster.polygon_mode_front)));
        enable(kGL_LINE_SMOOTH, raster.line_smooth);
        enable(kGL_COLOR_LOGIC_OP, draw.fragment.logic_op.has_value());
        if (draw.fragment.logic_op) set("logic op", fmt::format("glLogicOp({});", enum_name(*draw.fragment.logic_op)));
        if (draw.draws_points()) set("point size", "ffPointSize(@);", {to_float(point_size(draw))});
        enable(kGL_DEPTH_TEST, raster.depth_test);
        set("depth func", fmt::format("glDepthFunc({});", enum_name(raster.depth_func)));
        depth_mask(raster.depth_mask);
    }

    void fragment(const FragmentState& fragment) {
        scissor(fragment.scissor, fragment.color_mask);
        stencil(fragment.stencil);
        enable(kGL_BLEND, fragment.blend);
        if (!fragment.blend) return;
        set("blend func", fmt::format("glBlendFuncSeparate({}, {}, {}, {});", factor_name(fragment.blend_src),
                                      factor_name(fragment.blend_dst), factor_name(fragment.blend_src_alpha),
                                      factor_name(fragment.blend_dst_alpha)));
        set("blend equation", fmt::format("glBlendEquationSeparate({}, {});", enum_name(fragment.blend_equation),
                                          enum_name(fragment.blend_equation_alpha)));
        set("blend color", "glBlendColor(@);", floats_of(fragment.blend_color));
    }
    void stencil(const std::optional<StencilTest>& stencil) {
        enable(kGL_STENCIL_TEST, stencil.has_value());
        if (!stencil) return;
        for (const auto& [name, face] : {std::pair("GL_FRONT", &stencil->front), {"GL_BACK", &stencil->back}}) {
            set(fmt::format("{} stencil func", name),
                fmt::format("glStencilFuncSeparate({}, {}, {}, {:#x});", name, enum_name(face->func),
                            std::clamp(face->ref, 0, kMaxStencil), face->mask));
            set(fmt::format("{} stencil op", name),
                fmt::format("glStencilOpSeparate({}, {}, {}, {});", name, factor_name(face->fail),
                            factor_name(face->depth_fail), factor_name(face->depth_pass)));
            set(fmt::format("{} stencil mask", name),
                fmt::format("glStencilMaskSeparate({}, {:#x});", name, face->write_mask));
        }
    }

    // ---- State that core GL lacks ----

    void kept(const Draw& draw, const Plan& plan, const Code& code, int kind, std::size_t texture_number) {
        const EffectSet& effects = code.effects;
        enable_kept(kGL_LIGHTING, effects.lighting);
        if (effects.lighting) lighting(plan, code, kind);
        if (effects.takes_normal()) {
            enable_kept(kGL_NORMALIZE, draw.lighting.normalize);
            enable_kept(kGL_RESCALE_NORMAL, draw.lighting.rescale_normal);
        }
        // What the loader sees of flat shading; a point has one vertex.
        if (draw.mode != kGL_POINTS) shade_model(effects.shading == Shading::kFlat);
        enable_kept(kGL_ALPHA_TEST, draw.fragment.alpha_test);
        if (draw.fragment.alpha_test) alpha_func(draw.fragment);
        enable_kept(kGL_FOG, effects.has_fog());
        if (effects.has_fog()) fog(draw.fog);
        texture(draw.texture, effects, texture_number);
        for (int i = 0; i < kMaxClipPlanes; ++i) {
            const auto& plane = draw.raster.clip_planes_eye[static_cast<std::size_t>(i)];
            enable_kept(kGL_CLIP_PLANE0 + static_cast<Enum>(i), plane.has_value());
            if (plane && std::ranges::find(code.form.kept->clip_planes, i) != code.form.kept->clip_planes.end())
                set(fmt::format("plane {}", i), fmt::format("ffClipPlane(GL_CLIP_PLANE{}, (double[]){{@}});", i),
                    floats_of(*plane), CallScope::kEye);
        }
        matrix("GL_PROJECTION", draw.clip_from_eye);
        if (draw.texture.texture) matrix("GL_TEXTURE", draw.texture.texture_matrix);
    }

    void shade_model(bool flat) {
        set("shade model", fmt::format("ffShadeModel({});", flat ? "GL_FLAT" : "GL_SMOOTH"));
    }
    void alpha_func(const FragmentState& fragment) {
        set("alpha", fmt::format("ffAlphaFunc({}, @);", enum_name(fragment.alpha_func)),
            {to_float(fragment.alpha_ref)});
    }
    void fog(const Fog& fog) {
        set("fog mode", fmt::format("ffFogi(GL_FOG_MODE, {});", enum_name(fog.mode)));
        set("fog color", "ffFogfv(GL_FOG_COLOR, *);", floats_of(fog.color));
        if (fog.mode == kGL_LINEAR) {
            set("fog start", "ffFogf(GL_FOG_START, @);", {to_float(fog.start)});
            set("fog end", "ffFogf(GL_FOG_END, @);", {to_float(fog.end)});
        } else {
            set("fog density", "ffFogf(GL_FOG_DENSITY, @);", {to_float(fog.density)});
        }
    }
    // The current matrix is GL_MODELVIEW before and after.
    void matrix(const char* mode, const glm::dmat4& matrix) {
        set(mode, fmt::format("ffMatrixMode({});\nffLoadMatrixf(*);\nffMatrixMode(GL_MODELVIEW);", mode),
            floats_of(matrix));
    }

    void lighting(const Plan& plan, const Code& code, int kind) {
        const LightingState& state = plan.lighting;
        light_model(state.light_model, glm::dvec4(plan.constant_ambient, 1));
        const ColorMaterial* tracking = code.effects.needs_color() ? &state.color_material : nullptr;
        if (tracking) color_material(*tracking);
        enable_kept(kGL_COLOR_MATERIAL, tracking != nullptr);
        material("GL_FRONT", kGL_FRONT, state.front, tracking);
        if (code.effects.two_side) material("GL_BACK", kGL_BACK, state.back, tracking);
        for (int i = 0; i < kMostKeptLights; ++i) {
            const bool is_on = std::ranges::find(code.form.kept->lights, i) != code.form.kept->lights.end();
            switch_light(i, is_on);
            if (is_on) light(i, state.lights[static_cast<std::size_t>(i)], kind);
        }
    }
    void light_model(const LightModel& model, const glm::dvec4& ambient) {
        const auto one = [this](const char* parameter, const std::string& value) {
            set(parameter, fmt::format("ffLightModeli({}, {});", parameter, value));
        };
        set("ambient", "ffLightModelfv(GL_LIGHT_MODEL_AMBIENT, *);", floats_of(ambient));
        one("GL_LIGHT_MODEL_TWO_SIDE", fmt::format("{:d}", model.two_side));
        one("GL_LIGHT_MODEL_LOCAL_VIEWER", fmt::format("{:d}", model.local_viewer));
        one("GL_LIGHT_MODEL_COLOR_CONTROL", enum_name(model.color_control));
    }
    void color_material(const ColorMaterial& tracking) {
        set("color material",
            fmt::format("ffColorMaterial({}, {});", enum_name(tracking.face), enum_name(tracking.mode)));
    }
    void material(const char* name, Enum face, const Material& material, const ColorMaterial* tracking) {
        for (const MaterialProperty& property : kMaterialColors)
            if (!tracking || !is_tracked(*tracking, face, property))
                set(material_key(name, property.name), fmt::format("ffMaterialfv({}, {}, *);", name, property.name),
                    floats_of(material.*property.color));
        set(material_key(name, "GL_SHININESS"), fmt::format("ffMaterialf({}, GL_SHININESS, @);", name),
            {to_float(material.shininess)});
    }

    void switch_light(int number, bool is_on) {
        const std::string name = light_text(number);
        set(name, fmt::format("switch_light({}, {:d});", name, is_on), {}, CallScope::kFrame);
    }
    void light(int number, const LightSource& light, int kind) {
        light_colors(number, light);
        const std::string name = light_text(number);
        set(name + " position", fmt::format("place_light({}, @);", name), floats_of(light.position_eye),
            CallScope::kEye);
        if (light.is_spot())
            set(name + " direction", fmt::format("ffLightfv({}, GL_SPOT_DIRECTION, *);", name),
                floats_of(light.spot_direction_eye), CallScope::kEye);
        if (!light.smooth_cone) return;
        const SmoothConeValues cone = smooth_cone_values(light);
        for (const auto& [what, value] :
             {std::pair(LightValue::kCosOuter, cone.cos_outer), {LightValue::kConeSlope, cone.slope}}) {
            const std::string uniform = kept_cone_name(number, what);
            set(fmt::format("kind {} {}", kind, uniform), fmt::format("set_uniform({}, \"{}\", @);", kind, uniform),
                {to_float(value)});
        }
    }
    void light_colors(int number, const LightSource& light) {
        const std::string name = light_text(number);
        const auto color = [&](const char* parameter, const glm::dvec4& value) {
            set(name + parameter, fmt::format("ffLightfv({}, {}, *);", name, parameter), floats_of(value));
        };
        const auto one = [&](const char* parameter, double value) {
            set(name + parameter, fmt::format("ffLightf({}, {}, @);", name, parameter), {to_float(value)});
        };
        color("GL_AMBIENT", light.ambient);
        color("GL_DIFFUSE", light.diffuse);
        color("GL_SPECULAR", light.specular);
        one("GL_SPOT_CUTOFF", light.spot_cutoff_deg);
        one("GL_SPOT_EXPONENT", light.spot_exponent);
        one("GL_CONSTANT_ATTENUATION", light.constant_attenuation);
        one("GL_LINEAR_ATTENUATION", light.linear_attenuation);
        one("GL_QUADRATIC_ATTENUATION", light.quadratic_attenuation);
    }

    void texture(const TextureUnit& unit, const EffectSet& effects, std::size_t number) {
        for (const Enum target : {kGL_TEXTURE_1D, kGL_TEXTURE_2D, kGL_TEXTURE_3D})
            enable_kept(target, target_of(unit, version_) == target);
        if (!unit.texture) return;
        set("texture", fmt::format("use_texture({}, {}, @);", enum_name(target_of(*unit.texture, version_)), number),
            {to_float(unit.lod_bias)});
        environment(unit.env_mode);
        if (effects.texture.environment == TextureEnvironment::kBlend)
            set("environment color", "ffTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, *);", floats_of(unit.env_color));
        for (int i = 0; i < 4; ++i)
            enable_kept(gen_of(i),
                        std::ranges::find(unit.generated, i, &GeneratedCoordinate::coordinate) != unit.generated.end());
        for (const GeneratedCoordinate& one : unit.generated) generated(one);
    }
    void environment(Enum mode) {
        set("environment", fmt::format("ffTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {});", enum_name(mode)));
    }
    void generated(const GeneratedCoordinate& one) {
        const std::string name = fmt::format("GL_{}", "STRQ"[one.coordinate]);
        set(name, fmt::format("ffTexGeni({}, GL_TEXTURE_GEN_MODE, {});", name, enum_name(one.mode)));
        const auto plane = [&](const char* parameter, CallScope scope) {
            set(name + parameter, fmt::format("ffTexGenfv({}, {}, *);", name, parameter), floats_of(one.plane), scope);
        };
        if (one.mode == kGL_OBJECT_LINEAR) plane("GL_OBJECT_PLANE", CallScope::kAnywhere);
        if (one.mode == kGL_EYE_LINEAR) plane("GL_EYE_PLANE", CallScope::kEye);
    }

  private:
    void enable_by(const char* prefix, Enum capability, bool enabled) {
        const std::string name = enum_name(capability);
        set(name, fmt::format("{}{}({});", prefix, enabled ? "Enable" : "Disable", name));
    }
    void depth_mask(bool writes) { set("depth mask", fmt::format("glDepthMask({:d});", writes)); }
    static Enum gen_of(int coordinate) { return kGL_TEXTURE_GEN_S + static_cast<Enum>(coordinate); }
    static std::string light_text(int number) {
        return number < kMaxLights ? fmt::format("GL_LIGHT{}", number) : fmt::format("GL_LIGHT0 + {}", number);
    }

    const Glsl version_;
    std::vector<Setting> settings_;
};

}  // namespace

std::vector<Setting> initial_settings() {
    StateCalls calls;
    // First what counts only if something is on; then what is on.
    Draw draw;
    draw.raster.cull_enabled = draw.raster.polygon_offset.fill = draw.fragment.blend = true;
    draw.fragment.logic_op = kGL_COPY;
    draw.fragment.stencil.emplace();
    for (const Enum mode : {kGL_POINTS, kGL_LINES}) {
        draw.mode = mode;
        calls.raster(draw);
    }
    calls.fragment(draw.fragment);
    const Draw off;
    calls.raster(off);
    calls.fragment(off.fragment);
    calls.clear({.color = true, .depth = true, .clear_depth = 1, .stencil = true});

    for (const Enum capability :
         {kGL_LIGHTING, kGL_COLOR_MATERIAL, kGL_NORMALIZE, kGL_RESCALE_NORMAL, kGL_FOG, kGL_ALPHA_TEST, kGL_TEXTURE_1D,
          kGL_TEXTURE_2D, kGL_TEXTURE_3D, kGL_TEXTURE_GEN_S, kGL_TEXTURE_GEN_T, kGL_TEXTURE_GEN_R, kGL_TEXTURE_GEN_Q})
        calls.enable_kept(capability, false);
    for (int i = 0; i < kMaxClipPlanes; ++i) calls.enable_kept(kGL_CLIP_PLANE0 + static_cast<Enum>(i), false);
    const LightingState lighting;
    calls.light_model(lighting.light_model, lighting.light_model.ambient);
    calls.color_material(lighting.color_material);
    calls.material("GL_FRONT", kGL_FRONT, lighting.front, nullptr);
    calls.material("GL_BACK", kGL_BACK, lighting.back, nullptr);
    for (int i = 0; i < kMostKeptLights; ++i) {
        calls.switch_light(i, false);
        calls.light_colors(i, i < kMaxLights ? lighting.lights[static_cast<std::size_t>(i)] : LightSource());
    }
    calls.shade_model(false);
    calls.alpha_func({});
    for (const Enum mode : {kGL_LINEAR, kGL_EXP}) {
        Fog fog;
        fog.mode = mode;
        calls.fog(fog);
    }
    calls.environment(kGL_MODULATE);
    calls.matrix("GL_PROJECTION", glm::dmat4(1));
    calls.matrix("GL_TEXTURE", glm::dmat4(1));
    calls.set("kind", "ffUseKind(0);");
    return calls.take();
}

std::vector<Setting> settings_of(const Clear& clear) {
    StateCalls calls;
    calls.clear(clear);
    return calls.take();
}

std::string call_of(const Clear& clear) {
    std::vector<const char*> buffers;
    if (clear.color) buffers.push_back("GL_COLOR_BUFFER_BIT");
    if (clear.depth) buffers.push_back("GL_DEPTH_BUFFER_BIT");
    if (clear.stencil) buffers.push_back("GL_STENCIL_BUFFER_BIT");
    return fmt::format("glClear({});", fmt::join(buffers, " | "));
}

std::vector<Setting> settings_of(const Draw& draw, const Plan& plan, const Code& code, int kind, std::size_t texture,
                                 Glsl version) {
    StateCalls calls(version);
    calls.raster(draw);
    calls.fragment(draw.fragment);
    calls.kept(draw, plan, code, kind, texture);
    return calls.take();
}

std::vector<std::string> unknown_after(const Plan& plan, const Code& code) {
    std::vector<std::string> keys;
    if (!code.effects.lighting || !code.effects.needs_color()) return keys;
    for (const auto& [name, face] : {std::pair("GL_FRONT", kGL_FRONT), {"GL_BACK", kGL_BACK}})
        for (const MaterialProperty& property : kMaterialColors)
            if (is_tracked(plan.lighting.color_material, face, property))
                keys.push_back(material_key(name, property.name));
    return keys;
}

Enum target_of(const TextureUnit& unit, Glsl version) { return unit.texture ? target_of(*unit.texture, version) : 0; }
Enum target_of(const Texture& texture, Glsl version) {
    return version == Glsl::k300es && texture.is_flat() ? Enum{kGL_TEXTURE_2D} : texture.target;
}

CallText matrix_call(const glm::dmat4& matrix) { return {"ffMultMatrixf(*);", floats_of(matrix)}; }

}  // namespace twinlight::programmable

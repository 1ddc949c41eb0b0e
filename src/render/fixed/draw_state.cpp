#include "render/fixed/draw_state.h"

#include "render/context/gl.h"
#include "scene/frame/parameter_rows.h"

namespace twinlight::fixed {
namespace {

// Calls set(pname, its values as floats) for all parameters of a light, a material or the light model.
template <class Owner, class Set>
void set_all(const Owner& owner, const Set& set) {
    for (const ParameterRow<Owner>& parameter : kParameterRows<Owner>)
        set(parameter.pname, floats_of(owner, parameter).data());
}

void set_light(GLenum name, const LightSource& light) {
    set_all(light, [&](GLenum pname, const float* values) { glLightfv(name, pname, values); });
}

void set_material(GLenum face, const Material& material) {
    set_all(material, [&](GLenum pname, const float* values) { glMaterialfv(face, pname, values); });
}

}  // namespace

void set_enabled(Enum capability, bool enabled) { (enabled ? glEnable : glDisable)(capability); }

void load_matrix(Enum mode, const glm::dmat4& matrix) {
    glMatrixMode(mode);
    glLoadMatrixd(&matrix[0][0]);
}

void set_lighting(const LightingState& lighting, bool also_off) {
    set_enabled(GL_LIGHTING, lighting.enabled);
    glDisable(GL_COLOR_MATERIAL);
    if (!lighting.enabled && !also_off) return;
    for (std::size_t i = 0; i < kMaxLights; ++i) {
        const GLenum name = GL_LIGHT0 + static_cast<GLenum>(i);
        const LightSource& light = i < lighting.lights.size() ? lighting.lights[i] : LightSource{};
        set_enabled(name, light.enabled);
        if (light.enabled || also_off) set_light(name, light);
    }
    set_all(lighting.light_model, [](GLenum pname, const float* values) { glLightModelfv(pname, values); });
    set_material(GL_FRONT, lighting.front);
    set_material(GL_BACK, lighting.back);
    // Mesa executes glMaterial late, and would overwrite a material that colours have changed meanwhile. A query forces
    // it now.
    GLfloat answer[4];
    glGetMaterialfv(GL_FRONT, GL_AMBIENT, answer);
    const ColorMaterial& tracked = lighting.color_material;
    if (tracked.enabled || also_off) glColorMaterial(tracked.face, tracked.mode);
    if (tracked.enabled) glEnable(GL_COLOR_MATERIAL);
    set_enabled(GL_NORMALIZE, lighting.normalize);
    set_enabled(GL_RESCALE_NORMAL, lighting.rescale_normal);
}

void set_fog(const Fog& fog) {
    glFogi(GL_FOG_MODE, static_cast<GLint>(fog.mode));
    glFogi(GL_FOG_COORD_SRC, fog.by_coordinates ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
    glFogf(GL_FOG_DENSITY, static_cast<float>(fog.density));
    glFogf(GL_FOG_START, static_cast<float>(fog.start));
    glFogf(GL_FOG_END, static_cast<float>(fog.end));
    glFogfv(GL_FOG_COLOR, &glm::vec4(fog.color)[0]);
}

void set_combine(const Combine& combine) {
    const auto set = [](GLenum name, Enum value) { glTexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value)); };
    set(GL_COMBINE_RGB, combine.rgb);
    set(GL_COMBINE_ALPHA, combine.alpha);
    for (GLenum i = 0; i < combine.rgb_sources.size(); ++i) {
        set(GL_SRC0_RGB + i, combine.rgb_sources[i]);
        set(GL_SRC0_ALPHA + i, combine.alpha_sources[i]);
        set(GL_OPERAND0_RGB + i, combine.rgb_operands[i]);
        set(GL_OPERAND0_ALPHA + i, combine.alpha_operands[i]);
    }
    set(GL_RGB_SCALE, static_cast<Enum>(combine.rgb_scale));
    set(GL_ALPHA_SCALE, static_cast<Enum>(combine.alpha_scale));
}

}  // namespace twinlight::fixed

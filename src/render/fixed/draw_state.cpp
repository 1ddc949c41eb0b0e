#include "render/fixed/draw_state.h"

#include "render/context/gl.h"

namespace twinlight::fixed {
namespace {

void set_light(GLenum name, const LightSource& light) {
    const auto number = [&](GLenum what, double value) { glLightf(name, what, static_cast<float>(value)); };
    const auto vector = [&](GLenum what, const glm::vec4& v) { glLightfv(name, what, &v[0]); };
    vector(GL_AMBIENT, light.ambient);
    vector(GL_DIFFUSE, light.diffuse);
    vector(GL_SPECULAR, light.specular);
    vector(GL_POSITION, light.position_eye);
    vector(GL_SPOT_DIRECTION, glm::vec4(light.spot_direction_eye, 0));
    number(GL_SPOT_EXPONENT, light.spot_exponent);
    number(GL_SPOT_CUTOFF, light.spot_cutoff_deg);
    number(GL_CONSTANT_ATTENUATION, light.constant_attenuation);
    number(GL_LINEAR_ATTENUATION, light.linear_attenuation);
    number(GL_QUADRATIC_ATTENUATION, light.quadratic_attenuation);
}

void set_material(GLenum face, const Material& material) {
    const auto vector = [&](GLenum what, const glm::vec4& v) { glMaterialfv(face, what, &v[0]); };
    vector(GL_AMBIENT, material.ambient);
    vector(GL_DIFFUSE, material.diffuse);
    vector(GL_SPECULAR, material.specular);
    vector(GL_EMISSION, material.emission);
    glMaterialf(face, GL_SHININESS, static_cast<float>(material.shininess));
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
    const LightModel& model = lighting.light_model;
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &glm::vec4(model.ambient)[0]);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, model.two_side);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, static_cast<GLint>(model.color_control));
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

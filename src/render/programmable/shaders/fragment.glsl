#version VERSION
#if EFFECT_RAY && EFFECT_PHONG
// The fragment shader: casts the pixel's ray at an exact surface and lights it where it is met (GL 2.1, section 2.14, of a vertex there).
#elif EFFECT_RAY
// The fragment shader: casts the pixel's ray at an exact surface, and what is made of its colour there (GL 2.1, sections 3.8 to 3.10).
#elif EFFECT_PHONG
// The fragment shader: lights each fragment (GL 2.1, section 2.14, of a vertex there).
#else
// The fragment shader: the interpolated colours, and what is made of them (GL 2.1, sections 3.8 to 3.10).
#endif

#if EFFECT_PHONG && !EFFECT_RAY
#if EFFECT_VERTEX_W
in vec4 v_position_eye;
#elif EFFECT_POSITION_EYE
in vec3 v_position_eye;
#endif
#if EFFECT_NORMAL
in vec3 v_normal_eye;
#endif
#if EFFECT_COLOR
in vec4 v_color;
#endif
#for_each_property in PROPERTY_TYPE v_PROPERTY;
#elif !EFFECT_PHONG
#if EFFECT_PRIMARY
INTERPOLATION in vec4 v_front_primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
INTERPOLATION in vec3 v_front_secondary;
#endif
#if EFFECT_TWO_SIDE && EFFECT_PRIMARY
INTERPOLATION in vec4 v_back_primary;
#endif
#if EFFECT_TWO_SIDE && EFFECT_SEPARATE_SPECULAR
INTERPOLATION in vec3 v_back_secondary;
#endif
#endif

#if EFFECT_TEXTURE && !EFFECT_RAY_TEX_COORD
in TEX_COORD_TYPE v_tex_coord;
#endif
#if EFFECT_FOG_W && !EFFECT_RAY
in vec2 v_eye_z;  // z and w, in eye coordinates
#elif EFFECT_FOG && !EFFECT_RAY
in float v_eye_z;
#endif

out vec4 fragment_color;

#include "fragment_uniforms.glsl"
#if EFFECT_RAY
#include "surface_uniforms.glsl"

#include "surface_crossings.glsl"
#endif

#if EFFECT_PHONG
#if EFFECT_UNIT
#include "unit.glsl"
#endif
#if EFFECT_VERTEX_W
#include "divided_by_w.glsl"
#endif
#include "lighting.glsl"
#endif

void main() {
#if EFFECT_RAY
#include "surface_point.glsl"
#endif
#if EFFECT_PHONG
#if EFFECT_SURFACE
    Surface surface;
#endif
#if EFFECT_VERTEX_W
    surface.position_eye = divided_by_w(GIVEN_position_eye);
#elif EFFECT_POSITION_EYE
    surface.position_SPACE = GIVEN_position_SPACE;
#endif
#if EFFECT_NORMAL
    surface.normal_SPACE = unit(GIVEN_normal_SPACE);
#endif
#if EFFECT_COLOR
    surface.color = v_color;
#endif
#for_each_property     surface.PROPERTY = v_PROPERTY;
#if EFFECT_SHOWN_FACE && EFFECT_NORMAL
    surface.normal_SPACE = gl_FrontFacing ? surface.normal_SPACE : -surface.normal_SPACE;
#endif
#if EFFECT_SHOWN_FACE
    Lit lit = light_shown(SURFACE);
#elif EFFECT_TWO_SIDE
    Lit lit;
    if (gl_FrontFacing) {
        lit = light_front(SURFACE);
    } else {
#if EFFECT_NORMAL
        surface.normal_SPACE = -surface.normal_SPACE;
#endif
        lit = light_back(SURFACE);
    }
#else
    Lit lit = light_front(SURFACE);
#endif
#if EFFECT_PRIMARY
    vec4 primary = lit.primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
    vec3 secondary = lit.secondary;
#endif
#elif EFFECT_TWO_SIDE
#if EFFECT_PRIMARY
    vec4 primary = gl_FrontFacing ? v_front_primary : v_back_primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
    vec3 secondary = gl_FrontFacing ? v_front_secondary : v_back_secondary;
#endif
#else
#if EFFECT_PRIMARY
    vec4 primary = v_front_primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
    vec3 secondary = v_front_secondary;
#endif
#endif
#if EFFECT_TEXTURE
#include "texture_environment.glsl"
#else
    vec4 color = primary;
#endif
#if EFFECT_SEPARATE_SPECULAR
    color.rgb = min(color.rgb + secondary, 1.0);  // the colour sum (section 3.9)
#endif
#if EFFECT_FOG
#include "fog.glsl"
#endif
#if EFFECT_SRGB_CODED
    // Linear light as sRGB codes it (IEC 61966-2-1).
    color.rgb = mix(12.92 * color.rgb, 1.055 * pow(max(color.rgb, 0.0031308), vec3(1.0 / 2.4)) - 0.055,
        step(0.0031308, color.rgb));
#endif
    fragment_color = color;
}

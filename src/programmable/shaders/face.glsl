// The FACE face: its material, met with the lights.
uniform vec3 u_FACE_base;  // what is the same at every vertex
#if !EFFECT_FACE_TRACKS_DIFFUSE
uniform float u_FACE_alpha;  // d_cm's
#endif
#if EFFECT_SHININESS
uniform float u_FACE_shininess;  // s_rm
#endif
#for_each_light "product_uniforms.glsl"

Lit light_FACE(SURFACE_PARAMETER) {
    Lit lit;
#if EFFECT_FACE_TRACKS_EMISSION
    lit.primary.rgb = surface.color.rgb + u_FACE_base;  // e_cm is the vertex's colour
#elif EFFECT_FACE_TRACKS_AMBIENT
    lit.primary.rgb = u_FACE_base + surface.color.rgb * u_constant_ambient;  // e_cm + a_cm a_cs
#else
    lit.primary.rgb = u_FACE_base;  // e_cm + a_cm a_cs
#endif
#if EFFECT_FACE_TRACKS_DIFFUSE
    lit.primary.a = surface.color.a;  // of d_cm
#else
    lit.primary.a = u_FACE_alpha;
#endif
#if EFFECT_SEPARATE_SPECULAR
    lit.secondary = vec3(0.0);
#endif
#if EFFECT_LOCAL_VIEWER
    vec3 vpe_dir = unit(-surface.position_eye);  // VPe: GL_LIGHT_MODEL_LOCAL_VIEWER
#elif EFFECT_VPE_DIR
    const vec3 vpe_dir = vec3(0.0, 0.0, 1.0);  // the infinite viewer
#endif
#for_each_light "light.glsl"
#if EFFECT_CLAMP
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
#endif
#if EFFECT_CLAMP && EFFECT_SEPARATE_SPECULAR
    lit.secondary = clamp(lit.secondary, 0.0, 1.0);
#endif
    return lit;
}


// The FACE face: its material, met with the lights.
Lit light_FACE(SURFACE_PARAMETER) {
    Lit lit;
#if !EFFECT_PRIMARY
    // The texture leaves nothing of c_pri.
#elif !EFFECT_FACE_VARIES_EMISSION && !EFFECT_FACE_VARIES_AMBIENT
    lit.primary.rgb = BASE_OF_FACE;  // e_cm + a_cm a_cs
#elif !EFFECT_FACE_VARIES_AMBIENT
    lit.primary.rgb = VERTEX_EMISSION.rgb + BASE_OF_FACE;  // e_cm is the vertex's
#elif !EFFECT_FACE_VARIES_EMISSION
    lit.primary.rgb = BASE_OF_FACE + u_constant_ambient * VERTEX_AMBIENT.rgb;  // e_cm + a_cm a_cs
#else
    lit.primary.rgb = VERTEX_EMISSION.rgb + u_constant_ambient * VERTEX_AMBIENT.rgb;  // e_cm + a_cm a_cs
#endif
#if EFFECT_PRIMARY && EFFECT_FACE_VARIES_DIFFUSE
    lit.primary.a = VERTEX_DIFFUSE.a;  // of d_cm
#elif EFFECT_PRIMARY
    lit.primary.a = ALPHA_OF_FACE;
#endif
#if EFFECT_SEPARATE_SPECULAR
    lit.secondary = vec3(0.0);
#endif
#if EFFECT_LOCAL_VIEWER && EFFECT_OBJECT_SPACE
    vec3 vpe_dir = unit(u_viewer_object - surface.position_SPACE);  // VPe: GL_LIGHT_MODEL_LOCAL_VIEWER
#elif EFFECT_LOCAL_VIEWER
    vec3 vpe_dir = unit(-surface.position_SPACE);  // VPe: GL_LIGHT_MODEL_LOCAL_VIEWER
#elif EFFECT_VPE_DIR && EFFECT_OBJECT_SPACE
    vec3 vpe_dir = u_viewer_dir;  // the infinite viewer
#elif EFFECT_VPE_DIR
    const vec3 vpe_dir = vec3(0.0, 0.0, 1.0);  // the infinite viewer
#endif
#if EFFECT_HALF_SUM
    float n_dot_vpe = dot(surface.normal_SPACE, vpe_dir);
#endif
#if EFFECT_SAMPLED
    // Three samples of the spectrum a group, in the place of red, green and blue.
    vec3 samples[GROUPS];
    for (int g = 0; g < GROUPS; ++g) samples[g] = vec3(0.0);
#endif
#if EFFECT_SAMPLED && EFFECT_SEPARATE_SPECULAR
    vec3 secondary_samples[GROUPS];
    for (int g = 0; g < GROUPS; ++g) secondary_samples[g] = vec3(0.0);
#endif
#for_each_light "light.glsl"
#if EFFECT_SAMPLED
    for (int g = 0; g < GROUPS; ++g) lit.primary.rgb += u_rgb_from_samples[g] * samples[g];
#endif
#if EFFECT_SAMPLED && EFFECT_SEPARATE_SPECULAR
    for (int g = 0; g < GROUPS; ++g) lit.secondary += u_rgb_from_samples[g] * secondary_samples[g];
#endif
#if EFFECT_CLAMP && EFFECT_PRIMARY
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
#elif EFFECT_PRIMARY
    // Never the uniform as it is: Mesa takes that out of what is interpolated, and surfaces that cross at a small angle then
    // do so in other pixels than the fixed function's.
    lit.primary.a = clamp(lit.primary.a, 0.0, 1.0);
#endif
#if EFFECT_CLAMP && EFFECT_SEPARATE_SPECULAR
    lit.secondary = clamp(lit.secondary, 0.0, 1.0);
#endif
    return lit;
}


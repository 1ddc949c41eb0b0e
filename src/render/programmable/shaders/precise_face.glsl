// The FACE face: its material, met with the lights.
Lit light_FACE(SURFACE_PARAMETER) {
#if !EFFECT_PRIMARY
    // The texture leaves nothing of c_pri.
#elif !EFFECT_FACE_VARIES_EMISSION && !EFFECT_FACE_VARIES_AMBIENT
    precise vec3 primary = BASE_OF_FACE;  // e_cm + a_cm a_cs
#elif !EFFECT_FACE_VARIES_AMBIENT
    precise vec3 primary = BASE_OF_FACE + VERTEX_EMISSION.rgb;  // a_cm a_cs, and e_cm of the vertex
#elif !EFFECT_FACE_VARIES_EMISSION
    precise vec3 primary = u_constant_ambient * VERTEX_AMBIENT.rgb + BASE_OF_FACE;  // a_cm a_cs + e_cm
#else
    precise vec3 primary = u_constant_ambient * VERTEX_AMBIENT.rgb + VERTEX_EMISSION.rgb;  // a_cm a_cs + e_cm
#endif
#if EFFECT_SEPARATE_SPECULAR
    precise vec3 secondary = vec3(0.0);
#endif
#if EFFECT_LOCAL_VIEWER
    precise vec3 from_viewer_dir = precise_unit(surface.position_SPACE);  // -VPe: GL_LIGHT_MODEL_LOCAL_VIEWER
#endif
#for_each_light "precise_light.glsl"
    Lit lit;
#if EFFECT_PRIMARY && EFFECT_FACE_VARIES_DIFFUSE
    lit.primary = vec4(primary, VERTEX_DIFFUSE.a);
#elif EFFECT_PRIMARY
    lit.primary = vec4(primary, ALPHA_OF_FACE);
#endif
#if EFFECT_PRIMARY && EFFECT_CLAMP
    lit.primary = clamp(lit.primary, 0.0, 1.0);  // section 2.14.6
#endif
#if EFFECT_SEPARATE_SPECULAR && EFFECT_CLAMP
    lit.secondary = clamp(secondary, 0.0, 1.0);
#elif EFFECT_SEPARATE_SPECULAR
    lit.secondary = secondary;
#endif
    return lit;
}


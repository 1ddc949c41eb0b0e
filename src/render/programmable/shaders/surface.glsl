#if EFFECT_POSITION_EYE && EFFECT_OBJECT_SPACE
    vec4 position_object = POSITION;
#elif EFFECT_POSITION_EYE
    vec4 position_eye = u_eye_from_object * POSITION;
#endif
#if EFFECT_NORMAL && EFFECT_OBJECT_SPACE && EFFECT_NORMALIZE
    vec3 normal_object = unit(a_normal);  // GL_NORMALIZE
#elif EFFECT_NORMAL && EFFECT_OBJECT_SPACE
    vec3 normal_object = a_normal;
#elif EFFECT_NORMAL && EFFECT_NORMALIZE
    vec3 normal_eye = unit(u_eye_from_object_normal * a_normal);  // GL_NORMALIZE
#elif EFFECT_NORMAL
    vec3 normal_eye = u_eye_from_object_normal * a_normal;
#endif

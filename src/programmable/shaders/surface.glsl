#if EFFECT_POSITION_EYE
    vec4 position_eye = u_eye_from_object * a_position;
#endif
#if EFFECT_NORMAL && EFFECT_NORMALIZE
    vec3 normal_eye = unit(u_eye_from_object_normal * a_normal);  // GL_NORMALIZE
#elif EFFECT_NORMAL
    vec3 normal_eye = u_eye_from_object_normal * a_normal;
#endif

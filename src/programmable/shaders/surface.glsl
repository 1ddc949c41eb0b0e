#if EFFECT_POSITION_EYE && EFFECT_VERTEX_W
    vec4 homogeneous_eye = u_eye_from_object * a_position;
    vec3 position_eye = homogeneous_eye.xyz / homogeneous_eye.w;
#elif EFFECT_POSITION_EYE
    vec3 position_eye = (u_eye_from_object * a_position).xyz;
#endif
#if EFFECT_NORMAL && EFFECT_NORMALIZE
    vec3 normal_eye = unit(u_eye_from_object_normal * a_normal);  // GL_NORMALIZE
#elif EFFECT_NORMAL
    vec3 normal_eye = u_eye_from_object_normal * a_normal;
#endif

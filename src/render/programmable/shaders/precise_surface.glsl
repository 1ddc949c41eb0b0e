#if EFFECT_POSITION_EYE
    vec4 position_eye = transformed(u_eye_from_object, POSITION);
#endif
#if EFFECT_NORMAL && EFFECT_OBJECT_SPACE
    precise vec3 normal_object = a_normal;
#elif EFFECT_NORMAL
    precise vec3 normal_eye = a_normal.z * u_eye_from_object_normal[2];
    normal_eye = a_normal.y * u_eye_from_object_normal[1] + normal_eye;
    normal_eye = a_normal.x * u_eye_from_object_normal[0] + normal_eye;
#endif
#if EFFECT_NORMAL && EFFECT_NORMALIZE
    normal_SPACE = precise_unit(normal_SPACE);  // GL_NORMALIZE
#elif EFFECT_NORMAL && EFFECT_RESCALE
    normal_SPACE = normal_SPACE * u_normal_scale;  // GL_RESCALE_NORMAL
#endif

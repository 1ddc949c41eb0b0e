#if EFFECT_SAMPLED
#elif EFFECT_LIGHT_AMBIENT && EFFECT_FACE_VARIES_AMBIENT
uniform PRODUCT_TYPE u_LIGHTi_FACE_ambient;  // a_cli
#elif EFFECT_LIGHT_AMBIENT
uniform vec3 u_LIGHTi_FACE_ambient;  // a_cm a_cli
#endif
#if EFFECT_SAMPLED
#elif EFFECT_LIGHT_DIFFUSE && EFFECT_FACE_VARIES_DIFFUSE
uniform PRODUCT_TYPE u_LIGHTi_FACE_diffuse;  // d_cli
#elif EFFECT_LIGHT_DIFFUSE
uniform vec3 u_LIGHTi_FACE_diffuse;  // d_cm d_cli
#endif
#if EFFECT_SAMPLED
#elif EFFECT_LIGHT_SPECULAR && EFFECT_FACE_VARIES_SPECULAR
uniform PRODUCT_TYPE u_LIGHTi_FACE_specular;  // s_cli
#elif EFFECT_LIGHT_SPECULAR
uniform vec3 u_LIGHTi_FACE_specular;  // s_cm s_cli
#endif

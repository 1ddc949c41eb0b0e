// The FACE face.
#if EFFECT_PRIMARY && !EFFECT_FACE_VARIES_EMISSION || EFFECT_PRIMARY && !EFFECT_FACE_VARIES_AMBIENT
uniform vec3 u_FACE_base;  // what is the same at every vertex
#endif
#if EFFECT_PRIMARY && !EFFECT_FACE_VARIES_DIFFUSE
uniform float u_FACE_alpha;  // d_cm's
#endif
#if EFFECT_SHININESS && !EFFECT_FACE_VARIES_SHININESS
uniform float u_FACE_shininess;  // s_rm
#endif
#if EFFECT_SAMPLED && EFFECT_AMBIENT
uniform vec3 u_FACE_ambient_samples[GROUPS];  // a_cm
#endif
#if EFFECT_SAMPLED && EFFECT_DIFFUSE
uniform vec3 u_FACE_diffuse_samples[GROUPS];  // d_cm
#endif
#if EFFECT_SAMPLED && EFFECT_SPECULAR
uniform vec3 u_FACE_specular_samples[GROUPS];  // s_cm
#endif
#for_each_light "product_uniforms.glsl"

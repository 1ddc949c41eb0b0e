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
#for_each_light "product_uniforms.glsl"

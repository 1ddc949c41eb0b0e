// LIGHTi.
#if EFFECT_LIGHT_LOOP
// It stands for as many as this.
uniform float u_count_of_LIGHTi;
#endif
#if EFFECT_LIGHT_DIRECTIONAL
uniform vec3 u_LIGHTi_direction_SPACE;  // VP, of length 1
#else
uniform vec3 u_LIGHTi_position_SPACE;  // P_pli
#endif
#if EFFECT_LIGHT_ATTENUATED
uniform float u_LIGHTi_constant_attenuation;
uniform float u_LIGHTi_linear_attenuation;
uniform float u_LIGHTi_quadratic_attenuation;
#endif
#if EFFECT_LIGHT_SPOT || EFFECT_LIGHT_SMOOTH_CONE
uniform vec3 u_LIGHTi_spot_direction_SPACE;  // s_dli, of length 1
#endif
#if EFFECT_LIGHT_SPOT
uniform float u_LIGHTi_spot_cutoff_cosine;
#endif
#if EFFECT_LIGHT_SPOT && EFFECT_LIGHT_SPOT_EXPONENT
uniform float u_LIGHTi_spot_exponent;  // s_rli
#endif
#if EFFECT_LIGHT_SMOOTH_CONE
uniform float u_LIGHTi_outer_cosine;
uniform float u_LIGHTi_cone_slope;  // 1 / (cos inner - cos outer)
#endif
#if EFFECT_LIGHT_HALF_DIR
uniform vec3 u_LIGHTi_half_dir;  // h_i, the same at every vertex
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_AMBIENT
uniform vec3 u_LIGHTi_ambient_samples[GROUPS];  // a_cli
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_DIFFUSE
uniform vec3 u_LIGHTi_diffuse_samples[GROUPS];  // d_cli
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_SPECULAR
uniform vec3 u_LIGHTi_specular_samples[GROUPS];  // s_cli
#endif


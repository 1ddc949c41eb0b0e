#if EFFECT_TEXTURE
uniform SAMPLER u_texture;
#endif
#if EFFECT_BLEND
uniform vec4 u_texture_env_color;
#endif
#if EFFECT_FOG
uniform vec3 u_fog_color;
#endif
#if EFFECT_FOG_LINEAR
uniform float u_fog_end;
uniform float u_fog_scale;  // 1 / (end - start)
#elif EFFECT_FOG
uniform float u_fog_density;
#endif

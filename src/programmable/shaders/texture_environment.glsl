    // The texture and its environment (section 3.8.13, tables 3.22 and 3.23).
    vec4 texel = TEXTURE_LOOKUP(u_texture, v_tex_coord);
#if EFFECT_REPLACE && EFFECT_TEXEL_COLOR && EFFECT_TEXEL_ALPHA
    vec4 color = texel;
#else
    vec4 color = primary;
#endif
#if EFFECT_REPLACE && EFFECT_TEXEL_COLOR && !EFFECT_TEXEL_ALPHA
    color.rgb = texel.rgb;
#elif EFFECT_REPLACE && EFFECT_TEXEL_ALPHA && !EFFECT_TEXEL_COLOR
    color.a = texel.a;
#elif EFFECT_MODULATE && EFFECT_TEXEL_COLOR && EFFECT_TEXEL_ALPHA
    color *= texel;
#elif EFFECT_MODULATE && EFFECT_TEXEL_COLOR
    color.rgb *= texel.rgb;
#elif EFFECT_MODULATE
    color.a *= texel.a;
#elif EFFECT_DECAL
    color.rgb = mix(color.rgb, texel.rgb, texel.a);
#elif EFFECT_BLEND
    color.rgb = mix(color.rgb, u_texture_env_color.rgb, texel.rgb);
#elif EFFECT_ADD
    color.rgb = min(color.rgb + texel.rgb, 1.0);
#endif
#if EFFECT_BLEND && EFFECT_TEXEL_INTENSITY
    color.a = mix(color.a, u_texture_env_color.a, texel.a);
#elif EFFECT_ADD && EFFECT_TEXEL_INTENSITY
    color.a = min(color.a + texel.a, 1.0);
#elif EFFECT_BLEND && EFFECT_TEXEL_ALPHA || EFFECT_ADD && EFFECT_TEXEL_ALPHA
    color.a *= texel.a;
#endif

#if EFFECT_TEXTURE_CLAMP
    // GL_CLAMP (section 3.8.7) clamps to [0,1]. The end stays in the last texel, because the border begins beyond it.
    const float texture_end = 1.0 - 1.0 / 4194304.0;
#endif
#if EFFECT_TEXTURE_CLAMP || EFFECT_RAY_TEX_COORD
    DIVIDED_TYPE tex_coord = DIVIDED_TEX_COORD;
#endif
#if EFFECT_TEXTURE_GRADIENTS && !EFFECT_RAY_TEX_COORD
    DIVIDED_TYPE per_x = dFdx(tex_coord), per_y = dFdy(tex_coord);  // unclamped: they choose the level of detail
#endif
#if EFFECT_TEXTURE_CLAMP_S
    TEX_COORD_S = clamp(TEX_COORD_S, 0.0, texture_end);
#endif
#if EFFECT_TEXTURE_CLAMP_T
    tex_coord.t = clamp(tex_coord.t, 0.0, texture_end);
#endif
#if EFFECT_RAY_TEX_COORD
    vec4 texel = textureGrad(u_texture, tex_coord, tex_per_x.DIVIDED_PARTS, tex_per_y.DIVIDED_PARTS);
#elif EFFECT_TEXTURE_GRADIENTS
    vec4 texel = textureGrad(u_texture, tex_coord, per_x, per_y);
#elif EFFECT_TEXTURE_CLAMP
    vec4 texel = texture(u_texture, tex_coord);
#else
    vec4 texel = TEXTURE_LOOKUP(u_texture, TEX_COORD);
#endif
#insert texture_environment

#if EFFECT_TEXTURE_CLAMP
    // GL_CLAMP (section 3.8.7) clamps to [0,1]. The end stays in the last texel, because the border begins beyond it.
    const float texture_end = 1.0 - 1.0 / 4194304.0;
#endif
#if EFFECT_TEXTURE_CLAMP || EFFECT_TEXTURE_RIM || EFFECT_TEXTURE_FACES || EFFECT_TEXTURE_CLAMP_DEPTH || EFFECT_RAY_TEX_COORD
    DIVIDED_TYPE tex_coord = DIVIDED_TEX_COORD;
#endif
#if EFFECT_TEXTURE_GRADIENTS && !EFFECT_RAY_TEX_COORD
    GRADIENT_TYPE per_x = dFdx(TEX_COORD_PLACE), per_y = dFdy(TEX_COORD_PLACE);  // unclamped: they choose the level of detail
#endif
#if EFFECT_TEXTURE_LOD_BIAS && EFFECT_TEXTURE_GRADIENTS && !EFFECT_RAY_TEX_COORD
    per_x *= exp2(u_texture_lod_bias);  // GL_TEXTURE_LOD_BIAS is added to the gradients' logarithm (section 3.8.8)
    per_y *= exp2(u_texture_lod_bias);
#endif
#if EFFECT_TEXTURE_LOD_BIAS && EFFECT_RAY_TEX_COORD
    tex_per_x *= exp2(u_texture_lod_bias);  // GL_TEXTURE_LOD_BIAS is added to the gradients' logarithm (section 3.8.8)
    tex_per_y *= exp2(u_texture_lod_bias);
#endif
#if EFFECT_TEXTURE_CLAMP_S
    TEX_COORD_S = clamp(TEX_COORD_S, 0.0, texture_end);
#endif
#if EFFECT_TEXTURE_CLAMP_T
    tex_coord.t = clamp(tex_coord.t, 0.0, texture_end);
#endif
#if EFFECT_TEXTURE_CLAMP_R
    tex_coord.p = clamp(tex_coord.p, 0.0, texture_end);
#endif
#if EFFECT_TEXTURE_CLAMP_DEPTH
    tex_coord.p = clamp(tex_coord.p, 0.0, 1.0);  // compared with depths (section 3.8.14)
#endif
#if EFFECT_TEXTURE_RIM
    tex_coord = tex_coord * TEXTURE_INSIDE + (0.5 - 0.5 * TEXTURE_INSIDE);  // past the rim with the border's colour (section 3.8.7)
#endif
#if EFFECT_TEXTURE_RIM && EFFECT_TEXTURE_GRADIENTS && !EFFECT_RAY_TEX_COORD
    per_x *= INSIDE_PLACE;
    per_y *= INSIDE_PLACE;
#endif
#if EFFECT_TEXTURE_RIM && EFFECT_RAY_TEX_COORD
    tex_per_x.st *= u_texture_inside.st;
    tex_per_y.st *= u_texture_inside.st;
#endif
#if EFFECT_TEXTURE_FACES
    // The half texel at a face's borders is cut off, because OpenGL ES mixes it with the next face, and OpenGL 2.1 does not.
    vec3 sizes = abs(tex_coord);
    float largest = max(max(sizes.s, sizes.t), sizes.p);
    vec3 within_face = clamp(tex_coord, -u_texture_inside * largest, u_texture_inside * largest);
    tex_coord = mix(within_face, tex_coord, greaterThanEqual(sizes, vec3(largest)));
#endif
#if EFFECT_RAY_TEX_COORD
    LOOKED_UP = textureGrad(u_texture, RAY_ARGUMENTS)LOOKED_UP_PART;
#elif EFFECT_TEXTURE_GRADIENTS
    LOOKED_UP = textureGrad(u_texture, GRADIENT_ARGUMENTS)LOOKED_UP_PART;
#elif EFFECT_TEXTURE_CLAMP || EFFECT_TEXTURE_RIM || EFFECT_TEXTURE_FACES || EFFECT_TEXTURE_CLAMP_DEPTH
    LOOKED_UP = texture(u_texture, CLAMPED_ARGUMENTS)LOOKED_UP_PART;
#else
    LOOKED_UP = TEXTURE_LOOKUP(u_texture, LOOKUP_ARGUMENTS)LOOKED_UP_PART;
#endif
#if EFFECT_TEXTURE_DEPTHS
    vec4 texel = DEPTH_TEXEL;  // section 3.8.14: a depth, or 0 or 1 if it is compared with r
#endif

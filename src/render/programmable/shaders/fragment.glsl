void main() {
#insert clip_discards
#if EFFECT_RAY
#include "surface_point.glsl"
#endif
#insert lit
#if EFFECT_TEXTURE
#include "texture.glsl"
#else
#insert texture_lookups
#endif
#if EFFECT_ONE_STEP
#insert stipples
    fragment_color = FIRST_COLOR;ENVIRONMENT
#else
    vec4 color = FIRST_COLOR;ENVIRONMENT
#insert texture_environment
#if EFFECT_SEPARATE_SPECULAR
    color.rgb = min(color.rgb + SECONDARY, 1.0);  // the colour sum (section 3.9)
#endif
#if EFFECT_FOG
    color.rgb = mix(u_fog_color, color.rgb, FOG_FACTOR);  // section 3.10
#endif
#if EFFECT_SRGB_CODED
    color.rgb = srgb_coded(color.rgb);
#endif
#insert stipples
#insert coverage
#insert alpha_test
#insert logic_op
#insert blend_source
    fragment_color = color;
#endif
}

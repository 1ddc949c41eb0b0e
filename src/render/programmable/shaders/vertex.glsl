void main() {
#if EFFECT_RAY
    gl_Position = vec4(mix(u_rectangle_ndc.xy, u_rectangle_ndc.zw, a_position.xy), 0.0, 1.0);
#else
#if !EFFECT_POSITION_IS_ATTRIBUTE
    vec4 position = POSITION;
#endif
#if EFFECT_FLAT_EDGES
#insert lit
    position = a_edge_position;  // the vertex above gives only the colour (section 2.14.7)
#endif
#insert clip_position
#insert corner
#endif
#if !EFFECT_FLAT_EDGES
#insert lit
#endif
#insert generated
#insert outputs
#insert point_size
#insert clip_distances
}

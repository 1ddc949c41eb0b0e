void main() {
#if EFFECT_RAY
    gl_Position = vec4(mix(u_rectangle_ndc.xy, u_rectangle_ndc.zw, a_position.xy), 0.0, 1.0);
#else
    vec4 position = POSITION;
#insert clip_position
#insert beside_line
#endif
#insert lit
#insert generated
#insert outputs
#insert point_size
#insert clip_distances
}

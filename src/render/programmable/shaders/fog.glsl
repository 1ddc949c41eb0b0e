    // Fog (section 3.10), by the distance to the plane of the eye; alpha stays as it is.
#if EFFECT_FOG_W
    float fog_distance = abs(GIVEN_eye_z.x / GIVEN_eye_z.y);
#else
    float fog_distance = abs(GIVEN_eye_z);
#endif
#if EFFECT_FOG_LINEAR
    float fog_factor = clamp((u_fog_end - fog_distance) * u_fog_scale, 0.0, 1.0);
#elif EFFECT_FOG_EXP
    float fog_factor = exp(-u_fog_density * fog_distance);
#else
    float fog_thickness = u_fog_density * fog_distance;
    float fog_factor = exp(-fog_thickness * fog_thickness);  // GL_EXP2
#endif
    color.rgb = mix(u_fog_color, color.rgb, fog_factor);

    FOR_EACH_OF_LIGHTi{
        // LIGHTi.
#if EFFECT_LIGHT_DIRECTIONAL && EFFECT_LIGHT_VP_DIR
        vec3 vp_dir = u_LIGHTi_direction_SPACE;
#elif !EFFECT_LIGHT_DIRECTIONAL
        vec3 vp = u_LIGHTi_position_SPACE - surface.position_SPACE;
        float light_distance = sqrt(max(dot(vp, vp), 1e-24));
#endif
#if EFFECT_LIGHT_N_DOT_VP && EFFECT_LIGHT_DIRECTIONAL
        float signed_n_dot_vp = dot(surface.normal_SPACE, vp_dir);
#elif EFFECT_LIGHT_N_DOT_VP
        float distance_times_n_dot_vp = dot(surface.normal_SPACE, vp);
#endif
#if EFFECT_LIGHT_HALF_SUM && EFFECT_LIGHT_DIRECTIONAL
        // h_i is this sum made unit.
        vec3 half_sum = vp_dir + vpe_dir;
        float n_dot_half_sum = signed_n_dot_vp + n_dot_vpe;
#elif EFFECT_LIGHT_HALF_SUM
        // h_i is this sum of VP_i and VPe made unit, of which each is light_distance long.
        vec3 half_sum = vp + light_distance * vpe_dir;
        float n_dot_half_sum = distance_times_n_dot_vp + light_distance * n_dot_vpe;
#endif
#if EFFECT_LIGHT_HALF_SUM
        float half_sum_squared = max(dot(half_sum, half_sum), 1e-24);
#endif
#if EFFECT_LIGHT_ATTENUATED
        // att_i = 1 / (k0 + k1 d + k2 d^2)
        float attenuation_divisor = u_LIGHTi_constant_attenuation +
            light_distance * (u_LIGHTi_linear_attenuation + light_distance * u_LIGHTi_quadratic_attenuation);
#endif
#if EFFECT_LIGHT_DIRECTIONAL && EFFECT_LIGHT_HALF_SUM
        float per_half_sum_squared = 1.0 / half_sum_squared;
#elif !EFFECT_LIGHT_DIRECTIONAL
        // One division does for all: 1 / a is b c / (a b c).
        float reciprocal = 1.0 / max(light_distanceTIMES_ATTENUATION_DIVISORTIMES_HALF_SUM_SQUARED, 1e-37);
        float per_distance = reciprocalTIMES_HALF_SUM_SQUAREDTIMES_ATTENUATION_DIVISOR;
#endif
#if EFFECT_LIGHT_HALF_SUM && !EFFECT_LIGHT_DIRECTIONAL
        float per_half_sum_squared = reciprocal * (light_distanceTIMES_ATTENUATION_DIVISOR);
#endif
#if EFFECT_LIGHT_ATTENUATED
        // Where it would be 1/0, the light contributes nothing.
        float attenuation = u_LIGHTi_constant_attenuation > 0.0 || dot(vp, vp) > 0.0
            ? reciprocalTIMES_HALF_SUM_SQUARED * light_distance : 0.0;
#endif
#if EFFECT_LIGHT_N_DOT_VP && !EFFECT_LIGHT_DIRECTIONAL
        float signed_n_dot_vp = distance_times_n_dot_vp * per_distance;
#endif
#if EFFECT_LIGHT_N_DOT_VP
        float n_dot_vp = max(signed_n_dot_vp, 0.0);
#endif
#if EFFECT_LIGHT_SPOT || EFFECT_LIGHT_SMOOTH_CONE
        // spot_i: PV . s_dli is the cosine of the angle to the cone's axis.
        float spot_cosine = -per_distance * dot(vp, u_LIGHTi_spot_direction_SPACE);
#endif
#if EFFECT_LIGHT_SPOT && EFFECT_LIGHT_SPOT_EXPONENT
        float spot = spot_cosine >= u_LIGHTi_spot_cutoff_cosine
            ? SPOT_POWER(max(spot_cosine, 0.0), u_LIGHTi_spot_exponent) : 0.0;
#elif EFFECT_LIGHT_SPOT
        float spot = spot_cosine >= u_LIGHTi_spot_cutoff_cosine ? 1.0 : 0.0;
#elif EFFECT_LIGHT_SMOOTH_CONE
        // Not GL: a cone with a soft border.
        float spot = clamp((spot_cosine - u_LIGHTi_outer_cosine) * u_LIGHTi_cone_slope, 0.0, 1.0);
#endif
#if EFFECT_LIGHT_ATTENUATED && EFFECT_LIGHT_CONE
        float reach = attenuation * spot;
#elif EFFECT_LIGHT_ATTENUATED
        float reach = attenuation;
#elif EFFECT_LIGHT_CONE
        float reach = spot;
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_AMBIENT
        for (int g = 0; g < GROUPS; ++g) samples[g] += REACH_TIMES (AMBIENT_SAMPLES_OF_FACE * u_LIGHTi_ambient_samples[g]);
#elif EFFECT_LIGHT_AMBIENT && EFFECT_FACE_VARIES_AMBIENT
        lit.primary.rgb += REACH_TIMES (u_LIGHTi_FACE_ambient * VERTEX_AMBIENT.rgb);
#elif EFFECT_LIGHT_AMBIENT
        lit.primary.rgb += REACH_TIMES u_LIGHTi_FACE_ambient;
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_DIFFUSE
        for (int g = 0; g < GROUPS; ++g)
            samples[g] += REACH_TIMES n_dot_vp * (DIFFUSE_SAMPLES_OF_FACE * u_LIGHTi_diffuse_samples[g]);
#elif EFFECT_LIGHT_DIFFUSE && EFFECT_FACE_VARIES_DIFFUSE
        lit.primary.rgb += REACH_TIMES n_dot_vp * (u_LIGHTi_FACE_diffuse * VERTEX_DIFFUSE.rgb);
#elif EFFECT_LIGHT_DIFFUSE
        lit.primary.rgb += REACH_TIMES n_dot_vp * u_LIGHTi_FACE_diffuse;
#endif
#if EFFECT_LIGHT_SPECULAR && EFFECT_REFLECTION && EFFECT_SHININESS
        // Not GL: the highlight by reflection, (r . v)^s_rm, without f_i.
        vec3 reflected_dir = 2.0 * dot(surface.normal_SPACE, VP_DIR) * surface.normal_SPACE - VP_DIR;
        float highlight = POWER(max(dot(reflected_dir, vpe_dir), 0.0), SHININESS_OF_FACE);
#elif EFFECT_LIGHT_SPECULAR && EFFECT_REFLECTION
        float highlight = 1.0;  // (r . v)^0
#elif EFFECT_LIGHT_SPECULAR && EFFECT_LIGHT_HALF_DIR
        // f_i (n . h_i)^s_rm; f_i is 0 where the light is behind the surface.
        float n_dot_h = max(dot(surface.normal_SPACE, u_LIGHTi_half_dir), 0.0);
        float highlight = n_dot_vp > 0.0 ? POWER(n_dot_h, SHININESS_OF_FACE) : 0.0;
#elif EFFECT_LIGHT_SPECULAR && EFFECT_SHININESS
        // f_i (n . h_i)^s_rm; f_i is 0 where the light is behind the surface. Of (n . h_i)^2 an even power needs no root.
        n_dot_half_sum = max(n_dot_half_sum, 0.0);
#if EFFECT_HIGHLIGHT_BOUND
        n_dot_half_sum = min(n_dot_half_sum, 1e15);  // its square is a number
#endif
        float squared_n_dot_h = n_dot_half_sum * n_dot_half_sum * per_half_sum_squared;
        float highlight = n_dot_vp > 0.0 ? POWER_OF_ROOT(squared_n_dot_h, SHININESS_OF_FACE) : 0.0;
#elif EFFECT_LIGHT_SPECULAR
        float highlight = n_dot_vp > 0.0 ? 1.0 : 0.0;  // f_i; (n . h_i)^0 is 1
#endif
#if EFFECT_LIGHT_SPECULAR && EFFECT_HIGHLIGHT_BOUND
        highlight = min(highlight, 1e30);  // normals may be longer than 1; infinity times 0 is no number
#endif
#if EFFECT_SAMPLED && EFFECT_LIGHT_SPECULAR
        for (int g = 0; g < GROUPS; ++g)
            SPECULAR_SAMPLES[g] += REACH_TIMES highlight * (SPECULAR_SAMPLES_OF_FACE * u_LIGHTi_specular_samples[g]);
#elif EFFECT_LIGHT_SPECULAR && EFFECT_FACE_VARIES_SPECULAR
        SPECULAR_SUM += REACH_TIMES highlight * (u_LIGHTi_FACE_specular * VERTEX_SPECULAR.rgb);
#elif EFFECT_LIGHT_SPECULAR
        SPECULAR_SUM += REACH_TIMES highlight * u_LIGHTi_FACE_specular;
#endif
    }

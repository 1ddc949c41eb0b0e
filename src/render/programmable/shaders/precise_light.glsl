    {
        // LIGHTi.
#if EFFECT_LIGHT_DIRECTIONAL
        vec3 vp_dir = u_LIGHTi_direction_SPACE;
#else
        precise vec3 vp = u_LIGHTi_position_SPACE - surface.position_SPACE;
        precise float per_distance = per_length(vp);
        precise vec3 vp_dir = vp * per_distance;
#endif
#if EFFECT_LIGHT_SPOT
        // spot_i. What pow leaves open, 0^0, is 1 (section 2.1.1).
        precise float spot_cosine = dot3(-vp_dir, u_LIGHTi_spot_direction_SPACE);
        precise float spot_power =
            u_LIGHTi_spot_exponent > 0.0 ? pow(abs(spot_cosine), u_LIGHTi_spot_exponent) : 1.0;
        precise float reach = spot_cosine >= u_LIGHTi_spot_cutoff_cosine ? spot_power : 0.0;
#endif
#if EFFECT_LIGHT_ATTENUATED
        // att_i = 1 / (k0 + k1 d + k2 d^2), where the driver has d / d for 1. Where it would be 1/0, the light contributes nothing.
        precise float distance_squared = dot3(vp, vp);
        precise float light_distance = sqrt(distance_squared);
        precise vec3 powers_of_distance = vec3(light_distance > 0.0 ? per_distance * light_distance : 1.0, light_distance, distance_squared);
        precise float attenuation_divisor = dot3(
            vec3(u_LIGHTi_constant_attenuation, u_LIGHTi_linear_attenuation, u_LIGHTi_quadratic_attenuation),
            powers_of_distance);
        precise float attenuation = attenuation_divisor > 0.0 ? 1.0 / attenuation_divisor : 0.0;
#endif
#if EFFECT_LIGHT_ATTENUATED && EFFECT_LIGHT_SPOT
        reach = attenuation * reach;
#elif EFFECT_LIGHT_ATTENUATED
        precise float reach = attenuation;
#endif
        precise float n_dot_vp = dot3(surface.normal_SPACE, vp_dir);
        precise float diffuse = max(n_dot_vp, 0.0);
#if EFFECT_LIGHT_HALF_DIR
        precise float n_dot_h = dot3(surface.normal_SPACE, u_LIGHTi_half_dir);
#elif EFFECT_LIGHT_HALF_SUM && EFFECT_LOCAL_VIEWER
        precise vec3 half_sum = vp_dir - from_viewer_dir;
        precise float n_dot_h = dot3(surface.normal_SPACE, precise_unit(half_sum));
#elif EFFECT_LIGHT_HALF_SUM
        precise vec3 half_sum = vp_dir + vec3(0.0, 0.0, 1.0);
        precise float n_dot_h = dot3(surface.normal_SPACE, precise_unit(half_sum));
#endif
#if EFFECT_SHININESS
        // f_i (n . h_i)^s_rm; x^0 is 1 on the face that has a shininess of 0.
        precise float power = SHININESS_OF_FACE > 0.0 ? pow(max(n_dot_h, 0.0), SHININESS_OF_FACE) : 1.0;
        precise float specular = n_dot_vp > 0.0 ? power : 0.0;
#else
        precise float specular = n_dot_vp > 0.0 ? 1.0 : 0.0;  // f_i; (n . h_i)^0 is 1
#endif
#if EFFECT_HIGHLIGHT_BOUND
        specular = min(specular, 1e30);  // normals may be longer than 1; infinity times 0 is no number
#endif
#if EFFECT_LIGHT_REACH
        diffuse = diffuse * reach;
        specular = specular * reach;
#endif
#if EFFECT_LIGHT_AMBIENT && EFFECT_FACE_VARIES_AMBIENT
        precise vec3 ambient_product = u_LIGHTi_FACE_ambient * VERTEX_AMBIENT.rgb;
#elif EFFECT_LIGHT_AMBIENT
        vec3 ambient_product = u_LIGHTi_FACE_ambient;
#endif
#if EFFECT_LIGHT_DIFFUSE && EFFECT_FACE_VARIES_DIFFUSE
        precise vec3 diffuse_product = u_LIGHTi_FACE_diffuse * VERTEX_DIFFUSE.rgb;
#elif EFFECT_LIGHT_DIFFUSE
        vec3 diffuse_product = u_LIGHTi_FACE_diffuse;
#endif
#if EFFECT_FACE_VARIES_SPECULAR
        precise vec3 specular_product = u_LIGHTi_FACE_specular * VERTEX_SPECULAR.rgb;
#else
        vec3 specular_product = u_LIGHTi_FACE_specular;
#endif
#if EFFECT_LIGHT_AMBIENT && EFFECT_LIGHT_REACH
        primary = reach * ambient_product + primary;
#elif EFFECT_LIGHT_AMBIENT
        primary = ambient_product + primary;
#endif
#if EFFECT_LIGHT_DIFFUSE
        primary = diffuse * diffuse_product + primary;
#endif
        SPECULAR_SUM = specular * specular_product + SPECULAR_SUM;
    }

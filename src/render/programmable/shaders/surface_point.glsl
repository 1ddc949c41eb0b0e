    cast_ray();
    if (!is_met) discard;
    vec4 place = vec4(position_object, 1.0);
#if EFFECT_RAY_NORMAL
    vec3 outward = outward_normal(position_object);
#endif
#if EFFECT_TWO_SIDE
    is_front = u_front_side * dot(outward, direction) > 0.0;
#endif
#if EFFECT_RAY_STEPS
    // The depth slope: how depth changes per pixel in x and y on the tangent plane (in normalised device coordinates).
    vec3 step_depth = u_step_depth.xyz - u_step_depth.w * position_object;
    vec3 step_x = u_step_x.xyz - u_step_x.w * position_object;
    vec3 step_y = u_step_y.xyz - u_step_y.w * position_object;
    vec2 slope = -vec2(dot(outward, step_x), dot(outward, step_y)) / dot(outward, step_depth);
#endif
#if EFFECT_RAY_DEPTH
    // Computed from the far plane, because most depths are close to it.
    float depth = u_far_depth - u_half_depth_range * dot(u_to_far_plane, place) / dot(u_clip_w, place);
#endif
#if EFFECT_RAY_OFFSET
    // glPolygonOffset (section 3.5.5).
    depth += u_offset_factor * abs(u_half_depth_range) * max(abs(slope.x), abs(slope.y)) + u_offset;
#endif
#if EFFECT_RAY_DEPTH
    gl_FragDepth = clamp(depth, 0.0, 1.0);
#endif
#if EFFECT_RAY_TEX_COORD
    // Texture coordinates as in GLU's quadrics, and their change per pixel in x and y on the tangent plane.
    const float turn = 6.28318530717958648;
    vec3 p = position_object;
    float clip_w = dot(u_clip_w, place);
    vec3 per_x = clip_w * (step_x + slope.x * step_depth), per_y = clip_w * (step_y + slope.y * step_depth);
#endif
#if EFFECT_RAY_TEX_COORD && EFFECT_RAY_DISK
    float per_width = 0.5 / u_outer;
    vec4 tex_place = vec4(per_width * p.xy + 0.5, 0.0, 1.0);
    vec4 tex_per_x = vec4(per_width * per_x.xy, 0.0, 0.0), tex_per_y = vec4(per_width * per_y.xy, 0.0, 0.0);
#elif EFFECT_RAY_TEX_COORD
    float square = dot(p.xy, p.xy), angle = atan(p.x, p.y);
    vec4 tex_place = vec4((angle < 0.0 ? -angle : turn - angle) / turn, 0.0, 0.0, 1.0);
    vec4 tex_per_x = vec4((p.x * per_x.y - p.y * per_x.x) / (turn * square), 0.0, 0.0, 0.0);
    vec4 tex_per_y = vec4((p.x * per_y.y - p.y * per_y.x) / (turn * square), 0.0, 0.0, 0.0);
#endif
#if EFFECT_RAY_TEX_COORD && EFFECT_RAY_FRUSTUM
    float per_height = 0.5 / u_half_height;
    tex_place.t = per_height * p.z + 0.5;
    tex_per_x.t = per_height * per_x.z;
    tex_per_y.t = per_height * per_y.z;
#elif EFFECT_RAY_TEX_COORD && EFFECT_RAY_SPHERE
    float from_axis = sqrt(square);
    vec3 upwards = vec3(-p.z * p.xy / from_axis, from_axis) / (0.5 * turn * dot(p, p));
    tex_place.t = 1.0 - atan(from_axis, p.z) / (0.5 * turn);
    tex_per_x.t = dot(upwards, per_x);
    tex_per_y.t = dot(upwards, per_y);
#endif
#if EFFECT_RAY_TEX_COORD && EFFECT_TEXTURE_MATRIX
    tex_place = u_texture_matrix * tex_place;
    tex_per_x = u_texture_matrix * tex_per_x;
    tex_per_y = u_texture_matrix * tex_per_y;
#endif
#if EFFECT_RAY_TEX_COORD && EFFECT_TEXTURE_Q
    tex_place.st /= tex_place.q;
    tex_per_x.st = (tex_per_x.st - tex_per_x.q * tex_place.st) / tex_place.q;
    tex_per_y.st = (tex_per_y.st - tex_per_y.q * tex_place.st) / tex_place.q;
#endif

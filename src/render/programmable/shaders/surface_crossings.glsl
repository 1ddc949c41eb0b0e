vec3 direction;        // the direction of the ray
vec3 nearest;          // the ray's point nearest to the origin
vec3 position_object;  // where the ray meets the surface
bool is_met = false;
#if EFFECT_TWO_SIDE
bool is_front;
#endif
#if !EFFECT_RAY_NEAREST
float points_behind = 0.0;
#endif

// The outward normal, of any length.
vec3 outward_normal(vec3 p) {
#if EFFECT_RAY_SPHERE
    return p;
#elif EFFECT_RAY_FRUSTUM
    // At a cone's apex every normal is possible; the one along the axis is used.
    float from_axis = length(p.xy);
    return vec3(from_axis > 0.0 ? p.xy / from_axis : vec2(0.0), -u_slope);
#elif EFFECT_RAY_DISK
    return vec3(0.0, 0.0, u_disk_side);
#else
    return vec3(p.xy - u_ring / length(p.xy) * p.xy, p.z);
#endif
}

#if EFFECT_RAY_NEAREST
// Takes one of the ray's points on the surface, from near to far, and keeps the first visible one. Clipping and culling
// (sections 2.12, 3.5.1) work point by point.
#else
// Takes one of the ray's points on the surface, from far to near, and keeps number u_point_number of the visible ones.
// Clipping and culling (sections 2.12, 3.5.1) work point by point.
#endif
void meet(vec3 p) {
    vec4 place = vec4(p, 1.0);
#if EFFECT_RAY_FRUSTUM
    bool is_seen = abs(p.z) <= u_half_height;
#elif EFFECT_RAY_DISK
    float square = dot(p.xy, p.xy);
    bool is_seen = square <= u_outer * u_outer && square >= u_inner * u_inner;
#else
    bool is_seen = true;
#endif
#if EFFECT_RAY_SECTOR
    // Inside the sector if the angle to its middle (0 to pi) is at most half of its angle: the sine of their difference
    // is <= 0.
    float across = abs(u_sector.x * p.y - u_sector.y * p.x);
    is_seen = is_seen && across * u_sector.w <= dot(u_sector.xy, p.xy) * u_sector.z;
#endif
#if EFFECT_RAY_NEAR_FAR
    is_seen = is_seen && dot(u_clip_w, place) > 0.0;
    is_seen = is_seen && dot(u_to_near_plane, place) >= 0.0 && dot(u_to_far_plane, place) >= 0.0;
#endif
#insert within_clip_planes
#if EFFECT_RAY_CULL
    is_seen = is_seen && u_shown_side * dot(outward_normal(p), direction) > 0.0;
#endif
#if EFFECT_RAY_NEAREST
    if (is_seen) {
        position_object = p;
        is_met = true;
    }
#else
    if (is_seen && points_behind == u_point_number) {
        position_object = p;
        is_met = true;
    }
    points_behind += is_seen ? 1.0 : 0.0;
#endif
}

#if EFFECT_RAY_TORUS
// Along the ray, with s = the distance from its nearest point, the torus is where a quartic is 0: with k = |p|^2 + R^2
// - r^2, k^2 = 4 R^2 (distance from the axis)^2. Its roots are between those of its derivative, as in
// scene/shape/surface.h.
float quartic_square, quartic_linear;  // coefficients: s^4 + square s^2 + linear s + ...

// The derivative of the quartic.
float quartic_slope(float s) {
    return (4.0 * s * s + 2.0 * quartic_square) * s + quartic_linear;
}

// The quartic, computed from the point on the ray as two factors. The first is small near the surface.
float quartic(float s) {
    vec3 p = nearest + s * direction;
    float from_axis = length(p.xy), from_ring = from_axis - u_ring;
    float inner = from_ring * from_ring + (p.z - u_tube) * (p.z + u_tube);
    return inner * (inner + 4.0 * u_ring * from_axis);
}

// The zero of quartic_slope between low and high, or high if there is none. quartic_slope must be monotonic there.
// Newton's method, started where it converges from one side; the interval shrinks with each step as a safeguard. (About
// eight steps are enough. The limit of 40 keeps the compiler from unrolling the loop, which would prevent leaving it
// early.)
float turn_between(float low, float high, float start) {
    bool rises = quartic_slope(low) < 0.0;
    if (rises == (quartic_slope(high) < 0.0)) return high;
    float s = clamp(start, low, high);
    for (int i = 0; i < 40; ++i) {
        float value = quartic_slope(s);
        if ((value < 0.0) == rises) low = s;
        else high = s;
        float step = value / (12.0 * s * s + 2.0 * quartic_square);
        s -= step;
        if (!(s >= low && s <= high)) s = 0.5 * (low + high);
        if (abs(step) < 1e-7) break;
    }
    return s;
}

// Calls meet() with the quartic's root between low and high, if there is one.
void meet_between(float low, float high, float start) {
    bool rises = quartic(low) < 0.0;
    if (rises == (quartic(high) < 0.0)) return;
    float s = clamp(start, low, high);
    for (int i = 0; i < 40; ++i) {
        float value = quartic(s);
        if ((value < 0.0) == rises) low = s;
        else high = s;
        float step = value / quartic_slope(s);
        s -= step;
        if (!(s >= low && s <= high)) s = 0.5 * (low + high);
        if (abs(step) < 1e-7) break;
    }
    meet(nearest + s * direction);
}

#endif
// Calls meet() for each point where the pixel's ray meets the surface.
void cast_ray() {
    vec2 from_middle = gl_FragCoord.xy - u_middle_window;
    direction = u_direction + from_middle.x * u_direction_per_x + from_middle.y * u_direction_per_y;
    vec3 moment = u_moment + from_middle.x * u_moment_per_x + from_middle.y * u_moment_per_y;
#if EFFECT_RAY_DISK
    // The ray's point at z = 0: its cross product with the direction is the moment.
    meet(vec3(-moment.y, moment.x, 0.0) / direction.z);
#else
    nearest = cross(direction, moment) / dot(direction, direction);
#endif
#if EFFECT_RAY_SPHERE
    float distance_to_ray = length(nearest);
    float square = (u_radius - distance_to_ray) * (u_radius + distance_to_ray);
    if (square > 0.0) {
        float s = sqrt(square / dot(direction, direction));
#if EFFECT_RAY_NEAREST
        meet(nearest - s * direction);
        if (!is_met) meet(nearest + s * direction);
#else
        meet(nearest + s * direction);
        meet(nearest - s * direction);
#endif
    }
#elif EFFECT_RAY_FRUSTUM
    // a s^2 + 2 b s + c = 0, where p.x^2 + p.y^2 = (radius + slope p.z)^2.
    float radius = u_radius + u_slope * nearest.z, widening = u_slope * direction.z, from_axis = length(nearest.xy);
    float a = dot(direction.xy, direction.xy) - widening * widening;
    float b = dot(nearest.xy, direction.xy) - radius * widening;
    float c = (from_axis - radius) * (from_axis + radius);
    // b^2 - a c as a difference of two squares, from the moment (Lagrange's identity).
    float reach = length(u_radius * direction.xy + u_slope * vec2(moment.y, -moment.x));
    float discriminant = (reach - abs(moment.z)) * (reach + abs(moment.z));
    if (discriminant > 0.0) {
        float root = sqrt(discriminant);
        float q = b > 0.0 ? -(b + root) : root - b;
        float s = q / a, t = c / q;  // subtracts no nearly equal numbers
        if (a == 0.0) s = t;
#if EFFECT_RAY_NEAREST
        meet(nearest + min(s, t) * direction);
        if (!is_met) meet(nearest + max(s, t) * direction);
#else
        meet(nearest + max(s, t) * direction);
        if (a != 0.0) meet(nearest + min(s, t) * direction);
#endif
    }
#elif EFFECT_RAY_TORUS
    direction = normalize(direction);
    // The part of the ray inside a sphere and between two planes, slightly larger than the torus: the quartic is
    // positive at both ends.
    float outer = u_ring + u_tube + 0.03125, height = u_tube + 0.03125, distance_to_ray = length(nearest);
    float reach = sqrt(max((outer - distance_to_ray) * (outer + distance_to_ray), 0.0));
    float to_plane = (height - nearest.z) / direction.z, from_plane = (-height - nearest.z) / direction.z;
    float low = max(-reach, min(to_plane, from_plane)), high = min(reach, max(to_plane, from_plane));
    if (low < high) {
        float four = 4.0 * u_ring * u_ring;
        quartic_square = 2.0 * (dot(nearest, nearest) + (u_ring - u_tube) * (u_ring + u_tube)) -
            four * dot(direction.xy, direction.xy);
        quartic_linear = -2.0 * four * dot(nearest.xy, direction.xy);
        float inflection = sqrt(max(-quartic_square / 6.0, 0.0));  // the derivative has extrema at +-inflection
        float a = clamp(-inflection, low, high), b = clamp(inflection, low, high);
        float first = turn_between(low, a, low);
#if EFFECT_RAY_NEAREST
        meet_between(low, first, low);
        float second = high, third = high;
        if (!is_met) {
            second = turn_between(a, b, clamp(0.0, low, high));
            meet_between(first, second, a);
        }
        if (!is_met) {
            third = turn_between(b, high, high);
            meet_between(second, third, b);
        }
        if (!is_met) meet_between(third, high, high);
#else
        float second = turn_between(a, b, clamp(0.0, low, high)), third = turn_between(b, high, high);
        meet_between(third, high, high);
        meet_between(second, third, b);
        meet_between(first, second, a);
        meet_between(low, first, low);
#endif
    }
#endif
}


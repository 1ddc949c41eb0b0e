// The terms of the lighting equation (GL 2.1, section 2.14.1), with the names of src/lighting/equation.h, and their
// helpers; sphere maps, sizes of points, fog and sRGB at the end. A program contains only the functions that it calls (shader_assembly.h). All values
// are parameters, so that the same function serves every light, both faces, and object or eye coordinates. For integer
// exponents EXPONENT is int and POWER is whole_power; otherwise float and real_power.

// v scaled to length 1; the zero vector stays 0.
vec3 unit(vec3 v) {
    return v / max(length(v), 1e-18);
}

// The same for a vector of any length: squares of the largest floats would overflow, those of the smallest vanish.
vec3 unit_of_any(vec3 v) {
    vec3 size = abs(v);
    return unit(v / max(max(max(size.x, size.y), size.z), 1e-37));
}

// VP, or VP_e, times |w| (section 2.14.1): from a vertex (x, y, z, w) of object coordinates to a place there, turned to eye
// coordinates. The difference comes first, because it is exact where both are close together. w = 0 is a direction.
vec3 vector_to(vec3 place_object, vec4 vertex_object) {
    vec3 way = u_eye_from_object_turned * (place_object * vertex_object.w - vertex_object.xyz);
    return vertex_object.w < 0.0 ? -way : way;
}

// The same to a vertex whose w is between 1 and 2, or -2 and -1. Nothing is left of the difference of a vertex with itself.
vec3 vector_to_vertex(vec4 place_object, vec4 vertex_object) {
    vec3 way = u_eye_from_object_turned *
        (place_object.xyz * vertex_object.w - vertex_object.xyz * place_object.w) / place_object.w;
    return vertex_object.w < 0.0 ? -way : way;
}

// The same from a vertex of homogeneous eye coordinates to a place in eye coordinates.
vec3 vector_from(vec4 vertex_eye, vec3 place_eye) {
    vec3 way = place_eye * vertex_eye.w - vertex_eye.xyz;
    return vertex_eye.w < 0.0 ? -way : way;
}

// The largest component of a normal, so that the rest of it is neither short nor long.
float size_of(vec3 v) {
    vec3 size = abs(v);
    return max(max(max(size.x, size.y), size.z), 1e-37);
}

// The vector from a vertex to a light in a direction (w = 0). If the vertex is a direction too, it is the difference of
// the two (section 2.14.1).
vec3 between_directions(vec3 toward_light, vec3 vertex, float vertex_w) {
    return vertex_w == 0.0 ? toward_light - vertex : toward_light;
}

// The distance to a light whose VP times |w| is vp.
float distance_of(vec3 vp, float w) {
    const float greatest = 1e37;
    vec3 size = abs(vp);
    float largest = max(max(max(size.x, size.y), size.z), 1e-37);
    return w == 0.0 ? greatest : min(length(vp / largest) * largest / abs(w), greatest);
}

// p.xyz / p.w (section 2.14.1). A point at infinity (w = 0) becomes a very distant point.
vec3 divided_by_w(vec4 p) {
    const float far = 1e10;
    return length(p.xyz) < far * abs(p.w) ? p.xyz / p.w : unit(p.xyz) * (p.w < 0.0 ? -far : far);
}

// x^n for an integer n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
float whole_power(float x, int n) {
    float result = 1.0;
    for (int bit = 0; bit < 8; ++bit) {
        result *= (n >> bit & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return result;
}

// x^n for any n in [0, 128]. Only the fraction of n uses pow, which is exact enough there.
float real_power(float x, float n) {
    float fraction = fract(n);
    return whole_power(x, int(n)) * (fraction > 0.0 ? pow(x, fraction) : 1.0);
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
float positive_dot(vec3 a, vec3 b) {
    return max(dot(a, b), 0.0);
}

// att_i: the attenuation at a distance, for k = (k_0i, k_1i, k_2i) (section 2.14.1). 1 / 0, which the specification
// leaves open, becomes 0.
float attenuation(vec3 k, float light_distance) {
    float divisor = k[0] + light_distance * (k[1] + light_distance * k[2]);
    return divisor > 0.0 ? 1.0 / max(divisor, 1e-37) : 0.0;
}

// The same at a vertex whose VP times |w| is vp. Nothing is left of a light that grows weaker if the vertex is at infinity (w = 0).
float attenuation_of(vec3 k, vec3 vp, float w) {
    bool weakens = max(k[1], k[2]) > 0.0;
    return w == 0.0 && weakens ? 0.0 : attenuation(k, distance_of(vp, w));
}

// spot_i: the spotlight factor, 0 outside the cone and (PV . s_dli)^s_rli inside (section 2.14.1). The cone includes
// its border, so cos_cutoff is cos(c_rli) minus a margin for rounding.
float spot(vec3 spot_dir, float cos_cutoff, EXPONENT spot_exponent, vec3 vp_dir) {
    float cos_angle = dot(-vp_dir, spot_dir);
    return cos_angle >= cos_cutoff ? POWER(max(cos_angle, 0.0), spot_exponent) : 0.0;
}

// The lecture's cone with a soft border, instead of spot_i (not in GL). cone_slope is 1 / (cos inner - cos outer).
float smooth_cone(vec3 spot_dir, float cos_outer, float cone_slope, vec3 vp_dir) {
    return clamp((dot(-vp_dir, spot_dir) - cos_outer) * cone_slope, 0.0, 1.0);
}

// n . h, where h is the direction of a + b (section 2.14.1); 0 if it is negative or a + b is 0. Written as the root of
// a square, because the compiler can remove the root if the exponent is even.
float cosine_to_half(vec3 n, vec3 a, vec3 b) {
    vec3 sum = a + b;
    float n_dot_sum = max(dot(n, a) + dot(n, b), 0.0);
    return sqrt(n_dot_sum * n_dot_sum / max(dot(sum, sum), 1e-24));
}

// f_i: no highlight if the light is behind the surface (section 2.14.1).
float f_i(float n_dot_vp) {
    return n_dot_vp > 0.0 ? 1.0 : 0.0;
}

// f_i (n . h_i)^s_rm: the specular highlight (section 2.14.1). n_dot_h must not be negative.
float highlight(float n_dot_vp, float n_dot_h, EXPONENT shininess) {
    return n_dot_vp > 0.0 ? POWER(n_dot_h, shininess) : 0.0;
}

// (r . VPe)^s_rm: the lecture's highlight, without f_i (not in GL). r is VP reflected about n.
float reflected_highlight(vec3 n, vec3 vp_dir, vec3 vpe_dir, EXPONENT shininess) {
    vec3 reflected_dir = 2.0 * dot(n, vp_dir) * n - vp_dir;
    return POWER(positive_dot(reflected_dir, vpe_dir), shininess);
}

// x, but never infinite: the power of a long normal may overflow, and infinity times 0 is not a number.
float bounded(float x) {
    return min(x, 1e30);
}

// s and t of GL_SPHERE_MAP (section 2.11.4), from the reflected direction r. Where m is 0, they are 1/2.
vec2 sphere_map(vec3 r) {
    float m = 2.0 * length(r + vec3(0.0, 0.0, 1.0));
    return r.xy / max(m, 1e-18) + 0.5;
}

// A point's size (section 3.3). sizes: glPointSize, GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX.
float attenuated_size(float point_distance, vec3 attenuation, vec3 sizes) {
    float factor = attenuation.x + point_distance * (attenuation.y + point_distance * attenuation.z);
    return max(sizes.y, min(sizes.z, sizes.x * inversesqrt(abs(factor))));
}

// The fog factor f for GL_LINEAR (section 3.10). fog_scale is 1 / (end - start).
float fog_linear(float fog_distance, float fog_end, float fog_scale) {
    return clamp((fog_end - fog_distance) * fog_scale, 0.0, 1.0);
}

// The fog factor f for GL_EXP (section 3.10).
float fog_exp(float fog_distance, float density) {
    return exp(-density * fog_distance);
}

// The fog factor f for GL_EXP2 (section 3.10).
float fog_exp2(float fog_distance, float density) {
    float thickness = density * fog_distance;
    return exp(-thickness * thickness);
}

// Encodes linear light as sRGB (IEC 61966-2-1).
vec3 srgb_coded(vec3 linear) {
    return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

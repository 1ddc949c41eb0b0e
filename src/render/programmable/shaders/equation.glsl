// The terms of the lighting equation (GL 2.1, section 2.14.1), under the names of src/lighting/equation.h, with helpers of
// their own; fog and sRGB at the end. A program has the
// functions that it calls and no others (shader_assembly.h). They take their values as parameters, so one text serves every light,
// both faces, and object as well as eye coordinates. EXPONENT is int for whole exponents, and POWER whole_power; else float and
// real_power.

// The direction of v. The zero vector has none and stays 0.
vec3 unit(vec3 v) {
    return v / max(length(v), 1e-18);
}

// The place of a homogeneous position (section 2.14.1). A point at infinity is lit as if it were very far away.
vec3 divided_by_w(vec4 p) {
    const float far = 1e10;
    return length(p.xyz) < far * abs(p.w) ? p.xyz / p.w : unit(p.xyz) * (p.w < 0.0 ? -far : far);
}

// x^n for whole n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
float whole_power(float x, int n) {
    float result = 1.0;
    for (int bit = 0; bit < 8; ++bit) {
        result *= (n >> bit & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return result;
}

// x^n for any n in [0, 128]: pow computes only the fraction, where it is exact enough.
float real_power(float x, float n) {
    float fraction = fract(n);
    return whole_power(x, int(n)) * (fraction > 0.0 ? pow(x, fraction) : 1.0);
}

// max(a . b, 0): the product that section 2.14.1 writes as a dot in a circle.
float positive_dot(vec3 a, vec3 b) {
    return max(dot(a, b), 0.0);
}

// att_i (section 2.14.1), for k_0i, k_1i, k_2i and the distance. RULING: 0 where it would be 1 / 0.
float attenuation(vec3 k, float light_distance) {
    float divisor = k[0] + light_distance * (k[1] + light_distance * k[2]);
    return divisor > 0.0 ? 1.0 / max(divisor, 1e-37) : 0.0;
}

// spot_i (section 2.14.1): 0 outside of the cone, (PV . s_dli)^s_rli within. The border belongs to the cone: cos_cutoff is
// cos(c_rli), less what rounding may take from a cosine.
float spot(vec3 spot_dir, float cos_cutoff, EXPONENT spot_exponent, vec3 vp_dir) {
    float cos_angle = dot(-vp_dir, spot_dir);
    return cos_angle >= cos_cutoff ? POWER(max(cos_angle, 0.0), spot_exponent) : 0.0;
}

// Not GL: the lecture's cone with a soft border, instead of spot_i. cone_slope is 1 / (cos inner - cos outer).
float smooth_cone(vec3 spot_dir, float cos_outer, float cone_slope, vec3 vp_dir) {
    return clamp((dot(-vp_dir, spot_dir) - cos_outer) * cone_slope, 0.0, 1.0);
}

// n . h, for h = hat(a + b); 0 where that is negative or a + b is 0. The root of a square, because the compiler drops the root where
// the power is even.
float cosine_to_half(vec3 n, vec3 a, vec3 b) {
    vec3 sum = a + b;
    float n_dot_sum = max(dot(n, a) + dot(n, b), 0.0);
    return sqrt(n_dot_sum * n_dot_sum / max(dot(sum, sum), 1e-24));
}

// f_i (section 2.14.1): no highlight where the light is behind the surface.
float f_i(float n_dot_vp) {
    return n_dot_vp > 0.0 ? 1.0 : 0.0;
}

// f_i (n . h_i)^s_rm (section 2.14.1); n_dot_h is not negative.
float highlight(float n_dot_vp, float n_dot_h, EXPONENT shininess) {
    return n_dot_vp > 0.0 ? POWER(n_dot_h, shininess) : 0.0;
}

// Not GL: (r . VPe)^s_rm, without f_i. VP reflected about n is r.
float reflected_highlight(vec3 n, vec3 vp_dir, vec3 vpe_dir, EXPONENT shininess) {
    vec3 reflected_dir = 2.0 * dot(n, vp_dir) * n - vp_dir;
    return POWER(positive_dot(reflected_dir, vpe_dir), shininess);
}

// Normals may be longer than 1, and infinity times 0 is no number.
float bounded(float x) {
    return min(x, 1e30);
}

// f of section 3.10 by its three modes; fog_scale is 1 / (end - start).
float fog_linear(float fog_distance, float fog_end, float fog_scale) {
    return clamp((fog_end - fog_distance) * fog_scale, 0.0, 1.0);
}

float fog_exp(float fog_distance, float density) {
    return exp(-density * fog_distance);
}

float fog_exp2(float fog_distance, float density) {
    float thickness = density * fog_distance;
    return exp(-thickness * thickness);
}

// Linear light as sRGB codes it (IEC 61966-2-1).
vec3 srgb_coded(vec3 linear) {
    return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

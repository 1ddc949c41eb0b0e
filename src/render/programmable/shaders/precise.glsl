// The arithmetic of --precise: every sum has one fixed order, and `precise` forbids the compiler to change it. The
// order is that of Mesa's program for the fixed function (main/ffvertex_prog.c) after its NIR compiler: a dot product
// adds its last term first, 1 / inversesqrt(x) becomes sqrt(x), and sqrt(x) * sqrt(x) becomes x. A program contains
// only the functions that it calls.

// a . b, with the last term added first.
float dot3(vec3 a, vec3 b) {
    precise float sum = a.z * b.z;
    sum = sum + a.y * b.y;
    sum = sum + a.x * b.x;
    return sum;
}

// m p (section 2.11).
vec4 transformed(mat4 m, vec4 p) {
    precise vec4 sum = p.x * m[0];
    sum = p.y * m[1] + sum;
    sum = p.z * m[2] + sum;
    sum = p.w * m[3] + sum;
    return sum;
}

// m n, for a normal (section 2.11.3).
vec3 transformed_normal(mat3 m, vec3 n) {
    precise vec3 sum = n.z * m[2];
    sum = n.y * m[1] + sum;
    sum = n.x * m[0] + sum;
    return sum;
}

// The normal times GL_RESCALE_NORMAL's factor (section 2.11.3).
vec3 rescaled(vec3 n, float scale) {
    precise vec3 product = n * scale;
    return product;
}

// 1 / |v|, but finite for the zero vector, so that v times it stays 0.
float per_length(vec3 v) {
    precise float reciprocal = inversesqrt(max(dot3(v, v), 1e-37));
    return reciprocal;
}

// v scaled to length 1; the zero vector stays 0.
vec3 unit(vec3 v) {
    precise vec3 direction = v * per_length(v);
    return direction;
}

// att_i: the attenuation of a light (section 2.14.1). The driver computes d / d instead of 1. A divisor of 0 gives 0.
float attenuation(vec3 k, vec3 vp) {
    precise float distance_squared = dot3(vp, vp);
    precise float light_distance = sqrt(distance_squared);
    precise float one = light_distance > 0.0 ? per_length(vp) * light_distance : 1.0;
    precise float divisor = dot3(k, vec3(one, light_distance, distance_squared));
    precise float attenuation = divisor > 0.0 ? 1.0 / divisor : 0.0;
    return attenuation;
}

// spot_i: the spotlight factor (section 2.14.1). 0^0, which pow leaves open, is 1 (section 2.1.1).
float spot(vec3 spot_dir, float cos_cutoff, float spot_exponent, vec3 vp_dir) {
    precise float cos_angle = dot3(-vp_dir, spot_dir);
    precise float power = spot_exponent > 0.0 ? pow(abs(cos_angle), spot_exponent) : 1.0;
    precise float spot = cos_angle >= cos_cutoff ? power : 0.0;
    return spot;
}

// f_i: no highlight if the light is behind the surface (section 2.14.1).
float f_i(float n_dot_vp) {
    return n_dot_vp > 0.0 ? 1.0 : 0.0;
}

// f_i (n . h_i)^s_rm: the specular highlight (section 2.14.1). x^0 is 1 for a face with a shininess of 0.
float highlight(float n_dot_vp, float n_dot_h, float shininess) {
    precise float power = shininess > 0.0 ? pow(max(n_dot_h, 0.0), shininess) : 1.0;
    precise float highlight = n_dot_vp > 0.0 ? power : 0.0;
    return highlight;
}

// n . h, where h is the direction of sum.
float cosine_to(vec3 n, vec3 sum) {
    precise float cosine = dot3(n, unit(sum));
    return cosine;
}

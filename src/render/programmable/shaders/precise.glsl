// The arithmetic of --precise: every sum in one order, and `precise` forbids the compiler another. It is the order of Mesa's
// program for the fixed function (main/ffvertex_prog.c), as its NIR compiler leaves it: a dot product adds its last term
// first, 1 / inversesqrt(x) is sqrt(x), and sqrt(x) times itself x.
float dot3(vec3 a, vec3 b) {
    precise float sum = a.z * b.z;
    sum = sum + a.y * b.y;
    sum = sum + a.x * b.x;
    return sum;
}

vec4 transformed(mat4 m, vec4 p) {
    precise vec4 sum = p.x * m[0];
    sum = p.y * m[1] + sum;
    sum = p.z * m[2] + sum;
    sum = p.w * m[3] + sum;
    return sum;
}

#if EFFECT_LIGHTING
// One over the length. The zero vector stays 0 when multiplied by it.
float per_length(vec3 v) {
    precise float reciprocal = inversesqrt(max(dot3(v, v), 1e-37));
    return reciprocal;
}

vec3 precise_unit(vec3 v) {
    precise vec3 direction = v * per_length(v);
    return direction;
}

#endif

// Where a homogeneous position is. What lies at infinity is lit as if it were very far away.
vec3 divided_by_w(vec4 p) {
    const float far = 1e10;
    return length(p.xyz) < far * abs(p.w) ? p.xyz / p.w : unit(p.xyz) * (p.w < 0.0 ? -far : far);
}


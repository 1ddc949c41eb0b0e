// The direction of v. The zero vector has none and stays 0.
vec3 unit(vec3 v) {
    return v / max(length(v), 1e-18);
}


// x^n for whole n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
float whole_power(float x, float n) {
    float result = 1.0;
    for (int bit = 0; bit < 8; ++bit) {
        result *= (int(n) >> bit & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return result;
}

#if EFFECT_HALF_SUM
// sqrt(square)^n: an even power needs no root.
float whole_power_of_root(float square, float n) {
    float result = (int(n) & 1) != 0 ? sqrt(square) : 1.0;
    for (int bit = 1; bit < 8; ++bit) {
        result *= (int(n) >> bit & 1) != 0 ? square : 1.0;
        square *= square;
    }
    return result;
}

#endif
#if EFFECT_POWER_REAL
// x^n for any n in [0, 128]: pow has only the fraction to do, where it is exact enough.
float real_power(float x, float n) {
    float fraction = fract(n);
    return whole_power(x, floor(n)) * (fraction > 0.0 ? pow(x, fraction) : 1.0);
}

#if EFFECT_HALF_SUM
float real_power_of_root(float square, float n) {
    return real_power(sqrt(square), n);
}

#endif
#endif

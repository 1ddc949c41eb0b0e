// x^n for whole n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
float whole_power(float x, float n) {
    float result = 1.0;
    for (int bit = 0; bit < 8; ++bit) {
        result *= (int(n) >> bit & 1) != 0 ? x : 1.0;
        x *= x;
    }
    return result;
}

#if EFFECT_POWER_REAL
// x^n for any n in [0, 128]: pow has only the fraction to do, where it is exact enough.
float real_power(float x, float n) {
    float fraction = fract(n);
    return whole_power(x, floor(n)) * (fraction > 0.0 ? pow(x, fraction) : 1.0);
}

#endif

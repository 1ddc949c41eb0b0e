// Rounding to floats of numbers that stay doubles, as commands with a GLfloat round what they are given.
#pragma once

namespace twinlight {

// The float nearest to x. `volatile`, because g++ 12 with -O2 drops the rounding where it rounds two neighbours together
// ("return {(double)(float)v.x, (double)(float)v.y};").
inline double as_float(double x) {
    const volatile auto nearest = static_cast<float>(x);
    return static_cast<double>(nearest);
}

}  // namespace twinlight

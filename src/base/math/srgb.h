// sRGB (IEC 61966-2-1): the transfer curve, and the conversion to CIE 1931 XYZ. XYZ is relative: white has Y = 1.
#pragma once

#include <cmath>

#include "base/math/vec3.h"

namespace twinlight {

// The sRGB code on [0,1] of a linear channel on [0,1]. Colours outside the gamut are below 0 or above 1; the curve is
// continued to them (odd about 0), so they keep their order.
inline double srgb_coded(double linear) {
    const double a = std::abs(linear);
    const double coded = a <= 0.0031308 ? 12.92 * a : 1.055 * std::pow(a, 1 / 2.4) - 0.055;
    return std::copysign(coded, linear);
}
inline Vec3<double> srgb_coded(Vec3<double> c) { return {srgb_coded(c.x), srgb_coded(c.y), srgb_coded(c.z)}; }

inline double srgb_linear(double coded) {
    const double a = std::abs(coded);
    const double linear = a <= 0.04045 ? a / 12.92 : std::pow((a + 0.055) / 1.055, 2.4);
    return std::copysign(linear, coded);
}
inline Vec3<double> srgb_linear(Vec3<double> c) { return {srgb_linear(c.x), srgb_linear(c.y), srgb_linear(c.z)}; }

// A 3 x 3 matrix, stored by rows.
struct ColorMatrix {
    Vec3<double> row_x, row_y, row_z;
    Vec3<double> operator*(Vec3<double> c) const { return {dot(row_x, c), dot(row_y, c), dot(row_z, c)}; }
};

// Computed exactly from the primaries (0.64, 0.33), (0.30, 0.60), (0.15, 0.06) and the white (0.3127, 0.3290); the
// standard prints four digits.
inline constexpr ColorMatrix kXyzFromSrgb = {
    {506752.0 / 1228815, 87881.0 / 245763, 12673.0 / 70218},
    {87098.0 / 409605, 175762.0 / 245763, 12673.0 / 175545},
    {7918.0 / 409605, 87881.0 / 737289, 1001167.0 / 1053270},
};
inline constexpr ColorMatrix kSrgbFromXyz = {
    {12831.0 / 3959, -329.0 / 214, -1974.0 / 3959},
    {-851781.0 / 878810, 1648619.0 / 878810, 36519.0 / 878810},
    {705.0 / 12673, -2585.0 / 12673, 705.0 / 667},
};

// The XYZ of sRGB's white (red = green = blue = 1).
inline constexpr Vec3<double> kSrgbWhite = {0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};

}  // namespace twinlight

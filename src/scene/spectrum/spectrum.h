// Spectra of lights and surfaces, and the colours that they have: CIE 1931 2 degree observer, linear sRGB.
//
// Every spectrum is a table of 81 lines, 380 to 780 nm every 5 nm; integrals are sums over the lines (CIE 15:2004, 7.1).
// Nothing here knows of fluorescence, polarisation or what lies outside of 380 to 780 nm.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "base/math/vec3.h"

namespace twinlight {

inline constexpr int kLines = 81;
constexpr double wavelength_nm(int line) { return 380 + 5 * line; }

using Lines = std::array<double, kLines>;

struct Spectrum {
    std::string_view name;  // as pragmas say it: "dark_skin", "D65"
    Lines lines;
};

// The ColorChecker's 24 patches, row by row; values on [0,1].
std::span<const Spectrum> reflectances();
// A, D50, D65, F2, F11, LED_B3. Scaled: a perfect white under it has the luminance Y = 1.
std::span<const Spectrum> illuminants();
// Null where there is none of this name.
const Spectrum* find_reflectance(std::string_view name);
const Spectrum* find_illuminant(std::string_view name);

// The reflectances of sRGB's primaries (Mallett and Yuksel 2019): smooth, on [0,1], their sum is 1. So r, g and b times them
// is a reflectance of the colour (r, g, b), and one on [0,1] where the colour is.
std::span<const Spectrum, 3> primaries();

// Of light of this power at each line. Y of white is 1 under any of illuminants().
Vec3<double> xyz_of_light(const Lines& power);

// In linear sRGB: of a surface under D65, of a light on a perfect white. D65 and white are (1, 1, 1), exactly: sRGB's white is
// D65 rounded to four digits, and the channels are scaled by the 3e-4 at most that this makes.
Vec3<double> rgb_of_reflectance(const Lines& reflectance);
Vec3<double> rgb_of_light(const Lines& power);

// Per channel of linear sRGB, what each line of light relative to D65 adds.
std::span<const Vec3<double>> rgb_weights();
// x_bar + y_bar + z_bar at each line.
const Lines& observer_sum();

}  // namespace twinlight

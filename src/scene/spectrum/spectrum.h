// Spectra of lights and surfaces, and their colours for the CIE 1931 2 degree observer, in linear sRGB.
//
// Every spectrum is a table of 81 lines, 380 to 780 nm every 5 nm; integrals are sums over the lines (CIE 15:2004,
// 7.1). Fluorescence, polarisation and light outside 380 to 780 nm are ignored.
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
    std::string_view name;  // as in pragmas: "dark_skin", "D65"
    Lines lines;
};

// The ColorChecker's 24 patches, row by row; values on [0,1].
std::span<const Spectrum> reflectances();
// A, D50, D65, F2, F11, LED_B3. Scaled so that a perfect white under each has the luminance Y = 1.
std::span<const Spectrum> illuminants();
// Null if there is none with this name.
const Spectrum* find_reflectance(std::string_view name);
const Spectrum* find_illuminant(std::string_view name);

// The reflectances of sRGB's primaries (Mallett and Yuksel 2019). They are smooth, on [0,1], and sum to 1. So r, g and
// b times them give a reflectance with the colour (r, g, b), which is on [0,1] if the colour is.
std::span<const Spectrum, 3> primaries();

// The XYZ of light with this power at each line. Under all of illuminants(), white has Y = 1.
Vec3<double> xyz_of_light(const Lines& power);

// The colour in linear sRGB of a surface under D65, and of a light on a perfect white. D65 on white is exactly (1, 1,
// 1): sRGB's white is D65 rounded to four digits, so the channels are scaled by at most 3e-4.
Vec3<double> rgb_of_reflectance(const Lines& reflectance);
Vec3<double> rgb_of_light(const Lines& power);

// For each line: the linear sRGB colour that light of the power of D65 adds.
std::span<const Vec3<double>> rgb_weights();
// x_bar + y_bar + z_bar at each line.
const Lines& observer_sum();

}  // namespace twinlight

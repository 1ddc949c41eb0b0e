#include "scene/spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/math/srgb.h"

namespace twinlight {

namespace {

// clang-format off
#define OBSERVER(...)
#define ILLUMINANT(...)
#define REFLECTANCE(...)
#define PRIMARY(...)

#undef OBSERVER
#define OBSERVER(name, ...) constexpr Lines name = {__VA_ARGS__};
#include "scene/spectrum/spectra.def"
#undef OBSERVER
#define OBSERVER(...)

#undef ILLUMINANT
#define ILLUMINANT(name, ...) {#name, {__VA_ARGS__}},
constexpr Spectrum kIlluminantTables[] = {
#include "scene/spectrum/spectra.def"
};
#undef ILLUMINANT
#define ILLUMINANT(...)

#undef REFLECTANCE
#define REFLECTANCE(name, ...) {#name, {__VA_ARGS__}},
constexpr Spectrum kReflectances[] = {
#include "scene/spectrum/spectra.def"
};
#undef REFLECTANCE
#define REFLECTANCE(...)

#undef PRIMARY
#define PRIMARY(name, ...) Spectrum{#name, {__VA_ARGS__}},
constexpr std::array<Spectrum, 3> kPrimaries = {
#include "scene/spectrum/spectra.def"
};
#undef OBSERVER
#undef ILLUMINANT
#undef REFLECTANCE
#undef PRIMARY
// clang-format on
static_assert(std::size(kReflectances) == 24);

// CIE 15:2004, section 3.1: Planck's radiator with the constant of 1931, relative to 560 nm.
Spectrum illuminant_a() {
    Spectrum a{"A", {}};
    const auto planck = [](double nm) { return std::expm1(1.435e7 / (2848 * nm)); };
    for (int i = 0; i < kLines; ++i)
        a.lines[static_cast<std::size_t>(i)] =
            100 * std::pow(560 / wavelength_nm(i), 5) * planck(560) / planck(wavelength_nm(i));
    return a;
}

std::vector<Spectrum> scaled_illuminants() {
    std::vector<Spectrum> all = {illuminant_a()};
    all.insert(all.end(), std::begin(kIlluminantTables), std::end(kIlluminantTables));
    for (Spectrum& light : all) {
        double y = 0;
        for (std::size_t i = 0; i < kLines; ++i) y += y_bar[i] * light.lines[i];
        for (double& power : light.lines) power /= y;
    }
    return all;
}

const Spectrum* find(std::span<const Spectrum> all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &Spectrum::name);
    return found == all.end() ? nullptr : &*found;
}

const Lines& d65() {
    static const Lines& lines = find_illuminant("D65")->lines;
    return lines;
}

std::array<Vec3<double>, kLines> make_rgb_weights() {
    std::array<Vec3<double>, kLines> weights;
    Vec3<double> white;
    for (std::size_t i = 0; i < kLines; ++i) {
        weights[i] = kSrgbFromXyz * (d65()[i] * Vec3<double>{x_bar[i], y_bar[i], z_bar[i]});
        white += weights[i];
    }
    for (Vec3<double>& w : weights) w = {w.x / white.x, w.y / white.y, w.z / white.z};
    return weights;
}

}  // namespace

std::span<const Spectrum> reflectances() { return kReflectances; }
std::span<const Spectrum, 3> primaries() { return kPrimaries; }

std::span<const Spectrum> illuminants() {
    static const std::vector<Spectrum> all = scaled_illuminants();
    return all;
}

const Spectrum* find_reflectance(std::string_view name) { return find(reflectances(), name); }
const Spectrum* find_illuminant(std::string_view name) { return find(illuminants(), name); }

Vec3<double> xyz_of_light(const Lines& power) {
    Vec3<double> sum;
    for (std::size_t i = 0; i < kLines; ++i) sum += power[i] * Vec3<double>{x_bar[i], y_bar[i], z_bar[i]};
    return sum;
}

std::span<const Vec3<double>> rgb_weights() {
    static const std::array<Vec3<double>, kLines> weights = make_rgb_weights();
    return weights;
}

Vec3<double> rgb_of_reflectance(const Lines& reflectance) {
    Vec3<double> sum;
    for (std::size_t i = 0; i < kLines; ++i) sum += reflectance[i] * rgb_weights()[i];
    return sum;
}

Vec3<double> rgb_of_light(const Lines& power) {
    Vec3<double> sum;
    for (std::size_t i = 0; i < kLines; ++i) sum += power[i] / d65()[i] * rgb_weights()[i];
    return sum;
}

const Lines& observer_sum() {
    static const Lines sums = [] {
        Lines result;
        for (std::size_t i = 0; i < kLines; ++i) result[i] = x_bar[i] + y_bar[i] + z_bar[i];
        return result;
    }();
    return sums;
}

}  // namespace twinlight

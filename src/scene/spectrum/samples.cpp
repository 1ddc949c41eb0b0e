#include "scene/spectrum/samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace twinlight {

namespace {

// The share of each line in each band; the shares of a line sum to 1.
std::vector<Lines> bands(int count) {
    const auto n = static_cast<std::size_t>(count);
    std::vector<Lines> parts(n, Lines{});
    if (count == kLines) {
        for (std::size_t i = 0; i < n; ++i) parts[i][i] = 1;
        return parts;
    }
    Lines density;
    double whole = 0;
    for (std::size_t i = 0; i < kLines; ++i) whole += density[i] = std::cbrt(observer_sum()[i]);
    double begin = 0;  // in units of bands
    for (std::size_t i = 0; i < kLines; ++i) {
        const double width = density[i] / whole * count, end = begin + width;
        for (std::size_t band = 0; band < n; ++band) {
            const double from = std::max(begin, static_cast<double>(band));
            const double to = std::min(end, static_cast<double>(band + 1));
            parts[band][i] = std::max(to - from, 0.0) / width;
        }
        begin = end;
    }
    return parts;
}

// The inverse of the matrix with these columns.
ColorMatrix inverse(Vec3<double> a, Vec3<double> b, Vec3<double> c) {
    const double determinant = dot(a, cross(b, c));
    return {cross(b, c) / determinant, cross(c, a) / determinant, cross(a, b) / determinant};
}

}  // namespace

SpectralSamples::SpectralSamples(int count) : shares_(bands(count)) {
    assert(count >= kFewest && count <= kMost);
    for (Lines& share : shares_) {
        Vec3<double> rgb;
        double whole = 0;
        for (std::size_t i = 0; i < kLines; ++i) {
            rgb += share[i] * rgb_weights()[i];
            share[i] *= observer_sum()[i];
            whole += share[i];
        }
        for (double& s : share) s /= whole;
        rgb_.push_back(rgb);
    }
    // Mixes the means of the primaries so that they get the primaries' colours. White stays n ones, because its colour
    // is already exact.
    std::array<std::vector<double>, 3> mean;
    for (std::size_t i = 0; i < 3; ++i) mean[i] = means(primaries()[i].lines);
    const ColorMatrix mixing = inverse(color(mean[0]), color(mean[1]), color(mean[2]));
    for (std::size_t s = 0; s < rgb_.size(); ++s) {
        const Vec3<double> m{mean[0][s], mean[1][s], mean[2][s]};
        basis_.push_back(m.x * mixing.row_x + m.y * mixing.row_y + m.z * mixing.row_z);
    }
    for (const Spectrum& r : reflectances())
        reflectances_.push_back(with_color(means(r.lines), rgb_of_reflectance(r.lines)));
    const Lines& d65 = find_illuminant("D65")->lines;
    for (const Spectrum& light : illuminants()) {
        Lines relative;
        for (std::size_t i = 0; i < kLines; ++i) relative[i] = light.lines[i] / d65[i];
        illuminants_.push_back(with_color(means(relative), rgb_of_light(light.lines)));
    }
}

std::vector<double> SpectralSamples::means(const Lines& lines) const {
    std::vector<double> result;
    for (const Lines& share : shares_) {
        double mean = 0;
        for (std::size_t i = 0; i < kLines; ++i) mean += share[i] * lines[i];
        result.push_back(mean);
    }
    return result;
}

std::vector<double> SpectralSamples::with_color(std::vector<double> samples, Vec3<double> rgb) const {
    const std::vector<double> missing = of_color(rgb - color(samples));
    for (std::size_t s = 0; s < samples.size(); ++s) samples[s] += missing[s];
    return samples;
}

std::vector<double> SpectralSamples::of_color(Vec3<double> rgb) const {
    std::vector<double> samples;
    for (const Vec3<double>& basis : basis_) samples.push_back(dot(basis, rgb));
    return samples;
}

const std::vector<double>& SpectralSamples::of_reflectance(const Spectrum& reflectance) const {
    return reflectances_.at(static_cast<std::size_t>(&reflectance - reflectances().data()));
}

const std::vector<double>& SpectralSamples::of_illuminant(const Spectrum& illuminant) const {
    return illuminants_.at(static_cast<std::size_t>(&illuminant - illuminants().data()));
}

Vec3<double> SpectralSamples::color(std::span<const double> samples) const {
    Vec3<double> sum;
    for (std::size_t s = 0; s < rgb_.size(); ++s) sum += samples[s] * rgb_[s];
    return sum;
}

Vec3<double> SpectralSamples::color_of_product(std::span<const double> light, std::span<const double> surface) const {
    Vec3<double> sum;
    for (std::size_t s = 0; s < rgb_.size(); ++s) sum += light[s] * surface[s] * rgb_[s];
    return sum;
}

}  // namespace twinlight

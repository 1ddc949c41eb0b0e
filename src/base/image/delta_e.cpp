#include "base/image/delta_e.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "base/math/srgb.h"

namespace twinlight {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

// The function f of CIE 15:2004, section 8.2.1.1.
double lab_curve(double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

double seventh_power(double x) {
    const double cube = x * x * x;
    return cube * cube * x;
}

// sqrt(C^7 / (C^7 + 25^7)), which occurs in G and in R_C.
double of_chroma(double chroma) {
    const double c7 = seventh_power(chroma);
    return std::sqrt(c7 / (c7 + seventh_power(25)));
}

double cos_of(double angle_deg) { return std::cos(angle_deg / kDegrees); }
double sin_of(double angle_deg) { return std::sin(angle_deg / kDegrees); }

// Equation 7. On [0, 360); 0 for a colour without hue.
double hue_deg(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double angle = std::atan2(b, a) * kDegrees;
    return angle < 0 ? angle + 360 : angle;
}

// Equation 14. `has_hue`: neither chroma is 0.
double mean_hue_deg(double one, double other, bool has_hue) {
    const double sum = one + other;
    if (!has_hue) return sum;
    if (std::abs(one - other) <= 180) return sum / 2;
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

// A pixel's red, green and blue, clamped to [0,1]; NaN becomes 0.
Vec3<double> shown(const Rgba& pixel) {
    const auto clamped = [](float c) { return c > 0 ? std::min(static_cast<double>(c), 1.0) : 0.0; };
    return {clamped(pixel[0]), clamped(pixel[1]), clamped(pixel[2])};
}

}  // namespace

Lab lab_from_xyz(Vec3<double> xyz) {
    const double fx = lab_curve(xyz.x / kSrgbWhite.x), fy = lab_curve(xyz.y / kSrgbWhite.y),
                 fz = lab_curve(xyz.z / kSrgbWhite.z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Lab lab_from_linear_srgb(Vec3<double> linear) { return lab_from_xyz(kXyzFromSrgb * linear); }
Lab lab_from_srgb_codes(Vec3<double> codes) { return lab_from_linear_srgb(srgb_linear(codes)); }

// The paper's equations 2 to 22, in the paper's order. A p at the end of a name is the paper's prime.
double delta_e_2000(Lab one, Lab other) {
    const double mean_c = (std::hypot(one.a, one.b) + std::hypot(other.a, other.b)) / 2;
    const double g = 0.5 * (1 - of_chroma(mean_c));
    const double a1p = (1 + g) * one.a, a2p = (1 + g) * other.a;
    const double c1p = std::hypot(a1p, one.b), c2p = std::hypot(a2p, other.b);
    const double h1p = hue_deg(a1p, one.b), h2p = hue_deg(a2p, other.b);
    const bool has_hue = c1p * c2p != 0;

    const double dl = other.lightness - one.lightness;
    const double dc = c2p - c1p;
    double dh_deg = has_hue ? h2p - h1p : 0;
    if (dh_deg > 180) dh_deg -= 360;
    if (dh_deg < -180) dh_deg += 360;
    const double dh = 2 * std::sqrt(c1p * c2p) * sin_of(dh_deg / 2);

    const double mean_l = (one.lightness + other.lightness) / 2;
    const double mean_cp = (c1p + c2p) / 2;
    const double mean_h = mean_hue_deg(h1p, h2p, has_hue);
    const double t = 1 - 0.17 * cos_of(mean_h - 30) + 0.24 * cos_of(2 * mean_h) + 0.32 * cos_of(3 * mean_h + 6) -
                     0.20 * cos_of(4 * mean_h - 63);
    const double theta_deg = 30 * std::exp(-std::pow((mean_h - 275) / 25, 2));
    const double from_50 = (mean_l - 50) * (mean_l - 50);
    const double s_l = 1 + 0.015 * from_50 / std::sqrt(20 + from_50);
    const double s_c = 1 + 0.045 * mean_cp;
    const double s_h = 1 + 0.015 * mean_cp * t;
    const double r_t = -sin_of(2 * theta_deg) * 2 * of_chroma(mean_cp);

    const double l = dl / s_l, c = dc / s_c, h = dh / s_h;
    return std::sqrt(std::max(l * l + c * c + h * h + r_t * c * h, 0.0));
}

PerceivedDifference perceived_difference(const Image& one, const Image& other) {
    return perceived_difference(one, other, PixelMask(one.pixels.size(), true));
}

PerceivedDifference perceived_difference(const Image& one, const Image& other, const PixelMask& counted) {
    if (one.width != other.width || one.height != other.height || counted.size() != one.pixels.size()) {
        throw std::invalid_argument("pictures of different sizes cannot be compared");
    }
    PerceivedDifference result;
    std::vector<double> all;
    double sum = 0;
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            const std::size_t i = one.index(x, y);
            if (!counted[i]) continue;
            const Vec3<double> a = shown(one.pixels[i]), b = shown(other.pixels[i]);
            const double e = a == b ? 0 : delta_e_2000(lab_from_srgb_codes(a), lab_from_srgb_codes(b));
            sum += e;
            if (all.empty() || e > result.max) {
                result.max = e;
                result.worst_x = x;
                result.worst_y = y;
            }
            all.push_back(e);
        }
    }
    if (all.empty()) return result;
    result.pixels = all.size();
    result.mean = sum / static_cast<double>(all.size());
    const auto rank = all.begin() + static_cast<std::ptrdiff_t>((all.size() * 19 + 19) / 20 - 1);
    std::ranges::nth_element(all, rank);
    result.percentile_95 = *rank;
    return result;
}

}  // namespace twinlight

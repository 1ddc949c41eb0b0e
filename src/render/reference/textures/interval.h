// Numbers and intervals, so that the operations on a fragment are written once: over double they give the colour, over
// Interval all colours that correct choices (a neighbouring texel, a driver's rounding) can lead to.
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec4.hpp>

#include "lighting/real.h"

namespace twinlight::reference {

struct Interval {
    double low = 0, high = 0;

    constexpr Interval() = default;
    constexpr Interval(double value) : low(value), high(value) {}  // NOLINT: a number is an interval
    constexpr Interval(double l, double h) : low(l), high(h) {}

    double width() const { return high - low; }
    friend Interval operator+(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }
    friend Interval operator-(Interval a, Interval b) { return {a.low - b.high, a.high - b.low}; }
    friend Interval operator*(Interval a, Interval b) {
        const auto [least, most] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
        return {least, most};
    }
    friend bool operator==(const Interval&, const Interval&) = default;
};

inline Interval hull(Interval a, Interval b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
inline Interval widened(Interval a, double by) { return {a.low - by, a.high + by}; }

inline double clamp01(double x) { return lighting::clamp01(x); }
inline Interval clamp01(Interval x) { return {clamp01(x.low), clamp01(x.high)}; }

inline double smaller(double a, double b) { return std::min(a, b); }
inline double larger(double a, double b) { return std::max(a, b); }
inline Interval smaller(Interval a, Interval b) { return {std::min(a.low, b.low), std::min(a.high, b.high)}; }
inline Interval larger(Interval a, Interval b) { return {std::max(a.low, b.low), std::max(a.high, b.high)}; }

// R, G, B, A.
template <class Real>
using Channels = std::array<Real, 4>;

template <class Real>
Channels<Real> channels(const glm::dvec4& color) {
    return {Real(color.r), Real(color.g), Real(color.b), Real(color.a)};
}
// Channel by channel.
inline Channels<Interval> hull(const Channels<Interval>& a, const Channels<Interval>& b) {
    return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2]), hull(a[3], b[3])};
}
inline glm::dvec4 color_of(const Channels<double>& c) { return {c[0], c[1], c[2], c[3]}; }

}  // namespace twinlight::reference

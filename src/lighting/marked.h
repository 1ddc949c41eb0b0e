// Marked: a double that records which rulings affected its value. With it, the templates of equation.h and real.h find
// the rulings that a colour depends on. A product with an exact 0 drops the rulings of the other factor: they changed
// nothing.
#pragma once

#include <cmath>

#include "lighting/real.h"

namespace twinlight::lighting {

struct Marked {
    double value = 0;
    RulingSet rulings{};

    constexpr Marked() = default;
    constexpr Marked(double number, RulingSet from = {})
        : value(number), rulings(from) {}  // NOLINT: converts implicitly
    explicit operator double() const { return value; }

    constexpr bool is_plain_zero() const { return value == 0 && rulings.empty(); }
    // The result of a comparison, and the rulings that it depends on.
    struct Mask {
        bool holds = false;
        RulingSet rulings{};
        explicit constexpr operator bool() const { return holds; }
    };

    friend constexpr Marked operator+(Marked a, Marked b) { return {a.value + b.value, a.rulings | b.rulings}; }
    friend constexpr Marked operator-(Marked a, Marked b) { return {a.value - b.value, a.rulings | b.rulings}; }
    friend constexpr Marked operator-(Marked a) { return {-a.value, a.rulings}; }
    friend constexpr Marked operator*(Marked a, Marked b) {
        const bool is_zero = a.is_plain_zero() || b.is_plain_zero();
        const bool has_zero = a.value == 0 || b.value == 0;  // the other may be infinite
        return {has_zero ? 0 : a.value * b.value, is_zero ? RulingSet{} : a.rulings | b.rulings};
    }
    constexpr Marked& operator*=(Marked b) { return *this = *this * b; }
    friend constexpr Marked operator/(Marked a, Marked b) {
        return {a.value / b.value, a.is_plain_zero() ? RulingSet{} : a.rulings | b.rulings};
    }
    friend constexpr Mask operator<(Marked a, Marked b) { return {a.value < b.value, a.rulings | b.rulings}; }
    friend constexpr Mask operator<=(Marked a, Marked b) { return {a.value <= b.value, a.rulings | b.rulings}; }
    friend constexpr Mask operator>(Marked a, Marked b) { return b < a; }
    friend constexpr Mask operator>=(Marked a, Marked b) { return b <= a; }
    friend constexpr bool operator==(Marked a, Marked b) {
        return a.value == b.value;
    }  // used only for exponents and w, which no ruling affects

    friend Marked select(Mask mask, Marked a, Marked b) {
        const Marked chosen = mask.holds ? a : b;
        return {chosen.value, mask.rulings | chosen.rulings};
    }
    friend Marked abs(Marked a) { return {std::abs(a.value), a.rulings}; }
    friend Marked sqrt(Marked a) { return {std::sqrt(a.value), a.rulings}; }
    friend Marked exp(Marked a) { return {std::exp(a.value), a.rulings}; }
    friend Marked pow(Marked base, Marked exponent) { return {std::pow(base.value, exponent.value), base.rulings}; }
};

inline RulingSet rulings_of(const Vec3<Marked>& v) { return v.x.rulings | v.y.rulings | v.z.rulings; }
// v with these rulings added to each component.
inline Vec3<Marked> marked(const Vec3<Marked>& v, RulingSet by) {
    return {{v.x.value, v.x.rulings | by}, {v.y.value, v.y.rulings | by}, {v.z.value, v.z.rulings | by}};
}

inline Marked ruled(Ruling ruling, Marked value) { return {value.value, value.rulings | RulingSet{ruling}}; }
inline Marked ruled(Ruling ruling, Marked::Mask where, Marked value) {
    return where.holds ? ruled(ruling, value) : value;
}
inline Vec3<Marked> ruled(Ruling ruling, const Vec3<Marked>& v) { return marked(v, {ruling}); }
inline Vec3<Marked> ruled(Ruling ruling, Marked::Mask where, const Vec3<Marked>& v) {
    return where.holds ? marked(v, {ruling}) : v;
}

template <>
struct Limits<Marked> : Limits<double> {};

}  // namespace twinlight::lighting

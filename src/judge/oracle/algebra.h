// The oracle's numbers, vectors and matrices: rows and columns as the specification writes them.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace twinlight::oracle {

// The number that judges: 60 decimal digits, an exponent of 32 bits.
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<60, boost::multiprecision::digit_base_10, void, std::int32_t>,
    boost::multiprecision::et_off>;
// The number of evaluations whose inputs are rounded on purpose, at 2^-51 or more of each value. Its own rounding is 2^-64 an
// operation, which such inputs hide. Lighting multiplies a dozen floats of 2^149 at most, far from its largest, 2^16384; only powers
// may leave it.
using Rough = long double;

// Below these, cosines of right angles and ties of two cosines are 0.
template <class Number>
struct Noise {
    inline static const Number kRightAngle{"1e-55"}, kTie{"1e-45"};
};
template <>
struct Noise<Rough> {
    static constexpr Rough kRightAngle = 1e-18L, kTie = 1e-17L;
};

using std::abs, std::cos, std::pow, std::sin;  // Boost's are found by their arguments

template <class Number>
using Vec3 = std::array<Number, 3>;
template <class Number>
using Vec4 = std::array<Number, 4>;
template <class Number>
using Mat3 = std::array<Vec3<Number>, 3>;  // [row][column]
template <class Number>
using Mat4 = std::array<Vec4<Number>, 4>;

inline Rough root(Rough x) { return std::sqrt(x); }
// Newton's method, from a root in double; Boost's own finds one bit after the other.
inline Exact root(const Exact& x) {
    namespace mp = boost::multiprecision;
    if (x == 0) return 0;
    int exponent = 0;
    Exact m = mp::frexp(x, &exponent);
    if (exponent % 2 != 0) m = mp::ldexp(m, -1), ++exponent;
    Exact inverse = 1 / std::sqrt(m.convert_to<double>());  // 53 bits, then 105, then 201
    for (int round = 0; round < 2; ++round) inverse += mp::ldexp(Exact(inverse * (1 - m * inverse * inverse)), -1);
    Exact result = m * inverse;
    result += mp::ldexp(Exact(inverse * (m - result * result)), -1);
    return mp::ldexp(result, exponent / 2);
}

template <class Number>
Number dot(const Vec3<Number>& a, const Vec3<Number>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class Number>
Number length(const Vec3<Number>& v) {
    return root(dot(v, v));
}
template <class Number>
Vec3<Number> times(const Number& factor, const Vec3<Number>& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}
template <class Number>
Vec3<Number> plus(const Vec3<Number>& a, const Vec3<Number>& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Number>
Vec3<Number> minus(const Vec3<Number>& a, const Vec3<Number>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Vec3<Number> negative(const Vec3<Number>& v) {
    return {-v[0], -v[1], -v[2]};
}
template <class Number>
Vec3<Number> cross(const Vec3<Number>& a, const Vec3<Number>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Number>
Vec3<Number> xyz(const Vec4<Number>& v) {
    return {v[0], v[1], v[2]};
}
template <class Number>
bool is_zero(const Vec3<Number>& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

template <class Number>
struct Measured {
    Vec3<Number> dir;  // the unit vector; 0 stays 0 (a ruling each time: there is no direction)
    Number length;
};
template <class Number>
Measured<Number> measured(const Vec3<Number>& v) {
    if (is_zero(v)) return {v, 0};
    const Number size = length(v);
    return {times(Number(1 / size), v), size};
}
template <class Number>
Vec3<Number> unit(const Vec3<Number>& v) {
    return measured(v).dir;
}

template <class Number>
Mat4<Number> identity() {
    Mat4<Number> m{};
    for (std::size_t i = 0; i < 4; ++i) m[i][i] = 1;
    return m;
}
template <class Number>
Mat4<Number> product(const Mat4<Number>& a, const Mat4<Number>& b) {
    Mat4<Number> m{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
    return m;
}
template <class Number>
Vec4<Number> transformed(const Mat4<Number>& m, const Vec4<Number>& v) {
    Vec4<Number> result{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) result[i] += m[i][k] * v[k];
    return result;
}

template <class Number>
Number cosine_of(const Number& degrees) {
    return cos(Number(degrees * boost::math::constants::pi<Number>() / 180));
}
template <class Number>
Number sine_of(const Number& degrees) {
    return sin(Number(degrees * boost::math::constants::pi<Number>() / 180));
}
// Rotations by 90 degrees must have exact zeros, but pi has only so many digits.
template <class Number>
Number cleaned(const Number& x) {
    return abs(x) < Noise<Number>::kRightAngle ? Number(0) : x;
}

template <class Number>
Mat4<Number> rotation(const Number& angle_deg, const Vec3<Number>& axis) {  // 2.11.2
    if (is_zero(axis)) return identity<Number>();                           // undefined
    const Vec3<Number> u = unit(axis);
    const Number c = cleaned(cosine_of(angle_deg)), s = cleaned(sine_of(angle_deg));
    Mat4<Number> m = identity<Number>();
    const Mat3<Number> crossed = {{{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const Number uu = u[i] * u[j];
            m[i][j] = uu + c * (Number(i == j ? 1 : 0) - uu) + s * crossed[i][j];
        }
    return m;
}

template <class Number>
Mat4<Number> translation(const Vec3<Number>& by) {
    Mat4<Number> m = identity<Number>();
    for (std::size_t i = 0; i < 3; ++i) m[i][3] = by[i];
    return m;
}

template <class Number>
Mat4<Number> look_at(std::span<const double> a) {  // gluLookAt's rotation; the translation by -eye follows
    using Vector3 = Vec3<Number>;
    const Vector3 f = unit(Vector3{Number(a[3]) - a[0], Number(a[4]) - a[1], Number(a[5]) - a[2]});
    const Vector3 s = unit(cross(f, unit(Vector3{a[6], a[7], a[8]}))), u = cross(s, f);
    Mat4<Number> m = identity<Number>();
    for (std::size_t j = 0; j < 3; ++j) m[0][j] = s[j], m[1][j] = u[j], m[2][j] = -f[j];
    return m;
}

// ---- Normals: n' = n M^-1 (2.11.3) ----

template <class Number>
Mat3<Number> adjugate(const Mat3<Number>& m) {
    const Mat3<Number> columns = {
        {{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}, {m[0][2], m[1][2], m[2][2]}}};
    return {cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])};
}
template <class Number>
Number determinant(const Mat3<Number>& m, const Mat3<Number>& adjoint) {
    return m[0][0] * adjoint[0][0] + m[0][1] * adjoint[1][0] + m[0][2] * adjoint[2][0];
}

// A power of two near x > 0.
inline Rough power_of_two_near(Rough x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(Rough(1), exponent);
}

// RULING: a matrix is singular if its rank is less than 3 for numbers of 21 bits, after its rows and columns are scaled (which
// glScale does, and which loses no digits) by powers of two, so that the renderers agree about matrices at the border. 64 bits decide
// that well.
template <class Number>
bool is_singular(const Mat3<Number>& matrix) {
    constexpr Rough kSingular = 0x1p21L;
    constexpr int kRounds = 8;
    Mat3<Rough> m{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = static_cast<Rough>(matrix[i][j]);
    for (int round = 0; round < kRounds; ++round) {
        for (Vec3<Rough>& row : m) {
            const Rough largest = std::max({abs(row[0]), abs(row[1]), abs(row[2])});
            if (largest == 0) return true;
            row = times(1 / power_of_two_near(largest), row);
        }
        for (std::size_t j = 0; j < 3; ++j) {
            const Rough largest = std::max({abs(m[0][j]), abs(m[1][j]), abs(m[2][j])});
            if (largest == 0) return true;
            for (Vec3<Rough>& row : m) row[j] /= power_of_two_near(largest);
        }
    }
    const Mat3<Rough> adjoint = adjugate(m);
    const auto norm = [](const Mat3<Rough>& of) {
        return std::sqrt(dot(of[0], of[0]) + dot(of[1], of[1]) + dot(of[2], of[2]));
    };
    return norm(m) * norm(adjoint) >= kSingular * abs(determinant(m, adjoint));
}

}  // namespace twinlight::oracle

// Vec3<Real>: the vectors and colours of the lighting equation, over any number type.
//
// Real may be float, double, long double or a batch of SIMD lanes: nothing here branches on a value.
// A variable's name ends in its space (_object, _eye, ...), or in _dir if its length is 1.
#pragma once

#include <cmath>

namespace twinlight {

template <class Real>
struct Vec3 {
    Real x{}, y{}, z{};

    friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
    friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }  // channel by channel
    friend Vec3 operator*(Vec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
    friend Vec3 operator*(Real s, Vec3 a) { return a * s; }
    friend Vec3 operator/(Vec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
    Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class Real>
Real dot(Vec3<Real> a, Vec3<Real> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
Vec3<Real> cross(Vec3<Real> a, Vec3<Real> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
Real length(Vec3<Real> a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}

// Converts between vector types: Vec3<float>, glm::dvec3, ...
template <class To, class From>
To vec3_cast(const From& a) {
    using Real = decltype(To{}.x);
    return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
}

}  // namespace twinlight

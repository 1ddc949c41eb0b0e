// The equations of the curved surfaces that the meshes of shapes approximate.
//
// In surface space the axis is z. Object space is the same, or its axis is y. Lengths are in units of object space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "base/math/vec3.h"

namespace twinlight {

struct Command;

struct SphereSurface {  // centred at the origin
    double radius;
};
struct FrustumSurface {  // the side of a cylinder or cone, from radius `base` at z = 0 to `top` at z = height > 0
    double base, top, height;
};
struct DiskSurface {  // the part of the plane z = `z` between two radii; angles from +y towards +x, in degrees
    double inner, outer, z;
    bool faces_up;  // the normal is +z; otherwise -z
    double start_deg = 0, sweep_deg = 360;
};
struct TorusSurface {  // a tube of radius `tube` along the circle of radius `ring` around z
    double tube, ring;
};

struct Surface {
    std::variant<SphereSurface, FrustumSurface, DiskSurface, TorusSurface> equation;
    bool y_up = false;      // whether the axis in object space is y, not z
    bool inside = false;    // GLU_INSIDE: normals and front faces point inwards
    bool textured = false;  // has its own texture coordinates, like GLU's quadrics
};

// The surfaces of a SHAPE_COMMAND or of the pragma `shape`, in drawing order. None if the mesh itself is the shape: it
// has flat faces, is drawn as lines, or has a size that is not positive.
std::vector<Surface> shape_surfaces(const Command& command);

// ---- Intersection of a ray with a surface, in surface space ----

template <class Real>
Vec3<Real> surface_from_object(const Surface& surface, Vec3<Real> v) {
    return surface.y_up ? Vec3<Real>{v.x, -v.z, v.y} : v;
}
template <class Real>
Vec3<Real> object_from_surface(const Surface& surface, Vec3<Real> v) {
    return surface.y_up ? Vec3<Real>{v.x, v.z, -v.y} : v;
}

// The points origin + s direction of a ray on a surface: at most four values of s, ascending. Points where the ray only
// touches the surface may be missing.
template <class Real>
struct Crossings {
    std::array<Real, 4> s{};
    int count = 0;

    void add(Real value) { s[static_cast<std::size_t>(count++)] = value; }
};

// The real roots of c[0] + c[1] s + ... + c[N-1] s^(N-1) between low and high, ascending. The roots of the derivative
// divide the interval into pieces in which the polynomial only rises or only falls, and each piece is searched by
// bisection. A root where the polynomial only touches 0 may be missed.
template <class Real, std::size_t N>
int roots_between(const std::array<Real, N>& c, Real low, Real high, std::array<Real, N - 1>& roots) {
    const auto value = [&](Real s) {
        Real sum = c[N - 1];
        for (std::size_t i = N - 1; i > 0; --i) sum = sum * s + c[i - 1];
        return sum;
    };
    std::array<Real, N> borders{};
    std::size_t count = 0;
    borders[count++] = low;
    if constexpr (N > 2) {
        std::array<Real, N - 1> derivative{};
        for (std::size_t i = 1; i < N; ++i) derivative[i - 1] = static_cast<Real>(i) * c[i];
        std::array<Real, N - 2> turns{};
        const int turn_count = roots_between(derivative, low, high, turns);
        for (int i = 0; i < turn_count; ++i) borders[count++] = turns[static_cast<std::size_t>(i)];
    }
    int found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Real from = borders[i], to = i + 1 < count ? borders[i + 1] : high;
        const bool rises = value(from) < 0;
        if (rises == (value(to) < 0)) continue;
        while (true) {  // bisect until no number lies between
            const Real middle = from + (to - from) / 2;
            if (!(middle > from && middle < to)) break;
            ((value(middle) < 0) == rises ? from : to) = middle;
        }
        roots[static_cast<std::size_t>(found++)] = to;
    }
    return found;
}

namespace surface_parts {

// The roots of a s^2 + 2 b s + c, computed without subtracting nearly equal numbers.
template <class Real>
Crossings<Real> quadratic(Real a, Real b, Real c) {
    using std::sqrt;
    Crossings<Real> crossings;
    const Real discriminant = b * b - a * c;
    if (!(discriminant > 0)) return crossings;
    const Real q = b > 0 ? -(b + sqrt(discriminant)) : sqrt(discriminant) - b;
    if (a == 0) {
        crossings.add(c / q);
        return crossings;
    }
    const Real first = q / a, second = c / q;
    crossings.add(std::min(first, second));
    crossings.add(std::max(first, second));
    return crossings;
}

template <class Real>
Crossings<Real> crossings_of(const SphereSurface& sphere, Vec3<Real> o, Vec3<Real> d) {
    const Real r(sphere.radius);
    return quadratic(dot(d, d), dot(o, d), dot(o, o) - r * r);
}

template <class Real>
Crossings<Real> crossings_of(const FrustumSurface& f, Vec3<Real> o, Vec3<Real> d) {
    const Real slope = (Real(f.top) - Real(f.base)) / Real(f.height);
    const Real radius = Real(f.base) + slope * o.z,
               widening = slope * d.z;  // the radius at the ray's height is radius + s widening
    const Crossings<Real> of_cone =
        quadratic(d.x * d.x + d.y * d.y - widening * widening, o.x * d.x + o.y * d.y - radius * widening,
                  o.x * o.x + o.y * o.y - radius * radius);
    Crossings<Real> crossings;
    for (int i = 0; i < of_cone.count; ++i) {
        const Real s = of_cone.s[static_cast<std::size_t>(i)], z = o.z + s * d.z;
        if (z >= 0 && z <= Real(f.height)) crossings.add(s);
    }
    return crossings;
}

template <class Real>
Crossings<Real> crossings_of(const DiskSurface& disk, Vec3<Real> o, Vec3<Real> d) {
    using std::atan2;
    Crossings<Real> crossings;
    if (d.z == 0) return crossings;
    const Real s = (Real(disk.z) - o.z) / d.z, x = o.x + s * d.x, y = o.y + s * d.y;
    const Real square = x * x + y * y, inner(disk.inner), outer(disk.outer);
    if (square > outer * outer || square < inner * inner) return crossings;
    constexpr double kTurn = 360;
    if (std::abs(disk.sweep_deg) < kTurn) {
        const double start = disk.start_deg + std::min(disk.sweep_deg, 0.0);
        const double angle = std::fmod(static_cast<double>(atan2(x, y)) / std::numbers::pi * 180 - start, kTurn);
        if ((angle < 0 ? angle + kTurn : angle) > std::abs(disk.sweep_deg)) return crossings;
    }
    crossings.add(s);
    return crossings;
}

// |p|^2 + R^2 - r^2 = 2 R sqrt(x^2 + y^2), squared.
template <class Real>
Crossings<Real> crossings_of(const TorusSurface& torus, Vec3<Real> o, Vec3<Real> d) {
    using std::sqrt;
    Crossings<Real> crossings;
    const Real tube(torus.tube), ring(torus.ring), length_of_d = length(d);
    const Vec3<Real> u = d / length_of_d;
    // o is the ray's point nearest to the origin. Inside the sphere around the torus, s is between -reach and reach.
    const Real outer = ring + tube, square = outer * outer - dot(o, o);
    if (!(square > 0)) return crossings;
    const Real reach = sqrt(square), k = dot(o, o) + ring * ring - tube * tube, along = dot(o, u),
               four = 4 * ring * ring;
    const std::array<Real, 5> c = {k * k - four * (o.x * o.x + o.y * o.y),
                                   4 * k * along - 2 * four * (o.x * u.x + o.y * u.y),
                                   2 * k + 4 * along * along - four * (u.x * u.x + u.y * u.y), 4 * along, Real(1)};
    std::array<Real, 4> roots{};
    const int count = roots_between(c, -reach, reach, roots);
    for (int i = 0; i < count; ++i) crossings.add(roots[static_cast<std::size_t>(i)] / length_of_d);
    return crossings;
}

template <class Real>
Vec3<Real> normal_of(const SphereSurface& /*sphere*/, Vec3<Real> p) {
    return p;
}
template <class Real>
Vec3<Real> normal_of(const FrustumSurface& f, Vec3<Real> p) {
    using std::sqrt;
    // At the apex, where every normal of the side is possible, the axis is chosen.
    const Real from_axis = sqrt(p.x * p.x + p.y * p.y), height(f.height), narrows = Real(f.base) - Real(f.top);
    if (from_axis == 0) return {0, 0, narrows};
    return {height * p.x / from_axis, height * p.y / from_axis, narrows};
}
template <class Real>
Vec3<Real> normal_of(const DiskSurface& disk, Vec3<Real> /*p*/) {
    return {0, 0, Real(disk.faces_up ? 1 : -1)};
}
template <class Real>
Vec3<Real> normal_of(const TorusSurface& torus, Vec3<Real> p) {
    using std::sqrt;
    const Real to_ring = Real(torus.ring) / sqrt(p.x * p.x + p.y * p.y);
    return {p.x - to_ring * p.x, p.y - to_ring * p.y, p.z};
}

}  // namespace surface_parts

template <class Real>
Crossings<Real> crossings(const Surface& surface, Vec3<Real> origin, Vec3<Real> direction) {
    // Starts at the ray's point nearest to the centre, so that a far origin loses no digits.
    const Real nearest = -dot(origin, direction) / dot(direction, direction);
    const Vec3<Real> o = origin + nearest * direction;
    Crossings<Real> result = std::visit(
        [&](const auto& equation) { return surface_parts::crossings_of(equation, o, direction); }, surface.equation);
    for (Real& s : result.s) s = s + nearest;
    return result;
}

// The outward normal at a point of the surface. Its length is arbitrary.
template <class Real>
Vec3<Real> outward_normal(const Surface& surface, Vec3<Real> position) {
    return std::visit([&](const auto& equation) { return surface_parts::normal_of(equation, position); },
                      surface.equation);
}

// The texture coordinates (s, t) at a point of the surface, as for GLU's quadrics. On spheres and frustums s jumps from
// 1 to 0 at +y.
template <class Real>
std::array<Real, 2> surface_tex_coord(const Surface& surface, Vec3<Real> p) {
    using std::acos, std::atan2, std::sqrt;
    const Real turn = 2 * std::numbers::pi_v<Real>;
    if (const auto* disk = std::get_if<DiskSurface>(&surface.equation)) {
        const Real twice = 2 * Real(disk->outer);
        return {p.x / twice + Real(0.5), p.y / twice + Real(0.5)};
    }
    const Real angle = atan2(p.x, p.y), s = 1 - (angle < 0 ? angle + turn : angle) / turn;
    if (const auto* frustum = std::get_if<FrustumSurface>(&surface.equation)) return {s, p.z / Real(frustum->height)};
    // The polar angle by atan2, because acos(z / r) is inexact near the poles.
    return {s, 1 - atan2(sqrt(p.x * p.x + p.y * p.y), p.z) / std::numbers::pi_v<Real>};
}

}  // namespace twinlight

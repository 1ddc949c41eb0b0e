#include "app/session/mesh_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace twinlight::session {
namespace {

double distance_to(const SphereSurface& sphere, const glm::dvec3& p) {
    return std::abs(glm::length(p) - sphere.radius);
}

// To the cone or cylinder through the frustum; points of the mesh are beside it, not beyond its ends.
double distance_to(const FrustumSurface& frustum, const glm::dvec3& p) {
    const double slope = (frustum.top - frustum.base) / frustum.height;
    return std::abs(std::hypot(p.x, p.y) - frustum.base - slope * p.z) / std::sqrt(1 + slope * slope);
}

// The mesh of a disk lies in its plane: it lacks only the rim.
double distance_to(const DiskSurface& disk, const glm::dvec3& p) { return std::abs(p.z - disk.z); }

double distance_to(const TorusSurface& torus, const glm::dvec3& p) {
    return std::abs(std::hypot(std::hypot(p.x, p.y) - torus.ring, p.z) - torus.tube);
}

double distance_to(const Surface& surface, const glm::dvec3& point_object) {
    const Vec3<double> p = surface_from_object(surface, Vec3<double>{point_object.x, point_object.y, point_object.z});
    return std::visit([&](const auto& equation) { return distance_to(equation, glm::dvec3(p.x, p.y, p.z)); },
                      surface.equation);
}

double largest_distance(const Surface& surface, std::span<const glm::dvec3> points_object) {
    double largest = 0;
    for (const glm::dvec3& point : points_object) largest = std::max(largest, distance_to(surface, point));
    return largest;
}

// A triangle belongs to the surface that its corners are on; the rim of a cap is on two.
double error_of_triangle(const std::vector<Surface>& surfaces, const std::array<glm::dvec3, 3>& corners) {
    constexpr double kRounding = 1e-9;
    const auto& [a, b, c] = corners;
    const std::array middles = {(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0};
    double of_corners = std::numeric_limits<double>::infinity(), error = of_corners;
    for (const Surface& surface : surfaces) of_corners = std::min(of_corners, largest_distance(surface, corners));
    for (const Surface& surface : surfaces)
        if (largest_distance(surface, corners) <= of_corners + kRounding)
            error = std::min(error, largest_distance(surface, middles));
    return error;
}

// Visits the triangles of a Draw (2.6.1); quadrilaterals are cut from the first corner to the third.
template <class Visit>
void for_each_triangle(const Draw& draw, const Visit& visit) {
    const std::size_t count = draw.count();
    const auto corner = [&](std::size_t i) { return glm::dvec3(draw.vertices[draw.index(i)].position_object); };
    switch (draw.mode) {
        case kGL_TRIANGLES:
            for (std::size_t i = 0; i + 2 < count; i += 3) visit(corner(i), corner(i + 1), corner(i + 2));
            break;
        case kGL_TRIANGLE_STRIP:
        case kGL_QUAD_STRIP:
            for (std::size_t i = 0; i + 2 < count; ++i) visit(corner(i), corner(i + 1), corner(i + 2));
            break;
        case kGL_TRIANGLE_FAN:
        case kGL_POLYGON:
            for (std::size_t i = 1; i + 1 < count; ++i) visit(corner(0), corner(i), corner(i + 1));
            break;
        case kGL_QUADS:
            for (std::size_t i = 0; i + 3 < count; i += 4) {
                visit(corner(i), corner(i + 1), corner(i + 2));
                visit(corner(i), corner(i + 2), corner(i + 3));
            }
            break;
        default: break;
    }
}

}  // namespace

MeshError mesh_error(const Frame& frame, std::size_t first, std::size_t count) {
    MeshError error;
    const std::vector<const Draw*> draws = frame.draws();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 least(kInfinity), most(-kInfinity);
    for (std::size_t i = first; i < std::min(first + count, draws.size()); ++i) {
        const Draw& draw = *draws[i];
        if (!draw.surfaces || draw.surfaces->empty()) continue;
        error.has_surfaces = true;
        for_each_triangle(draw, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
            error.distance = std::max(error.distance, error_of_triangle(*draw.surfaces, {a, b, c}));
            for (const glm::dvec3& point : {a, b, c}) {
                least = glm::min(least, point);
                most = glm::max(most, point);
            }
        });
    }
    const glm::dvec3 size = most - least;
    const double half = std::max({size.x, size.y, size.z}) / 2;
    if (error.has_surfaces && half > 0) error.of_size = error.distance / half;
    return error;
}

}  // namespace twinlight::session
